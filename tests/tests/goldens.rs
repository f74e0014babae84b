//! After a wanted change run the tests with `UPDATE_GOLDENS=1` and look at what became of the pictures.

mod sample;

use std::{env, fs, path::PathBuf};

use cogmap_formats::world;
use cogmap_geometry::DVec2;
use cogmap_mapping::MapperSetup;
use cogmap_scene::{MemoryOptions, Scene, Sheet, Theme, WorldOptions, memory_scene, png, svg, world_scene};
use cogmap_simulation::{Driver, Robot, Session, SessionRecord, Source};

fn project() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("..")
}

fn compare(name: &str, bytes: &[u8]) {
    let path = project().join("tests/goldens").join(name);
    if env::var_os("UPDATE_GOLDENS").is_some() {
        fs::write(&path, bytes).unwrap();
    }
    let golden = fs::read(&path).unwrap_or_default();
    assert!(golden == bytes, "the picture differs from tests/goldens/{name}");
}

fn compare_both_themes(name: &str, scene: &Scene, [width, height]: [f64; 2]) {
    for (theme, suffix) in [(Theme::Light, "light"), (Theme::Dark, "dark")] {
        let sheet = Sheet::new(width, height, theme);
        compare(&format!("{name}-{suffix}.png"), &png::paint(scene, &sheet, 1.0).unwrap());
        compare(&format!("{name}-{suffix}.svg"), svg::paint(scene, &sheet).as_bytes());
    }
}

/// The bad robot after the first route of the small office.
fn drive() -> Session {
    let name = "small-office.world.json";
    let text = fs::read_to_string(project().join("worlds").join(name)).unwrap();
    let world = world::read(&text, name).unwrap();
    let robot = Robot::named("bad").unwrap();
    let route: Vec<DVec2> = world.routes.values().next().unwrap().iter().copied().map(DVec2::from).collect();
    let mut driver = Driver::new(&world, &robot, &route).unwrap();
    let mapper = MapperSetup::named("perceptual").unwrap();
    let mut session =
        Session::drive(SessionRecord::new(Source::world(world, robot), vec![mapper], 1)).unwrap();
    driver.drive(&mut session);
    session
}

#[test]
fn a_world_with_every_mark_looks_as_it_did() {
    compare_both_themes("sample-world", &sample::world(), [1200.0, 800.0]);
}

#[test]
fn a_memory_with_every_mark_looks_as_it_did() {
    compare_both_themes("sample-memory", &sample::memory(), [1200.0, 800.0]);
}

#[test]
fn a_network_with_every_mark_looks_as_it_did() {
    compare_both_themes("sample-network", &sample::network(), [1200.0, 800.0]);
}

#[test]
fn a_telephone_is_wide_enough() {
    compare_both_themes("sample-narrow", &sample::memory(), [390.0, 600.0]);
}

#[test]
fn a_drive_through_the_small_office_looks_as_it_did() {
    let session = drive();
    compare_both_themes("office-world", &world_scene(&session, WorldOptions::default()), [1200.0, 800.0]);
    let options = MemoryOptions { truth: true, ..MemoryOptions::default() };
    let start = session.journal().truth[0].pose;
    let memory = memory_scene(&session, 0, options).seen_from(start);
    compare_both_themes("office-memory", &memory, [1200.0, 800.0]);
}
