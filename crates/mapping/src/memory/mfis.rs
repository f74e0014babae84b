use cogmap_geometry::{Pose, Segment};
use serde::{Deserialize, Serialize};

use crate::{
    PathPoint,
    perception::{End, Surface},
};

/// Names a surface of one MFIS, in the order of storing.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
pub struct SurfaceId(pub u32);

/// Names a local frame of one MFIS, in the order of opening; frame 0 is the map's.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
pub struct FrameId(pub u32);

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
}

/// A coordinate system fixed to a place. Most mappers know one; with several, each place keeps the
/// layout that it had when it was first seen, and only the links say how they lie to each other.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Frame {
    /// Its name.
    pub id: FrameId,
    /// Where it lay in the map when it was opened; for drawing, and never changed.
    pub map_from_frame: Pose,
}

/// How one frame lies seen from another.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Link {
    /// The frame that it starts from.
    pub from: FrameId,
    /// The frame that it leads to.
    pub to: FrameId,
    /// Where the second lies in the first.
    pub from_from_to: Pose,
    /// The view in which it was made.
    pub step: usize,
    /// What made it.
    pub kind: LinkKind,
}

/// What made a link.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum LinkKind {
    /// The robot went from one to the other.
    Passage,
    /// The robot recognised a place that it had been to.
    Recognised,
}

/// The memory for one's immediate surroundings (§2.2.2): a map in world-fixed frames. Surfaces,
/// frames and links are added and never altered: there is no way to reach a stored one for writing.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Mfis {
    surfaces: Vec<StoredSurface>,
    frames: Vec<Frame>,
    links: Vec<Link>,
}

impl Default for Mfis {
    fn default() -> Self {
        let map = Frame { id: FrameId(0), map_from_frame: Pose::IDENTITY };
        Self { surfaces: Vec::new(), frames: vec![map], links: Vec::new() }
    }
}

impl Mfis {
    /// Everything stored, oldest first; each surface in its own frame.
    #[must_use]
    pub fn surfaces(&self) -> &[StoredSurface] {
        &self.surfaces
    }

    /// The surface of that name.
    #[must_use]
    pub fn get(&self, id: SurfaceId) -> Option<&StoredSurface> {
        self.surfaces.get(id.0 as usize)
    }

    /// The frames, oldest first; the first is the map's own.
    #[must_use]
    pub fn frames(&self) -> &[Frame] {
        &self.frames
    }

    /// The links between frames, oldest first.
    #[must_use]
    pub fn links(&self) -> &[Link] {
        &self.links
    }

    /// Where a frame lay in the map when it was opened.
    #[must_use]
    pub fn map_from_frame(&self, frame: FrameId) -> Pose {
        self.frames.get(frame.0 as usize).map_or(Pose::IDENTITY, |frame| frame.map_from_frame)
    }

    /// A stored surface as it is drawn: in the map.
    #[must_use]
    pub fn in_map(&self, surface: &StoredSurface) -> Segment {
        self.map_from_frame(surface.frame) * surface.segment
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
        let (segment, ends) = (frame_from_robot * surface.segment, surface.ends);
        self.surfaces.push(StoredSurface { id, frame, segment, ends, step, index_in_view });
        id
    }

    /// Opens a frame that lies so in the map.
    pub(crate) fn open_frame(&mut self, map_from_frame: Pose) -> FrameId {
        #[allow(clippy::cast_possible_truncation, reason = "memory ends long before that many frames")]
        let id = FrameId(self.frames.len() as u32);
        self.frames.push(Frame { id, map_from_frame });
        id
    }

    /// Notes how two frames lie to each other.
    pub(crate) fn link(&mut self, link: Link) {
        self.links.push(link);
    }
}

/// When a surface was first seen, and the frame that remembers it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Sighting {
    pub(crate) frame: FrameId,
    pub(crate) step: usize,
    pub(crate) index_in_view: usize,
}
