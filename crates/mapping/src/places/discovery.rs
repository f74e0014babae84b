use std::collections::BTreeSet;

use cogmap_geometry::{DVec2, Metric, Pose, Segment, trig};

use super::{
    AsrId, Crossing, Exit, ExitId, Form, Now, Places,
    closing::Newcomer,
    passage::{self, Passage},
};
use crate::{Event, memory::SurfaceId, say};

/// A known exit is widened by so much on either side when the robot goes through it, metres.
const JAMB_ERROR: f64 = 0.2;
/// A narrow place is a known exit when their middles lie so near to each other, metres …
const SAME_EXIT: f64 = 0.6;
/// … and they are turned less than this against each other, radians.
const SAME_TURN: f64 = 40.0 * trig::PI / 180.0;

/// A known exit that the robot is going through; it may still turn back.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Pending {
    exit: ExitId,
    view: usize,
    way: f64,
    pub(super) at: DVec2,
}

impl Places {
    /// Notes whether the way from one point to the next goes through a known exit.
    pub(super) fn watch_known_exits(&mut self, from: DVec2, to: DVec2, view: usize) {
        let step = Segment::new(from, to);
        let crossed = self.exits_here().find_map(|exit| {
            let segment = self.nearby.here_from(exit.frame)? * exit.segment;
            let along = segment.direction()? * JAMB_ERROR;
            let at = step.crossing(Segment::new(segment.a - along, segment.b + along))?;
            Some((exit.id, at))
        });
        if let Some((exit, at)) = crossed {
            let way = self.trail.way();
            self.pending = Some(Pending { exit, view, way, at });
            self.since = way + self.params.narrowness.spacing;
        }
    }

    /// Goes over into the space behind a known exit once the robot is clear of it.
    pub(super) fn go_through_known(&mut self, now: Now<'_>) -> Vec<Event> {
        let Some(pending) = self.pending else { return Vec::new() };
        let Some(exit) = self.network.exit(pending.exit).copied() else { return Vec::new() };
        let Some(here_from_frame) = self.nearby.here_from(exit.frame) else { return Vec::new() };
        let segment = here_from_frame * exit.segment;
        let off = segment.offset_of(Self::robot(now)).unwrap_or(0.0);
        if off.abs() < self.params.narrowness.beyond || now.here.step <= pending.view {
            return Vec::new();
        }
        self.pending = None;
        let into = exit.between[usize::from(off > 0.0)];
        let left = self.network.current();
        if into == left {
            return Vec::new();
        }
        self.cross(now, (exit.id, segment), (pending.view, into));
        let why = say("the robot knew this exit: it leads back into ASR {}", &[(f64::from(into.0), 0)]);
        vec![Event::Exit { exit: exit.id, why }]
    }

    /// The robot is in another space since the view after the crossing; what it has seen since then is
    /// shared out anew.
    fn cross(
        &mut self,
        now: Now<'_>,
        (exit, segment): (ExitId, Segment),
        (view, into): (usize, AsrId),
    ) -> usize {
        let left = self.network.current();
        let behind = self.behind(now.memory, (left, view), segment);
        for &surface in &behind {
            self.network.assign(surface, into);
        }
        if self.params.form == Form::Recommended {
            self.claim(now, segment, (left, into), view + 1);
        }
        let robot_from_exit = self
            .here_from_robot_at(now.memory, view)
            .map_or(segment, |here_from_robot| here_from_robot.inverse() * segment);
        self.network.cross(Crossing { exit, into, view, step: now.here.step, robot_from_exit });
        behind.len()
    }

    /// Looks for a narrow place that the robot has gone through; behind it is another space.
    pub(super) fn go_through_new(&mut self, now: Now<'_>) -> Vec<Event> {
        let narrowness = &self.params.narrowness;
        self.trail.look_back(self.nearby.surfaces(), narrowness);
        let Some(passage) = passage::find(&self.trail, self.since, Self::robot(now), narrowness) else {
            return Vec::new();
        };
        if now.here.step <= passage.view {
            return Vec::new();
        }
        self.since = passage.way + narrowness.spacing;
        if let Some(exit) = self.known_exit_at(passage.segment) {
            let (view, way, at) = (passage.view, passage.way, passage.at);
            self.pending = Some(Pending { exit, view, way, at });
            return self.go_through_known(now);
        }
        let left = self.network.current();
        let behind = self.behind(now.memory, (left, passage.view), passage.segment);
        match self.space_behind(now, &passage, &behind) {
            Some(known) => self.link(now, &passage, known),
            None => self.open(now, &passage),
        }
    }

