use cogmap_mapping::MapperSetup;
use cogmap_simulation::{Command, Robot, SessionRecord, Source, World};

use super::*;
use crate::{Item, MemoryOptions, Shape, memory_scene};

fn session(mapper: &str) -> Session {
    let world: World = serde_json::from_str(
        r#"{"format": "cogmap-world/1", "name": "Cell", "start": {"position": [1, 2], "heading_deg": 30},
            "walls": [[[0, 0], [6, 0], [6, 4], [0, 4], [0, 0]]],
            "boxes": [{"center": [4.5, 3], "size": [0.6, 0.4]}]}"#,
    )
    .unwrap();
    let source = Source::world(world, Robot::named("perfect").unwrap());
    let mapper = MapperSetup::named(mapper).unwrap();
    let mut session = Session::drive(SessionRecord::new(source, vec![mapper], 1)).unwrap();
    for turn in [-0.5, 0.2, 0.6] {
        session.command(Command::Step { turn, travel: 0.7 });
        while session.advance() && !session.at_rest() {}
    }
    session
}

/// What a stage adds to the picture: how many lines of a role.
fn added(session: &Session, stage: Stage, role: impl Into<Role>) -> usize {
    let role = role.into();
    let plain = MemoryOptions { view: false, ..MemoryOptions::default() };
    let mut scene = memory_scene(session, 0, plain);
    let before = scene.changing.len();
    point_out(&mut scene, session, 0, stage);
    let items = scene.changing[before..].iter().filter(|item| item.role == role);
    let count = |item: &Item| if let Shape::Segments(lines) = &item.shape { lines.len() } else { 1 };
    items.map(count).sum()
}

#[test]
fn what_was_seen_and_recognised_is_pointed_out_once_each() {
    let session = session("perceptual");
    let report = session.journal().mappers[0].reports.last().unwrap();
    let (seen, recognised) = (report.view.surfaces.len(), report.matches.len());
    assert!(recognised > 2, "{recognised} of {seen}");
    assert_eq!(added(&session, Stage::Surfaces, Annotation::Movement), seen);
    assert_eq!(added(&session, Stage::Recognised, Annotation::Movement), recognised);
    assert_eq!(added(&session, Stage::Recognised, Annotation::Flaw), seen - recognised);
    assert_eq!(added(&session, Stage::Scan, Role::LaserFan), 1);
}

#[test]
fn the_reference_is_pointed_out_with_its_runners_up() {
    let session = session("perceptual");
    let candidates = session.journal().mappers[0].reports.last().unwrap().references.len();
    assert!(candidates > 1);
    assert_eq!(added(&session, Stage::Reference, Role::ReferenceSeen), 1);
    assert_eq!(added(&session, Stage::Reference, Annotation::Known), candidates - 1);
}

#[test]
fn a_mapper_without_references_has_none_pointed_out() {
    let session = session("transform");
    assert_eq!(added(&session, Stage::Reference, Role::ReferenceSeen), 0);
    assert_eq!(added(&session, Stage::Movement, Annotation::Movement), 1);
}

#[test]
fn what_is_ignored_and_what_is_placed_make_the_view() {
    for mapper in ["perceptual", "consensus", "transform"] {
        let session = session(mapper);
        let seen = session.journal().mappers[0].reports.last().unwrap().view.surfaces.len();
        let ignored = added(&session, Stage::Ignored, Annotation::Known)
            + added(&session, Stage::Ignored, Annotation::Flaw);
        assert_eq!(added(&session, Stage::Placed, Annotation::Added) + ignored, seen, "{mapper}");
    }
}
