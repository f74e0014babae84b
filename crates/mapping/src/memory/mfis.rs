use cogmap_geometry::Segment;
use serde::{Deserialize, Serialize};

use crate::perception::End;

/// Names a surface of one MFIS, in the order of storing.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
pub struct SurfaceId(pub u32);

/// A surface as it was placed when it was first seen; it never changes (§3.2.1, the stable world).
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct StoredSurface {
    /// Its name.
    pub id: SurfaceId,
    /// Where it lies in the map, metres; the visible side as in the view.
    pub segment: Segment,
    /// Why it ended where it did in the view that placed it.
    pub ends: [End; 2],
    /// The view that first saw it.
    pub step: usize,
    /// Which surface of that view it was.
    pub index_in_view: usize,
}

/// The memory for one's immediate surroundings (§2.2.2): a map in a world-fixed frame. Surfaces are
/// added and never altered: there is no way to reach a stored one for writing.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Mfis {
    surfaces: Vec<StoredSurface>,
}

impl Mfis {
    /// Everything stored, oldest first.
    #[must_use]
    pub fn surfaces(&self) -> &[StoredSurface] {
        &self.surfaces
    }

    /// The surface of that name.
    #[must_use]
    pub fn get(&self, id: SurfaceId) -> Option<&StoredSurface> {
        self.surfaces.get(id.0 as usize)
    }

    /// Stores a surface for good and names it.
    pub(crate) fn store(&mut self, new: &NewSurface) -> SurfaceId {
        #[allow(
            clippy::cast_possible_truncation,
            reason = "memory ends long before four thousand million surfaces"
        )]
        let id = SurfaceId(self.surfaces.len() as u32);
        let NewSurface { segment, ends, step, index_in_view } = *new;
        self.surfaces.push(StoredSurface { id, segment, ends, step, index_in_view });
        id
    }
}

/// What is told of a surface when it is stored.
pub(crate) struct NewSurface {
    pub(crate) segment: Segment,
    pub(crate) ends: [End; 2],
    pub(crate) step: usize,
    pub(crate) index_in_view: usize,
}
