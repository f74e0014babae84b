use cogmap_geometry::{Pose, trig};
use serde::{Deserialize, Serialize};

use super::{
    alignment::{Alignment, Fit, align},
    candidates::Candidates,
    line::Line,
    surroundings::Surroundings,
};
use crate::memory::{FrameId, Mfis};

/// How a place known before is found again: views must fit an old place's own surfaces for a while,
/// as a second hypothesis beside the first, before the two places are linked.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Recognition {
    /// Whether to recognise at all.
    pub on: bool,
    /// Only places farther than this along the links can be come back to, metres.
    pub loop_length: f64,
    /// An old place is looked for within this, metres …
    pub radius: f64,
    /// … and this share of the way along the links: the map drifts …
    pub drift: f64,
    /// … but not farther than this, metres.
    pub radius_max: f64,
    /// Grid of the positions to try, metres.
    pub grid: f64,
    /// Turn to try to either side, radians.
    pub turn: f64,
    /// What is remembered within this along the links of the old place counts as its surfaces, metres.
    pub surroundings: f64,
    /// A hypothesis begins when this share of a view fits …
    pub begin_fraction: f64,
    /// … and so many metres of it do.
    pub begin_length: f64,
    /// It is believed when this share of the views fitted in the mean …
    pub believe_fraction: f64,
    /// … over so many views …
    pub believe_views: u32,
    /// … and so many metres of the way.
    pub believe_way: f64,
    /// It is dropped when less than this share of one view fits.
    pub drop_below: f64,
}

impl Default for Recognition {
    fn default() -> Self {
        Self {
            on: true,
            loop_length: 15.0,
            radius: 0.7,
            drift: 0.03,
            radius_max: 5.0,
            grid: 0.7,
            turn: 7.0 * trig::PI / 180.0,
            surroundings: 12.0,
            begin_fraction: 0.62,
            begin_length: 2.5,
            believe_fraction: 0.58,
            believe_views: 3,
            believe_way: 1.8,
            drop_below: 0.4,
        }
    }
}

/// An old place, and where the robot is in it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Place {
    pub(super) frame: FrameId,
    pub(super) frame_from_robot: Pose,
    /// Metres that the hypothesis was followed before it was believed.
    pub(super) way: f64,
}

/// The second hypothesis, if there is one.
#[derive(Clone, Debug, Default)]
pub(super) struct Recall {
    hypothesis: Option<Hypothesis>,
}

#[derive(Clone, Debug)]
struct Hypothesis {
    place: Place,
    views: u32,
    fractions: f64,
}

impl Recall {
    /// The robot has moved: so has it in the old place, if that is where it is.
    pub(super) fn carry(&mut self, moved: Pose) {
        if let Some(Hypothesis { place, .. }) = &mut self.hypothesis {
            place.frame_from_robot = place.frame_from_robot * moved;
            place.way += moved.position.length();
        }
    }

    /// Follows the hypothesis, or looks for one; the place when it is believed.
    pub(super) fn consider(
        &mut self,
        view: &[Line],
        here: (FrameId, Pose),
        (mfis, surroundings): (&Mfis, &Surroundings),
        (params, alignment): (&Recognition, &Alignment),
    ) -> Option<Place> {
        if !params.on {
            return None;
        }
        if let Some(hypothesis) = self.hypothesis.take() {
            let known = surroundings.lines_elsewhere(mfis, hypothesis.place.frame, params.surroundings, 10.0);
            return self.follow(hypothesis, view, &known, (params, alignment));
        }
        self.hypothesis = begin(view, here, (mfis, surroundings), (params, alignment));
        None
    }

    fn follow(
        &mut self,
        mut hypothesis: Hypothesis,
        view: &[Line],
        known: &[Line],
        (params, alignment): (&Recognition, &Alignment),
    ) -> Option<Place> {
        let fit = fit_at(view, known, hypothesis.place.frame_from_robot, 0.0, alignment)?;
        hypothesis.place.frame_from_robot = fit.pose;
        hypothesis.views += 1;
        hypothesis.fractions += fit.fraction;
        let mean = hypothesis.fractions / f64::from(hypothesis.views);
        if fit.fraction < params.drop_below || mean < params.believe_fraction - 0.05 {
            return None;
        }
        let long_enough =
            hypothesis.views > params.believe_views && hypothesis.place.way >= params.believe_way;
        if long_enough && mean >= params.believe_fraction && fit.rank == 3 {
            return Some(hypothesis.place);
        }
        self.hypothesis = Some(hypothesis);
        None
    }
}

/// Looks for an old place that the view fits, on a grid around where the robot would be in it.
fn begin(
    view: &[Line],
    (frame, frame_from_robot): (FrameId, Pose),
    (mfis, surroundings): (&Mfis, &Surroundings),
    (params, alignment): (&Recognition, &Alignment),
) -> Option<Hypothesis> {
    let mut nearest: Option<(FrameId, Pose, f64, f64)> = None;
    for (old, way) in mfis.ways_from(frame, f64::INFINITY) {
        let old_from_robot = way.here_from_frame.inverse() * frame_from_robot;
        let distance = old_from_robot.position.length();
        let radius = (params.radius + params.drift * way.length).min(params.radius_max);
        let near = way.length > params.loop_length && distance < radius + 2.0;
        if near && nearest.is_none_or(|(.., least, _)| distance < least) {
            nearest = Some((old, old_from_robot, distance, radius));
        }
    }
    let (old, old_from_robot, _, radius) = nearest?;
    let known = surroundings.lines_elsewhere(mfis, old, params.surroundings, 10.0);
    let fit = best_on_grid(view, &known, (old_from_robot, radius), (params, alignment))?;
    let place = Place { frame: old, frame_from_robot: fit.pose, way: 0.0 };
    Some(Hypothesis { place, views: 1, fractions: fit.fraction })
}

#[allow(clippy::cast_possible_truncation, reason = "the radius is a few metres")]
fn best_on_grid(
    view: &[Line],
    known: &[Line],
    (centre, radius): (Pose, f64),
    (params, alignment): (&Recognition, &Alignment),
) -> Option<Fit> {
    let cells = (radius / params.grid).ceil() as i32;
    let mut best: Option<Fit> = None;
    for (i, j) in (-cells..=cells).flat_map(|i| (-cells..=cells).map(move |j| (i, j))) {
        let (x, y) = (params.grid * f64::from(i), params.grid * f64::from(j));
        if x * x + y * y > radius * radius {
            continue;
        }
        for turn in [-params.turn, 0.0, params.turn] {
            let start = Pose::new(centre.position.x + x, centre.position.y + y, centre.heading + turn);
            let fit = fit_at(view, known, start, params.begin_fraction, alignment).filter(|fit| {
                fit.fraction > params.begin_fraction && fit.matched > params.begin_length && fit.rank == 3
            });
            if let Some(fit) = fit
                && best.as_ref().is_none_or(|best| fit.matched > best.matched)
            {
                best = Some(fit);
            }
        }
    }
    best
}

/// How a view fits there; `None` where less than `least` of it could.
fn fit_at(view: &[Line], known: &[Line], start: Pose, least: f64, alignment: &Alignment) -> Option<Fit> {
    let near = Candidates::around(view, known, start, 1.3 * alignment.gate, 1.2 * alignment.gate_angle);
    (near.possible_fraction() >= least).then(|| align(view, &near, start, 0.0, alignment))
}
