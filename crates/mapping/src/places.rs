//! Building a network of ASRs (§3.2.2): local spaces, and the exits that join them.
//!
//! [`Places`] follows the robot through the map that a mapper builds and shares it out among spaces. It
//! reads the memory and never writes to it: closing a loop changes the network, not the map.

mod asr;
mod exit;
mod network;
mod wideness;

pub use asr::{Asr, AsrId};
pub use exit::{Exit, ExitId};
pub use network::Network;
pub use wideness::Wideness;

use serde::{Deserialize, Serialize};

use crate::{Event, StepReport, memory::Memory};

/// Every parameter of the network of ASRs.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct PlacesParams {}

/// What one view brought to the network.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct PlaceReport {
    /// The space in which the robot believes to be.
    pub asr: AsrId,
    /// How wide it was on the way since the last view, in order.
    pub wideness: Vec<Wideness>,
    /// What changed in the network, in order: [`Event::Exit`], [`Event::NewAsr`], [`Event::LoopClosed`].
    pub events: Vec<Event>,
}

/// The robot's sense of place: watches how wide it is along the way, and keeps the network.
#[derive(Clone, Debug, PartialEq)]
pub struct Places {
    params: PlacesParams,
    network: Network,
}

impl Places {
    /// One space without exits, in which the robot begins.
    #[must_use]
    pub fn new(params: &PlacesParams) -> Self {
        Self { params: *params, network: Network::default() }
    }

    /// The spaces and exits found so far.
    #[must_use]
    pub fn network(&self) -> &Network {
        &self.network
    }

    /// Takes in a view that the mapper has integrated.
    pub(crate) fn follow(&mut self, report: &StepReport, memory: &Memory) -> PlaceReport {
        let asr = self.network.current();
        self.network.assign(&report.placed, asr);
        self.network.note_step(memory.path().len(), asr);
        PlaceReport { asr, wideness: Vec::new(), events: Vec::new() }
    }
}
