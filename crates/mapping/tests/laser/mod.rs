//! A laser without noise, in worlds of straight walls.

use cogmap_geometry::{DVec2, Pose, Segment, trig};
use cogmap_mapping::perception::{Moment, Reading, Scan};

/// How far it sees, metres.
const RANGE: f64 = 12.0;

/// What the robot's program is given when it truly is at one place and believes to be at another.
pub(crate) fn reading(t: f64, walls: &[Segment], world_from_robot: Pose, odom_from_robot: Pose) -> Reading {
    let ranges = (0..361).map(|beam| {
        let (sin, cos) = trig::sin_cos(world_from_robot.heading + f64::from(beam - 180).to_radians() / 2.0);
        let origin = world_from_robot.position;
        let ray = Segment::new(origin, origin + DVec2::new(cos, sin) * RANGE);
        let hits = walls.iter().filter_map(|wall| ray.crossing(*wall));
        hits.map(|hit| hit.distance(origin)).fold(f64::INFINITY, f64::min)
    });
    let scan = Scan {
        robot_from_laser: Pose::IDENTITY,
        angle_min: -trig::FRAC_PI_2,
        angle_increment: trig::PI / 360.0,
        range_max: RANGE,
        ranges: ranges.collect(),
        labels: Vec::new(),
    };
    Reading { t, odom_from_robot, moment: Moment::StepEnd, scan }
}

/// Walls through these points.
pub(crate) fn walls(points: &[(f64, f64)]) -> Vec<Segment> {
    points.windows(2).map(|pair| Segment::new(pair[0].into(), pair[1].into())).collect()
}
