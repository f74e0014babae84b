use std::collections::VecDeque;

use cogmap_geometry::{DVec2, Metric, Pose};

use super::{
    nearby::Near,
    passage::{self, Narrowness},
    wideness::Chord,
};
use crate::memory::FrameId;

/// Samples of the way are so far apart, metres.
pub(super) const SPACING: f64 = 0.1;

/// A point of the way between two views.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Sample {
    /// Metres of way since the first view.
    pub(super) way: f64,
    pub(super) at: DVec2,
    /// Where the robot was going, a unit vector.
    pub(super) direction: DVec2,
    /// The last view before it.
    pub(super) view: usize,
    /// How wide it is there.
    pub(super) chord: Chord,
    /// On how many sides a wall goes on outward along the chord.
    pub(super) jambs: u8,
}

/// The recent way in the robot's frame, sampled each [`SPACING`] metres of straight line, so that a
/// robot that turns on the spot or trembles makes no way.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Trail {
    frame: FrameId,
    /// Where the last sample was taken, or the first view.
    last: Option<DVec2>,
    way: f64,
    samples: VecDeque<Sample>,
}

/// A step from one sample of the way to the next.
#[derive(Clone, Copy, Debug)]
pub(super) struct Stride {
    pub(super) way: f64,
    pub(super) at: DVec2,
    pub(super) direction: DVec2,
}

impl Trail {
    pub(super) fn frame(&self) -> FrameId {
        self.frame
    }

    /// Metres since the first view.
    pub(super) fn way(&self) -> f64 {
        self.way
    }

    pub(super) fn samples(&self) -> &VecDeque<Sample> {
        &self.samples
    }

    /// The robot goes on in another frame; a way that cannot be carried over is forgotten.
    pub(super) fn carry(&mut self, frame: FrameId, new_from_old: Option<Pose>) {
        self.frame = frame;
        let Some(new_from_old) = new_from_old else {
            self.samples.clear();
            self.last = None;
            return;
        };
        self.last = self.last.map(|last| new_from_old * last);
        for sample in &mut self.samples {
            sample.at = new_from_old * sample.at;
            sample.direction = new_from_old.rotate(sample.direction);
            sample.chord.segment = new_from_old * sample.chord.segment;
        }
    }

    /// The samples that are due now that the robot is at `to`.
    pub(super) fn go_to(&mut self, to: DVec2) -> Vec<Stride> {
        let Some(from) = self.last else {
            self.last = Some(to);
            return Vec::new();
        };
        let Some(direction) = (to - from).unit() else { return Vec::new() };
        let mut strides = Vec::new();
        let mut at = from;
        while at.distance_from(to) >= SPACING {
            at += direction * SPACING;
            self.way += SPACING;
            strides.push(Stride { way: self.way, at, direction });
        }
        self.last = Some(at);
        strides
    }

    /// Looks again for the walls beside the narrow places not far behind: the far side of a wall is seen only after
    /// the robot has gone through it.
    pub(super) fn look_back(&mut self, near: &[Near], narrowness: &Narrowness) {
        let oldest = self.way - narrowness.at_latest;
        let recent = self.samples.iter_mut().filter(|sample| sample.way >= oldest && sample.jambs < 2);
        for sample in recent.filter(|sample| sample.chord.width <= narrowness.max_width) {
            sample.jambs = sample.jambs.max(passage::jambs_of(sample.chord.segment, near));
        }
    }

    /// Adds a sample; what lies more than `memory` metres of way behind it is forgotten.
    pub(super) fn add(&mut self, sample: Sample, memory: f64) {
        self.samples.push_back(sample);
        while self.samples.front().is_some_and(|first| first.way < sample.way - memory) {
            self.samples.pop_front();
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn samples_lie_a_spacing_apart_however_far_apart_the_views_are(
            steps in prop::collection::vec((0.0f64..1.2, -1.5f64..1.5), 1..30),
        ) {
            let (mut trail, mut pose) = (Trail::default(), Pose::IDENTITY);
            trail.go_to(pose.position);
            let mut before = pose.position;
            for (travel, turn) in steps {
                pose = pose * Pose::new(0.0, 0.0, turn) * Pose::new(travel, 0.0, 0.0);
                for stride in trail.go_to(pose.position) {
                    prop_assert!((stride.at.distance(before) - SPACING).abs() < 1e-9);
                    before = stride.at;
                }
                prop_assert!(before.distance(pose.position) < SPACING + 1e-9);
            }
        }
    }

    #[test]
    fn a_robot_that_trembles_makes_no_way() {
        let mut trail = Trail::default();
        for k in 0..100 {
            let off = if k % 2 == 0 { 0.03 } else { -0.03 };
            assert!(trail.go_to(DVec2::new(off, 0.0)).is_empty());
        }
        assert_eq!(trail.way(), 0.0);
    }
}
