use cogmap_geometry::{DVec2, Pose, Segment, trig};
use cogmap_mapping::{MapperSetup, memory::Matching, traditional::OdometryParams};
use cogmap_scene::{Annotation, Item, LegendEntry, Role, Sample, Scene, Shape};

use super::{
    Drawing, Runs,
    draw::{arc, degrees, lines, panel, robot, role, word},
    maps::{off_in_the_end, panel_of, plan_of},
    outings::RING,
    stage::Stage,
};

/// A wall and nothing else.
const WALL: &str = r#"{"format": "cogmap-world/1", "name": "A wall", "start": {"position": [0, 0]},
    "walls": [[[4.6, -1.9], [4.6, 1.9]]]}"#;
/// What the wheels tell too much in each step, radians.
const EXTRA_TURN: f64 = 9.0 * trig::PI / 180.0;
/// Metres of each step.
const STEP: f64 = 0.7;

/// Fig. 2.5: the odometry mapper, told a turn that never was, once in each step.
pub(super) fn of_turns(_: &mut Runs) -> Result<Drawing, String> {
    let stage = Stage::new(WALL)?;
    let places: Vec<Pose> = (0..3).map(|step| Pose::new(STEP * f64::from(step), 0.0, 0.0)).collect();
    let wrong = Pose::new(0.0, 0.0, EXTRA_TURN) * Pose::new(STEP, 0.0, 0.0);
    let told = [Pose::IDENTITY, wrong, wrong * wrong];
    // Every sighting is kept, so that all three can be seen.
    let never = Matching { distance: 0.0, angle: 0.0, ..Matching::default() };
    let setup = MapperSetup::Odometry(OdometryParams { matching: never, ..OdometryParams::default() });
    let (mapper, reports) = stage.map(&setup, &places, &told)?;
    let walls: Vec<Segment> = mapper.mfis().surfaces().iter().map(|surface| surface.segment).collect();
    let turns: Vec<f64> = walls.iter().map(|wall| walls[0].angle_to(*wall)).collect();
    let path = reports.iter().map(|report| report.map_from_robot.position).collect();
    let mut items = vec![Item::new(Role::Path, Shape::Polyline(path))];
    items.extend(angles(&walls, &turns));
    for (view, (wall, report)) in walls.iter().zip(&reports).enumerate() {
        let robot_at = report.map_from_robot;
        let (low, down) = (wall.midpoint() * 2.0 - top(*wall), wall.midpoint() - top(*wall));
        items.push(lines(Role::SurfaceOfView(view), [*wall]));
        items.push(word(low + down.normalize_or_zero() * 0.2, format!("view {}", view + 1)));
        items.push(robot(Role::BelievedRobot, robot_at));
        items.push(word(robot_at.position - DVec2::new(0.0, 0.5), format!("R{}", view + 1)));
    }
    let mut panel = panel("", items, &LEGEND);
    panel.scene.views = 4;
    let turned = |view: usize| turns.get(view).copied().map_or(String::new(), degrees);
    Ok(Drawing {
        panels: vec![panel],
        columns: 1,
        outcome: format!("After one step the wall is turned by {}, after two by {}.", turned(1), turned(2)),
        source: "the odometry mapper, told a turn of 9° in each step straight ahead".to_owned(),
    })
}

const LEGEND: [(Sample, &str); 5] = [
    (Sample::Robot(Role::BelievedRobot), "where odometry puts the robot"),
    (Sample::Line(Role::SurfaceOfView(0)), "the wall as first seen"),
    (Sample::Line(Role::SurfaceOfView(1)), "a step later"),
    (Sample::Line(Role::SurfaceOfView(2)), "two steps later"),
    (Sample::Line(role(Annotation::Measure)), "how far it is turned"),
];

/// The upper end of a wall.
fn top(wall: Segment) -> DVec2 {
    if wall.a.y > wall.b.y { wall.a } else { wall.b }
}

/// An arc from the first wall to each later one, with the angle.
fn angles(walls: &[Segment], turns: &[f64]) -> Vec<Item> {
    let mut items = Vec::new();
    let Some(first) = walls.first() else { return items };
    for (index, (wall, turn)) in walls.iter().zip(turns).enumerate().skip(1) {
        let Some(meeting) = meeting(*first, *wall) else { continue };
        let radius = 0.5 + 0.28 * index as f64;
        let up = |wall: Segment| {
            let end = top(wall);
            trig::atan2(end.y - meeting.y, end.x - meeting.x)
        };
        items.push(Item::new(role(Annotation::Measure), arc(meeting, radius, up(*first), up(*wall))));
        let beside = DVec2::new(trig::cos(up(*first)), trig::sin(up(*first))) * radius;
        items.push(word(meeting + beside + DVec2::new(0.35, 0.0), degrees(*turn)));
    }
    items
}

/// Where two lines meet.
fn meeting(first: Segment, second: Segment) -> Option<DVec2> {
    let (along, other) = (first.direction()?, second.direction()?);
    let cross = along.perp_dot(other);
    (cross.abs() > 1e-9).then(|| first.a + along * ((second.a - first.a).perp_dot(other) / cross))
}

/// Steps of one lap.
const LAP: usize = 18;

/// Fig. 2.6: two laps, each in its own colour.
pub(super) fn two_laps(runs: &mut Runs) -> Result<Drawing, String> {
    let run = runs.of(&RING)?;
    let (mapper, _) = run.mind("odometry")?;
    let mfis = mapper.mfis();
    let of_lap = |lap: usize| {
        let of_lap = mfis.surfaces().iter().filter(move |surface| (surface.step > LAP) == (lap == 1));
        let lines = of_lap.map(|surface| mfis.in_map(surface)).collect();
        Item::new(Role::SurfaceOfView(lap), Shape::Segments(lines))
    };
    let path: Vec<DVec2> = mapper.path().iter().map(|point| mfis.place_of(point).position).collect();
    let still = vec![of_lap(0), of_lap(1), Item::new(Role::Path, Shape::Polyline(path))];
    let legend = vec![
        LegendEntry::new(Sample::Line(Role::SurfaceOfView(0)), "first lap"),
        LegendEntry::new(Sample::Line(Role::SurfaceOfView(1)), "second lap"),
        LegendEntry::new(Sample::Line(Role::Path), "where odometry takes the robot"),
    ];
    let map = Scene { still, legend, views: 2, ..Scene::default() }.seen_from(run.world_from_map());
    let (_, off) = off_in_the_end(&run, "odometry")?;
    Ok(Drawing {
        panels: vec![panel_of("The building", plan_of(&run)), panel_of("The map after two laps", map)],
        columns: 2,
        outcome: format!("In the end the robot is wrong about its heading by {:.0}°.", off.to_degrees()),
        source: format!("odometry alone, {}", run.words()),
    })
}
