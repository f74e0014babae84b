use cogmap_mapping::MapperSetup;
use cogmap_simulation::{Robot, Strategy};
use serde::{Deserialize, Serialize};
use tsify::Tsify;

use crate::layers::Layers;

/// What a run in a building is made of.
#[derive(Clone, Debug, Deserialize, Tsify)]
#[serde(deny_unknown_fields)]
pub struct Setup {
    /// The name of the world file, for messages.
    pub file: String,
    /// The text of the world file, or `generated:SEED` for an office floor made from that seed.
    pub world: String,
    /// One of [`Choices::robots`].
    pub robot: String,
    /// One to four of [`Choices::mappers`], each once: their memories are shown side by side.
    pub mappers: Vec<String>,
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
    /// One to four of [`Choices::mappers`], for a world or a log.
    pub mappers: Vec<String>,
    /// The seed of a world's run.
    pub seed: u64,
    /// Metres a pixel, of a floor plan that does not say it.
    #[tsify(optional)]
    pub resolution: Option<f64>,
    /// The name of the file beside it.
    #[tsify(optional)]
    pub beside: Option<String>,
}

/// What the page opens with, as the command line does.
const FIRST_MAPPER: &str = "consensus";
/// How the robot goes home unless somebody chooses otherwise.
const FIRST_STRATEGY: &str = "recommended";

/// The names that a [`Setup`] can hold, and what is chosen at first.
#[derive(Clone, Debug, Serialize, Tsify)]
pub struct Choices {
    /// The robots, best odometry first.
    pub robots: Vec<String>,
    /// The mappers.
    pub mappers: Vec<String>,
    /// The ways of going home, by name.
    pub strategies: Vec<String>,
    /// The robot at first.
    pub robot: String,
    /// The mapper at first.
    pub mapper: String,
    /// The way of going home at first.
    pub strategy: String,
    /// The seed at first.
    pub seed: u64,
    /// What is shown at first.
    pub layers: Layers,
}

impl Choices {
    /// Everything that this version knows.
    pub(crate) fn all() -> Self {
        let names = |names: &[&str]| names.iter().map(|name| (*name).to_owned()).collect();
        let [.., robot] = Robot::NAMES;
        Self {
            robots: names(&Robot::NAMES),
            mappers: names(&MapperSetup::NAMES),
            strategies: names(&Strategy::names()),
            robot: robot.to_owned(),
            mapper: FIRST_MAPPER.to_owned(),
            strategy: FIRST_STRATEGY.to_owned(),
            seed: 1,
            layers: Layers::default(),
        }
    }
}
