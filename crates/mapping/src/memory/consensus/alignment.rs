use cogmap_geometry::{DVec2, Metric, Pose, trig};
use serde::{Deserialize, Serialize};

use super::{
    candidates::Candidates,
    information::{Information, Step},
    line::Line,
};
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
    /// Steps of Gauss and Newton at most, each with lines paired anew …
    pub iterations: usize,
    /// … and with the last pairs, until the pose is where they want it, whatever it began with.
    pub refinements: usize,
    /// Whether all pairs speak together, or only the longest.
    pub all_references: bool,
    /// A residual this many times its variance, squared, counts half: what lies far off is likely
    /// something else.
    pub doubt: f64,
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
            refinements: 20,
            all_references: true,
            doubt: 6.0,
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
    /// The direction in which the pairs leave the robot's place open, if that is one and not its heading.
    pub(super) open: Option<DVec2>,
    /// The pairs.
    pub(super) matches: Vec<Match>,
}

/// The widest gates of a step: metres and radians.
#[derive(Clone, Copy)]
struct Gate {
    distance: f64,
    angle: f64,
}

/// A pose changes less than this in a step when it has settled, metres; the pairs stay from then on …
const SETTLED: f64 = 1e-3;
/// … until it changes less than this.
const STILL: f64 = 1e-10;
/// So often the lines may be paired anew where the pose has settled.
const PAIRED_AGAIN: usize = 4;

/// A line of the view, the remembered one, and the part of the first that lies beside the second.
struct Pair<'a> {
    seen: &'a Line,
    placed: Line,
    known: &'a Line,
    from: f64,
    to: f64,
}

/// Robustly finds the pose near `start` in which the view lies best on the remembered lines. `slack`
/// widens the gates, metres: a robot that was lost does not well know where to look.
pub(super) fn align(view: &[Line], near: &Candidates, start: Pose, slack: f64, params: &Alignment) -> Fit {
    let mut pose = start;
    let mut iteration = 0;
    let mut gate = gate_of(iteration, slack, params);
    let mut pairs = pair_up(view, near, pose, gate, params);
    while iteration < params.iterations {
        let moved = step(&pairs, &mut pose, gate, params).by.iter().map(|x| x.abs()).sum::<f64>();
        iteration += 1;
        if iteration > 3 && moved < SETTLED {
            break;
        }
        gate = gate_of(iteration, slack, params);
        pairs = pair_up(view, near, pose, gate, params);
    }
    // The result must not depend on where the search began: it is where the pairs want the pose to be
    // that are found there.
    let mut last = settle(&mut pairs, &mut pose, gate, params);
    for _ in 0..PAIRED_AGAIN {
        let again = pair_up(view, near, pose, gate, params);
        if again.iter().map(Pair::names).eq(pairs.iter().map(Pair::names)) {
            break;
        }
        pairs = again;
        last = settle(&mut pairs, &mut pose, gate, params);
    }
    fit(view, near, pose, last, params)
}

/// Moves the pose to where these pairs want it.
fn settle(pairs: &mut [Pair<'_>], pose: &mut Pose, gate: Gate, params: &Alignment) -> Step {
    let mut last = Step { by: [0.0; 3], rank: 0, open: None };
    for _ in 0..params.refinements.max(1) {
        pairs.iter_mut().for_each(|pair| pair.place(*pose));
        last = step(pairs, pose, gate, params);
        if last.by.iter().all(|x| x.abs() < STILL) {
            break;
        }
    }
    last
}

/// Moves the pose by one step of Gauss and Newton.
fn step(pairs: &[Pair<'_>], pose: &mut Pose, gate: Gate, params: &Alignment) -> Step {
    let step = gather(pairs, *pose, gate, params).step(params.information, params.information_share);
    let [x, y, turn] = step.by;
    *pose = Pose::new(pose.position.x + x, pose.position.y + y, pose.heading + turn / params.lever);
    step
}

fn fit(view: &[Line], near: &Candidates, pose: Pose, step: Step, params: &Alignment) -> Fit {
    let gate = Gate { distance: params.gate_floor, angle: params.gate_angle_floor };
    let best = |(index, line)| {
        let misfit = |pair: &Pair<'_>| pair.misfit(gate);
        partners(line, pose, near.of(index), gate).min_by(|a, b| misfit(a).total_cmp(&misfit(b)))
    };
    let matches = view.iter().enumerate().filter_map(best).map(|pair| pair.as_match()).collect();
    let total: f64 = view.iter().map(|line| line.length).sum();
    let covered = |(index, line): (usize, &Line)| {
        line.seen_from(pose).covered_by(near.of(index), gate.distance, gate.angle)
    };
    let matched: f64 = view.iter().enumerate().map(covered).sum();
    let fraction = if total > 0.0 { matched / total } else { 0.0 };
    let open = step.open.filter(|_| step.rank == 2).map(|[x, y, _]| DVec2::new(x, y));
    let open = open.filter(|open| open.norm() > 0.5).map(Metric::unit_or_zero);
    Fit { pose, matched, fraction, rank: step.rank, open, matches }
}

fn gate_of(iteration: usize, slack: f64, params: &Alignment) -> Gate {
    let factor = [1.0, 0.6].get(iteration).copied().unwrap_or(0.35);
    Gate {
        distance: (params.gate * factor).max(params.gate_floor) + slack * factor,
        angle: (params.gate_angle * factor).max(params.gate_angle_floor),
    }
}

/// Every remembered line is held against every line of the view that it may be: a wall that was stored
/// piece by piece is where all of its pieces have it, not where the one has it that the guess is nearest to.
fn pair_up<'a>(
    view: &'a [Line],
    near: &'a Candidates,
    pose: Pose,
    gate: Gate,
    params: &Alignment,
) -> Vec<Pair<'a>> {
    let pairs = view.iter().enumerate().flat_map(|(index, line)| partners(line, pose, near.of(index), gate));
    if params.all_references {
        return pairs.collect();
    }
    pairs.max_by(|a, b| (a.to - a.from).total_cmp(&(b.to - b.from))).into_iter().collect()
}

