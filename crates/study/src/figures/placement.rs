use cogmap_geometry::{DVec2, Pose, Segment, trig};
use cogmap_mapping::{Mapper, MapperSetup, StepReport, memory::SurfaceId};
use cogmap_scene::{Annotation, Item, Role, Sample, Shape};

use super::{
    Drawing, Runs,
    draw::{dashed, degrees, lines, panel, robot, role, word},
    stage::Stage,
};

/// A room behind whose corner one more wall comes into view.
const ROOM: &str = r#"{"format": "cogmap-world/1", "name": "Room with a corner", "start": {"position": [1, 1]},
    "walls": [[[0, 0], [6.4, 0], [6.4, 2.2], [8, 2.2], [8, 4], [4.6, 4], [4.6, 2.9], [0, 2.9], [0, 0]]],
    "boxes": [{"center": [3.2, 0.5], "size": [0.9, 0.5]}]}"#;
const FIRST: Pose = Pose { position: DVec2::new(1.0, 1.7), heading: -0.2 };
const SECOND: Pose = Pose { position: DVec2::new(2.7, 1.75), heading: 0.35 };
/// Where the wheels believe the second view to be taken: 0.25 m and 7° off.
const TOLD: Pose = Pose { position: DVec2::new(2.92, 1.87), heading: 0.47 };

const REFERENCE: Role = Role::ReferenceSeen;
const NEW: Role = role(Annotation::Added);
const OLD: Role = role(Annotation::Known);

/// The step that the two figures show.
fn step() -> Result<(Mapper, StepReport), String> {
    let stage = Stage::new(ROOM)?;
    let setup = MapperSetup::named("perceptual").ok_or("there is no perceptual mapper")?;
    let (mapper, mut reports) = stage.map(&setup, &[FIRST, SECOND], &[FIRST, TOLD])?;
    let report = reports.pop().ok_or("the robot took no view")?;
    Ok((mapper, report))
}

/// The longest of the surfaces that were placed.
fn newest(mapper: &Mapper, report: &StepReport) -> Option<(SurfaceId, usize)> {
    let stored = report.placed.iter().filter_map(|&id| mapper.mfis().get(id));
    let longest = stored.max_by(|a, b| a.segment.length().total_cmp(&b.segment.length()))?;
    Some((longest.id, longest.index_in_view))
}

/// From the nearer end of the reference to the nearest end of the new surface, with the distance, and
/// the angle between both.
fn relation(reference: Segment, new: Segment) -> Vec<Item> {
    let ends = [reference.a, reference.b].map(|a| [new.a, new.b].map(|b| Segment::new(a, b)));
    let shortest = ends.concat().into_iter().min_by(|a, b| a.length().total_cmp(&b.length()));
    let Some(tie) = shortest else { return Vec::new() };
    let text = format!("{:.2} m, {}", tie.length(), degrees(reference.angle_to(new)));
    let across = tie.direction().map_or(DVec2::Y, DVec2::perp);
    let aside = across * (0.2 + 0.45 * across.x.abs());
    vec![lines(role(Annotation::Measure), dashed(tie, 0.1)), word(tie.midpoint() + aside, text)]
}

const LEGEND: [(Sample, &str); 5] = [
    (Sample::Robot(Role::Robot), "robot"),
    (Sample::Line(REFERENCE), "reference"),
    (Sample::Line(NEW), "new surface"),
    (Sample::Line(OLD), "old surface"),
    (Sample::Line(role(Annotation::Measure)), "distance and angle from one to the other"),
];

/// Fig. 3.11.
pub(super) fn view(_: &mut Runs) -> Result<Drawing, String> {
    let (mapper, report) = step()?;
    let up = Pose::new(0.0, 0.0, trig::FRAC_PI_2);
    let all = || report.view.surfaces.iter().map(|surface| up * surface.segment);
    let (best, new) = (report.references.first(), newest(&mapper, &report));
    let reference = best.and_then(|best| all().nth(best.seen));
    let added = new.and_then(|(_, index)| all().nth(index));
    let mut items = vec![lines(OLD, all()), lines(NEW, added), lines(REFERENCE, reference)];
    items.extend(reference.zip(added).map(|(reference, new)| relation(reference, new)).unwrap_or_default());
    items.push(robot(Role::Robot, up));
    let mut legend = LEGEND;
    legend[3].1 = "other surface in view";
    Ok(Drawing {
        panels: vec![panel("Seen from the robot, which looks up", items, &legend)],
        columns: 1,
        outcome: format!(
            "Of {} surfaces {} are recognised.",
            report.view.surfaces.len(),
            report.matches.len()
        ),
        source: "the perceptual mapper, second view in a room made for it".to_owned(),
    })
}

/// Fig. 3.12.
pub(super) fn memory(_: &mut Runs) -> Result<Drawing, String> {
    let (mapper, report) = step()?;
    let mfis = mapper.mfis();
    let line = |id: SurfaceId| mfis.get(id).map(|surface| FIRST * mfis.in_map(surface));
    let reference = report.references.first().and_then(|best| line(best.known));
    let added = newest(&mapper, &report).and_then(|(id, _)| line(id));
    let before = mfis.surfaces().iter().filter(|surface| !report.placed.contains(&surface.id));
    let before: Vec<Segment> = before.filter_map(|surface| line(surface.id)).collect();
    let placed = FIRST * report.map_from_robot;
    let told = robot(Role::BelievedRobot, TOLD);
    let mut items =
        vec![lines(OLD, before), told, lines(NEW, report.placed.iter().filter_map(|&id| line(id)))];
    items.push(lines(REFERENCE, reference));
    items.extend(reference.zip(added).map(|(reference, new)| relation(reference, new)).unwrap_or_default());
    items.push(Item::new(Role::Path, Shape::Polyline(vec![FIRST.position, placed.position])));
    items.push(robot(Role::Robot, placed));
    let mut legend = LEGEND.to_vec();
    legend.push((Sample::Robot(Role::BelievedRobot), "where the wheels put the robot"));
    let (told_off, off) =
        (TOLD.position.distance(SECOND.position), placed.position.distance(SECOND.position));
    Ok(Drawing {
        panels: vec![panel("", items, &legend)],
        columns: 1,
        outcome: format!(
            "The wheels are off by {told_off:.2} m and {}; the robot, located by the reference, by {off:.3} m.",
            degrees((TOLD.heading - SECOND.heading).abs())
        ),
        source: "the perceptual mapper, second view in a room made for it".to_owned(),
    })
}
