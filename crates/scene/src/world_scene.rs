use cogmap_geometry::{DVec2, Pose, Segment, trig};
use cogmap_mapping::perception::Scan;
use cogmap_simulation::{BodyParams, Disc, Door, Robot, Room, Session, Source, World};
use serde::{Deserialize, Serialize};

use crate::{
    Item, LegendEntry, Role, Sample, Scene, Shape, homing_scene,
    label::{label_place, plural},
};

/// What of the world is shown.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct WorldOptions {
    /// What the laser saw last.
    pub laser: bool,
    /// Where the robot went.
    pub path: bool,
    /// The names of the rooms.
    pub labels: bool,
    /// Where the run began, also before the robot is told to go back there.
    pub home: bool,
}

impl Default for WorldOptions {
    fn default() -> Self {
        Self { laser: true, path: true, labels: true, home: false }
    }
}

/// The world as it is, which the robot never sees. A recorded log has no truth: there it is where
/// odometry takes the robot.
#[must_use]
pub fn world_scene(session: &Session, options: WorldOptions) -> Scene {
    let journal = session.journal();
    let (way, robot) = match session.world_from_robot() {
        Some(pose) => (&journal.truth, pose),
        None => (&journal.odometry, session.odom_from_robot()),
    };
    let (title, note) = words(session, way.len());
    let mut scene = Scene { title, note, ..Scene::default() };
    scene.explain(Sample::Robot(Role::Robot), "robot");
    if let Some(world) = session.world() {
        draw_world(&mut scene, world, options);
    }
    if options.path {
        let mut points: Vec<_> = way.iter().map(|stamped| (stamped.t, stamped.pose.position)).collect();
        points.dedup_by_key(|(_, place)| *place);
        let tail = points.last().map(|(_, last)| vec![*last, robot.position]);
        homing_scene::draw_path(&mut scene, session, &points, tail, Role::TruePath);
    }
    if let (true, Some(scan), Some(taken)) = (options.laser, session.last_scan(), way.last()) {
        scene.changing.extend(laser(scan, taken.pose));
        scene.explain(Sample::Area(Role::LaserFan), "what the laser sees");
    }
    let told = !homing_scene::times_home(session).is_empty();
    if let Some(world) = session.world().filter(|_| options.home || told) {
        homing_scene::draw_home(&mut scene, world.start.position.into(), "home");
    }
    draw_people(&mut scene, session.people());
    scene.changing.push(Item::new(Role::Robot, Shape::Robot(robot, robot_radius(session))));
    scene
}

/// Radius of the robot's footprint, metres.
pub(crate) fn robot_radius(session: &Session) -> f64 {
    match &session.record().source {
        Source::World { robot: Robot { body, .. }, .. } => body.radius,
        Source::Log { .. } => BodyParams::default().radius,
    }
}

/// The walls of a world, metres.
pub(crate) fn walls(world: &World) -> Vec<Segment> {
    let pairs = world.walls.iter().flat_map(|wall| wall.iter().zip(wall.iter().skip(1)));
    pairs.map(|(a, b)| Segment::new((*a).into(), (*b).into())).collect()
}

fn words(session: &Session, scans: usize) -> (String, String) {
    let scans = plural(scans, "scan");
    match &session.record().source {
        Source::World { world, robot, .. } => {
            (world.name.clone(), format!("The world · {} robot · {scans}", robot.name))
        }
        Source::Log { path, .. } => {
            let name = path.rsplit(['/', '\\']).next().unwrap_or(path);
            (name.to_owned(), format!("Where odometry takes the robot · {scans}"))
        }
    }
}

pub(crate) fn draw_world(scene: &mut Scene, world: &World, options: WorldOptions) {
    let corners = |room: &Room| room.outline.iter().copied().map(DVec2::from).collect::<Vec<_>>();
    let still = &mut scene.still;
    still.extend(world.rooms.iter().map(|room| Item::new(Role::Room, Shape::Polygon(corners(room)))));
    let boxes = world.boxes.iter().map(|furniture| Shape::Polygon(furniture.corners().to_vec()));
    let posts = world.posts.iter().map(|post| Shape::Disc(post.center.into(), post.radius));
    still.extend(boxes.chain(posts).map(|shape| Item::new(Role::Furniture, shape)));
    still.push(Item::new(Role::Wall, Shape::Segments(walls(world))));
    still.extend(world.doors.iter().map(|door| Item::new(Role::DoorSwing, Shape::Polyline(swing(door)))));
    let leaves = world.doors.iter().map(Door::leaf).collect();
    still.push(Item::new(Role::Door, Shape::Segments(leaves)));
    if options.labels {
        let labels = world.rooms.iter().filter_map(|room| {
            let (at, width) = label_place(&corners(room))?;
            Some(Item::new(Role::RoomLabel, Shape::Label { at, text: room.name.clone(), room: width }))
        });
        still.extend(labels);
    }
    if !world.doors.is_empty() {
        scene.explain(Sample::Line(Role::Door), "door");
    }
    if !(world.boxes.is_empty() && world.posts.is_empty()) {
        scene.explain(Sample::Area(Role::Furniture), "furniture");
    }
}

