use cogmap_geometry::{Pose, fit_motion};
use serde::{Deserialize, Serialize};

/// Where the robot stood at one moment, and where its map has it.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Sample {
    /// The truth.
    pub world_from_robot: Pose,
    /// What the robot believes.
    pub map_from_robot: Pose,
}

impl Sample {
    /// Where the map lies in the world if this one view is believed.
    #[must_use]
    pub fn world_from_map(&self) -> Pose {
        self.world_from_robot * self.map_from_robot.inverse()
    }
}

/// The map laid onto the world so that the first view fits; `None` of nothing.
#[must_use]
pub fn by_first_view(samples: &[Sample]) -> Option<Pose> {
    samples.first().map(Sample::world_from_map)
}

/// The map laid onto the world so that the way fits best (least squares of the positions, no
/// scaling); `None` of nothing.
#[must_use]
pub fn by_whole_way(samples: &[Sample]) -> Option<Pose> {
    // A robot that never moved says nothing about directions: its first heading does.
    let heading = by_first_view(samples)?.heading;
    let pairs: Vec<_> =
        samples.iter().map(|it| [it.map_from_robot.position, it.world_from_robot.position]).collect();
    fit_motion(&pairs, heading)
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    fn samples(world_from_map: Pose, way: &[(f64, f64)]) -> Vec<Sample> {
        let sample = |&(x, y): &(f64, f64)| {
            let map_from_robot = Pose::new(x, y, 0.3);
            Sample { world_from_robot: world_from_map * map_from_robot, map_from_robot }
        };
        way.iter().map(sample).collect()
    }

    proptest! {
        #[test]
        fn a_map_that_is_only_moved_is_moved_back(x in -9.0f64..9.0, y in -9.0f64..9.0, turn in -3.0f64..3.0) {
            let world_from_map = Pose::new(x, y, turn);
            let samples = samples(world_from_map, &[(0.0, 0.0), (3.0, 0.5), (2.0, 4.0), (-1.0, 2.0)]);
            for found in [by_first_view(&samples).unwrap(), by_whole_way(&samples).unwrap()] {
                let off = world_from_map.from_here(found);
                prop_assert!(off.position.length() < 1e-9 && off.heading.abs() < 1e-9);
            }
        }
    }

    #[test]
    fn the_whole_way_shares_an_error_out_that_the_first_view_leaves_at_the_end() {
        // The robot drove 2 m along x and believes 4 m.
        let at = |world: f64, map: f64| Sample {
            world_from_robot: Pose::new(world, 0.0, 0.0),
            map_from_robot: Pose::new(map, 0.0, 0.0),
        };
        let samples = [at(0.0, 0.0), at(2.0, 4.0)];
        assert_eq!(by_first_view(&samples).unwrap().position.x, 0.0);
        assert!((by_whole_way(&samples).unwrap().position.x + 1.0).abs() < 1e-12);
    }

    #[test]
    fn a_robot_that_never_moved_is_laid_by_its_heading() {
        let still = samples(Pose::new(1.0, 2.0, 0.5), &[(0.0, 0.0), (0.0, 0.0)]);
        assert!((by_whole_way(&still).unwrap().heading - 0.5).abs() < 1e-12);
        assert_eq!(by_whole_way(&[]), None);
    }
}
