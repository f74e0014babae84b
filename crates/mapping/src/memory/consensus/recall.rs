use cogmap_geometry::{Metric, Pose};

use super::{
    Recognition, Relocation,
    alignment::Fit,
    hypothesis::{Hypothesis, Place, Remembered, Rules, Sight, fit_at},
    relocation::{guesses, same_place},
    surroundings::Elsewhere,
};
use crate::memory::{FrameId, Mfis, Way};

/// Loops are looked for in so many frames at most, the nearest along the links: memory for one's immediate
/// surroundings has an end (§2.2.2), and a step must not cost more the larger the map is.
const FRAMES: usize = 500;

/// The hypotheses beside the first: one, or several while the robot is lost.
#[derive(Clone, Debug, Default)]
pub(super) struct Recall {
    hypotheses: Vec<Hypothesis>,
    lost: Option<Lostness>,
    ways: Ways,
}

/// A robot that is lost looks into the frames from before, one after the other.
#[derive(Clone, Copy, Debug)]
struct Lostness {
    /// The first frame of what it has mapped since.
    since: FrameId,
    next: u32,
    examined: u32,
}

/// The ways from a frame to those around it, kept while they are the same.
#[derive(Clone, Debug, Default)]
struct Ways {
    from: Option<(FrameId, usize)>,
    all: Vec<(FrameId, Way)>,
}

impl Recall {
    /// The robot has moved: so has it in the old places, if that is where it is.
    pub(super) fn carry(&mut self, moved: Pose) {
        for Hypothesis { place, .. } in &mut self.hypotheses {
            place.frame_from_robot = place.frame_from_robot * moved;
            place.way += moved.position.norm();
        }
    }

    /// The robot is lost: what it maps from this frame on has no link to what was before.
    pub(super) fn lose(&mut self, since: FrameId) {
        self.hypotheses.clear();
        self.lost = Some(Lostness { since, next: 0, examined: 0 });
    }

    /// Follows the hypotheses, or looks for one; the place when it is believed.
    pub(super) fn consider(
        &mut self,
        sight: Sight<'_>,
        here: (FrameId, Pose),
        remembered: Remembered<'_>,
        rules: Rules<'_>,
    ) -> Option<Place> {
        if !rules.recognition.on {
            return None;
        }
        let place = match self.lost {
            Some(lost) => self.find_any(lost, sight, remembered, rules),
            None => self.find_near(sight, here, remembered, rules),
        };
        if place.is_some() {
            (self.hypotheses, self.lost) = (Vec::new(), None);
        }
        place
    }

    /// A loop: the place is about where the links say.
    fn find_near(
        &mut self,
        sight: Sight<'_>,
        here: (FrameId, Pose),
        remembered: Remembered<'_>,
        rules: Rules<'_>,
    ) -> Option<Place> {
        let Some(mut hypothesis) = self.hypotheses.pop() else {
            self.ways.update(remembered.mfis, here.0);
            self.hypotheses.extend(self.begin_near(sight, here, remembered, rules));
            return None;
        };
        let fit = hypothesis.follow(sight, remembered, rules)?;
        let Recognition { believe_views, believe_way, believe_fraction, .. } = *rules.recognition;
        let long_enough = hypothesis.views > believe_views && hypothesis.place.way >= believe_way;
        if long_enough && hypothesis.mean() >= believe_fraction && fit.rank == 3 {
            return Some(hypothesis.place);
        }
        self.hypotheses.push(hypothesis);
        None
    }

    /// Looks for an old place that the view fits, on a grid around where the robot would be in it.
    fn begin_near(
        &self,
        sight: Sight<'_>,
        (_, frame_from_robot): (FrameId, Pose),
        remembered: Remembered<'_>,
        rules: Rules<'_>,
    ) -> Option<Hypothesis> {
        let Recognition { radius, drift, radius_max, loop_length, .. } = *rules.recognition;
        let mut nearest: Option<(FrameId, Pose, f64, f64)> = None;
        let reach = radius_max + 2.0;
        let robot = frame_from_robot.position;
        // Most frames are too far off to be worth a turn of the pose.
        let may_be_near = |way: &Way| way.here_from_frame.position.distance_from(robot) < reach + 1e-6;
        for &(old, way) in self.ways.all.iter().filter(|(_, way)| may_be_near(way)) {
            let old_from_robot = way.here_from_frame.inverse() * frame_from_robot;
            let distance = old_from_robot.position.norm();
            let radius = (radius + drift * way.length).min(radius_max);
            let near = way.length > loop_length && distance < radius + 2.0;
            if near && nearest.is_none_or(|(.., least, _)| distance < least) {
                nearest = Some((old, old_from_robot, distance, radius));
            }
        }
        let (old, old_from_robot, _, radius) = nearest?;
        let known = remembered.around(old, rules);
        let fit = best_of(grid(old_from_robot, radius, rules.recognition), sight, &known, rules)?;
        let agreement = known.agreement(&sight.look.seen_from(fit.pose), rules.free_space);
        (agreement.contradiction() <= rules.recognition.contradiction)
            .then(|| Hypothesis::begin(old, &fit, agreement))
    }

