use cogmap_geometry::{DVec2, Pose, trig};
use serde::{Deserialize, Serialize};

use super::{candidates::Candidates, information::Information, line::Line};
use crate::{
    memory::{Match, PairError, SurfaceId},
    perception::End,
};

/// How a view is laid onto what is remembered: which lines are paired, and how much a pair says.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Alignment {
    /// Lines farther apart than this are not the same, to begin with, metres; the gate shrinks.
    pub gate: f64,
    /// Lines turned more than this are not the same, to begin with, radians.
    pub gate_angle: f64,
    /// What the gate shrinks to, metres.
    pub gate_floor: f64,
    /// What the gate of the angle shrinks to, radians.
    pub gate_angle_floor: f64,
    /// Steps of Gauss and Newton at most.
    pub iterations: usize,
    /// A direction of the pose counts as determined from this much information on, 1/m² …
    pub information: f64,
    /// … and from this share of the best determined direction's: walls that are almost parallel do
    /// not tell how far along them the robot is.
    pub information_share: f64,
    /// Error of a remembered line's place beside its noise, metres.
    pub model_error: f64,
    /// Error of a true end beside the spacing of the beams, metres.
    pub end_error: f64,
    /// True ends farther apart than this are not the same, metres.
    pub end_gate: f64,
    /// A turn by a radian weighs as much as a shift by this, metres.
    pub lever: f64,
}

impl Default for Alignment {
    fn default() -> Self {
        Self {
            gate: 0.5,
            gate_angle: 15.0 * trig::PI / 180.0,
            gate_floor: 0.12,
            gate_angle_floor: 5.0 * trig::PI / 180.0,
            iterations: 10,
            information: 100.0,
            information_share: 0.01,
            model_error: 0.02,
            end_error: 0.04,
            end_gate: 0.25,
            lever: 3.0,
        }
    }
}

/// Where a view fits.
#[derive(Clone, Debug)]
pub(super) struct Fit {
    pub(super) pose: Pose,
    /// Metres of the view that lie on remembered lines.
    pub(super) matched: f64,
    /// The same as a share of the view.
    pub(super) fraction: f64,
    /// How many directions of the pose the pairs determine, 0 to 3.
    pub(super) rank: usize,
    /// The pairs.
    pub(super) matches: Vec<Match>,
}

/// The widest gates of a step: metres and radians.
#[derive(Clone, Copy)]
struct Gate {
    distance: f64,
    angle: f64,
}

/// A line of the view where it is placed, the remembered one, and the part of it beside that.
struct Pair<'a> {
    placed: Line,
    known: &'a Line,
    from: f64,
    to: f64,
}

/// Robustly finds the pose near `start` in which the view lies best on the remembered lines. `slack`
/// widens the gates, metres: a robot that was lost does not know well where to look.
pub(super) fn align(view: &[Line], near: &Candidates, start: Pose, slack: f64, params: &Alignment) -> Fit {
    let (mut pose, mut rank) = (start, 0);
    for iteration in 0..params.iterations {
        let information = gather(view, near, pose, gate_of(iteration, slack, params), params);
        let (step, directions) = information.step(params.information, params.information_share);
        rank = directions;
        let [x, y, turn] = step;
        pose = Pose::new(pose.position.x + x, pose.position.y + y, pose.heading + turn / params.lever);
        if iteration >= 3 && x.abs() + y.abs() + turn.abs() < 1e-5 {
            break;
        }
    }
    let gate = Gate { distance: params.gate_floor, angle: params.gate_angle_floor };
    let pairs = pair_up(view, near, pose, gate);
    let total: f64 = view.iter().map(|line| line.length).sum();
    let covered = |(index, line): (usize, &Line)| {
        line.seen_from(pose).covered_by(near.of(index), gate.distance, gate.angle)
    };
    let matched: f64 = view.iter().enumerate().map(covered).sum();
    let fraction = if total > 0.0 { matched / total } else { 0.0 };
    Fit { pose, matched, fraction, rank, matches: pairs.iter().map(Pair::as_match).collect() }
}

