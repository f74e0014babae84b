use cogmap_geometry::{Pose, Segment};

use super::{FrameId, Link, Match, Matching, Mfis, Sighting, StoredSurface, SurfaceId, match_views};
use crate::{
    PathPoint, Placement, StepReport,
    perception::{End, Surface, View},
};

/// What a view is compared with: a surface of the previous view, and which stored surface it is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tracked {
    /// In the previous view's robot frame, metres.
    pub segment: Segment,
    /// Why it ended where it did.
    pub ends: [End; 2],
    /// Which thing it is, if the robot could tell that by sight.
    pub label: Option<u32>,
    /// Its first stored version; handed on from sighting to sighting, so that tracking does not drift.
    /// `None` where its view was not stored, or what was stored is forgotten.
    pub known: Option<SurfaceId>,
}

impl Tracked {
    /// A surface of a view under the name that it is known by.
    #[must_use]
    pub fn seen(surface: &Surface, known: Option<SurfaceId>) -> Self {
        Self { segment: surface.segment, ends: surface.ends, label: surface.label, known }
    }

    /// A surface as it is stored, in its own frame.
    #[must_use]
    pub fn stored(stored: &StoredSurface) -> Self {
        let StoredSurface { id, segment, ends, label, .. } = *stored;
        Self { segment, ends, label, known: Some(id) }
    }

    /// The same from another frame.
    #[must_use]
    pub fn seen_from(&self, other_from_here: Pose) -> Self {
        Self { segment: other_from_here * self.segment, ..*self }
    }
}

/// What a mapper carries from one view to the next: the map, the previous view's surfaces with
/// their stored versions, and where each view was taken.
#[derive(Clone, Debug, Default, PartialEq)]
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

    /// The previous view's surfaces as they are stored, seen from where the robot was then.
    pub(crate) fn previous_as_stored(&self) -> Vec<Tracked> {
        let Some(last) = self.path.last() else { return Vec::new() };
        let robot_from_map = self.mfis.place_of(last).inverse();
        let as_stored = |tracked: &Tracked| {
            let stored = self.mfis.get(tracked.known?)?;
            let segment = robot_from_map * self.mfis.in_map(stored);
            Some(Tracked { segment, ..Tracked::stored(stored) })
        };
        self.previous.iter().filter_map(as_stored).collect()
    }

    /// Stores what was not recognised; a new sighting of a known surface is ignored (§3.2.1, the
    /// stable world).
    pub(crate) fn store_new(
        &mut self,
        view: &View,
        matches: &[Match],
        map_from_robot: Pose,
    ) -> Vec<SurfaceId> {
        self.track(view, matches);
        let step = self.path.len();
        let mut placed = Vec::new();
        for (index_in_view, (surface, tracked)) in view.surfaces.iter().zip(&mut self.previous).enumerate() {
            if tracked.known.is_none() {
                let sighting = Sighting { frame: FrameId::default(), step, index_in_view };
                let id = self.mfis.store(surface, map_from_robot, sighting);
                tracked.known = Some(id);
                placed.push(id);
            }
        }
        placed
    }

    /// Hands the names of what was recognised on to the current view, and stores nothing.
    pub(crate) fn track(&mut self, view: &View, matches: &[Match]) {
        self.previous = view.surfaces.iter().map(|surface| Tracked::seen(surface, None)).collect();
        for m in matches {
            self.previous[m.seen].known = Some(m.known);
        }
    }

    /// Forgets stored surfaces; whoever sees one again sees something new.
    pub(crate) fn forget(&mut self, surfaces: &[SurfaceId]) {
        let step = self.path.len().saturating_sub(1);
        for &surface in surfaces {
            self.mfis.forget(surface, step);
        }
        for tracked in &mut self.previous {
            tracked.known = tracked.known.filter(|&known| self.mfis.remembers(known));
        }
    }

    /// Closes the step in the map's own frame and numbers it.
    pub(crate) fn remember_view(&mut self, t: f64, map_from_robot: Pose, odom_from_robot: Pose) -> usize {
        self.remember(t, (FrameId::default(), map_from_robot), odom_from_robot)
    }

    /// Closes the step and numbers it.
    pub(crate) fn remember(
        &mut self,
        t: f64,
        (frame, frame_from_robot): (FrameId, Pose),
        odom_from_robot: Pose,
    ) -> usize {
        let step = self.path.len();
        self.path.push(PathPoint { step, t, frame, frame_from_robot });
        self.odom_from_last = Some(odom_from_robot);
        step
    }

    /// §3.1.2: puts a view where a movement since the last one takes it, and stores what is new.
    pub(crate) fn transform(
        &mut self,
        view: View,
        (t, odom_from_robot): (f64, Pose),
        (by, moved): (Placement, Option<Pose>),
        matching: &Matching,
    ) -> StepReport {
        let previous = self.previous_as_stored();
        let matches =
            moved.map_or(Vec::new(), |moved| match_views(&view.surfaces, &previous, moved, matching));
        let (placement, map_from_robot) = match (moved, self.path.last()) {
            (Some(moved), Some(last)) => (by, last.frame_from_robot * moved),
            _ => (Placement::First, Pose::IDENTITY),
        };
        let placed = self.store_new(&view, &matches, map_from_robot);
        let step = self.remember_view(t, map_from_robot, odom_from_robot);
        let report = StepReport::new((step, t), view, placement, map_from_robot);
        StepReport { matches, placed, ..report }
    }

    /// Stores one surface.
    pub(crate) fn store(
        &mut self,
        surface: &Surface,
        frame_from_robot: Pose,
        sighting: Sighting,
    ) -> SurfaceId {
        self.mfis.store(surface, frame_from_robot, sighting)
    }

    /// Opens a frame that lies so in the map.
    pub(crate) fn open_frame(&mut self, map_from_frame: Pose) -> FrameId {
        self.mfis.open_frame(map_from_frame)
    }

    /// Notes how two frames lie to each other.
    pub(crate) fn link(&mut self, link: Link) {
        self.mfis.link(link);
    }
}
