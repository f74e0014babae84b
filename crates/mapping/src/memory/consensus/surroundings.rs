use std::collections::BTreeMap;

use cogmap_geometry::{Metric, Pose};
use serde::{Deserialize, Serialize};

use super::{
    known::Known,
    line::Line,
    look::{Agreement, FreeSpace, Look},
};
use crate::memory::{FrameId, Mfis, Way};

/// Of each frame so many looks are kept at most …
const LOOKS: usize = 6;
/// … each this far from the others, metres …
const LOOKS_APART: f64 = 0.8;
/// … or turned against them by this, radians.
const LOOKS_TURNED: f64 = cogmap_geometry::trig::FRAC_PI_4;
/// Looks from nearer than this tell something of what is seen from a place, metres.
const LOOKS_NEAR: f64 = 4.0;

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

/// What was stored in one frame, and what was seen free from it.
#[derive(Clone, Debug, Default)]
struct Stored {
    lines: Vec<Line>,
    looks: Vec<Look>,
}

/// What is remembered near the robot, in its frame.
#[derive(Clone, Debug)]
pub(super) struct Surroundings {
    stored: Vec<Stored>,
    ways: BTreeMap<FrameId, Way>,
    lines: Known,
}

/// What is remembered around some frame, in that frame.
pub(super) struct Elsewhere {
    pub(super) lines: Known,
    looks: Vec<Look>,
}

impl Default for Surroundings {
    fn default() -> Self {
        let here = Way { here_from_frame: Pose::IDENTITY, length: 0.0 };
        let ways = BTreeMap::from([(FrameId::default(), here)]);
        Self { stored: Vec::new(), ways, lines: Known::default() }
    }
}

impl Surroundings {
    /// What is remembered around the robot, in its frame.
    pub(super) fn lines(&self) -> &Known {
        &self.lines
    }

    /// A surface was stored in the robot's frame.
    pub(super) fn remember(&mut self, frame: FrameId, line: Line) {
        self.stored_in(frame).lines.push(line);
        self.lines.add(line);
    }

    /// A look was taken in the robot's frame; it is kept where there are none like it.
    pub(super) fn keep(&mut self, frame: FrameId, look: &Look) {
        let looks = &mut self.stored_in(frame).looks;
        let alike = |other: &Look| {
            let apart = other.frame_from_laser.from_here(look.frame_from_laser);
            apart.position.norm() < LOOKS_APART && apart.heading.abs() < LOOKS_TURNED
        };
        if looks.len() < LOOKS && !looks.iter().any(alike) {
            looks.push(look.clone());
        }
    }

    fn stored_in(&mut self, frame: FrameId) -> &mut Stored {
        let place = frame.0 as usize;
        if self.stored.len() <= place {
            self.stored.resize_with(place + 1, Stored::default);
        }
        &mut self.stored[place]
    }

    /// The robot is in another frame now.
    pub(super) fn centre_on(&mut self, mfis: &Mfis, frame: FrameId, reach: &Reach) {
        self.ways = mfis.ways_from(frame, reach.along_links);
        self.ways.retain(|other, way| *other == frame || way.here_from_frame.position.norm() <= reach.radius);
        self.lines = self.lines_along(&self.ways);
    }

    /// The near frame whose origin is nearest to the robot, other than its own: which it is, where
    /// it lies, and how far off, metres.
    pub(super) fn nearest_frame(&self, own: FrameId, here_from_robot: Pose) -> Option<(FrameId, Pose, f64)> {
        self.ways
            .iter()
            .filter(|(frame, _)| **frame != own)
            .map(|(&frame, way)| {
                let distance = way.here_from_frame.position.distance_from(here_from_robot.position);
                (frame, way.here_from_frame, distance)
            })
            .min_by(|a, b| a.2.total_cmp(&b.2))
    }

    /// What is remembered around another frame but does not belong to the robot's surroundings.
    pub(super) fn elsewhere(&self, mfis: &Mfis, frame: FrameId, along_links: f64, radius: f64) -> Elsewhere {
        let mut ways = mfis.ways_from(frame, along_links);
        ways.retain(|other, way| {
            !self.ways.contains_key(other) && way.here_from_frame.position.norm() <= radius
        });
        let looks = self
            .each_along(&ways)
            .flat_map(|(stored, way)| stored.looks.iter().map(|look| look.seen_from(way.here_from_frame)));
        Elsewhere { lines: self.lines_along(&ways), looks: looks.collect() }
    }

    fn lines_along(&self, ways: &BTreeMap<FrameId, Way>) -> Known {
        self.each_along(ways)
            .flat_map(|(stored, way)| stored.lines.iter().map(|line| line.seen_from(way.here_from_frame)))
            .collect()
    }

    fn each_along<'a>(
        &'a self,
        ways: &'a BTreeMap<FrameId, Way>,
    ) -> impl Iterator<Item = (&'a Stored, &'a Way)> {
        ways.iter().filter_map(|(frame, way)| Some((self.stored.get(frame.0 as usize)?, way)))
    }
}

impl Elsewhere {
    /// How far a look from there bears out what was seen free around there.
    pub(super) fn agreement(&self, look: &Look, params: &FreeSpace) -> Agreement {
        let at = look.frame_from_laser.position;
        let near = |other: &&Look| other.frame_from_laser.position.distance_from(at) <= LOOKS_NEAR;
        self.looks.iter().filter(near).map(|other| other.agreement(look, params)).sum()
    }
}