    fn known_exit_at(&self, passage: Segment) -> Option<ExitId> {
        let near = self.exits_here().filter_map(|exit| {
            let segment = self.nearby.here_from(exit.frame)? * exit.segment;
            let distance = segment.midpoint().distance_from(passage.midpoint());
            is_same_exit(segment, passage).then_some((distance, exit.id))
        });
        near.min_by(|a, b| a.0.total_cmp(&b.0)).map(|(_, exit)| exit)
    }

    fn exits_here(&self) -> impl Iterator<Item = &Exit> {
        self.nearby.exits.iter().filter_map(|&exit| self.network.exit(exit))
    }

    /// The space behind a passage, if the robot knows it, and how much of it says so: where it lies in the
    /// literal form (§3.2.3), whose surfaces the robot has recognised since it went through in ours.
    fn space_behind(&self, now: Now<'_>, passage: &Passage, behind: &[SurfaceId]) -> Option<(AsrId, f64)> {
        let left = self.network.current();
        match self.params.form {
            Form::Literal => self.overlapped(now, behind, left),
            Form::Recommended => {
                let new: BTreeSet<SurfaceId> = behind.iter().copied().collect();
                self.sightings
                    .most(passage.view + 1, &self.network, &new, (left, None))
                    .filter(|(_, share)| *share >= self.params.familiarity.known)
            }
        }
    }

    fn open(&mut self, now: Now<'_>, passage: &Passage) -> Vec<Event> {
        let entrance = entrance_of(passage.segment);
        let asr = self.network.open((now.here.frame, entrance), now.here.step);
        let (exit, moved) = self.join(now, passage, asr);
        self.newcomer = Some(Newcomer::new((asr, exit), passage.view, self.trail.way()));
        vec![exit_event(exit, passage), Event::NewAsr { asr, exit, moved }]
    }

    fn link(&mut self, now: Now<'_>, passage: &Passage, (asr, overlap): (AsrId, f64)) -> Vec<Event> {
        let (exit, _) = self.join(now, passage, asr);
        let why = say(
            "{} % of what is behind the exit belongs to ASR {}: the robot is back",
            &[(100.0 * overlap, 0), (f64::from(asr.0), 0)],
        );
        let closed = Event::LoopClosed { asr, instead_of: None, exit, overlap, why };
        vec![exit_event(exit, passage), closed]
    }

    fn join(&mut self, now: Now<'_>, passage: &Passage, asr: AsrId) -> (ExitId, usize) {
        let exit = self.network.add_exit(Exit {
            id: self.network.next_exit(),
            frame: now.here.frame,
            segment: passage.segment,
            between: [self.network.current(), asr],
            step: now.here.step,
            crossed: passage.view,
            jambs: passage.jambs,
        });
        self.nearby.exits.push(exit);
        self.confirm(passage.segment, exit);
        let moved = self.cross(now, (exit, passage.segment), (passage.view, asr));
        (exit, moved)
    }
}

/// Whether two exits lie at the same place.
pub(super) fn is_same_exit(one: Segment, other: Segment) -> bool {
    one.midpoint().distance_from(other.midpoint()) <= SAME_EXIT && one.angle_to(other) <= SAME_TURN
}

/// The pose of an entrance: the origin in the exit's middle, x along the normal into the space entered.
fn entrance_of(exit: Segment) -> Pose {
    let normal = (exit.b - exit.a).perp();
    let (middle, heading) = (exit.midpoint(), trig::atan2(normal.y, normal.x));
    Pose::new(middle.x, middle.y, heading)
}

fn exit_event(exit: ExitId, passage: &Passage) -> Event {
    let (width, jambs) = (passage.width(), passage.jambs);
    let wide = say("{} m wide and wider on both sides of it along the way", &[(width, 2)]);
    let why = wide.then(say("walls go on beside {} of its jambs", &[(f64::from(jambs), 0)]));
    Event::Exit { exit, why }
}
