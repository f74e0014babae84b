use std::collections::{BTreeMap, BTreeSet};

use cogmap_geometry::Segment;

use super::{AsrId, ExitId, Form, Now, Places, overlap, shape};
use crate::{
    Event,
    memory::{Mfis, SurfaceId},
    say,
};

/// Spaces are compared each so many metres of way.
const COMPARE_EACH: f64 = 1.0;

/// A space that was opened not long ago and may turn out to be an old one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Newcomer {
    asr: AsrId,
    exit: ExitId,
    /// The last view before the robot was in it.
    view: usize,
    opened: f64,
    compare_at: f64,
}

impl Newcomer {
    pub(super) fn new((asr, exit): (AsrId, ExitId), view: usize, way: f64) -> Self {
        Self { asr, exit, view, opened: way, compare_at: way + COMPARE_EACH }
    }
}

/// The robot was recognised to be in an old place: for a while spaces are compared that lie over each other
/// along the new link.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Homecoming {
    until: f64,
    compare_at: f64,
}

impl Places {
    /// Compares a space that was opened not long ago with the old ones: the more of it is known, the
    /// plainer it is that it is one of them.
    pub(super) fn compare_newcomer(&mut self, now: Now<'_>) -> Vec<Event> {
        let way = self.trail.way();
        let Some(newcomer) = self.newcomer.filter(|newcomer| way >= newcomer.compare_at) else {
            return Vec::new();
        };
        self.newcomer = Some(Newcomer { compare_at: way + COMPARE_EACH, ..newcomer })
            .filter(|newcomer| way - newcomer.opened <= self.params.overlap.within);
        if self.network.current() != newcomer.asr {
            return Vec::new();
        }
        let Some((old, overlap)) = self.old_space_of(now, newcomer) else { return Vec::new() };
        self.newcomer = None;
        vec![self.close(newcomer.asr, old, overlap)]
    }

    /// The old space that a new one is, and how much of it says so: by what was recognised in it since the robot
    /// came in (`recommended`); by where it lies, and in the recommended form by its size too.
    fn old_space_of(&mut self, now: Now<'_>, newcomer: Newcomer) -> Option<(AsrId, f64)> {
        let Newcomer { asr, exit, view, .. } = newcomer;
        let exit = self.network.exit(exit)?;
        let left = exit.leads_from(asr)?;
        if self.params.form == Form::Recommended {
            let segment =
                self.nearby.here_from(exit.frame).map(|here_from_frame| here_from_frame * exit.segment);
            if let Some(segment) = segment {
                self.claim(now, segment, (left, asr), view + 1);
            }
            let known = self.sightings.most(view + 1, &self.network, &BTreeSet::new(), (left, Some(asr)));
            if let Some(known) = known.filter(|(_, share)| *share >= self.params.familiarity.known) {
                return Some(known);
            }
        }
        let (old, share) = self.overlapped(now, self.network.surfaces_of(asr), left)?;
        let fits = self.params.form == Form::Literal || self.is_no_larger(now.memory.mfis(), asr, old);
        fits.then_some((old, share))
    }

    /// Whether a new space is not so much larger than an old one that it must be another.
    fn is_no_larger(&self, mfis: &Mfis, newer: AsrId, older: AsrId) -> bool {
        let around = self.params.overlap.around;
        let area = |asr| overlap::area_of(&overlap::hull_of(&self.network, mfis, asr, around));
        area(newer) <= self.params.familiarity.larger * area(older)
    }

    /// The old space that some surfaces mostly lie in (§3.2.3), other than the one just left; the robot must be in
    /// it too.
    pub(super) fn overlapped(
        &self,
        now: Now<'_>,
        surfaces: &[SurfaceId],
        left: AsrId,
    ) -> Option<(AsrId, f64)> {
        let (mfis, robot) = (now.memory.mfis(), now.report.map_from_robot.position);
        let segments: Vec<Segment> =
            surfaces.iter().filter_map(|&id| mfis.get(id)).map(|surface| mfis.in_map(surface)).collect();
        let newest = self.network.current();
        let others = self.network.asrs().iter().map(|asr| asr.id).filter(|&asr| asr != left && asr != newest);
        let shares = others.filter_map(|asr| {
            let way = self.trail.way() - self.last_in.get(&asr).copied().unwrap_or(0.0);
            let tolerance = self.params.overlap.tolerance_after(way);
            let around = self.params.overlap.around;
            // No hull reaches farther, so most spaces need not be outlined.
            let may_be_there = self.network.visits().may_reach(asr, robot, around + tolerance + 1e-6);
            let hull = may_be_there.then(|| overlap::hull_of(&self.network, mfis, asr, around))?;
            let is_there = overlap::is_within(robot, &hull, tolerance);
            Some((asr, if is_there { overlap::share_within(&segments, &hull, tolerance) } else { 0.0 }))
        });
        let best = shares.max_by(|a, b| a.1.total_cmp(&b.1))?;
        (best.1 >= self.params.overlap.share).then_some(best)
    }