/// The remembered lines that a line of the view may be: near, parallel, and long enough beside it.
fn partners<'a>(seen: &'a Line, pose: Pose, near: &'a [Line], gate: Gate) -> impl Iterator<Item = Pair<'a>> {
    let placed = seen.seen_from(pose);
    let least = (0.3 * placed.length).min(0.3);
    near.iter().filter(move |known| placed.turn_to(known) <= gate.angle).filter_map(move |known| {
        let (gap, from, to) = placed.gap(known)?;
        (gap <= gate.distance && to - from >= least).then_some(Pair { seen, placed, known, from, to })
    })
}

fn gather(pairs: &[Pair<'_>], pose: Pose, gate: Gate, params: &Alignment) -> Information {
    let mut information = Information::default();
    for pair in pairs {
        let Pair { placed, known, from, to, .. } = pair;
        let variance = placed.variance + known.variance + params.model_error * params.model_error;
        for at in [*from, *to] {
            let point = placed.point(at);
            let measured = Measured { normal: known.along.perp(), residual: known.across(point), variance };
            measured.add_to(&mut information, point - pose.position, params);
        }
        for (end, residual) in pair.shared_true_ends(gate, params) {
            let sigma = params.end_error + placed.spacing + known.spacing;
            let measured = Measured { normal: known.along, residual, variance: sigma * sigma };
            measured.add_to(&mut information, placed.end(end) - pose.position, params);
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
    fn add_to(&self, information: &mut Information, arm: DVec2, params: &Alignment) {
        let gradient = [self.normal.x, self.normal.y, self.normal.dot(arm.perp()) / params.lever];
        let doubt = 1.0 + self.residual * self.residual / (params.doubt * self.variance);
        information.add(gradient, self.residual, 1.0 / (self.variance * doubt));
    }
}

impl Pair<'_> {
    /// Which lines these are.
    fn names(&self) -> (u32, u32) {
        (self.seen.tag, self.known.tag)
    }

    /// The robot is there: so its line is elsewhere, and another part of it lies beside the known one.
    fn place(&mut self, pose: Pose) {
        self.placed = self.seen.seen_from(pose);
        if let Some((from, to)) = self.placed.beside(self.known) {
            (self.from, self.to) = (from, to);
        }
    }

    /// The ends that both saw as true ends, with their distance along the line.
    fn shared_true_ends(&self, gate: Gate, params: &Alignment) -> impl Iterator<Item = (usize, f64)> {
        (0..2).filter_map(move |end| {
            let both = self.placed.ends[end] == End::True && self.known.ends[end] == End::True;
            let apart = self.placed.end(end) - self.known.end(end);
            let residual = self.known.along.dot(apart);
            let same = residual.abs() <= params.end_gate && apart.norm() <= params.end_gate + gate.distance;
            (both && same).then_some((end, residual))
        })
    }

    /// How badly the two fit, the longer beside each other the less.
    fn misfit(&self, gate: Gate) -> f64 {
        let gap = [self.from, self.to].map(|at| self.known.across(self.placed.point(at)).abs());
        let turn = self.placed.turn_to(self.known);
        (gap[0].max(gap[1]) / gate.distance + turn / gate.angle + 0.2) / (self.to - self.from).min(2.0)
    }

    fn as_match(&self) -> Match {
        let [d1, d2] = [self.from, self.to].map(|at| self.known.across(self.placed.point(at)).abs());
        let phi = self.placed.turn_to(self.known);
        let fit = PairError { d1, d2, phi, error: d1.max(d2) };
        Match { seen: self.placed.tag as usize, previous: None, known: SurfaceId(self.known.tag), fit }
    }
}

#[cfg(test)]
mod tests;
