use std::collections::BTreeMap;

use cogmap_geometry::Pose;
use serde::{Deserialize, Serialize};

use super::line::Line;
use crate::memory::FrameId;

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

/// How a frame lies seen from another, and how long the way along the links is, metres.
#[derive(Clone, Copy, Debug)]
pub(super) struct Way {
    pub(super) here_from_frame: Pose,
    pub(super) length: f64,
}

/// A place in the network, and what was stored in it.
#[derive(Clone, Debug, Default)]
struct Node {
    lines: Vec<Line>,
    links: Vec<(FrameId, Pose)>,
}

/// The network of frames, and what of it is near the robot's.
#[derive(Clone, Debug)]
pub(super) struct Surroundings {
    nodes: Vec<Node>,
    ways: BTreeMap<FrameId, Way>,
    lines: Vec<Line>,
}

impl Default for Surroundings {
    fn default() -> Self {
        let here = Way { here_from_frame: Pose::IDENTITY, length: 0.0 };
        let ways = BTreeMap::from([(FrameId::default(), here)]);
        Self { nodes: vec![Node::default()], ways, lines: Vec::new() }
    }
}

impl Surroundings {
    /// What is remembered around the robot, in its frame.
    pub(super) fn lines(&self) -> &[Line] {
        &self.lines
    }

    /// A surface was stored in the robot's frame.
    pub(super) fn remember(&mut self, frame: FrameId, line: Line) {
        if let Some(node) = self.nodes.get_mut(frame.0 as usize) {
            node.lines.push(line);
        }
        self.lines.push(line);
    }

    pub(super) fn link(&mut self, from: FrameId, to: FrameId, from_from_to: Pose) {
        let last = from.0.max(to.0) as usize;
        if self.nodes.len() <= last {
            self.nodes.resize_with(last + 1, Node::default);
        }
        self.nodes[from.0 as usize].links.push((to, from_from_to));
        self.nodes[to.0 as usize].links.push((from, from_from_to.inverse()));
    }

    /// The robot is in another frame now.
    pub(super) fn centre_on(&mut self, frame: FrameId, reach: &Reach) {
        self.ways = self.ways_from(frame, reach.along_links);
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
    pub(super) fn lines_elsewhere(&self, frame: FrameId, along_links: f64, radius: f64) -> Vec<Line> {
        let mut ways = self.ways_from(frame, along_links);
        ways.retain(|frame, _| !self.ways.contains_key(frame));
        self.lines_along(&ways, radius)
    }

    /// The shortest ways along the links to every frame within `reach` metres (Dijkstra).
    pub(super) fn ways_from(&self, start: FrameId, reach: f64) -> BTreeMap<FrameId, Way> {
        let mut done: BTreeMap<FrameId, Way> = BTreeMap::new();
        let mut open = vec![(start, Way { here_from_frame: Pose::IDENTITY, length: 0.0 })];
        let nearest = |open: &[(FrameId, Way)]| {
            (0..open.len()).min_by(|&a, &b| open[a].1.length.total_cmp(&open[b].1.length))
        };
        while let Some(next) = nearest(&open) {
            let (frame, way) = open.swap_remove(next);
            if done.contains_key(&frame) {
                continue;
            }
            done.insert(frame, way);
            for &(to, frame_from_to) in self.nodes.get(frame.0 as usize).map_or(&[][..], |node| &node.links) {
                let length = way.length + frame_from_to.position.length();
                if length <= reach && !done.contains_key(&to) {
                    open.push((to, Way { here_from_frame: way.here_from_frame * frame_from_to, length }));
                }
            }
        }
        done
    }

    fn lines_along(&self, ways: &BTreeMap<FrameId, Way>, radius: f64) -> Vec<Line> {
        ways.iter()
            .filter(|(_, way)| way.here_from_frame.position.length() <= radius)
            .filter_map(|(frame, way)| Some((self.nodes.get(frame.0 as usize)?, way)))
            .flat_map(|(node, way)| node.lines.iter().map(|line| line.seen_from(way.here_from_frame)))
            .collect()
    }
}
