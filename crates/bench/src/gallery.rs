use cogmap_geometry::{
    DVec2, Pose, Segment,
    trig::{self, FRAC_PI_2, PI},
};
use cogmap_mapping::perception::{Moment, Reading, Scan};
use rand_core::{Rng, SeedableRng};
use rand_pcg::Pcg32;

/// Metres of the gallery that are furnished alike.
const BAY: f64 = 3.0;
/// So many bays further there is a wall across with a door in it.
const ROOM: i64 = 4;
/// Metres of a door.
const DOOR: f64 = 1.0;
/// Metres to either wall.
const HALF: f64 = 2.5;
/// Metres of a step.
const STEP: f64 = 0.3;
/// Metres that the laser sees.
const RANGE: f64 = 8.0;
const BEAMS: usize = 181;

/// A row of rooms without an end, with pillars and cupboards that chance has put up, and a robot that
/// walks through them: the map grows for as long as one likes, and so does the network of spaces.
#[derive(Clone, Default)]
pub(crate) struct Gallery {
    walked: f64,
}

impl Gallery {
    /// The next view; odometry is a little short.
    pub(crate) fn step(&mut self) -> Reading {
        self.walked += STEP;
        let (aside, turn) = (aside(self.walked), 0.3 * trig::sin(self.walked / 5.0));
        let world_from_robot = Pose::new(self.walked, aside, turn);
        let odom_from_robot = Pose::new(self.walked * 0.99, aside, turn);
        let walls = self.walls();
        let ranges = (0..BEAMS).map(|beam| range(&walls, world_from_robot, beam)).collect();
        let scan = Scan {
            robot_from_laser: Pose::IDENTITY,
            angle_min: -FRAC_PI_2,
            angle_increment: PI / (BEAMS - 1) as f64,
            range_max: RANGE,
            ranges,
            labels: Vec::new(),
        };
        Reading { t: self.walked, odom_from_robot, moment: Moment::StepEnd, scan }
    }

    /// What stands near enough to be seen.
    fn walls(&self) -> Vec<Segment> {
        let first = ((self.walked - RANGE) / BAY).floor() as i64;
        let last = ((self.walked + RANGE) / BAY).floor() as i64;
        (first..=last).flat_map(bay).collect()
    }
}

/// Metres that the robot is off the middle.
fn aside(x: f64) -> f64 {
    0.4 * trig::sin(x / 5.0)
}

/// Both walls of a bay, each with something that stands out from it, and the wall across where a room ends.
fn bay(number: i64) -> Vec<Segment> {
    let mut dice = Pcg32::seed_from_u64(number as u64);
    let mut between =
        |low: f64, high: f64| low + (high - low) * (f64::from(dice.next_u32()) / 4_294_967_296.0);
    let mut walls = Vec::new();
    if number % ROOM == 0 {
        let x = number as f64 * BAY;
        let door = [-0.5, 0.5].map(|side| DVec2::new(x, aside(x) + side * DOOR));
        walls.push(Segment::new(DVec2::new(x, -HALF), door[0]));
        walls.push(Segment::new(door[1], DVec2::new(x, HALF)));
    }
    for side in [-1.0, 1.0] {
        let x = number as f64 * BAY;
        let (from, depth) = (x + between(0.3, 1.2), between(0.3, 1.2));
        let to = from + between(0.4, 1.4);
        let points =
            [(x, HALF), (from, HALF), (from, HALF - depth), (to, HALF - depth), (to, HALF), (x + BAY, HALF)];
        let at = |(x, y): (f64, f64)| DVec2::new(x, side * y);
        walls.extend(points.windows(2).map(|pair| Segment::new(at(pair[0]), at(pair[1]))));
    }
    walls
}

fn range(walls: &[Segment], world_from_robot: Pose, beam: usize) -> f64 {
    let bearing = PI * (beam as f64 / (BEAMS - 1) as f64) - FRAC_PI_2;
    let (sin, cos) = trig::sin_cos(world_from_robot.heading + bearing);
    let origin = world_from_robot.position;
    let ray = Segment::new(origin, origin + DVec2::new(cos, sin) * RANGE);
    let hits = walls.iter().filter_map(|wall| ray.crossing(*wall));
    hits.map(|hit| hit.distance(origin)).fold(f64::INFINITY, f64::min)
}