    /// The robot is lost: any place may be the one.
    fn find_any(
        &mut self,
        mut lost: Lostness,
        sight: Sight<'_>,
        remembered: Remembered<'_>,
        rules: Rules<'_>,
    ) -> Option<Place> {
        self.hypotheses.retain_mut(|hypothesis| hypothesis.follow(sight, remembered, rules).is_some());
        let params = &rules.recognition.relocation;
        for _ in 0..params.frames.min(lost.since.0) {
            let old = FrameId(lost.next % lost.since.0);
            (lost.next, lost.examined) = (old.0 + 1, lost.examined + 1);
            if let Some(found) = begin_anywhere(old, sight, remembered, rules) {
                self.admit(found, remembered.mfis, params.rivals);
            }
        }
        self.lost = Some(lost);
        let thorough = lost.examined >= lost.since.0.min(params.examined);
        if thorough { self.undisputed(params) } else { None }
    }

    /// Follows a new hypothesis, unless it is followed already, or there are better ones enough.
    fn admit(&mut self, found: Hypothesis, mfis: &Mfis, rivals: usize) {
        let in_map = |place: &Place| mfis.map_from_frame(place.frame) * place.frame_from_robot;
        let at = in_map(&found.place);
        if self.hypotheses.len() < rivals
            && !self.hypotheses.iter().any(|other| same_place(in_map(&other.place), at))
        {
            self.hypotheses.push(found);
        }
    }

    /// The place that fits for long enough, and clearly better than any other.
    fn undisputed(&self, params: &Relocation) -> Option<Place> {
        let best = self.hypotheses.iter().max_by(|a, b| a.mean().total_cmp(&b.mean()))?;
        let rivals = self.hypotheses.iter().filter(|other| other.mean() > best.mean() - params.lead).count();
        let believed = best.mean() >= params.believe_fraction
            && best.contradiction() <= params.contradiction
            && best.views > params.believe_views
            && best.place.way >= params.believe_way;
        (believed && rivals == 1).then_some(best.place)
    }
}

impl Ways {
    fn update(&mut self, mfis: &Mfis, frame: FrameId) {
        let now = Some((frame, mfis.links().len()));
        if self.from != now {
            self.from = now;
            self.all = mfis.nearest_frames(frame).take(FRAMES).collect();
            self.all.sort_unstable_by_key(|(frame, _)| *frame);
        }
    }
}

/// Looks for the view anywhere in an old place.
fn begin_anywhere(
    old: FrameId,
    sight: Sight<'_>,
    remembered: Remembered<'_>,
    rules: Rules<'_>,
) -> Option<Hypothesis> {
    let known = remembered.around(old, rules);
    let params = &rules.recognition.relocation;
    let better = |best: Option<Hypothesis>, start: Pose| {
        let Some(fit) = fit_at(sight.lines, &known.lines, start, (params.begin_fraction, rules.alignment))
        else {
            return best;
        };
        let agreement = known.agreement(&sight.look.seen_from(fit.pose), rules.free_space);
        let fits = fit.fraction > params.begin_fraction
            && fit.matched > params.begin_length
            && fit.rank == 3
            && agreement.contradiction() <= rules.recognition.contradiction
            && best.as_ref().is_none_or(|best| fit.fraction > best.mean());
        if fits { Some(Hypothesis::begin(old, &fit, agreement)) } else { best }
    };
    guesses(sight.lines, &known.lines, params).into_iter().fold(None, better)
}

/// The poses to try around one.
#[allow(clippy::cast_possible_truncation, reason = "the radius is a few metres")]
fn grid(centre: Pose, radius: f64, params: &Recognition) -> impl Iterator<Item = Pose> {
    let (size, turn) = (params.grid, params.turn);
    let cells = (radius / size).ceil() as i32;
    (-cells..=cells)
        .flat_map(move |i| (-cells..=cells).map(move |j| (size * f64::from(i), size * f64::from(j))))
        .filter(move |(x, y)| x * x + y * y <= radius * radius)
        .flat_map(move |shift| [-turn, 0.0, turn].map(|turn| (shift, turn)))
        .map(move |((x, y), turn)| {
            Pose::new(centre.position.x + x, centre.position.y + y, centre.heading + turn)
        })
}

/// The fit from one of the starts that matches the longest part of the view.
fn best_of(
    starts: impl Iterator<Item = Pose>,
    sight: Sight<'_>,
    known: &Elsewhere,
    rules: Rules<'_>,
) -> Option<Fit> {
    let Recognition { begin_fraction, begin_length, .. } = *rules.recognition;
    starts
        .filter_map(|start| fit_at(sight.lines, &known.lines, start, (begin_fraction, rules.alignment)))
        .filter(|fit| fit.fraction > begin_fraction && fit.matched > begin_length && fit.rank == 3)
        .max_by(|a, b| a.matched.total_cmp(&b.matched))
}
