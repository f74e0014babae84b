use cogmap_geometry::{DVec2, Pose};
use cogmap_mapping::perception::Reading;

use crate::{Anchored, Atlas, Belief};

/// A scan that is kept: in the place where it was taken, so that it comes along when the robot learns how
/// that place lies to another.
#[derive(Clone, Debug)]
pub(super) struct Sight {
    /// Where the laser was.
    pub(super) laser: Anchored<Pose>,
    /// What the beams hit, in the laser's frame; beams that saw nothing say nothing.
    pub(super) points: Vec<DVec2>,
    /// How many decisions had been made.
    pub(super) moment: u16,
}

impl Sight {
    pub(super) fn of(reading: &Reading, atlas: &Atlas, belief: &Belief, moment: u16) -> Self {
        let here_from_laser = belief.here_from_robot * reading.scan.robot_from_laser;
        let points = (0..reading.scan.ranges.len()).filter_map(|beam| reading.scan.point(beam)).collect();
        Self { laser: atlas.keep(here_from_laser), points, moment }
    }

    /// Whether it was taken about where the other was, so that one of the two says enough.
    pub(super) fn is_like(&self, other: &Self, distance: f64, turn: f64) -> bool {
        let moved = self.laser.value.from_here(other.laser.value);
        self.laser.frame == other.laser.frame
            && moved.position.length() < distance
            && moved.heading.abs() < turn
    }
}
