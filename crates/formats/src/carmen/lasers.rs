use cogmap_geometry::{Pose, normalize_angle, trig::PI};
use cogmap_mapping::perception::{Moment, Reading, Scan};

use super::message::{RawScan, Side};

/// Offsets that differ from their median by more, metres, are no offsets.
const STEADY_POSITION: f64 = 0.02;
/// Offsets that are turned against their median by more, radians, are no offsets.
const STEADY_HEADING: f64 = 0.01;
/// A laser farther from the robot's centre, metres, is not on the robot.
const ON_THE_ROBOT: f64 = 5.0;

/// What the log's `PARAM` lines say of one laser.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct LaserNotes {
    pub(super) forward: Option<f64>,
    pub(super) side: f64,
    pub(super) turn: f64,
    pub(super) range_max: Option<f64>,
}

impl LaserNotes {
    /// Where the notes put the laser; a rear laser looks back.
    fn robot_from_laser(self, side: Side) -> Option<Pose> {
        let facing = if side == Side::Front { 0.0 } else { PI };
        self.forward.map(|forward| Pose::new(forward, self.side, facing + self.turn))
    }

    /// Takes in a parameter, if it is about the laser of that name (`front` or `rear`).
    pub(super) fn note(&mut self, laser: &str, name: &str, value: &str) {
        let Some(number) = value.parse::<f64>().ok().filter(|value| value.abs() <= 1000.0) else {
            return;
        };
        let Some(rest) = name.strip_prefix("robot_").and_then(|rest| rest.strip_prefix(laser)) else {
            return;
        };
        match rest {
            "laser_offset" if number.abs() <= ON_THE_ROBOT => self.forward = Some(number),
            "laser_side_offset" if number.abs() <= ON_THE_ROBOT => self.side = number,
            "laser_angular_offset" => self.turn = number,
            "_laser_max" if number > 0.0 => self.range_max = Some(number),
            _ => {}
        }
    }
}

/// One of the robot's lasers, as the whole log tells of it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Laser {
    robot_from_laser: Pose,
    limit: RangeLimit,
}

impl Laser {
    /// The laser on that side, and a warning where its place had to be guessed.
    pub(super) fn of(scans: &[RawScan], side: Side, notes: LaserNotes) -> (Self, Option<String>) {
        let scans: Vec<&RawScan> = scans.iter().filter(|scan| scan.side == side).collect();
        let (robot_from_laser, warning) = robot_from_laser(&scans, side, notes);
        let limit = RangeLimit::of(&scans, notes);
        (Self { robot_from_laser, limit }, warning.filter(|_| !scans.is_empty()))
    }

    /// What a mapper gets to see of a scan.
    pub(super) fn reading(self, scan: RawScan) -> Reading {
        Reading {
            t: scan.t,
            odom_from_robot: scan.odom_from_robot,
            moment: Moment::StepEnd,
            scan: Scan {
                robot_from_laser: self.robot_from_laser,
                angle_min: scan.angle_min,
                angle_increment: scan.angle_increment,
                range_max: self.limit.for_scan(&scan),
                ranges: scan.ranges,
                labels: Vec::new(),
            },
        }
    }
}

/// Where a laser sits on the robot. The two poses of each line tell it, where they differ by the
/// same motion throughout; where they agree or make no sense the log's parameters do; else the
/// laser is taken to sit at the centre. The text is a warning where the poses make no sense.
fn robot_from_laser(scans: &[&RawScan], side: Side, notes: LaserNotes) -> (Pose, Option<String>) {
    let noted = notes.robot_from_laser(side);
    match steady_offset(scans) {
        Some(offset) if offset != Pose::IDENTITY => (offset, None),
        Some(offset) => (noted.unwrap_or(offset), None),
        None => {
            let facing = if side == Side::Front { 0.0 } else { PI };
            let warning = "the first pose of a scan line should be the laser's, but lies differently to the \
                           robot's from line to line; the laser's place is taken from the log's parameters, \
                           or as the robot's centre";
            (noted.unwrap_or(Pose::new(0.0, 0.0, facing)), Some(warning.to_owned()))
        }
    }
}

/// The median motion from the robot's pose to the laser's, if nearly all lines agree on it.
fn steady_offset(scans: &[&RawScan]) -> Option<Pose> {
    let offsets: Vec<Pose> =
        scans.iter().map(|scan| scan.odom_from_robot.from_here(scan.odom_from_laser)).collect();
    let first = offsets.first()?.heading;
    let middle = |value: fn(&Pose) -> f64| median(offsets.iter().map(value).collect());
    let turn = median(offsets.iter().map(|offset| normalize_angle(offset.heading - first)).collect());
    let tenth_of_millimetre = |value: f64| (value * 1e4).round() / 1e4 + 0.0;
    let median = Pose::new(
        tenth_of_millimetre(middle(|offset| offset.position.x)),
        tenth_of_millimetre(middle(|offset| offset.position.y)),
        first + turn,
    );
    let agrees = |offset: &&Pose| {
        offset.position.distance(median.position) <= STEADY_POSITION
            && normalize_angle(offset.heading - median.heading).abs() <= STEADY_HEADING
    };
    let agreeing = offsets.iter().filter(agrees).count();
    let steady = 20 * agreeing >= 19 * offsets.len() && median.position.length() <= ON_THE_ROBOT;
    steady.then_some(median)
}

fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    values.get(values.len() / 2).copied().unwrap_or_default()
}

/// The range from which on a laser's readings mean that nothing was seen, metres. The scan's own
/// line says it, or the log's parameters; but a SICK LMS answers with the codes 8183 to 8191 of its
/// unit (cm or mm) whatever it was set to. Where nothing is said, the largest value of the log is
/// the laser's limit if it comes back again and again exactly, as no measured distance does.
#[derive(Clone, Copy, Debug, PartialEq)]
struct RangeLimit {
    noted: Option<f64>,
    lms_code: Option<f64>,
    from_data: f64,
}

impl RangeLimit {
    fn of(scans: &[&RawScan], notes: LaserNotes) -> Self {
        let readings =
            || scans.iter().flat_map(|scan| &scan.ranges).copied().filter(|range| range.is_finite());
        let largest = readings().fold(0.0, f64::max);
        let lms_code = match largest {
            81.825..81.925 => Some(81.825),
            8.1825..8.1925 => Some(8.1825),
            _ => None,
        };
        let exact = readings().filter(|&range| range >= largest).count();
        let near = readings().filter(|&range| range >= 0.99 * largest).count();
        let from_data = if exact >= 3 && 2 * exact >= near { largest } else { largest.next_up() };
        Self { noted: notes.range_max, lms_code, from_data }
    }

    fn for_scan(self, scan: &RawScan) -> f64 {
        match (scan.range_max.or(self.noted), self.lms_code) {
            (Some(said), Some(code)) => said.min(code),
            (Some(limit), None) | (None, Some(limit)) => limit,
            (None, None) => self.from_data,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn scan(ranges: &[f64], odom_from_laser: Pose, odom_from_robot: Pose) -> RawScan {
        RawScan {
            side: Side::Front,
            t: 0.0,
            angle_min: 0.0,
            angle_increment: 0.1,
            range_max: None,
            ranges: ranges.to_vec(),
            odom_from_laser,
            odom_from_robot,
        }
    }

    fn limit(ranges: &[f64], notes: LaserNotes) -> f64 {
        let scan = scan(ranges, Pose::IDENTITY, Pose::IDENTITY);
        RangeLimit::of(&[&scan], notes).for_scan(&scan)
    }

    #[test]
    fn the_limit_is_what_comes_back_exactly() {
        assert_eq!(limit(&[1.0, 50.0, 50.0, 50.0, f64::INFINITY], LaserNotes::default()), 50.0);
        let seen = [1.0, 29.98, 29.99, 30.0, 30.0, 30.0, 29.95, 29.97];
        assert!(limit(&seen, LaserNotes::default()) > 30.0, "a far wall is no limit");
    }

    #[test]
    fn the_codes_of_a_sick_are_no_distances_whatever_the_log_says() {
        let notes = LaserNotes { range_max: Some(81.9), ..LaserNotes::default() };
        assert!(limit(&[47.7, 81.83], notes) < 81.83);
        assert!(limit(&[7.5, 8.183, 8.191], LaserNotes::default()) < 8.183);
        let notes = LaserNotes { range_max: Some(30.0), ..LaserNotes::default() };
        assert_eq!(limit(&[47.7, 81.83], notes), 30.0);
    }

    #[test]
    fn the_two_poses_tell_where_the_laser_sits() {
        let offset = Pose::new(0.78, 0.0, 0.0);
        let scans: Vec<RawScan> = (0..20)
            .map(|i| Pose::new(f64::from(i), 2.0, f64::from(i) * 0.4))
            .map(|robot| scan(&[1.0], robot * offset, robot))
            .collect();
        let (found, warning) =
            robot_from_laser(&scans.iter().collect::<Vec<_>>(), Side::Front, LaserNotes::default());
        assert!((found.position - offset.position).length() < 1e-12 && found.heading.abs() < 1e-9);
        assert_eq!(warning, None);
    }

    #[test]
    fn parameters_help_where_the_poses_say_nothing() {
        let mut notes = LaserNotes::default();
        notes.note("rear", "robot_rearlaser_offset", "-0.3");
        notes.note("rear", "robot_frontlaser_offset", "0.9");
        notes.note("rear", "robot_rear_laser_max", "50");
        assert_eq!((notes.forward, notes.range_max), (Some(-0.3), Some(50.0)));
        let same = scan(&[1.0], Pose::IDENTITY, Pose::IDENTITY);
        let (found, _) = robot_from_laser(&[&same], Side::Rear, notes);
        assert_eq!(found, Pose::new(-0.3, 0.0, PI));
    }

    #[test]
    fn poses_that_make_no_sense_are_told() {
        let scans: Vec<RawScan> =
            (0..20).map(|i| scan(&[1.0], Pose::new(f64::from(i), 0.0, 0.0), Pose::IDENTITY)).collect();
        let (found, warning) =
            robot_from_laser(&scans.iter().collect::<Vec<_>>(), Side::Front, LaserNotes::default());
        assert_eq!(found, Pose::IDENTITY);
        assert!(warning.is_some_and(|text| text.contains("differently")));
    }
}
