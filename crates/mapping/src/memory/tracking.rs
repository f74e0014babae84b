use cogmap_geometry::Pose;
use serde::{Deserialize, Serialize};

use super::{Match, Matching, Mfis, NewSurface, SurfaceId, match_views};
use crate::{
    PathPoint,
    perception::{Surface, View},
};

/// A surface of the previous view: how it looked then, and which stored surface it is.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Tracked {
    /// In the previous view's robot frame.
    pub surface: Surface,
    /// Its first stored version; handed on from sighting to sighting, so that tracking does not drift.
    pub known: SurfaceId,
}

/// What a mapper carries from one view to the next: the map, the previous view's surfaces with
/// their stored versions, and where each view was taken.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Memory {
    mfis: Mfis,
    previous: Vec<Tracked>,
    path: Vec<PathPoint>,
    odom_from_last: Option<Pose>,
}

impl Memory {
    /// The map.
    #[must_use]
    pub fn mfis(&self) -> &Mfis {
        &self.mfis
    }

    /// Where each view was taken, oldest first.
    #[must_use]
    pub fn path(&self) -> &[PathPoint] {
        &self.path
    }

    /// Where odometry stood at the last view.
    #[must_use]
    pub fn odom_from_last(&self) -> Option<Pose> {
        self.odom_from_last
    }

    /// The rough movement since the last view.
    pub(crate) fn moved_to(&self, odom_from_robot: Pose) -> Option<Pose> {
        Some(self.odom_from_last?.from_here(odom_from_robot))
    }

    /// The surfaces that the view has in common with the previous one.
    pub(crate) fn recognise(&self, view: &View, moved: Option<Pose>, params: &Matching) -> Vec<Match> {
        moved.map_or(Vec::new(), |moved| match_views(&view.surfaces, &self.previous, moved, params))
    }

    /// Stores what was not recognised; a new sighting of a known surface is ignored (§3.2.1, the
    /// stable world).
    pub(crate) fn store_new(
        &mut self,
        view: &View,
        matches: &[Match],
        map_from_robot: Pose,
    ) -> Vec<SurfaceId> {
        let mut known_as = vec![None; view.surfaces.len()];
        for m in matches {
            known_as[m.seen] = Some(m.known);
        }
        let step = self.path.len();
        let mut placed = Vec::new();
        let mut tracked = Vec::with_capacity(view.surfaces.len());
        for (index_in_view, (surface, known)) in view.surfaces.iter().zip(known_as).enumerate() {
            let known = known.unwrap_or_else(|| {
                let segment = map_from_robot * surface.segment;
                let id = self.mfis.store(&NewSurface { segment, ends: surface.ends, step, index_in_view });
                placed.push(id);
                id
            });
            tracked.push(Tracked { surface: surface.clone(), known });
        }
        self.previous = tracked;
        placed
    }

    /// Closes the step and numbers it.
    pub(crate) fn remember_view(&mut self, t: f64, map_from_robot: Pose, odom_from_robot: Pose) -> usize {
        let step = self.path.len();
        self.path.push(PathPoint { step, t, map_from_robot });
        self.odom_from_last = Some(odom_from_robot);
        step
    }
}
