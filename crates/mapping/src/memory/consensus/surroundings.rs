use std::collections::BTreeMap;

use cogmap_geometry::Pose;
use serde::{Deserialize, Serialize};

use super::line::Line;
use crate::memory::{FrameId, Mfis, Way};

/// How much of the memory is near: only that is compared with a view (§2.2.2: the last few spaces).
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Reach {
    /// Frames within this along the links, metres …
    pub along_links: f64,
    /// … and within this in a straight line.
    pub radius: f64,
}

impl Default for Reach {
    fn default() -> Self {
        Self { along_links: 20.0, radius: 14.0 }
    }
}

/// What is remembered near the robot, in its frame.
#[derive(Clone, Debug)]
pub(super) struct Surroundings {
    /// For each frame what was stored in it.
    stored: Vec<Vec<Line>>,
    ways: BTreeMap<FrameId, Way>,
    lines: Vec<Line>,
}

impl Default for Surroundings {
    fn default() -> Self {
        let here = Way { here_from_frame: Pose::IDENTITY, length: 0.0 };
        let ways = BTreeMap::from([(FrameId::default(), here)]);
        Self { stored: Vec::new(), ways, lines: Vec::new() }
    }
}

impl Surroundings {
    /// What is remembered around the robot, in its frame.
    pub(super) fn lines(&self) -> &[Line] {
        &self.lines
    }

    /// A surface was stored in the robot's frame.
    pub(super) fn remember(&mut self, frame: FrameId, line: Line) {
        let place = frame.0 as usize;
        if self.stored.len() <= place {
            self.stored.resize_with(place + 1, Vec::new);
        }
        self.stored[place].push(line);
        self.lines.push(line);
    }

    /// The robot is in another frame now.
    pub(super) fn centre_on(&mut self, mfis: &Mfis, frame: FrameId, reach: &Reach) {
        self.ways = mfis.ways_from(frame, reach.along_links);
        self.lines = self.lines_along(&self.ways, reach.radius);
    }

    /// The near frame whose origin is nearest to the robot, other than its own: which it is, where
    /// it lies, and how far off, metres.
    pub(super) fn nearest_frame(&self, own: FrameId, here_from_robot: Pose) -> Option<(FrameId, Pose, f64)> {
        self.ways
            .iter()
            .filter(|(frame, _)| **frame != own)
            .map(|(&frame, way)| {
                let distance = way.here_from_frame.position.distance(here_from_robot.position);
                (frame, way.here_from_frame, distance)
            })
            .min_by(|a, b| a.2.total_cmp(&b.2))
    }

    /// What is remembered around another frame but does not belong to the robot's surroundings.
    pub(super) fn lines_elsewhere(
        &self,
        mfis: &Mfis,
        frame: FrameId,
        along_links: f64,
        radius: f64,
    ) -> Vec<Line> {
        let mut ways = mfis.ways_from(frame, along_links);
        ways.retain(|frame, _| !self.ways.contains_key(frame));
        self.lines_along(&ways, radius)
    }

    fn lines_along(&self, ways: &BTreeMap<FrameId, Way>, radius: f64) -> Vec<Line> {
        ways.iter()
            .filter(|(_, way)| way.here_from_frame.position.length() <= radius)
            .filter_map(|(frame, way)| Some((self.stored.get(frame.0 as usize)?, way)))
            .flat_map(|(stored, way)| stored.iter().map(|line| line.seen_from(way.here_from_frame)))
            .collect()
    }
}
