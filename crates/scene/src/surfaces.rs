use cogmap_mapping::{Mapper, memory::StoredSurface};
use serde::{Deserialize, Serialize};

use crate::{HomingMark, Item, PlaceMark, Role, Shape};

/// What the colour of a surface says.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Colouring {
    /// Which view saw it first.
    #[default]
    View,
    /// Which local space it belongs to; without local spaces, which view saw it first.
    Asr,
    /// How long ago it was first seen.
    Age,
}

/// Surfaces below this are thin, metres.
const DEBRIS: f64 = 0.4;

/// What a mapper remembers: what the robot does not go by below, then debris, so that walls lie above
/// it; oldest first.
pub(crate) fn surfaces(
    mind: &Mapper,
    colouring: Colouring,
    is_trusted: &dyn Fn(&StoredSurface) -> bool,
) -> Vec<Item> {
    let (trusted, forgotten): (Vec<_>, Vec<_>) =
        mind.mfis().remembered().partition(|surface| is_trusted(surface));
    let (debris, long): (Vec<_>, Vec<_>) =
        trusted.into_iter().partition(|surface| surface.segment.length() < DEBRIS);
    let mut items = Vec::new();
    if !forgotten.is_empty() {
        let segments = forgotten.iter().map(|surface| mind.mfis().in_map(surface)).collect();
        items.push(Item::new(Role::Homing(HomingMark::Forgotten), Shape::Segments(segments)));
    }
    for surfaces in [debris, long] {
        let role = |surface: &StoredSurface| role(surface, mind, colouring);
        let item = |run: &[&StoredSurface]| {
            let segments = run.iter().map(|surface| mind.mfis().in_map(surface)).collect();
            Some(Item::new(role(run.first()?), Shape::Segments(segments)))
        };
        items.extend(surfaces.chunk_by(|a, b| role(a) == role(b)).filter_map(item));
    }
    items
}

fn role(surface: &StoredSurface, mind: &Mapper, colouring: Colouring) -> Role {
    let is_debris = surface.segment.length() < DEBRIS;
    let asr = || mind.network()?.asr_of(surface.id);
    match (colouring, asr()) {
        (Colouring::Age, _) => {
            let age = mind.path().len().saturating_sub(surface.step).max(1).ilog2();
            if is_debris { Role::DebrisOfAge(age) } else { Role::SurfaceOfAge(age) }
        }
        (Colouring::Asr, Some(asr)) => {
            Role::Place(if is_debris { PlaceMark::Debris(asr.0) } else { PlaceMark::Surface(asr.0) })
        }
        _ if is_debris => Role::DebrisOfView(surface.step),
        _ => Role::SurfaceOfView(surface.step),
    }
}
