use cogmap_geometry::trig;
use serde::{Deserialize, Serialize};

use super::Relocation;

/// How a place known before is found again: views must fit an old place's own surfaces for a while,
/// as a second hypothesis beside the first, before the two places are linked.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Recognition {
    /// Whether to recognise at all.
    pub on: bool,
    /// Only places farther than this along the links can be come back to, metres.
    pub loop_length: f64,
    /// An old place is looked for within this, metres …
    pub radius: f64,
    /// … and this share of the way along the links: the map drifts …
    pub drift: f64,
    /// … but not farther than this, metres.
    pub radius_max: f64,
    /// Grid of the positions to try, metres.
    pub grid: f64,
    /// Turn to try to either side, radians.
    pub turn: f64,
    /// What is remembered within this along the links of the old place counts as its surfaces, metres.
    pub surroundings: f64,
    /// A hypothesis begins when this share of a view fits …
    pub begin_fraction: f64,
    /// … and so many metres of it do.
    pub begin_length: f64,
    /// It is believed when this share of the views fitted in the mean …
    pub believe_fraction: f64,
    /// … over so many views …
    pub believe_views: u32,
    /// … and so many metres of the way.
    pub believe_way: f64,
    /// It is dropped when less than this share of one view fits …
    pub drop_below: f64,
    /// … or more than this share of the beams contradicts what was seen free there; rooms that differ
    /// in size or shape do.
    pub contradiction: f64,
    /// How any old place is found again by a robot that is lost.
    pub relocation: Relocation,
}

impl Default for Recognition {
    fn default() -> Self {
        Self {
            on: true,
            loop_length: 15.0,
            radius: 0.7,
            drift: 0.03,
            radius_max: 5.0,
            grid: 0.7,
            turn: 7.0 * trig::PI / 180.0,
            surroundings: 12.0,
            begin_fraction: 0.62,
            begin_length: 2.5,
            believe_fraction: 0.58,
            believe_views: 2,
            believe_way: 1.0,
            drop_below: 0.4,
            contradiction: 0.2,
            relocation: Relocation::default(),
        }
    }
}
