use cogmap_geometry::Segment;
use serde::{Deserialize, Serialize};

/// How wide it is at a point of the way (§3.2.2, Fig. 3.14).
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Wideness {
    /// Metres of way since the first view, as the map has it.
    pub way: f64,
    /// Metres from what is on the left to what is on the right.
    pub width: f64,
    /// From what is on the left to what is on the right, in the map, metres.
    pub chord: Segment,
}
