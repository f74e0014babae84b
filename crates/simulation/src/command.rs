use serde::{Deserialize, Serialize};

use crate::{Strategy, WorldChange};

/// What a person or a program tells the robot.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(tag = "do", rename_all = "snake_case", deny_unknown_fields)]
pub enum Command {
    /// Drive at a velocity until told otherwise.
    Drive {
        /// Metres per second, forward positive.
        linear: f64,
        /// Radians per second, counter-clockwise positive.
        angular: f64,
    },
    /// The thesis's movement step (§3.1.3): turn, then travel, then scan.
    Step {
        /// Radians, counter-clockwise positive.
        turn: f64,
        /// Metres.
        travel: f64,
    },
    /// Come to rest, whatever was going on.
    Stop,
    /// Be picked up and set down at rest elsewhere: the wheels do not turn, so odometry does not notice.
    /// Refused where the robot does not fit.
    Kidnap {
        /// Where its middle is set down, metres.
        position: [f64; 2],
        /// Degrees, counter-clockwise from the x axis.
        #[serde(default)]
        heading_deg: f64,
    },
    /// Find the way home alone (§3.3), from rest; any other order to the robot ends it.
    GoHome {
        /// How.
        strategy: Strategy,
    },
    /// Not to the robot, which need not notice: something is changed around it. Refused where the robot
    /// or somebody stands in the way.
    Change(WorldChange),
}

/// A command and the tick at whose beginning it takes effect.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct TimedCommand {
    /// Ticks of [`TICK`](crate::TICK) seconds since the beginning.
    pub tick: u64,
    /// What to do.
    #[serde(flatten)]
    pub command: Command,
}
