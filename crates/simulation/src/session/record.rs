use cogmap_mapping::MapperSetup;
use serde::{Deserialize, Serialize};

use crate::{Robot, TimedCommand, World};

/// Everything that a run depends on; running it again gives the same bytes.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct SessionRecord {
    /// Always `cogmap-session/1`.
    pub format: String,
    /// The version of the program that made it.
    pub engine: String,
    /// What the laser and the odometry read.
    pub source: Source,
    /// The mappers, each fed the same readings.
    pub mappers: Vec<MapperSetup>,
    /// Everything random comes from it.
    pub seed: u64,
}

/// Where a run's readings come from.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(tag = "from", rename_all = "snake_case", deny_unknown_fields)]
#[allow(clippy::large_enum_variant, reason = "there is one a session")]
pub enum Source {
    /// A robot driven through a world.
    World {
        /// The building.
        world: World,
        /// The robot.
        robot: Robot,
        /// What it was told, in order of time.
        commands: Vec<TimedCommand>,
        /// How long it ran, in ticks.
        ticks: u64,
    },
    /// A recorded log.
    Log {
        /// Where the log was found.
        path: String,
        /// SHA-256 of the file as it was read, in hexadecimal.
        sha256: String,
        /// Keep a scan each so many metres or radians; `None` keeps all.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        every: Option<f64>,
        /// Factor of the noise added to its odometry; 0 adds none.
        #[serde(default)]
        odometry_noise: f64,
    },
}