    /// After the mapper recognised an old place, newer spaces that lie over old ones along the new link are
    /// the same (`recommended`).
    pub(super) fn compare_after_recognition(&mut self, now: Now<'_>) -> Vec<Event> {
        let way = self.trail.way();
        if now.report.recalled.is_some() {
            let until = way + self.params.familiarity.within;
            self.homecoming = Some(Homecoming { until, compare_at: way });
        }
        let Some(homecoming) = self.homecoming.filter(|homecoming| way >= homecoming.compare_at) else {
            return Vec::new();
        };
        self.homecoming = Some(Homecoming { compare_at: way + COMPARE_EACH, ..homecoming })
            .filter(|homecoming| way <= homecoming.until);
        if self.params.form != Form::Recommended {
            return Vec::new();
        }
        let mut events = Vec::new();
        let mfis = now.memory.mfis();
        while let Some((newer, older, overlap)) = self.double(mfis).or_else(|| self.seen_again(now)) {
            events.push(self.close(newer, older, overlap));
        }
        events
    }

    /// The newer and the older of two near spaces that lie over each other most.
    fn double(&self, mfis: &Mfis) -> Option<(AsrId, AsrId, f64)> {
        let near: Vec<(AsrId, Vec<Segment>)> = self.outlines_here(mfis).into_iter().collect();
        let mut best: Option<(AsrId, AsrId, f64)> = None;
        for (at, (newer, new)) in near.iter().enumerate() {
            for (older, old) in &near[..at] {
                let share = shape::share_on(new, old);
                if share >= self.params.familiarity.shape && best.is_none_or(|(.., most)| share > most) {
                    best = Some((*newer, *older, share));
                }
            }
        }
        best
    }

    /// The robot's own space, and an older one whose outline most of the view lies on.
    fn seen_again(&self, now: Now<'_>) -> Option<(AsrId, AsrId, f64)> {
        let (mfis, current) = (now.memory.mfis(), self.network.current());
        let seen = now.report.view.surfaces.iter().map(|surface| now.here.frame_from_robot * surface.segment);
        let seen: Vec<Segment> =
            seen.filter(|segment| segment.length() >= self.params.looking.debris).collect();
        let mut outlines: BTreeMap<AsrId, Vec<Segment>> = self.outlines_here(mfis);
        let own = outlines.remove(&current)?;
        let older = outlines.into_iter().take_while(|(asr, _)| *asr < current);
        let shares = older.filter_map(|(asr, outline)| {
            let fits = shape::share_on(&own, &outline) >= self.params.familiarity.shape / 2.0;
            fits.then(|| (current, asr, shape::share_on(&seen, &outline)))
        });
        let best = shares.max_by(|a, b| a.2.total_cmp(&b.2))?;
        (best.2 >= self.params.familiarity.known).then_some(best)
    }

    /// Makes one space of two, and one exit of two that lie at the same place between the same spaces.
    fn close(&mut self, newer: AsrId, older: AsrId, overlap: f64) -> Event {
        let entered = self.network.asr(newer).and_then(|asr| asr.exits.first().copied());
        self.network.merge(newer, older);
        let doubles: Vec<(ExitId, ExitId)> = self.double_exits(older);
        for (newer, older) in doubles {
            self.network.merge_exits(newer, older);
        }
        let exit = entered.and_then(|exit| self.network.exit(exit)).map_or(ExitId(0), |exit| exit.id);
        let why = say(
            "{} % of ASR {} lies over ASR {}: the robot is back",
            &[(100.0 * overlap, 0), (f64::from(newer.0), 0), (f64::from(older.0), 0)],
        );
        Event::LoopClosed { asr: older, instead_of: Some(newer), exit, overlap, why }
    }

    /// The exits of a space that are found twice, newer first.
    fn double_exits(&self, asr: AsrId) -> Vec<(ExitId, ExitId)> {
        let exits = self.network.asr(asr).into_iter().flat_map(|asr| &asr.exits);
        let placed: Vec<(ExitId, Segment, AsrId)> = exits
            .filter_map(|&exit| self.network.exit(exit))
            .filter_map(|exit| {
                Some((exit.id, self.nearby.here_from(exit.frame)? * exit.segment, exit.leads_from(asr)?))
            })
            .collect();
        let mut doubles = Vec::new();
        for (at, (newer, segment, other)) in placed.iter().enumerate() {
            let same = |(_, known, behind): &&(ExitId, Segment, AsrId)| {
                behind == other && super::discovery::is_same_exit(*known, *segment)
            };
            doubles.extend(placed[..at].iter().find(same).map(|(older, ..)| (*newer, *older)));
        }
        doubles
    }
}
