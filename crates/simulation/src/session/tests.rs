use cogmap_mapping::MapperSetup;

use super::*;
use crate::{Noise, Robot, SOMEBODY, Strategy, World, WorldChange};

mod changing;
mod homing;
mod people;

fn cell() -> World {
    let text = r#"{ "format": "cogmap-world/1", "name": "Cell",
        "walls": [[[0,0],[6,0],[6,5],[0,5],[0,0]]],
        "boxes": [{"center": [4,4], "size": [0.8,0.5], "heading_deg": 20}],
        "start": {"position": [1,2]} }"#;
    serde_json::from_str(text).unwrap()
}

fn record() -> SessionRecord {
    let source = Source::world(cell(), Robot::named("bad").unwrap());
    let mappers = MapperSetup::NAMES.iter().filter_map(|name| MapperSetup::named(name)).collect();
    SessionRecord::new(source, mappers, 7)
}

fn run_to_rest(session: &mut Session) {
    while session.advance() && !session.at_rest() {}
}

/// Steps, then velocity driving into a wall, then a stop.
fn driven() -> Session {
    let mut session = Session::drive(record()).unwrap();
    for turn in [0.4, -0.3, 0.2] {
        session.command(Command::Step { turn, travel: 0.7 });
        run_to_rest(&mut session);
    }
    session.command(Command::Drive { linear: 0.8, angular: 0.3 });
    for _ in 0..400 {
        session.advance();
    }
    session.command(Command::Stop);
    run_to_rest(&mut session);
    session
}

/// Everything that a run brought to light, bit by bit.
fn print(session: &Session) -> String {
    format!("{:?} {:?} {:?}", session.position(), session.journal(), session.mappers())
}

/// What happened besides what happened to the map.
fn kinds(session: &Session) -> Vec<String> {
    let events = session.journal().mappers[0].events.iter();
    let not_map = events.filter(|(_, event)| !matches!(event, SessionEvent::Map(_)));
    not_map
        .map(|(_, event)| serde_json::to_value(event).unwrap()["kind"].as_str().unwrap().to_owned())
        .collect()
}

#[test]
fn a_record_replays_to_the_same_bits() {
    let first = driven();
    let text = serde_json::to_string(first.record()).unwrap();
    let mut again = Session::drive(serde_json::from_str(&text).unwrap()).unwrap();
    again.jump(again.end());
    assert_eq!(print(&first), print(&again));
    assert_eq!(first.record(), again.record());
}

#[test]
fn other_mappers_are_fed_the_very_same_readings() {
    let session = driven();
    let mappers = ["odometry", "perceptual"].map(|name| MapperSetup::named(name).unwrap()).to_vec();
    let mut other = session.remapped(mappers.clone()).unwrap();
    assert_eq!((other.position(), &other.record().mappers), (0, &mappers));
    other.jump(session.position());
    assert_eq!(other.journal().truth, session.journal().truth);
    assert_eq!(other.journal().odometry, session.journal().odometry);
    let perceptual =
        session.record().mappers.iter().position(|mapper| mapper.name() == "perceptual").unwrap();
    assert_eq!(other.mappers()[1].mfis(), session.mappers()[perceptual].mfis());
}

#[test]
fn a_jump_back_and_forth_changes_nothing() {
    let mut session = driven();
    let (end, before) = (session.end(), print(&session));
    for position in [0, 1, end / 3, end / 2, 7, end - 1] {
        session.jump(position);
        assert_eq!(session.position(), position);
        let mut fresh = Session::drive(session.record().clone()).unwrap();
        fresh.jump(position);
        assert_eq!(print(&session), print(&fresh));
    }
    session.jump(end);
    assert_eq!(print(&session), before);
}

#[test]
fn a_command_at_an_earlier_moment_begins_another_run() {
    let mut session = driven();
    session.jump(30);
    session.command(Command::Step { turn: 1.0, travel: 0.2 });
    assert!(session.record().commands().iter().all(|timed| timed.tick <= 30));
    assert_eq!(session.end(), 30);
    run_to_rest(&mut session);
    let mut again = Session::drive(session.record().clone()).unwrap();
    again.jump(session.position());
    assert_eq!(print(&session), print(&again));
}

#[test]
fn the_robot_looks_before_it_moves_and_at_the_end_of_each_step() {
    let mut session = Session::drive(record()).unwrap();
    assert_eq!(session.journal().mappers[0].reports.len(), 1);
    session.command(Command::Step { turn: 0.5, travel: 1.0 });
    run_to_rest(&mut session);
    assert_eq!(session.journal().mappers[0].reports.len(), 2);
    // On the way the laser records each 0.1 m or 5°, for mappers that use it.
    assert!((13..=18).contains(&session.journal().odometry.len()), "{}", session.journal().odometry.len());
}

#[test]
fn running_into_a_wall_is_told_once() {
    let mut session = Session::drive(record()).unwrap();
    session.command(Command::Step { turn: 0.0, travel: 9.0 });
    run_to_rest(&mut session);
    assert_eq!(session.journal().mappers[0].collisions().count(), 1);
    let truth = session.world_from_robot().unwrap().position;
    assert!(truth.x < 5.76 && truth.x > 5.5, "{truth}");
}

#[test]
fn every_stored_surface_knows_its_true_wall_or_that_it_has_none() {
    let session = driven();
    let solids = session.solids().unwrap();
    for (mapper, journal) in session.mappers().iter().zip(&session.journal().mappers) {
        assert_eq!(journal.true_walls.len(), mapper.mfis().surfaces().len());
        assert!(journal.true_walls.iter().flatten().all(|&wall| (wall as usize) < solids.segments.len()));
    }
}

#[test]
fn velocities_that_hold_are_not_written_down_again() {
    let mut session = Session::drive(record()).unwrap();
    for _ in 0..50 {
        session.command(Command::Drive { linear: 0.2, angular: 0.0 });
        session.advance();
    }
    assert_eq!(session.record().commands().len(), 1);
}

#[test]
fn a_robot_that_is_moved_unseen_is_elsewhere_and_its_odometry_does_not_notice() {
    let mut session = Session::drive(record()).unwrap();
    session.command(Command::Step { turn: 0.4, travel: 0.7 });
    run_to_rest(&mut session);
    let (odometry, scans) = (session.odom_from_robot(), session.journal().odometry.len());
    session.command(Command::Kidnap { position: [4.0, 1.0], heading_deg: 90.0 });
    session.advance();
    assert_eq!(session.odom_from_robot(), odometry);
    assert_eq!(session.journal().odometry.len(), scans, "it does not look either");
    let there = session.world_from_robot().unwrap();
    assert_eq!((there.position, there.heading), ((4.0, 1.0).into(), cogmap_geometry::trig::FRAC_PI_2));
    session.command(Command::Kidnap { position: [4.0, 4.0], heading_deg: 0.0 });
    session.advance();
    session.command(Command::Kidnap { position: [f64::NAN, 4.0], heading_deg: 0.0 });
    session.advance();
    assert_eq!(session.world_from_robot(), Some(there), "nobody sets it down on a box");
    session.command(Command::Step { turn: 0.1, travel: 0.3 });
    run_to_rest(&mut session);
    let mut again = Session::drive(session.record().clone()).unwrap();
    again.jump(session.position());
    assert_eq!(print(&session), print(&again));
}
