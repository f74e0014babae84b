use std::collections::BTreeMap;

use cogmap_geometry::{DVec2, Pose, Segment};

use crate::memory::{FrameId, Mfis, SurfaceId, Way};

/// How far the robot may go before its surroundings are gathered anew, metres.
const SLACK: f64 = 1.0;

/// Frames farther than this along the links are not near, metres.
const ALONG_LINKS: f64 = 30.0;

/// A remembered surface in the robot's frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Near {
    pub(super) id: SurfaceId,
    pub(super) segment: Segment,
}

/// What is remembered around the robot, in its frame. It is gathered now and then, so that a view costs
/// the same however large the map is.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Nearby {
    frame: FrameId,
    centre: Option<DVec2>,
    links: usize,
    ways: BTreeMap<FrameId, Way>,
    surfaces: Vec<Near>,
}

impl Nearby {
    /// The robot is at a point of a frame, and these surfaces are new.
    pub(super) fn update(
        &mut self,
        mfis: &Mfis,
        (frame, at): (FrameId, DVec2),
        placed: &[SurfaceId],
        radius: f64,
    ) {
        let same_ways = self.frame == frame && self.links == mfis.links().len() && self.centre.is_some();
        if !same_ways {
            self.ways = mfis.ways_from(frame, ALONG_LINKS);
            (self.frame, self.links) = (frame, mfis.links().len());
        }
        if same_ways && self.centre.is_some_and(|centre| centre.distance(at) <= SLACK) {
            let added = placed.iter().filter_map(|&id| self.bring(mfis, id)).collect::<Vec<_>>();
            self.surfaces.extend(added);
        } else {
            self.gather(mfis, at, radius + SLACK);
        }
    }

    fn gather(&mut self, mfis: &Mfis, at: DVec2, radius: f64) {
        self.centre = Some(at);
        let gathered = self.ways.iter().flat_map(|(&frame, way)| {
            let here_from_frame = way.here_from_frame;
            mfis.near(frame, here_from_frame.inverse() * at, radius)
                .map(move |surface| Near { id: surface.id, segment: here_from_frame * surface.segment })
        });
        self.surfaces = gathered.collect();
    }

    fn bring(&self, mfis: &Mfis, id: SurfaceId) -> Option<Near> {
        let stored = mfis.get(id)?;
        Some(Near { id, segment: self.here_from(stored.frame)? * stored.segment })
    }

    /// Where a near frame lies in the robot's.
    pub(super) fn here_from(&self, frame: FrameId) -> Option<Pose> {
        self.ways.get(&frame).map(|way| way.here_from_frame)
    }

    /// The surfaces around.
    pub(super) fn surfaces(&self) -> &[Near] {
        &self.surfaces
    }
}
