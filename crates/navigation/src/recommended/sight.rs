use std::iter;

use cogmap_geometry::{DVec2, Pose};
use cogmap_mapping::perception::{Reading, Scan};

use super::floor::GRAZING;
use crate::{Anchored, Atlas, Belief};

/// A beam's end is torn from its neighbour's if it lies farther from it than this, metres, and than the ends lie
/// apart on a wall that the beams graze.
const TORN: f64 = 0.1;

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
        Self { laser: atlas.keep(here_from_laser), points: firm(&reading.scan), moment }
    }

    /// Whether it was taken about where the other was, so that one of the two says enough.
    pub(super) fn is_like(&self, other: &Self, distance: f64, turn: f64) -> bool {
        let moved = self.laser.value.from_here(other.laser.value);
        self.laser.frame == other.laser.frame
            && moved.position.length() < distance
            && moved.heading.abs() < turn
    }
}

/// What the beams hit, without the ends that are torn from both their neighbours': a beam that half meets an
/// edge may tell of a place between that and what is behind it, where nothing stands.
fn firm(scan: &Scan) -> Vec<DVec2> {
    let ends = (0..scan.ranges.len()).map(|beam| scan.point(beam));
    let ends: Vec<Option<DVec2>> = iter::once(None).chain(ends).chain([None]).collect();
    let holds = |end: DVec2, beside: DVec2| {
        end.distance(beside) <= TORN + end.length() * scan.angle_increment / GRAZING
    };
    let firm = |three: &[Option<DVec2>]| {
        let [before, end, after] = three else { return None };
        end.filter(|&end| [before, after].into_iter().flatten().any(|&beside| holds(end, beside)))
    };
    ends.windows(3).filter_map(firm).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use cogmap_geometry::trig;

    /// A degree from beam to beam, the first to the right.
    fn scan(ranges: Vec<f64>) -> Scan {
        let angle_increment = trig::PI / 180.0;
        #[allow(clippy::cast_precision_loss, reason = "a few beams")]
        let angle_min = -0.5 * angle_increment * (ranges.len() - 1) as f64;
        let robot_from_laser = Pose::new(0.0, 0.0, 0.0);
        Scan { robot_from_laser, angle_min, angle_increment, range_max: 8.0, ranges, labels: Vec::new() }
    }

    #[test]
    fn a_beam_that_half_met_an_edge_is_not_believed() {
        let near_and_far = |between: f64| firm(&scan(vec![1.0, 1.0, 1.0, between, 3.0, 3.0, 3.0]));
        assert_eq!(near_and_far(2.1).len(), 6, "torn from both");
        assert!(near_and_far(2.1).iter().all(|end| (end.length() - 2.1).abs() > 0.5));
        assert_eq!(near_and_far(1.05).len(), 7, "on the near surface");
        assert_eq!(near_and_far(f64::INFINITY).len(), 6, "nothing seen is no end");
    }

    #[test]
    fn a_wall_along_which_the_robot_looks_is_believed_and_so_is_a_post_that_two_beams_meet() {
        let beside = 0.5;
        let along = (0..40).map(|beam| beside / trig::sin(trig::PI / 180.0 * (20.0 + f64::from(beam))));
        assert_eq!(firm(&scan(along.collect())).len(), 40);
        let post = firm(&scan(vec![4.0, 4.0, 1.5, 1.5, 4.0, 4.0]));
        assert_eq!(post.len(), 6);
    }
}
