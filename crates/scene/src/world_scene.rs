use cogmap_geometry::{DVec2, Pose, Segment, trig};
use cogmap_mapping::perception::Scan;
use cogmap_simulation::{BodyParams, Door, Robot, Room, Session, Source, World};
use serde::{Deserialize, Serialize};

use crate::{
    Item, LegendEntry, Role, Sample, Scene, Shape,
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
}

impl Default for WorldOptions {
    fn default() -> Self {
        Self { laser: true, path: true, labels: true }
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
    if let Source::World { world, .. } = &session.record().source {
        draw_world(&mut scene, world, options);
    }
    if options.path {
        let mut points: Vec<_> = way.iter().map(|stamped| stamped.pose.position).collect();
        points.dedup();
        let tail = points.last().map(|last| vec![*last, robot.position]);
        scene.changing.extend(tail.map(|tail| Item::new(Role::TruePath, Shape::Polyline(tail))));
        scene.still.push(Item::new(Role::TruePath, Shape::Polyline(points)));
        scene.explain(Sample::Line(Role::TruePath), "its way");
    }
    if let (true, Some(scan), Some(taken)) = (options.laser, session.last_scan(), way.last()) {
        scene.changing.extend(laser(scan, taken.pose));
        scene.explain(Sample::Area(Role::LaserFan), "what the laser sees");
    }
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

fn draw_world(scene: &mut Scene, world: &World, options: WorldOptions) {
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
fn laser(scan: &Scan, frame_from_robot: Pose) -> [Item; 2] {
    const FARTHEST_DRAWN: f64 = 8.19;
    let frame_from_laser = frame_from_robot * scan.robot_from_laser;
    let beams = 0..scan.ranges.len();
    let hits: Vec<_> = beams.clone().filter_map(|beam| Some(frame_from_laser * scan.point(beam)?)).collect();
    let ends = beams.map(|beam| {
        let free = scan.range(beam).unwrap_or_else(|| scan.range_max.min(FARTHEST_DRAWN));
        let (sin, cos) = trig::sin_cos(scan.bearing(beam));
        frame_from_laser * (DVec2::new(cos, sin) * free)
    });
    let fan = core::iter::once(frame_from_laser.position).chain(ends).collect();
    [Item::new(Role::LaserFan, Shape::Polygon(fan)), Item::new(Role::LaserHit, Shape::Signs(hits))]
}

impl Scene {
    pub(crate) fn explain(&mut self, sample: Sample, text: &str) {
        self.legend.push(LegendEntry::new(sample, text));
    }
}
