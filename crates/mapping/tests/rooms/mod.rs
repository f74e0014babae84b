//! Small buildings, and a robot with perfect odometry and an ideal laser that drives through them.

use cogmap_geometry::{DVec2, Pose, Segment, normalize_angle, trig};
use cogmap_mapping::{
    Mapper, MapperSetup, StepReport,
    memory::{ConsensusParams, PerceptualParams},
    perception::{Moment, Reading, Scan},
    places::PlacesParams,
};

const RANGE: f64 = 8.0;

/// A wall along several points.
pub(crate) fn polyline(points: &[[f64; 2]]) -> Vec<Segment> {
    points.windows(2).map(|ends| Segment::new(DVec2::from(ends[0]), DVec2::from(ends[1]))).collect()
}

/// Two rooms of 5 m by 4 m with a door of 0.9 m between them, in a wall of 0.1 m.
pub(crate) fn two_rooms() -> Vec<Segment> {
    polyline(&[
        [5.0, 1.55],
        [5.0, 0.0],
        [0.0, 0.0],
        [0.0, 4.0],
        [5.0, 4.0],
        [5.0, 2.45],
        [5.1, 2.45],
        [5.1, 4.0],
        [10.1, 4.0],
        [10.1, 0.0],
        [5.1, 0.0],
        [5.1, 1.55],
        [5.0, 1.55],
    ])
}

/// Four rooms around a pillar of walls, each with a door to the next: a ring.
pub(crate) fn ring() -> Vec<Segment> {
    let quarter = [
        // A room of 4 m by 4 m left and below of the middle, with doors of 0.9 m to the right and above.
        polyline(&[[-0.1, -2.45], [-0.1, -4.1], [-4.1, -4.1], [-4.1, -0.1], [-2.45, -0.1], [-2.45, 0.1]]),
        polyline(&[[-1.55, 0.1], [-1.55, -0.1], [-0.1, -0.1], [-0.1, -1.55], [0.1, -1.55]]),
        polyline(&[[-0.1, -2.45], [0.1, -2.45]]),
    ]
    .concat();
    (0..4)
        .flat_map(|turn| {
            let turned = Pose::new(0.0, 0.0, f64::from(turn) * trig::FRAC_PI_2);
            quarter.iter().map(move |&wall| turned * wall).collect::<Vec<_>>()
        })
        .collect()
}

/// Both mappers of the theory, each with its own form of finding places, or with `places`.
pub(crate) fn setups(places: Option<PlacesParams>) -> [MapperSetup; 2] {
    let (mut perceptual, mut consensus) = (PerceptualParams::default(), ConsensusParams::default());
    if let Some(places) = places {
        perceptual.places = places;
        consensus.places = places;
    }
    [MapperSetup::Perceptual(perceptual), MapperSetup::Consensus(Box::new(consensus))]
}

/// A robot at work.
pub(crate) struct Drive {
    walls: Vec<Segment>,
    pub(crate) pose: Pose,
    pub(crate) mapper: Mapper,
    pub(crate) reports: Vec<StepReport>,
    /// Where it truly was at each view.
    pub(crate) truth: Vec<Pose>,
    odom_from_world: Pose,
}

impl Drive {
    /// It has looked once.
    pub(crate) fn begin(walls: &[Segment], pose: Pose, setup: &MapperSetup) -> Self {
        let mut drive = Self {
            walls: walls.to_vec(),
            pose,
            mapper: Mapper::new(setup, 1),
            reports: Vec::new(),
            truth: Vec::new(),
            odom_from_world: pose.inverse(),
        };
        drive.look(Moment::StepEnd);
        drive
    }

    /// Turns to a point and goes there, looking each 30° and each `step` metres.
    pub(crate) fn go_to(&mut self, point: [f64; 2], step: f64) {
        let ahead = DVec2::from(point) - self.pose.position;
        let heading = trig::atan2(ahead.y, ahead.x);
        let turn = normalize_angle(heading - self.pose.heading);
        let turns = (turn.abs() / (trig::PI / 6.0) - 1e-9).ceil();
        let mut turned = 1.0;
        while turned < turns {
            self.turn(turn / turns);
            turned += 1.0;
        }
        let steps = (ahead.length() / step).round().max(1.0);
        let mut done = 1.0;
        let from = self.pose.position;
        while done <= steps {
            let at = from + ahead * (done / steps);
            self.pose = Pose::new(at.x, at.y, heading);
            self.look(Moment::StepEnd);
            done += 1.0;
        }
    }

    /// Turns on the spot and looks.
    pub(crate) fn turn(&mut self, angle: f64) {
        self.pose = self.pose * Pose::new(0.0, 0.0, angle);
        self.look(Moment::StepEnd);
    }

    fn look(&mut self, moment: Moment) {
        let reading = Reading {
            t: self.reports.len() as f64,
            odom_from_robot: self.odom_from_world * self.pose,
            moment,
            scan: self.scan(),
        };
        if let Some(report) = self.mapper.observe(&reading) {
            self.reports.push(report);
            self.truth.push(self.pose);
        }
    }

    fn scan(&self) -> Scan {
        let range = |beam: u32| {
            let (sin, cos) = trig::sin_cos((f64::from(beam) * 0.5 - 90.0) * trig::PI / 180.0);
            let end = self.pose * (DVec2::new(cos, sin) * RANGE);
            let ray = Segment::new(self.pose.position, end);
            let hits = self.walls.iter().filter_map(|wall| ray.crossing(*wall));
            hits.map(|hit| hit.distance(self.pose.position)).fold(f64::INFINITY, f64::min)
        };
        Scan {
            robot_from_laser: Pose::IDENTITY,
            angle_min: -trig::FRAC_PI_2,
            angle_increment: 0.5 * trig::PI / 180.0,
            range_max: RANGE,
            ranges: (0..=360).map(range).collect(),
            labels: Vec::new(),
        }
    }
}
