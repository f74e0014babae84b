use std::collections::BTreeMap;

use cogmap_geometry::{DVec2, Pose, Segment};
use serde::{Deserialize, Serialize};

use super::{Frame, FrameId, Link, Way, frames::Frames, index::Index};
use crate::{
    PathPoint,
    perception::{End, Surface},
};

/// Names a surface of one MFIS, in the order of storing.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
pub struct SurfaceId(pub u32);

/// A surface as it was placed when it was first seen; it never changes (§3.2.1, the stable world).
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct StoredSurface {
    /// Its name.
    pub id: SurfaceId,
    /// The frame that it was stored in.
    pub frame: FrameId,
    /// Where it lies in that frame, metres; the visible side as in the view.
    pub segment: Segment,
    /// Why it ended where it did in the view that placed it.
    pub ends: [End; 2],
    /// The view that first saw it.
    pub step: usize,
    /// Which surface of that view it was.
    pub index_in_view: usize,
    /// Which thing it is, if the robot could tell that by sight.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub label: Option<u32>,
}

/// The memory for one's immediate surroundings (§2.2.2): a map in world-fixed frames. Surfaces,
/// frames and links are added and never altered: there is no way to reach a stored one for writing.
/// A surface can be forgotten; its name is never given to another.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Mfis {
    surfaces: Vec<StoredSurface>,
    /// For each surface the view in which it was forgotten.
    forgotten: Vec<Option<usize>>,
    frames: Frames,
    index: Index<SurfaceId>,
}

impl Mfis {
    /// Everything ever stored, oldest first; each surface in its own frame. What was forgotten since
    /// is still listed, see [`Mfis::remembers`].
    #[must_use]
    pub fn surfaces(&self) -> &[StoredSurface] {
        &self.surfaces
    }

    /// The surface of that name.
    #[must_use]
    pub fn get(&self, id: SurfaceId) -> Option<&StoredSurface> {
        self.surfaces.get(id.0 as usize)
    }

    /// Whether a surface is stored and has not been forgotten.
    #[must_use]
    pub fn remembers(&self, id: SurfaceId) -> bool {
        self.forgotten.get(id.0 as usize).is_some_and(Option::is_none)
    }

    /// The view in which a surface was forgotten.
    #[must_use]
    pub fn forgotten_in(&self, id: SurfaceId) -> Option<usize> {
        self.forgotten.get(id.0 as usize).copied().flatten()
    }

    /// What is remembered, oldest first.
    pub fn remembered(&self) -> impl Iterator<Item = &StoredSurface> {
        self.surfaces.iter().filter(|surface| self.remembers(surface.id))
    }

    /// The remembered surfaces of a frame that come within `radius` metres of a point of that frame,
    /// oldest first; what it costs depends on how many those are, not on the size of the map.
    pub fn near(&self, frame: FrameId, at: DVec2, radius: f64) -> impl Iterator<Item = &StoredSurface> {
        self.index
            .around(frame, at, radius)
            .into_iter()
            .filter_map(|id| self.get(id))
            .filter(move |surface| surface.segment.distance_to(at) <= radius && self.remembers(surface.id))
    }

    /// Everything ever stored in a frame, oldest first.
    pub(crate) fn in_frame(&self, frame: FrameId) -> impl Iterator<Item = &StoredSurface> {
        self.index.in_frame(frame).into_iter().filter_map(|id| self.get(id))
    }

    /// The frames, oldest first; the first is the map's own.
    #[must_use]
    pub fn frames(&self) -> &[Frame] {
        self.frames.all()
    }

    /// The links between frames, oldest first.
    #[must_use]
    pub fn links(&self) -> &[Link] {
        self.frames.links()
    }

    /// Where a frame lay in the map when it was opened.
    #[must_use]
    pub fn map_from_frame(&self, frame: FrameId) -> Pose {
        self.frames.map_from_frame(frame)
    }

    /// The shortest ways along the links from a frame to every frame within `reach` metres of way,
    /// its own included.
    #[must_use]
    pub fn ways_from(&self, frame: FrameId, reach: f64) -> BTreeMap<FrameId, Way> {
        self.frames.nearest_from(frame, reach).collect()
    }

    /// The frames around one along the links with the shortest ways there, the nearest first; it costs as
    /// much as is taken of it.
    pub(crate) fn nearest_frames(&self, frame: FrameId) -> impl Iterator<Item = (FrameId, Way)> {
        self.frames.nearest_from(frame, f64::INFINITY)
    }

    /// A stored surface as it is drawn: in the map.
    #[must_use]
    pub fn in_map(&self, surface: &StoredSurface) -> Segment {
        self.map_from_frame(surface.frame) * surface.segment
    }

    /// What is remembered, seen from an origin of one's own choice, oldest first (§2.2.2: the preferred
    /// one is the entrance of the space in which the robot is). It is a way of looking at the map:
    /// what is stored stays where it is, so that coming back to the map's own frame changes nothing.
    pub fn seen_from(
        &self,
        frame: FrameId,
        frame_from_origin: Pose,
    ) -> impl Iterator<Item = (SurfaceId, Segment)> {
        let origin_from_map = (self.map_from_frame(frame) * frame_from_origin).inverse();
        self.remembered().map(move |stored| (stored.id, origin_from_map * self.in_map(stored)))
    }

    /// Where the robot was when it took a view, in the map.
    #[must_use]
    pub fn place_of(&self, point: &PathPoint) -> Pose {
        self.map_from_frame(point.frame) * point.frame_from_robot
    }

    /// Stores a surface for good and names it.
    pub(crate) fn store(
        &mut self,
        surface: &Surface,
        frame_from_robot: Pose,
        sighting: Sighting,
    ) -> SurfaceId {
        #[allow(
            clippy::cast_possible_truncation,
            reason = "memory ends long before four thousand million surfaces"
        )]
        let id = SurfaceId(self.surfaces.len() as u32);
        let Sighting { frame, step, index_in_view } = sighting;
        let (segment, ends, label) = (frame_from_robot * surface.segment, surface.ends, surface.label);
        self.surfaces.push(StoredSurface { id, frame, segment, ends, step, index_in_view, label });
        self.forgotten.push(None);
        self.index.insert(frame, segment, id);
        id
    }

    /// Forgets a surface in a view; what is forgotten already stays so since then.
    pub(crate) fn forget(&mut self, id: SurfaceId, step: usize) {
        if let Some(forgotten) = self.forgotten.get_mut(id.0 as usize) {
            forgotten.get_or_insert(step);
        }
    }

    /// Opens a frame that lies so in the map.
    pub(crate) fn open_frame(&mut self, map_from_frame: Pose) -> FrameId {
        self.frames.open(map_from_frame)
    }

    /// Notes how two frames lie to each other.
    pub(crate) fn link(&mut self, link: Link) {
        self.frames.link(link);
    }
}

/// When a surface was first seen, and the frame that remembers it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Sighting {
    pub(crate) frame: FrameId,
    pub(crate) step: usize,
    pub(crate) index_in_view: usize,
}
