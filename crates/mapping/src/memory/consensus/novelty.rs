use cogmap_geometry::{Metric, trig};
use serde::{Deserialize, Serialize};

use super::{known::Known, line::Line};

/// What of a view is new. A longer sighting of a known wall is: it becomes another frozen surface.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Novelty {
    /// A surface is known when this share of it lies beside known ones.
    pub cover: f64,
    /// Beside means nearer than this, metres …
    pub distance: f64,
    /// … and turned less than this, radians.
    pub angle: f64,
    /// Shorter surfaces are debris, metres: they turn with the viewpoint.
    pub debris: f64,
    /// Debris is known when this share of it is covered …
    pub debris_cover: f64,
    /// … or other debris ends within this, metres.
    pub debris_distance: f64,
}

impl Default for Novelty {
    fn default() -> Self {
        Self {
            cover: 0.8,
            distance: 0.2,
            angle: 8.0 * trig::PI / 180.0,
            debris: 0.4,
            debris_cover: 0.3,
            debris_distance: 0.25,
        }
    }
}

pub(super) fn is_new(placed: &Line, known: &Known, params: &Novelty) -> bool {
    let facing = known.facing(placed.heading, params.angle).filter(|other| placed.may_be(other));
    let cover = placed.covered_by(facing, params.distance, params.angle) / placed.length;
    if placed.length >= params.debris {
        return cover < params.cover;
    }
    let beside = |other: &Line| {
        let nearest = other.a.distance_from(placed.a).min(other.b().distance_from(placed.b()));
        other.length < params.debris && nearest < params.debris_distance
    };
    cover < params.debris_cover && !known.all().any(beside)
}