pub(crate) fn draw_people(scene: &mut Scene, people: &[Disc]) {
    let discs = people.iter().map(|person| Shape::Disc(person.center, person.radius));
    scene.changing.extend(discs.map(|disc| Item::new(Role::Person, disc)));
    if !people.is_empty() {
        scene.explain(Sample::Sign(Role::Person), "somebody walking");
    }
}

/// The quarter circle along which the end of a door leaf swings; nothing for a closed door.
fn swing(door: &Door) -> Vec<DVec2> {
    const PIECES: u32 = 12;
    let (hinge, latch) = (DVec2::from(door.hinge), DVec2::from(door.latch));
    let turned = |i: u32| {
        let pose = Pose::new(hinge.x, hinge.y, trig::FRAC_PI_2 * f64::from(i) / f64::from(PIECES));
        pose * (latch - hinge)
    };
    if door.open { (0..=PIECES).map(turned).collect() } else { Vec::new() }
}

/// The area that a scan found free, and the points that it hit.
pub(crate) fn laser(scan: &Scan, frame_from_robot: Pose) -> [Item; 2] {
    let frame_from_laser = frame_from_robot * scan.robot_from_laser;
    let carried = |points: Vec<DVec2>| points.into_iter().map(|point| frame_from_laser * point).collect();
    let hits = (0..scan.ranges.len()).filter_map(|beam| scan.point(beam)).collect();
    let fan = Shape::Polygon(carried(fan(scan)));
    [Item::new(Role::LaserFan, fan), Item::new(Role::LaserHit, Shape::Signs(carried(hits)))]
}

/// The outline of what a scan saw, in the laser's frame. A few lost beams make no gap in it; where
/// more in a row saw nothing it leads back to the laser.
fn fan(scan: &Scan) -> Vec<DVec2> {
    const LOST: usize = 8;
    let mut outline = vec![DVec2::ZERO];
    let mut missing = 0;
    for beam in 0..scan.ranges.len() {
        if let Some(point) = scan.point(beam) {
            if missing > LOST {
                outline.push(DVec2::ZERO);
            }
            outline.push(point);
            missing = 0;
        } else {
            missing += 1;
        }
    }
    outline
}

impl Scene {
    pub(crate) fn explain(&mut self, sample: Sample, text: &str) {
        self.legend.push(LegendEntry::new(sample, text));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn scan(ranges: Vec<f64>) -> Scan {
        let angle_increment = trig::PI / 180.0;
        Scan {
            robot_from_laser: Pose::IDENTITY,
            angle_min: 0.0,
            angle_increment,
            range_max: 8.0,
            ranges,
            labels: Vec::new(),
        }
    }

    #[test]
    fn the_fan_reaches_no_farther_than_the_laser_saw() {
        let mut ranges = vec![2.0; 60];
        ranges[5..8].fill(f64::INFINITY);
        ranges[20..40].fill(f64::NAN);
        let outline = fan(&scan(ranges));
        assert!(outline.iter().all(|point| point.length() < 2.0 + 1e-12));
        assert_eq!(outline.iter().filter(|point| **point == DVec2::ZERO).count(), 2, "the start and one gap");
        assert_eq!(outline.len(), 2 + 60 - 3 - 20);
    }

    #[test]
    fn only_an_open_door_swings() {
        let door = Door { name: "d".into(), hinge: [1.0, 1.0], latch: [2.0, 1.0], open: true };
        let way = swing(&door);
        let [first, .., last] = way.as_slice() else { panic!("{way:?}") };
        assert!(first.distance(door.latch.into()) < 1e-12 && last.distance(door.leaf().b) < 1e-12);
        assert!(swing(&Door { open: false, ..door }).is_empty());
    }
}
