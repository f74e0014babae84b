use cogmap_mapping::Mapper;
use serde::{Deserialize, Serialize};

use crate::{
    Mode,
    route::Route,
    strategy::{Proposal, Situation, Wish},
};

/// What [`StrategySetup::Retrace`](crate::StrategySetup::Retrace) goes by.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct RetraceParams {
    /// How far the path may lie from the line between two waypoints, metres.
    pub tolerance: f64,
    /// A waypoint counts as passed from here, metres.
    pub passed: f64,
    /// Decisions in a row without a free way before it gives up.
    pub patience: usize,
}

impl Default for RetraceParams {
    fn default() -> Self {
        Self { tolerance: 0.1, passed: 0.25, patience: 10 }
    }
}

/// Goes back the way that the robot came, waypoint by waypoint. The thesis rejects it (§3.3.1): the
/// world keeps changing.
#[derive(Clone, Debug)]
pub(crate) struct Retrace {
    params: RetraceParams,
    route: Route,
    /// How many waypoints are still ahead.
    ahead: usize,
    blocked: usize,
}

impl Retrace {
    pub(crate) fn new(params: &RetraceParams, mapper: &Mapper) -> Self {
        let route = Route::of(mapper, params.tolerance);
        Self { params: params.clone(), route, ahead: usize::MAX, blocked: 0 }
    }

    pub(crate) fn decide(&mut self, situation: &Situation) -> Proposal {
        let waypoints = self.route.seen_from(situation.atlas);
        self.ahead = self.ahead.min(waypoints.len());
        let here = situation.belief.here_from_robot.position;
        while self.ahead > 1 && waypoints[self.ahead - 1].distance(here) <= self.params.passed {
            self.ahead -= 1;
        }
        let left = waypoints.get(..self.ahead).unwrap_or(&[]);
        let Some(&next) = left.last() else {
            return Proposal::new(Wish::GiveUp, Mode::Route, "no remembered way leads home".to_owned());
        };
        let free = situation.free_toward(next) >= situation.params.step_min;
        self.blocked = if free { 0 } else { self.blocked + 1 };
        let (wish, why) = if self.blocked > self.params.patience {
            (Wish::GiveUp, "something stands in the way that the robot came".to_owned())
        } else {
            (
                Wish::GoTo(next),
                format!("the way that the robot came leads over {} more waypoints", left.len()),
            )
        };
        let way = left.iter().rev().copied().collect();
        let waypoints = left.to_vec();
        Proposal { way, waypoints, ..Proposal::new(wish, Mode::Route, why) }
    }
}
