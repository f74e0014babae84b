use super::Sample;

/// How far the two ends of a closed way fail to meet in the map.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Closing {
    /// Metres between the two places of what is around the robot.
    pub gap: f64,
    /// Radians between their two directions.
    pub heading: f64,
}

/// At the revisit, where the last view puts a wall of the place and where the first view has it:
/// the offset at the robot's place, and the turn.
#[must_use]
pub fn closing(samples: &[Sample]) -> Option<Closing> {
    let (first, last) = (samples.first()?, samples.last()?);
    let map_from_world = first.world_from_map().inverse();
    let should_be = map_from_world * last.world_from_robot;
    let off = should_be.from_here(last.map_from_robot);
    Some(Closing { gap: off.position.length(), heading: off.heading.abs() })
}

#[cfg(test)]
mod tests {
    use cogmap_geometry::Pose;

    use super::*;

    #[test]
    fn a_robot_back_home_that_believes_to_be_elsewhere_has_a_gap() {
        let home = Pose::new(3.0, 2.0, 1.0);
        let first = Sample { world_from_robot: home, map_from_robot: Pose::IDENTITY };
        let last = Sample { world_from_robot: home, map_from_robot: Pose::new(0.3, -0.4, -0.1) };
        let found = closing(&[first, last]).unwrap();
        assert!((found.gap - 0.5).abs() < 1e-12 && (found.heading - 0.1).abs() < 1e-12);
        assert_eq!(closing(&[]), None);
    }

    #[test]
    fn a_robot_that_ends_elsewhere_and_knows_it_has_none() {
        let start = Pose::new(3.0, 2.0, 1.0);
        let moved = Pose::new(1.0, 0.5, 0.7);
        let first = Sample { world_from_robot: start, map_from_robot: Pose::IDENTITY };
        let last = Sample { world_from_robot: start * moved, map_from_robot: moved };
        assert!(closing(&[first, last]).unwrap().gap < 1e-12);
    }
}