fn gate_of(iteration: usize, slack: f64, params: &Alignment) -> Gate {
    let factor = [1.0, 0.6].get(iteration).copied().unwrap_or(0.35);
    Gate {
        distance: (params.gate * factor).max(params.gate_floor) + slack * factor,
        angle: (params.gate_angle * factor).max(params.gate_angle_floor),
    }
}

fn pair_up<'a>(view: &[Line], near: &'a Candidates, pose: Pose, gate: Gate) -> Vec<Pair<'a>> {
    view.iter()
        .enumerate()
        .filter_map(|(index, line)| partner(line.seen_from(pose), near.of(index), gate))
        .collect()
}

/// The remembered line that a placed one fits best: near, parallel, and long beside it.
fn partner(placed: Line, near: &[Line], gate: Gate) -> Option<Pair<'_>> {
    let mut best: Option<(f64, Pair<'_>)> = None;
    for known in near {
        let turn = placed.turn_to(known);
        let Some((gap, from, to)) = placed.gap(known) else { continue };
        let too_short = to - from < (0.3 * placed.length).min(0.3);
        if turn > gate.angle || gap > gate.distance || too_short {
            continue;
        }
        let misfit = (gap / gate.distance + turn / gate.angle + 0.2) / (to - from).min(2.0);
        if best.as_ref().is_none_or(|(least, _)| misfit < *least) {
            best = Some((misfit, Pair { placed, known, from, to }));
        }
    }
    best.map(|(_, pair)| pair)
}

fn gather(view: &[Line], near: &Candidates, pose: Pose, gate: Gate, params: &Alignment) -> Information {
    let mut information = Information::default();
    for pair in pair_up(view, near, pose, gate) {
        let Pair { placed, known, from, to } = &pair;
        let variance = placed.variance + known.variance + params.model_error * params.model_error;
        for at in [*from, *to] {
            let point = placed.point(at);
            let measured = Measured { normal: known.along.perp(), residual: known.across(point), variance };
            measured.add_to(&mut information, point - pose.position, params.lever);
        }
        for (end, residual) in pair.shared_true_ends(gate, params) {
            let sigma = params.end_error + placed.spacing + known.spacing;
            let measured = Measured { normal: known.along, residual, variance: sigma * sigma };
            measured.add_to(&mut information, placed.end(end) - pose.position, params.lever);
        }
    }
    information
}

/// A distance that should be nothing.
struct Measured {
    normal: DVec2,
    residual: f64,
    variance: f64,
}

impl Measured {
    /// Weighs it robustly: what lies far off is likely something else.
    fn add_to(&self, information: &mut Information, arm: DVec2, lever: f64) {
        let gradient = [self.normal.x, self.normal.y, self.normal.dot(arm.perp()) / lever];
        let doubt = 1.0 + self.residual * self.residual / (6.0 * self.variance);
        information.add(gradient, self.residual, 1.0 / (self.variance * doubt));
    }
}

impl Pair<'_> {
    /// The ends that both saw as true ends, with their distance along the line.
    fn shared_true_ends(&self, gate: Gate, params: &Alignment) -> impl Iterator<Item = (usize, f64)> {
        (0..2).filter_map(move |end| {
            let both = self.placed.ends[end] == End::True && self.known.ends[end] == End::True;
            let apart = self.placed.end(end) - self.known.end(end);
            let residual = self.known.along.dot(apart);
            let same = residual.abs() <= params.end_gate && apart.length() <= params.end_gate + gate.distance;
            (both && same).then_some((end, residual))
        })
    }

    fn as_match(&self) -> Match {
        let [d1, d2] = [self.from, self.to].map(|at| self.known.across(self.placed.point(at)).abs());
        let phi = self.placed.turn_to(self.known);
        let fit = PairError { d1, d2, phi, error: d1.max(d2) };
        Match { seen: self.placed.tag as usize, previous: None, known: SurfaceId(self.known.tag), fit }
    }
}
