use cogmap_scene::{Colouring, MemoryOptions, TruthFit};
use serde::{Deserialize, Serialize};
use tsify::Tsify;

use crate::stance::Stance;

/// What is shown of the memories beside their surfaces.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, Tsify)]
#[serde(deny_unknown_fields)]
pub struct Layers {
    /// What the colours of the surfaces say.
    pub colours: Colours,
    /// The exits.
    pub exits: bool,
    /// The network of local spaces.
    pub network: bool,
    /// The world laid over the memory.
    pub truth: bool,
    /// What it is laid by.
    pub fit: Fit,
    /// What a robot on its way home has in mind.
    pub homing: bool,
    /// From where the memories are looked at.
    pub stance: Stance,
}

/// What the colour of a surface says.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, Tsify)]
#[serde(rename_all = "snake_case")]
pub enum Colours {
    /// Which view saw it first.
    View,
    /// Which local space it belongs to.
    Asr,
    /// How long ago it was first seen.
    Age,
}

/// What the world is laid over the memories by.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, Tsify)]
#[serde(rename_all = "snake_case")]
pub enum Fit {
    /// So that both agree about the first view.
    FirstView,
    /// So that the path in memory lies as near to the true one as it can.
    BestFit,
}

impl Default for Layers {
    fn default() -> Self {
        Self {
            colours: Colours::View,
            exits: true,
            network: true,
            truth: false,
            fit: Fit::FirstView,
            homing: true,
            stance: Stance::Map,
        }
    }
}

impl From<Layers> for MemoryOptions {
    fn from(layers: Layers) -> Self {
        let Layers { colours, exits, network, truth, fit, homing, stance: _ } = layers;
        let colouring = match colours {
            Colours::View => Colouring::View,
            Colours::Asr => Colouring::Asr,
            Colours::Age => Colouring::Age,
        };
        let truth_fit = match fit {
            Fit::FirstView => TruthFit::FirstView,
            Fit::BestFit => TruthFit::BestFit,
        };
        Self { truth, truth_fit, exits, network, homing, home: true, colouring, ..Self::default() }
    }
}
