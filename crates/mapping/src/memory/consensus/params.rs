use cogmap_geometry::trig;
use serde::{Deserialize, Serialize};

use super::{Alignment, FreeSpace, Loss, Novelty, Reach, Recognition, Search};
use crate::{perception::Extraction, places::PlacesParams};

/// Every parameter of the consensus mapper.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct ConsensusParams {
    /// How points become surfaces.
    pub extraction: Extraction,
    /// How a view is laid onto what is remembered.
    pub alignment: Alignment,
    /// Where else to look when the view does not fit where odometry puts it.
    pub search: Search,
    /// How much of the memory is near.
    pub reach: Reach,
    /// What of a view is new.
    pub novelty: Novelty,
    /// When what two scans saw of free space contradicts itself.
    pub free_space: FreeSpace,
    /// When the robot notices that it was moved unseen.
    pub loss: Loss,
    /// How a place known before is found again.
    pub recognition: Recognition,
    /// How the map is shared out among local spaces.
    pub places: PlacesParams,
    /// Surfaces are placed each so many metres …
    pub place_distance: f64,
    /// … or each so many radians.
    pub place_turn: f64,
    /// A new local frame is opened this far from the origin of the last one, metres.
    pub frame_size: f64,
}

impl Default for ConsensusParams {
    fn default() -> Self {
        Self {
            extraction: Extraction::fine(),
            alignment: Alignment::default(),
            search: Search::default(),
            reach: Reach::default(),
            novelty: Novelty::default(),
            free_space: FreeSpace::default(),
            loss: Loss::default(),
            recognition: Recognition::default(),
            places: PlacesParams::recommended(),
            place_distance: 0.1,
            place_turn: 5.0 * trig::PI / 180.0,
            frame_size: 4.0,
        }
    }
}
