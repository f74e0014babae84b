use cogmap_geometry::{DVec2, Pose, trig};
use serde::{Deserialize, Serialize};

use super::{
    ConsensusParams,
    alignment::{Alignment, Fit, align},
    candidates::Candidates,
    known::Known,
    line::Line,
};

/// Where else to look when the view does not fit where odometry puts it.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Search {
    /// Look elsewhere when less than this share of the view fits …
    pub search_below: f64,
    /// … or when this share of what it saw of free space contradicts what was seen just before.
    pub search_contradiction: f64,
    /// When this share of the view fits, that is where the robot is.
    pub sure: f64,
    /// Believe odometry alone when less than this share fits anywhere …
    pub lost_below: f64,
    /// … and fewer metres than this either: in a doorway most of what is in view may be new.
    pub enough: f64,
    /// Turns to try to either side, radians.
    pub turns: [f64; 4],
    /// Shifts to try in each direction, metres.
    pub shifts: [f64; 2],
    /// Lines of a try are compared when they are nearer than this, metres …
    pub near: f64,
    /// … and turned less than this, radians.
    pub near_angle: f64,
    /// So many of the most promising tries are followed up.
    pub followed: usize,
    /// The gates widen by this with each step lost, metres …
    pub slack_per_step: f64,
    /// … up to this.
    pub slack_max: f64,
}

impl Default for Search {
    fn default() -> Self {
        let degree = trig::PI / 180.0;
        Self {
            search_below: 0.6,
            search_contradiction: 0.2,
            sure: 0.8,
            lost_below: 0.3,
            enough: 0.7,
            turns: [6.0 * degree, 12.0 * degree, 20.0 * degree, 30.0 * degree],
            shifts: [0.25, 0.5],
            near: 0.3,
            near_angle: 8.0 * degree,
            followed: 8,
            slack_per_step: 0.05,
            slack_max: 0.5,
        }
    }
}

impl Search {
    /// Whether enough of the view fits to believe it.
    pub(super) fn believes(&self, fit: &Fit) -> bool {
        fit.fraction >= self.lost_below || fit.matched >= self.enough
    }
}

/// Lays the view onto the remembered lines, beginning at `predicted`, and elsewhere around it if it
/// fits badly there; keeps what fits the longest part of the view and contradicts the least of what
/// was seen of free space just before. `contradiction` tells that share for a pose.
pub(super) fn locate(
    view: &[Line],
    known: &Known,
    (predicted, steps_lost): (Pose, u32),
    contradiction: impl Fn(Pose) -> f64,
    params: &ConsensusParams,
) -> Fit {
    let search = &params.search;
    let slack = (search.slack_per_step * f64::from(steps_lost)).min(search.slack_max);
    let first = align_from(view, known, predicted, slack, &params.alignment);
    if first.fraction >= search.sure {
        return first;
    }
    let doubt = contradiction(first.pose);
    if first.fraction >= search.search_below && doubt <= search.search_contradiction {
        return first;
    }
    let mut best = (worth(&first, doubt), first);
    for start in most_promising(view, known, predicted, search) {
        let fit = align_from(view, known, start, slack, &params.alignment);
        let worth = worth(&fit, contradiction(fit.pose));
        if worth > best.0 * 1.05 + 0.1 {
            best = (worth, fit);
        }
    }
    best.1
}

/// Metres of the view that fit, less where free space contradicts the pose.
fn worth(fit: &Fit, contradiction: f64) -> f64 {
    fit.matched * (1.0 - contradiction)
}

/// Lays the view onto the remembered lines, beginning at `start` only.
pub(super) fn align_from(view: &[Line], known: &Known, start: Pose, slack: f64, params: &Alignment) -> Fit {
    let (reach, angle) = (1.5 * params.gate + slack, 1.3 * params.gate_angle);
    let near = Candidates::around(view, known, start, reach, angle);
    align(view, &near, start, slack, params)
}

/// The starts from which the longest part of the view lies near remembered lines, best first.
fn most_promising(view: &[Line], known: &Known, predicted: Pose, search: &Search) -> Vec<Pose> {
    let near = |start| beside(view, known, start, (search.near, search.near_angle));
    let mut starts: Vec<(f64, Pose)> = starts(predicted, search).map(|start| (near(start), start)).collect();
    starts.sort_by(|a, b| b.0.total_cmp(&a.0));
    starts.into_iter().take(search.followed).map(|(_, start)| start).collect()
}

/// Metres of the view that lie beside remembered lines when the robot is there: nearer than the first
/// and turned less than the second of the gates.
pub(super) fn beside(view: &[Line], known: &Known, pose: Pose, (near, angle): (f64, f64)) -> f64 {
    let beside = |line: &Line| {
        let placed = line.seen_from(pose);
        placed.covered_by(known.facing(placed.heading, angle), near, angle)
    };
    view.iter().map(beside).sum()
}

fn starts(predicted: Pose, search: &Search) -> impl Iterator<Item = Pose> {
    let turns = search.turns.into_iter().flat_map(|turn| [-turn, turn]).chain([0.0]);
    let around = |s: f64| [(s, 0.0), (-s, 0.0), (0.0, s), (0.0, -s)];
    let shifts = search.shifts.into_iter().flat_map(around).chain([(0.0, 0.0)]);
    let shifts: Vec<DVec2> = shifts.map(DVec2::from).collect();
    turns.flat_map(move |turn| {
        let starts: Vec<Pose> = shifts
            .iter()
            .map(|shift| predicted.position + *shift)
            .map(|at| Pose::new(at.x, at.y, predicted.heading + turn))
            .collect();
        starts
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_doorway_s_jambs_are_enough_to_believe_where_the_rest_of_the_view_is_new() {
        let fit = |fraction, matched| Fit {
            pose: Pose::IDENTITY,
            matched,
            fraction,
            rank: 3,
            open: None,
            matches: Vec::new(),
        };
        let search = Search::default();
        assert!(search.believes(&fit(0.35, 0.4)) && search.believes(&fit(0.2, 1.2)));
        assert!(!search.believes(&fit(0.2, 0.4)));
    }
}
