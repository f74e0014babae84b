use std::collections::BTreeMap;

use cogmap_geometry::{DVec2, Metric, Pose, Segment};

use super::{ExitId, Network};
use crate::memory::{FrameId, Mfis, SurfaceId, Way};

/// How far the robot may go before its surroundings are gathered anew, metres.
const SLACK: f64 = 1.0;

/// Frames farther than this along the links are not near, metres.
const ALONG_LINKS: f64 = 30.0;

/// A remembered surface in the robot's frame; length and direction are asked for each time that it is looked at.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Near {
    pub(super) segment: Segment,
    pub(super) length: f64,
    pub(super) direction: Option<DVec2>,
}

impl Near {
    pub(super) fn new(segment: Segment) -> Self {
        Self { segment, length: segment.length(), direction: segment.direction() }
    }
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
    /// The exits around, in the order of finding.
    pub(super) exits: Vec<ExitId>,
    /// The numbers of the exits around that may be, in order.
    pub(super) hypotheses: Vec<usize>,
}

impl Nearby {
    /// The robot is at a point of a frame, and these surfaces are new.
    pub(super) fn update(
        &mut self,
        (mfis, network): (&Mfis, &Network),
        (frame, at): (FrameId, DVec2),
        placed: &[SurfaceId],
        radius: f64,
    ) {
        let same_ways = self.frame == frame && self.links == mfis.links().len() && self.centre.is_some();
        if !same_ways {
            self.ways = mfis.ways_from(frame, ALONG_LINKS);
            (self.frame, self.links) = (frame, mfis.links().len());
        }
        if same_ways && self.centre.is_some_and(|centre| centre.distance_from(at) <= SLACK) {
            let added = placed.iter().filter_map(|&id| self.bring(mfis, id)).collect::<Vec<_>>();
            self.surfaces.extend(added);
        } else {
            self.gather((mfis, network), at, radius + SLACK);
        }
    }

    fn gather(&mut self, (mfis, network): (&Mfis, &Network), at: DVec2, radius: f64) {
        self.centre = Some(at);
        self.exits.clear();
        self.hypotheses.clear();
        self.surfaces.clear();
        for (&frame, Way { here_from_frame, .. }) in &self.ways {
            let at = here_from_frame.inverse() * at;
            let surfaces = mfis.near(frame, at, radius);
            self.surfaces.extend(surfaces.map(|surface| Near::new(*here_from_frame * surface.segment)));
            self.exits.extend(network.exits_around(frame, at, radius));
            self.hypotheses.extend(network.hypotheses_around(frame, at, radius));
        }
        self.exits.sort_unstable();
        self.hypotheses.sort_unstable();
    }

    fn bring(&self, mfis: &Mfis, id: SurfaceId) -> Option<Near> {
        let stored = mfis.get(id)?;
        Some(Near::new(self.here_from(stored.frame)? * stored.segment))
    }

    /// Where a near frame lies in the robot's.
    pub(super) fn here_from(&self, frame: FrameId) -> Option<Pose> {
        self.ways.get(&frame).map(|way| way.here_from_frame)
    }

    /// The near frames, oldest first, and where they lie in the robot's.
    pub(super) fn frames(&self) -> impl Iterator<Item = (FrameId, Pose)> {
        self.ways.iter().map(|(&frame, way)| (frame, way.here_from_frame))
    }

    /// The surfaces around.
    pub(super) fn surfaces(&self) -> &[Near] {
        &self.surfaces
    }
}
