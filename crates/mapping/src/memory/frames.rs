use std::{
    cmp::Ordering,
    collections::{BTreeSet, BinaryHeap},
    iter,
};

use cogmap_geometry::{Metric, Pose};
use serde::{Deserialize, Serialize};

/// Names a local frame of one MFIS, in the order of opening; frame 0 is the map's.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
pub struct FrameId(pub u32);

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

/// How a frame lies seen from another along the links, and how long the way is, metres.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Way {
    /// Where the frame lies in the one that the way begins in.
    pub here_from_frame: Pose,
    /// Metres along the links.
    pub length: f64,
}

/// The local frames of one map and the links between them: the first frame is the map's own. Frames
/// and links are added and never altered.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Frames {
    frames: Vec<Frame>,
    links: Vec<Link>,
    neighbours: Vec<Vec<(FrameId, Pose)>>,
}

impl Default for Frames {
    fn default() -> Self {
        let map = Frame { id: FrameId(0), map_from_frame: Pose::IDENTITY };
        Self { frames: vec![map], links: Vec::new(), neighbours: vec![Vec::new()] }
    }
}

impl Frames {
    pub(super) fn all(&self) -> &[Frame] {
        &self.frames
    }

    pub(super) fn links(&self) -> &[Link] {
        &self.links
    }

    pub(super) fn map_from_frame(&self, frame: FrameId) -> Pose {
        self.frames.get(frame.0 as usize).map_or(Pose::IDENTITY, |frame| frame.map_from_frame)
    }

    pub(super) fn open(&mut self, map_from_frame: Pose) -> FrameId {
        #[allow(clippy::cast_possible_truncation, reason = "memory ends long before that many frames")]
        let id = FrameId(self.frames.len() as u32);
        self.frames.push(Frame { id, map_from_frame });
        self.neighbours.push(Vec::new());
        id
    }

    pub(super) fn link(&mut self, link: Link) {
        let Link { from, to, from_from_to, .. } = link;
        self.neighbours[from.0 as usize].push((to, from_from_to));
        self.neighbours[to.0 as usize].push((from, from_from_to.inverse()));
        self.links.push(link);
    }

    /// The frames within `reach` metres along the links and the shortest ways there, the nearest first (Dijkstra).
    pub(super) fn nearest_from(&self, start: FrameId, reach: f64) -> impl Iterator<Item = (FrameId, Way)> {
        let here = Way { here_from_frame: Pose::IDENTITY, length: 0.0 };
        let mut open = BinaryHeap::from([Open { way: here, frame: start }]);
        let mut done = BTreeSet::new();
        iter::from_fn(move || {
            let Open { way, frame } = iter::from_fn(|| open.pop()).find(|next| done.insert(next.frame))?;
            for &(to, frame_from_to) in self.neighbours.get(frame.0 as usize).map_or(&[][..], Vec::as_slice) {
                let length = way.length + frame_from_to.position.norm();
                if length <= reach && !done.contains(&to) {
                    let way = Way { here_from_frame: way.here_from_frame * frame_from_to, length };
                    open.push(Open { way, frame: to });
                }
            }
            Some((frame, way))
        })
    }
}

/// A frame to go on from: the nearest is the greatest.
struct Open {
    way: Way,
    frame: FrameId,
}

impl Ord for Open {
    fn cmp(&self, other: &Self) -> Ordering {
        other.way.length.total_cmp(&self.way.length).then(other.frame.cmp(&self.frame))
    }
}

impl PartialOrd for Open {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl PartialEq for Open {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other).is_eq()
    }
}

impl Eq for Open {}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn frames_come_nearest_first_however_they_are_linked() {
        let mut frames = Frames::default();
        let ids: Vec<FrameId> = (0..4).map(|_| frames.open(Pose::IDENTITY)).collect();
        let (from, kind) = (FrameId::default(), LinkKind::Passage);
        for (from, to, x) in
            [(from, ids[0], 9.0), (from, ids[1], 2.0), (ids[1], ids[2], 3.0), (ids[2], ids[0], 1.0)]
        {
            frames.link(Link { from, to, from_from_to: Pose::new(x, 0.0, 0.0), step: 0, kind });
        }
        let found: Vec<_> = frames.nearest_from(from, 6.0).map(|(frame, way)| (frame, way.length)).collect();
        assert_eq!(found, [(from, 0.0), (ids[1], 2.0), (ids[2], 5.0), (ids[0], 6.0)]);
        assert_eq!(frames.nearest_from(from, 5.5).count(), 3);
        // No link leads to the last one.
        assert_eq!(frames.nearest_from(ids[3], f64::INFINITY).count(), 1);
    }
}
