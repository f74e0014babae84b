use cogmap_geometry::{DVec2, Metric, Pose, trig};
use cogmap_mapping::perception::{Reading, Scan};

/// Only what is nearer than this can have gone away, metres: farther off it is in nobody's way.
pub(super) const NEAR: f64 = 2.0;
/// The points of a scan, in the odometry's frame; over so short a way odometry does not drift.
#[derive(Clone, Debug)]
pub(super) struct Sight {
    pub(super) t: f64,
    pub(super) odom_from_robot: Pose,
    pub(super) points: Vec<Seen>,
}

/// A point, and along what the surface there runs, as a unit vector; nothing where it stands alone or was not seen
/// squarely.
#[derive(Clone, Copy, Debug)]
pub(super) struct Seen {
    pub(super) at: DVec2,
    along: DVec2,
}

/// Points of a scan that are nearer to each other than this are one surface's, metres.
const TOGETHER: f64 = 0.15;
/// The sine of the angle up to which a beam grazes a surface and tells nothing of it: 20°. A door leaf seen from its
/// edge is as good as invisible.
const GRAZING: f64 = 0.34;
impl Sight {
    pub(super) fn of(reading: &Reading) -> Self {
        Self { t: reading.t, odom_from_robot: reading.odom_from_robot, points: seen(reading) }
    }

    /// Drops the points past which a later scan sees clearly, on both sides too: what was there has moved on.
    pub(super) fn forget_what_is_gone(&mut self, later: &Reading, gone: f64) {
        let odom_from_laser = later.odom_from_robot * later.scan.robot_from_laser;
        let (scan, laser_from_odom) = (&later.scan, odom_from_laser.inverse());
        let origin = laser_from_odom.position;
        let (x, y) = (laser_from_odom.rotate(DVec2::X), laser_from_odom.rotate(DVec2::Y));
        let laser = odom_from_laser.position;
        self.points.retain(|&Seen { at, along }| {
            let seen = origin + x * at.x + y * at.y;
            let grazes = along.perp_dot(at - laser).abs() < GRAZING * seen.length() * along.length();
            seen.length() > NEAR || grazes || !sees_past(scan, seen, gone)
        });
    }
}

/// The points of a scan in odometry's frame.
fn seen(reading: &Reading) -> Vec<Seen> {
    let odom_from_laser = reading.odom_from_robot * reading.scan.robot_from_laser;
    let turn = odom_from_laser.forward();
    let place = |point: DVec2| odom_from_laser.position + turn.rotate(point);
    let points: Vec<DVec2> =
        (0..reading.scan.ranges.len()).filter_map(|beam| reading.scan.point(beam)).map(place).collect();
    let along = |k: usize| {
        let span = points[(k + 1).min(points.len() - 1)] - points[k.saturating_sub(1)];
        let (along, beam) = (span.unit_or_zero(), points[k] - odom_from_laser.position);
        let squarely = along.perp_dot(beam).abs() >= GRAZING * beam.norm();
        if span.norm() < TOGETHER && squarely { along } else { DVec2::ZERO }
    };
    (0..points.len()).map(|k| Seen { at: points[k], along: along(k) }).collect()
}

/// Whether a scan sees past a point in its laser's frame by so much, on both sides too.
pub(super) fn sees_past(scan: &Scan, point: DVec2, by: f64) -> bool {
    let beam = (trig::atan2(point.y, point.x) - scan.angle_min) / scan.angle_increment;
    if beam < 1.0 {
        return false;
    }
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "it is positive")]
    let beam = beam.round() as usize;
    let past = |beam: usize| scan.range(beam).is_some_and(|seen| seen > point.length() + by);
    past(beam - 1) && past(beam) && past(beam + 1)
}

#[cfg(test)]
mod tests {
    use cogmap_mapping::perception::Moment;

    use super::*;

    /// What a robot sees of a door leaf on the x axis from 1 to 2 m, before a wall at x = 5 m, from a place on x = 0
    /// so far beside the leaf's line, looking along x.
    fn reading(aside: f64) -> Reading {
        let ranges = (0..361).map(|beam| {
            let bearing = f64::from(beam - 180) * 0.5_f64.to_radians();
            let (sin, cos) = trig::sin_cos(bearing);
            let on_leaf = -aside / sin;
            let hit = aside != 0.0 && (1.0..=2.0).contains(&(on_leaf * cos)) && on_leaf > 0.0;
            if hit { on_leaf } else { 5.0 / cos.max(0.6) }
        });
        let scan = Scan {
            robot_from_laser: Pose::IDENTITY,
            angle_min: -trig::FRAC_PI_2,
            angle_increment: 0.5_f64.to_radians(),
            range_max: 9.0,
            ranges: ranges.collect(),
            labels: Vec::new(),
        };
        Reading { t: 0.0, odom_from_robot: Pose::new(0.0, aside, 0.0), moment: Moment::StepEnd, scan }
    }

    #[test]
    fn a_door_leaf_seen_from_its_edge_is_still_there_and_one_that_is_looked_through_has_gone() {
        let leaf = |sight: &Sight| {
            sight.points.iter().filter(|seen| seen.at.x < 2.5 && seen.at.y.abs() < 0.1).count()
        };
        let mut sight = Sight::of(&reading(0.8));
        let before = leaf(&sight);
        assert!(before > 20, "{before}");
        sight.forget_what_is_gone(&reading(0.0), 0.25);
        assert!(leaf(&sight) + 2 >= before, "{} of {before}", leaf(&sight));
        let gone = Reading { odom_from_robot: Pose::new(0.0, 0.8, 0.0), ..reading(0.0) };
        sight.forget_what_is_gone(&gone, 0.25);
        assert!(leaf(&sight) <= 4, "{} of {before}", leaf(&sight));
    }
}
