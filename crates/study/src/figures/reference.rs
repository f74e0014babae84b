use cogmap_geometry::{DVec2, Pose, Segment};
use cogmap_mapping::{
    MapperSetup, StepReport,
    memory::{PerceptualParams, Reference, ReferenceQuality},
    perception::Surface,
};
use cogmap_scene::{Annotation, Item, Role, Sample, Shape};

use super::{
    Drawing, Runs,
    draw::{degrees, lines, panel, ring, robot, role, surfaces, word},
    stage::Stage,
};

/// A room with a round pillar.
const ROOM: &str = r#"{"format": "cogmap-world/1", "name": "Room with a pillar", "start": {"position": [1, 1]},
    "walls": [[[0, 0], [7, 0], [7, 4.6], [0, 4.6], [0, 0]]],
    "posts": [{"center": [3.1, 3.0], "radius": 0.4}],
    "boxes": [{"center": [5.6, 0.5], "size": [0.9, 0.5]}]}"#;
const PILLAR: DVec2 = DVec2::new(3.1, 3.0);
/// Its radius, metres.
const RADIUS: f64 = 0.4;
/// How much larger the close-up is.
const LARGER: f64 = 4.0;
const FIRST: Pose = Pose { position: DVec2::new(0.9, 1.6), heading: 0.3 };
const SECOND: Pose = Pose { position: DVec2::new(1.5, 1.45), heading: 0.35 };

const KNOWN: Role = role(Annotation::Known);
const SEEN: Role = role(Annotation::Added);

/// Two views of the room and what the perceptual mapper makes of them, with every recognised pair
/// among its references, also those that it would set aside.
fn step() -> Result<[StepReport; 2], String> {
    let stage = Stage::new(ROOM)?;
    let reference = ReferenceQuality { agreement: f64::INFINITY, ..ReferenceQuality::default() };
    let params = PerceptualParams { reference, ..PerceptualParams::default() };
    let places = [FIRST, SECOND];
    let (_, reports) = stage.map(&MapperSetup::Perceptual(params), &places, &places)?;
    reports.try_into().map_err(|_| "the robot took no two views".to_owned())
}

/// The surface of a view that was fitted to the pillar.
fn pillar_in(report: &StepReport, world_from_robot: Pose) -> Option<(usize, &Surface)> {
    let distance = |surface: &Surface| (world_from_robot * surface.segment).midpoint().distance(PILLAR);
    let surfaces = report.view.surfaces.iter().enumerate();
    let near = surfaces.filter(|(_, surface)| distance(surface) < 0.6);
    near.max_by(|a, b| a.1.length().total_cmp(&b.1.length()))
}

/// Fig. 3.17.
pub(super) fn changing_shape(_: &mut Runs) -> Result<Drawing, String> {
    let [first, second] = step()?;
    let before = pillar_in(&first, FIRST).ok_or("the pillar was not seen")?.1;
    let after = pillar_in(&second, SECOND).ok_or("the pillar was not seen")?.1;
    let (before, after) = (FIRST * before.segment, SECOND * after.segment);
    let large = |line: Segment| Segment::new((line.a - PILLAR) * LARGER, (line.b - PILLAR) * LARGER);
    let close = vec![
        Item::new(Role::Furniture, Shape::Disc(DVec2::ZERO, RADIUS * LARGER)),
        lines(KNOWN, [large(before)]),
        lines(SEEN, [large(after)]),
    ];
    let legend = [
        (Sample::Robot(Role::BelievedRobot), "R1, the robot at first"),
        (Sample::Robot(Role::Robot), "R2, a step later"),
        (Sample::Line(KNOWN), "seen from R1"),
        (Sample::Line(SEEN), "seen from R2"),
        (Sample::Area(Role::Furniture), "the pillar"),
    ];
    Ok(Drawing {
        panels: vec![
            panel("Both views as they truly lie", both_views(&first, &second), &legend),
            panel(format!("The pillar, {LARGER} times as large"), close, &[]),
        ],
        columns: 2,
        outcome: format!(
            "Here it turns by {} and is {:.2} m long, then {:.2} m.",
            degrees(before.angle_to(after)),
            before.length(),
            after.length()
        ),
        source: "two views of a robot without errors in a room made for it".to_owned(),
    })
}

fn both_views(first: &StepReport, second: &StepReport) -> Vec<Item> {
    let below = DVec2::new(0.0, 0.5);
    vec![
        Item::new(Role::Furniture, Shape::Disc(PILLAR, RADIUS)),
        surfaces(KNOWN, FIRST, &first.view.surfaces),
        surfaces(SEEN, SECOND, &second.view.surfaces),
        robot(Role::BelievedRobot, FIRST),
        robot(Role::Robot, SECOND),
        word(FIRST.position - below, "R1"),
        word(SECOND.position - below, "R2"),
        ring(PILLAR, RADIUS + 0.25),
    ]
}

/// Fig. 3.18.
pub(super) fn displacement(_: &mut Runs) -> Result<Drawing, String> {
    let [first, second] = step()?;
    let (pillar, _) = pillar_in(&second, SECOND).ok_or("the pillar was not seen")?;
    let best = second.references.iter().find(|reference| reference.seen != pillar);
    let bad = second.references.iter().find(|reference| reference.seen == pillar);
    let (best, bad) = best.zip(bad).ok_or("the pillar was not recognised")?;
    let turned = (bad.map_from_robot.heading - best.map_from_robot.heading).abs();
    let farthest = farthest_apart(&second, best, bad);
    let legend = [
        (Sample::Robot(Role::Robot), "robot"),
        (Sample::Line(KNOWN), "in the map"),
        (Sample::Line(SEEN), "current view"),
        (Sample::Line(Role::ReferenceSeen), "reference"),
    ];
    Ok(Drawing {
        panels: vec![
            panel("Placed by the best reference", placed(&first, &second, best), &legend),
            panel("Placed by the pillar", placed(&first, &second, bad), &legend),
        ],
        columns: 2,
        outcome: format!(
            "An error of {} in the reference puts the farthest surface off by {farthest:.2} m.",
            degrees(turned)
        ),
        source: "the perceptual mapper in a room made for it; by itself it would not take the pillar"
            .to_owned(),
    })
}

/// The current view over the map as a reference places it.
fn placed(first: &StepReport, second: &StepReport, by: &Reference) -> Vec<Item> {
    let world_from_robot = FIRST * by.map_from_robot;
    let reference = second.view.surfaces.get(by.seen);
    let middle = reference.map(|surface| (world_from_robot * surface.segment).midpoint());
    let mut items = vec![
        surfaces(KNOWN, FIRST, &first.view.surfaces),
        surfaces(SEEN, world_from_robot, &second.view.surfaces),
        surfaces(Role::ReferenceSeen, world_from_robot, reference),
        robot(Role::Robot, world_from_robot),
    ];
    let small = reference.filter(|surface| surface.length() < 1.0);
    items.extend(middle.zip(small).map(|(at, surface)| ring(at, 0.5 * surface.length() + 0.25)));
    items
}

/// How far apart the two references put an end of the view at most, metres.
fn farthest_apart(view: &StepReport, one: &Reference, other: &Reference) -> f64 {
    let ends = view.view.surfaces.iter().flat_map(|surface| [surface.segment.a, surface.segment.b]);
    let apart = |end: DVec2| (one.map_from_robot * end).distance(other.map_from_robot * end);
    ends.map(apart).fold(0.0, f64::max)
}
