use cogmap_geometry::{
    Pose,
    trig::{FRAC_PI_2, PI, TAU},
};
use cogmap_simulation::Stamped;

use super::fields::{Fields, shown};

/// Readings beyond this, metres, are no distances that a robot's laser can tell.
const PLAUSIBLE_RANGE: f64 = 1000.0;

/// Which of a robot's two lasers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Side {
    Front,
    Rear,
}

/// A scan as its line tells it, before the log as a whole says where the laser sits.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct RawScan {
    pub(super) side: Side,
    pub(super) t: f64,
    pub(super) angle_min: f64,
    pub(super) angle_increment: f64,
    /// The range that the line gives as the laser's limit, metres.
    pub(super) range_max: Option<f64>,
    /// Metres; infinite where nothing was seen.
    pub(super) ranges: Vec<f64>,
    pub(super) odom_from_laser: Pose,
    pub(super) odom_from_robot: Pose,
}

impl RawScan {
    pub(super) fn shows_something(&self) -> bool {
        self.ranges.iter().any(|range| range.is_finite())
    }
}

/// One line of a log.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Message {
    Blank,
    Comment,
    Param(String, String),
    Odometry(Stamped),
    Scan(RawScan),
    Unknown(String),
}

/// Understands a line, or says what is wrong with it.
pub(super) fn parse(line: &[u8]) -> Result<Message, String> {
    let mut fields = Fields::of(line);
    let Some(keyword) = fields.word() else {
        return Ok(Message::Blank);
    };
    match keyword {
        [b'#', ..] => Ok(Message::Comment),
        b"PARAM" => param(&mut fields),
        b"ODOM" => odometry(&mut fields).map(Message::Odometry),
        b"FLASER" => half_circle(&mut fields, Side::Front).map(Message::Scan),
        b"RLASER" => half_circle(&mut fields, Side::Rear).map(Message::Scan),
        b"ROBOTLASER1" => robot_laser(&mut fields).map(Message::Scan),
        other => Ok(Message::Unknown(shown(other))),
    }
}

/// `PARAM name value …`
fn param(fields: &mut Fields<'_>) -> Result<Message, String> {
    let name = fields.word().ok_or("the parameter has no name")?;
    let value = fields.word().unwrap_or(b"");
    Ok(Message::Param(shown(name), shown(value)))
}

/// `ODOM x y theta tv rv accel time …`
fn odometry(fields: &mut Fields<'_>) -> Result<Stamped, String> {
    let pose = fields.pose("the pose")?;
    fields.skip(3, "the velocities")?;
    Ok(Stamped { t: fields.stamp()?, pose })
}

/// `FLASER n range… laser_x laser_y laser_theta odom_x odom_y odom_theta time …`: a fan of 180°
/// whose beam 0 looks right. An odd number of beams reaches the left edge, an even one (the 180 of
/// a laser set to 1°) stops one beam short of it.
fn half_circle(fields: &mut Fields<'_>, side: Side) -> Result<RawScan, String> {
    let ranges = ranges(fields)?;
    let gaps = if ranges.len() % 2 == 1 { ranges.len() - 1 } else { ranges.len() };
    let odom_from_laser = fields.pose("the laser's pose")?;
    let odom_from_robot = fields.pose("the robot's pose")?;
    Ok(RawScan {
        side,
        t: fields.stamp()?,
        angle_min: -FRAC_PI_2,
        angle_increment: PI / gaps as f64,
        range_max: None,
        ranges,
        odom_from_laser,
        odom_from_robot,
    })
}

/// `ROBOTLASER1 type start fov resolution max_range accuracy remission_mode n range… m remission…
/// laser_x laser_y laser_theta robot_x robot_y robot_theta tv rv front_safety side_safety turn_axis time …`
fn robot_laser(fields: &mut Fields<'_>) -> Result<RawScan, String> {
    fields.skip(1, "the laser's type")?;
    let angle_min = fields.bounded("the start angle", TAU)?;
    let _field_of_view = fields.number("the field of view")?;
    let angle_increment = fields.bounded("the angular resolution", TAU)?;
    let range_max = fields.number("the maximum range")?;
    fields.skip(2, "accuracy and remission mode")?;
    let ranges = ranges(fields)?;
    let fan = angle_increment * (ranges.len() - 1) as f64;
    if !(angle_increment > 0.0 && fan < TAU + angle_increment) {
        return Err(format!("{} beams {angle_increment} rad apart are no fan", ranges.len()));
    }
    let remissions = fields.count("remissions")?;
    fields.skip(remissions, "a remission")?;
    let odom_from_laser = fields.pose("the laser's pose")?;
    let odom_from_robot = fields.pose("the robot's pose")?;
    fields.skip(5, "velocities and safety distances")?;
    Ok(RawScan {
        side: Side::Front,
        t: fields.stamp()?,
        angle_min,
        angle_increment,
        range_max: (range_max > 0.0 && range_max <= PLAUSIBLE_RANGE).then_some(range_max),
        ranges,
        odom_from_laser,
        odom_from_robot,
    })
}

