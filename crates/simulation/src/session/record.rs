use cogmap_mapping::MapperSetup;
use serde::{Deserialize, Serialize};

use crate::{Command, Robot, TimedCommand, World};

/// The format that this version writes and reads.
pub const SESSION_FORMAT: &str = "cogmap-session/1";

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
    /// Whose belief leads the robot home where it is not the first mapper's: the one that led it when the
    /// run was driven.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub navigator: Option<MapperSetup>,
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

impl SessionRecord {
    /// A run that has not begun.
    #[must_use]
    pub fn new(source: Source, mappers: Vec<MapperSetup>, seed: u64) -> Self {
        let engine = env!("CARGO_PKG_VERSION").to_owned();
        Self { format: SESSION_FORMAT.to_owned(), engine, source, mappers, navigator: None, seed }
    }

    /// The same run for other mappers. A robot that went home goes the same way again: it still believes
    /// what it believed then.
    #[must_use]
    pub fn with_mappers(&self, mappers: Vec<MapperSetup>) -> Self {
        let navigator = self.navigator.clone().or_else(|| self.mappers.first().cloned());
        let led = self.commands().iter().any(|timed| matches!(timed.command, Command::GoHome { .. }));
        let navigator = navigator.filter(|navigator| led && mappers.first() != Some(navigator));
        Self { mappers, navigator, ..self.clone() }
    }

    /// What the robot was told; a log's robot was told nothing.
    #[must_use]
    pub fn commands(&self) -> &[TimedCommand] {
        match &self.source {
            Source::World { commands, .. } => commands,
            Source::Log { .. } => &[],
        }
    }

    /// Adds a command at `tick` and ends there what had been recorded; `false` for logs. A velocity
    /// or a stop that holds already is not written down again. At one tick the last order to the robot
    /// counts; with `also` the changes of the world that were told at this tick count as well.
    pub(super) fn tell(&mut self, tick: u64, command: Command, also: bool) -> bool {
        let Source::World { commands, ticks, .. } = &mut self.source else { return false };
        let told = |timed: &TimedCommand| timed.tick == tick && also;
        let change = matches!(command, Command::Change(_));
        commands.retain(|timed| {
            timed.tick < tick || told(timed) && (change || matches!(timed.command, Command::Change(_)))
        });
        *ticks = tick;
        let holds = matches!(command, Command::Drive { .. } | Command::Stop)
            && commands.last().is_some_and(|last| last.command == command);
        if !holds {
            commands.push(TimedCommand { tick, command });
        }
        true
    }

    pub(super) fn lasts_at_least(&mut self, position: u64) {
        if let Source::World { ticks, .. } = &mut self.source {
            *ticks = position.max(*ticks);
        }
    }
}

impl Source {
    /// A world with a robot that has not been told anything yet.
    #[must_use]
    pub fn world(world: World, robot: Robot) -> Self {
        Self::World { world, robot, commands: Vec::new(), ticks: 0 }
    }
}
