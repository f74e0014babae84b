use cogmap_geometry::{Pose, trig};
use serde::{Deserialize, Serialize};

use super::{
    ConsensusParams,
    alignment::{Alignment, Fit, align},
    candidates::Candidates,
    line::Line,
};

/// Where else to look when the view does not fit where odometry puts it.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Search {
    /// Look elsewhere when less than this share of the view fits.
    pub search_below: f64,
    /// Believe odometry alone when less than this share fits anywhere.
    pub lost_below: f64,
    /// Turns to try to either side, radians.
    pub turns: [f64; 3],
    /// Shifts to try in each direction, metres.
    pub shift: f64,
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
            lost_below: 0.3,
            turns: [6.0 * degree, 12.0 * degree, 20.0 * degree],
            shift: 0.25,
            slack_per_step: 0.05,
            slack_max: 0.5,
        }
    }
}

/// Lays the view onto the remembered lines, beginning at `predicted`, and elsewhere around it if it
/// fits badly there; keeps what fits the longest part of the view.
pub(super) fn locate(
    view: &[Line],
    known: &[Line],
    predicted: Pose,
    steps_lost: u32,
    params: &ConsensusParams,
) -> Fit {
    let slack = (params.search.slack_per_step * f64::from(steps_lost)).min(params.search.slack_max);
    let mut best = align_from(view, known, predicted, slack, &params.alignment);
    if best.fraction >= params.search.search_below {
        return best;
    }
    for start in starts(predicted, &params.search) {
        let fit = align_from(view, known, start, slack, &params.alignment);
        if fit.matched > best.matched * 1.05 + 0.1 {
            best = fit;
        }
    }
    best
}

fn align_from(view: &[Line], known: &[Line], start: Pose, slack: f64, params: &Alignment) -> Fit {
    let (reach, angle) = (1.5 * params.gate + slack, 1.3 * params.gate_angle);
    let near = Candidates::around(view, known, start, reach, angle);
    align(view, &near, start, slack, params)
}

fn starts(predicted: Pose, search: &Search) -> impl Iterator<Item = Pose> {
    let turns = search.turns.into_iter().flat_map(|turn| [-turn, turn]).chain([0.0]);
    let s = search.shift;
    let shifts = [(0.0, 0.0), (s, 0.0), (-s, 0.0), (0.0, s), (0.0, -s)];
    turns.flat_map(move |turn| {
        shifts.into_iter().map(move |(x, y)| {
            Pose::new(predicted.position.x + x, predicted.position.y + y, predicted.heading + turn)
        })
    })
}
