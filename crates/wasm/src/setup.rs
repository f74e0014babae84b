use cogmap_mapping::MapperSetup;
use cogmap_simulation::Robot;
use serde::{Deserialize, Serialize};
use tsify::Tsify;

/// What a run in a building is made of.
#[derive(Clone, Debug, Deserialize, Tsify)]
#[serde(deny_unknown_fields)]
pub struct Setup {
    /// The name of the world file, for messages.
    pub file: String,
    /// The text of the world file.
    pub world: String,
    /// One of [`Choices::robots`].
    pub robot: String,
    /// One of [`Choices::mappers`].
    pub mapper: String,
    /// Everything random comes from it.
    pub seed: u64,
}

/// What a file that somebody brought is to be run with, as far as it does not say so itself.
#[derive(Clone, Debug, Deserialize, Tsify)]
#[serde(deny_unknown_fields)]
pub struct Opening {
    /// The file's name.
    pub name: String,
    /// One of [`Choices::robots`], for a world.
    pub robot: String,
    /// One of [`Choices::mappers`], for a world or a log.
    pub mapper: String,
    /// The seed of a world's run.
    pub seed: u64,
}

/// The names that a [`Setup`] can hold, and what is chosen at first.
#[derive(Clone, Debug, Serialize, Tsify)]
pub struct Choices {
    /// The robots, best odometry first.
    pub robots: Vec<String>,
    /// The mappers.
    pub mappers: Vec<String>,
    /// The robot at first.
    pub robot: String,
    /// The mapper at first.
    pub mapper: String,
    /// The seed at first.
    pub seed: u64,
}

impl Choices {
    /// Everything that this version knows.
    pub(crate) fn all() -> Self {
        let names = |names: &[&str]| names.iter().map(|name| (*name).to_owned()).collect();
        let [mapper, ..] = MapperSetup::NAMES;
        let [.., robot] = Robot::NAMES;
        Self {
            robots: names(&Robot::NAMES),
            mappers: names(&MapperSetup::NAMES),
            robot: robot.to_owned(),
            mapper: mapper.to_owned(),
            seed: 1,
        }
    }
}