/// A count and so many distances; what cannot be a distance becomes "nothing seen" (REP-117).
fn ranges(fields: &mut Fields<'_>) -> Result<Vec<f64>, String> {
    let count = fields.count("readings")?;
    if count < 2 {
        return Err(format!("a scan of {count} readings shows nothing"));
    }
    let readings = fields.numbers(count, "a reading")?;
    let distance = |r: f64| if r > 0.0 && r <= PLAUSIBLE_RANGE { r } else { f64::INFINITY };
    Ok(readings.into_iter().map(distance).collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn scan(line: &str) -> RawScan {
        match parse(line.as_bytes()) {
            Ok(Message::Scan(scan)) => scan,
            other => panic!("{other:?}"),
        }
    }

    fn fan_of(beams: usize) -> (f64, f64) {
        let readings = " 1.5".repeat(beams);
        let scan = scan(&format!("FLASER {beams}{readings} 0 0 0 0 0 0 9.5 host 0.1"));
        let last = scan.angle_min + scan.angle_increment * (beams - 1) as f64;
        (scan.angle_increment.to_degrees(), last.to_degrees())
    }

    #[test]
    fn old_scans_span_half_a_circle() {
        for (beams, spacing, last) in [(180, 1.0, 89.0), (181, 1.0, 90.0), (360, 0.5, 89.5), (361, 0.5, 90.0)]
        {
            let fan = fan_of(beams);
            assert!((fan.0 - spacing).abs() < 1e-9 && (fan.1 - last).abs() < 1e-9, "{beams}: {fan:?}");
        }
    }

    #[test]
    fn the_first_pose_is_the_lasers_and_the_first_stamp_counts() {
        let scan = scan("RLASER 3 1 nan -2 1 2 0.5 3 4 0.25 976052857.337 host 0.012");
        assert_eq!(scan.odom_from_laser, Pose::new(1.0, 2.0, 0.5));
        assert_eq!(scan.odom_from_robot, Pose::new(3.0, 4.0, 0.25));
        assert_eq!((scan.t, scan.side), (976_052_857.337, Side::Rear));
        assert_eq!(scan.ranges, [1.0, f64::INFINITY, f64::INFINITY]);
    }

    #[test]
    fn new_scans_tell_their_own_fan_and_limit() {
        let scan =
            scan("ROBOTLASER1 0 -1.5 3 0.5 50 0.01 0 3 1 2 3 2 7 7 0.1 0 0 0 0 0 0 0 0 0 0 12.5 host 1");
        assert_eq!((scan.angle_min, scan.angle_increment, scan.range_max), (-1.5, 0.5, Some(50.0)));
        assert_eq!((scan.t, scan.odom_from_laser), (12.5, Pose::new(0.1, 0.0, 0.0)));
    }

    #[test]
    fn what_is_wrong_with_a_line_is_said() {
        for (line, reason) in [
            ("FLASER 180 1 2 3", "announces 180 readings but has only 3 words"),
            ("FLASER 1e18 1", "not a whole number up to"),
            ("FLASER -1", "not a whole number"),
            ("FLASER x", "`x` is not a number"),
            ("FLASER", "ends before the number of readings"),
            ("FLASER 1 1 0 0 0 0 0 0 1", "shows nothing"),
            ("FLASER 2 1 1 0 0 0 0 0 0", "ends before the time stamp"),
            ("FLASER 2 1 1 0 0 0 0 inf 0 1", "the robot's pose is inf"),
            ("FLASER 2 1 1 0 0 0 0 0 0 1e300", "the time stamp is 1e300"),
            ("ODOM 0 0 NaN 0 0 0 1", "the pose is NaN"),
            ("ODOM 0 0 0 0 0", "ends before the velocities"),
            ("ROBOTLASER1 0 0 0 -1 9 0 0 2 1 1 0", "are no fan"),
            ("PARAM", "has no name"),
        ] {
            let error = parse(line.as_bytes()).unwrap_err();
            assert!(error.contains(reason), "{line}: {error}");
        }
    }
}
