use cogmap_geometry::{DVec2, Pose, Segment, trig};

use super::planner::{CLEARANCE, Planner};
use crate::{BodyParams, OdometryErrors, Robot};

/// The pieces that a step is looked at in, metres.
const PIECE: f64 = 0.05;
/// How many standard deviations of slip the person reckons with.
const SIGMAS: f64 = 3.0;

/// How far a robot may end up from where it was sent: what the person at the controls has learnt
/// from watching it.
#[derive(Clone, Debug)]
pub(super) struct Caution {
    body: BodyParams,
    errors: OdometryErrors,
}

impl Caution {
    pub(super) fn about(robot: &Robot) -> Self {
        Self { body: robot.body.clone(), errors: robot.odometry.clone() }
    }

    /// Metres off the line, `way` metres after a turn.
    pub(super) fn error(&self, turn: f64, way: f64) -> f64 {
        let OdometryErrors { left_radius, right_radius, axle, slip } = self.errors;
        let slipped = |rolled: f64| SIGMAS * slip * (2.0 * rolled.abs()).sqrt() / self.body.axle;
        let wrong_turn = axle.abs() * turn.abs() + slipped(turn * self.body.axle / 2.0);
        let bend = (right_radius - left_radius).abs() * way / self.body.axle;
        // A heading that walks at random to ±1 carries the robot off by ±1/√3 on average.
        let aside = way * (wrong_turn + bend / 2.0 + slipped(way) / 3.0_f64.sqrt());
        let ahead = way * left_radius.abs().max(right_radius.abs()) + SIGMAS * slip * (way / 2.0).sqrt();
        aside + ahead
    }

    /// Whether a step surely keeps its distance from everything.
    pub(super) fn allows(&self, pose: Pose, turn: f64, travel: f64, planner: &Planner) -> bool {
        let (sin, cos) = trig::sin_cos(pose.heading + turn);
        let at = |way: f64| pose.position + DVec2::new(cos, sin) * way;
        let gap = planner.room_at(pose.position) - self.body.radius;
        let margin = CLEARANCE.min(0.8 * gap);
        let pieces = (travel / PIECE).ceil().max(1.0);
        (0..pieces as u32).all(|k| {
            let [near, far] = [f64::from(k), f64::from(k) + 1.0].map(|piece| travel * piece / pieces);
            let keep = self.body.radius + margin + self.error(turn, far);
            gap > 0.0 && planner.obstacles.leaves_free(Segment::new(at(near), at(far)), keep)
        })
    }
}
