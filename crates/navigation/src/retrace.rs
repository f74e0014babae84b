use cogmap_geometry::{DVec2, trig::PI};
use cogmap_mapping::{Mapper, say};
use serde::{Deserialize, Serialize};

use crate::{
    Mode,
    route::Route,
    steering,
    strategy::{Proposal, Situation, Wish},
};

/// So far aside of its way the robot goes round something small, radians.
const ASIDE: f64 = 80.0 * PI / 180.0;

/// What [`StrategySetup::Retrace`](crate::StrategySetup::Retrace) goes by.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct RetraceParams {
    /// How far the path may lie from the line between two waypoints, metres.
    pub tolerance: f64,
    /// A waypoint counts as passed from here, metres.
    pub passed: f64,
    /// A waypoint that something stands on is left out from here, metres, once the next lies open.
    pub around: f64,
    /// Decisions in a row that bring it no nearer before it gives up.
    pub patience: usize,
}

impl Default for RetraceParams {
    fn default() -> Self {
        Self { tolerance: 0.1, passed: 0.25, around: 1.2, patience: 12 }
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
    /// The nearest that the robot has come to the next one, and the decisions since, metres.
    nearest: f64,
    blocked: usize,
}

impl Retrace {
    pub(crate) fn new(params: &RetraceParams, mapper: &Mapper) -> Self {
        let route = Route::of(mapper, params.tolerance);
        Self { params: params.clone(), route, ahead: usize::MAX, nearest: f64::INFINITY, blocked: 0 }
    }

    pub(crate) fn decide(&mut self, situation: &Situation) -> Proposal {
        let waypoints = self.route.seen_from(situation.atlas);
        self.pass(situation, &waypoints);
        let left = waypoints.get(..self.ahead).unwrap_or(&[]);
        let Some(&next) = left.last() else {
            return Proposal::new(Wish::GiveUp, Mode::Route, say("no remembered way leads home", &[]));
        };
        self.count(next.distance(situation.belief.here_from_robot.position));
        let wish = match steering::toward(situation, &[next], ASIDE) {
            _ if self.blocked > self.params.patience => Wish::GiveUp,
            Some(wish) => wish,
            None => Wish::GoTo(next),
        };
        let why = match wish {
            Wish::GiveUp => say("something stands in the way that the robot came", &[]),
            _ => say(
                "the robot goes back the way that it came: the next of {} waypoints is {} m away",
                &[(left.len() as f64, 0), (next.distance(situation.belief.here_from_robot.position), 1)],
            ),
        };
        let way = left.iter().rev().copied().collect();
        let waypoints = left.to_vec();
        Proposal { way, waypoints, ..Proposal::new(wish, Mode::Route, why) }
    }

    /// Forgets the waypoints that are passed: near enough, or the one behind them lies open while
    /// something small stands on them.
    fn pass(&mut self, situation: &Situation, waypoints: &[DVec2]) {
        let here = situation.belief.here_from_robot.position;
        let open = |point: DVec2| situation.free_toward(point) >= here.distance(point) - 0.05;
        let before = self.ahead.min(waypoints.len());
        self.ahead = before;
        while self.ahead > 1 {
            let [next, behind] = [waypoints[self.ahead - 1], waypoints[self.ahead - 2]];
            let near = next.distance(here) <= self.params.passed;
            let taken = next.distance(here) < self.params.around && !open(next) && open(behind);
            if !near && !taken {
                break;
            }
            self.ahead -= 1;
        }
        if self.ahead < before {
            (self.blocked, self.nearest) = (0, f64::INFINITY);
        }
    }

    /// Counts the decisions since the robot last came nearer to the next waypoint.
    fn count(&mut self, distance: f64) {
        if distance < self.nearest - 0.05 {
            (self.nearest, self.blocked) = (distance, 0);
        } else {
            self.blocked += 1;
        }
    }
}
