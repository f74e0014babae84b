use cogmap_geometry::{DVec2, Pose, normalize_angle, trig};
use cogmap_simulation::{BodyParams, Command};
use serde::Deserialize;
use tsify::Tsify;

use crate::{failure::Failure, opening};

/// Share of the highest speed at which a person drives: fast enough to be fun, slow enough to steer.
const DRIVING_SHARE: f64 = 0.5;
/// Share of the highest turn rate at which a person turns.
const TURNING_SHARE: f64 = 0.22;
/// How far a nudge goes, metres.
const NUDGE: f64 = 0.5;
/// How far a nudge turns, radians.
const NUDGE_TURN: f64 = core::f64::consts::FRAC_PI_6;
/// Closer than this, in metres, there is nowhere to go.
const NEAR: f64 = 0.05;

/// What a person tells the robot, in terms that leave its speeds to the engine.
#[derive(Clone, Debug, PartialEq, Deserialize, Tsify)]
#[serde(tag = "kind", rename_all = "snake_case", deny_unknown_fields)]
pub enum Order {
    /// Drive until told otherwise.
    Steer {
        /// From −1, back, to 1, ahead.
        ahead: f64,
        /// From −1, right, to 1, left.
        left: f64,
    },
    /// A short step in one direction.
    Nudge {
        /// −1 back, 1 ahead, 0 neither.
        ahead: f64,
        /// −1 right, 1 left, 0 neither.
        left: f64,
    },
    /// Come to rest.
    Stop,
    /// Find the way home alone.
    GoHome {
        /// One of [`Choices::strategies`](crate::Choices::strategies).
        strategy: String,
    },
}

impl Order {
    /// What the robot of that body is told.
    pub(crate) fn command(self, body: &BodyParams) -> Result<Command, Failure> {
        Ok(match self {
            Self::Steer { ahead, left } => Command::Drive {
                linear: share(ahead) * DRIVING_SHARE * body.max_speed,
                angular: share(left) * TURNING_SHARE * body.max_turn_rate,
            },
            Self::Nudge { ahead, left } => {
                Command::Step { turn: share(left) * NUDGE_TURN, travel: share(ahead) * NUDGE }
            }
            Self::Stop => Command::Stop,
            Self::GoHome { strategy } => Command::GoHome { strategy: opening::strategy(&strategy)? },
        })
    }
}

/// The thesis's movement step (§3.1.3) from where the robot is to a point of the world; `None` if it is there.
pub(crate) fn step_to(point: DVec2, world_from_robot: Pose) -> Option<Command> {
    let way = point - world_from_robot.position;
    let travel = way.length();
    let turn = normalize_angle(trig::atan2(way.y, way.x) - world_from_robot.heading);
    (travel.is_finite() && travel > NEAR).then_some(Command::Step { turn, travel })
}

/// A share between −1 and 1, whatever a page may send.
fn share(number: f64) -> f64 {
    if number.is_nan() { 0.0 } else { number.clamp(-1.0, 1.0) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use cogmap_geometry::trig::FRAC_PI_2;

    #[test]
    fn nothing_that_a_page_sends_exceeds_the_robot() {
        let body = BodyParams::default();
        for wild in [f64::NAN, f64::INFINITY, -1e300, 7.0] {
            let Ok(Command::Drive { linear, angular }) =
                (Order::Steer { ahead: wild, left: wild }).command(&body)
            else {
                panic!("steering drives");
            };
            assert!(linear.abs() <= body.max_speed && angular.abs() <= body.max_turn_rate);
        }
    }

    #[test]
    fn a_step_turns_to_the_point_and_travels_there() {
        let world_from_robot = Pose::new(1.0, 1.0, FRAC_PI_2);
        let Some(Command::Step { turn, travel }) = step_to(DVec2::new(3.0, 1.0), world_from_robot) else {
            panic!("there is a way to go");
        };
        assert!((turn + FRAC_PI_2).abs() < 1e-12 && (travel - 2.0).abs() < 1e-12);
    }

    #[test]
    fn there_is_no_step_to_where_the_robot_is_or_to_nowhere() {
        let here = Pose::new(1.0, 1.0, 0.0);
        assert_eq!(step_to(DVec2::new(1.0, 1.01), here), None);
        assert_eq!(step_to(DVec2::new(f64::NAN, 1.0), here), None);
        assert_eq!(step_to(DVec2::new(f64::INFINITY, 1.0), here), None);
    }
}
