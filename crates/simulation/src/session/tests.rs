use cogmap_mapping::MapperSetup;

use super::*;
use crate::{Robot, SOMEBODY, Strategy, World, WorldChange};

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

/// A short way out, then home.
fn homed(strategy: &str) -> Session {
    let mut session = Session::drive(record()).unwrap();
    for turn in [0.4, -0.3, 0.2] {
        session.command(Command::Step { turn, travel: 0.7 });
        run_to_rest(&mut session);
    }
    session.command(Command::GoHome { strategy: Strategy::named(strategy).unwrap() });
    session
}

fn kinds(session: &Session) -> Vec<String> {
    let events = session.journal().mappers[0].events.iter();
    let not_map = events.filter(|(_, event)| !matches!(event, SessionEvent::Map(_)));
    not_map
        .map(|(_, event)| serde_json::to_value(event).unwrap()["kind"].as_str().unwrap().to_owned())
        .collect()
}

#[test]
fn every_strategy_takes_the_robot_home_across_a_room_and_replays_to_the_same_bits() {
    for strategy in Strategy::names() {
        let mut session = homed(strategy);
        session.advance();
        assert_eq!(session.homing().unwrap().strategy().name(), strategy);
        run_to_rest(&mut session);
        assert!(session.homing().is_none());
        let truth = session.world_from_robot().unwrap();
        assert!(truth.position.distance((1.0, 2.0).into()) < 0.5, "{strategy}: {}", truth.position);
        let kinds = kinds(&session);
        assert_eq!((kinds[0].as_str(), kinds.last().unwrap().as_str()), ("go_home", "home"), "{strategy}");
        assert!(session.journal().decisions.len() >= 2, "{strategy}");
        assert_eq!(session.record().commands().len(), 4, "its own orders are not commands");
        let text = serde_json::to_string(session.record()).unwrap();
        let mut again = Session::drive(serde_json::from_str(&text).unwrap()).unwrap();
        again.jump(session.position());
        assert_eq!(print(&session), print(&again));
    }
}

#[test]
fn a_jump_into_a_way_home_changes_nothing() {
    let mut session = homed("recommended");
    run_to_rest(&mut session);
    let (end, before) = (session.end(), print(&session));
    let told = session.record().commands().last().unwrap().tick;
    for position in [told, told + 1, (told + end) / 2, end - 1, told + 250, 1] {
        session.jump(position);
        let mut fresh = Session::drive(session.record().clone()).unwrap();
        fresh.jump(position);
        assert_eq!(session.homing().is_some(), fresh.homing().is_some());
        assert_eq!(print(&session), print(&fresh));
    }
    session.jump(end);
    assert_eq!(print(&session), before);
}

#[test]
fn whatever_the_user_tells_the_robot_ends_its_way_home() {
    let orders = [
        Command::Stop,
        Command::Drive { linear: 0.0, angular: 0.2 },
        Command::Step { turn: 0.1, travel: 0.0 },
        Command::Kidnap { position: [2.0, 2.0], heading_deg: 0.0 },
    ];
    for order in orders {
        let mut session = homed("retrace");
        for _ in 0..60 {
            session.advance();
        }
        session.command(order);
        session.advance();
        assert!(session.homing().is_none());
        assert_eq!(kinds(&session).last().unwrap(), "stopped");
        assert_eq!(session.way_home().unwrap().ending, Some(Ending::Stopped));
        let decisions = session.journal().decisions.len();
        for _ in 0..200 {
            session.advance();
        }
        assert_eq!(session.journal().decisions.len(), decisions, "nobody decides for the user");
    }
}

#[test]
fn a_robot_on_its_way_home_need_not_be_told_again() {
    let mut session = homed("retrace");
    run_to_rest(&mut session);
    let undisturbed = print(&session);
    session.jump(session.end() / 2);
    assert!(session.homing().is_some());
    session.command(Command::GoHome { strategy: Strategy::named("retrace").unwrap() });
    run_to_rest(&mut session);
    assert_eq!(print(&session), undisturbed);
}

#[test]
fn other_mappers_see_the_very_same_way_home() {
    let mut session = homed("recommended");
    run_to_rest(&mut session);
    let mappers = ["odometry", "consensus"].map(|name| MapperSetup::named(name).unwrap()).to_vec();
    let mut other = session.remapped(mappers.clone()).unwrap();
    assert_eq!(other.record().navigator.as_ref(), session.record().mappers.first());
    other.jump(session.position());
    assert_eq!(other.mappers().len(), 2);
    assert_eq!(other.journal().truth, session.journal().truth);
    assert_eq!(other.journal().decisions, session.journal().decisions);
    assert_eq!(kinds(&other), kinds(&session));
    let mut back = other.remapped(session.record().mappers.clone()).unwrap();
    back.jump(session.position());
    assert_eq!((print(&back), back.record()), (print(&session), session.record()));
}

#[test]
fn a_robot_that_is_told_while_it_drives_comes_to_rest_and_looks_first() {
    let mut session = Session::drive(record()).unwrap();
    session.command(Command::Drive { linear: 0.8, angular: 0.0 });
    for _ in 0..120 {
        session.advance();
    }
    session.command(Command::GoHome { strategy: Strategy::named("retrace").unwrap() });
    while session.journal().decisions.is_empty() {
        session.advance();
    }
    let way = session.way_home().unwrap();
    assert!(way.distance > 1.0 && way.believed.unwrap() > 1.0);
    assert_eq!(session.last_moment(), Some(Moment::StepEnd));
    run_to_rest(&mut session);
    let way = session.way_home().unwrap();
    assert_eq!(way.ending, Some(Ending::Home));
    assert!(way.distance < 0.5 && way.way_home < 1.3 * way.shortest.unwrap(), "{way:?}");
}

/// Two rooms with two doors between them; somebody may walk across the first.
fn rooms(people: &str) -> SessionRecord {
    let text = r#"{ "format": "cogmap-world/1", "name": "Rooms",
        "walls": [[[0,0],[8,0],[8,5],[0,5],[0,0]], [[4,0],[4,1]], [[4,2],[4,3.5]], [[4,4.5],[4,5]]],
        "boxes": [{"center": [7,4.4], "size": [0.8,0.5], "heading_deg": 20}],
        "posts": [{"center": [1,4], "radius": 0.03}],
        "doors": [{"name": "south", "hinge": [4,2], "latch": [4,1], "open": true},
            {"name": "north", "hinge": [4,4.5], "latch": [4,3.5], "open": true}],
        "people": [PEOPLE], "start": {"position": [1.5,1.5]} }"#;
    let world = serde_json::from_str(&text.replace("PEOPLE", people)).unwrap();
    let mapper = MapperSetup::named("consensus").unwrap();
    SessionRecord::new(Source::world(world, Robot::named("bad").unwrap()), vec![mapper], 3)
}

fn shut(name: &str) -> Command {
    Command::Change(WorldChange::Door { name: name.to_owned(), open: false })
}

#[test]
fn a_door_that_is_closed_behind_the_robot_is_told_and_the_other_one_leads_home() {
    let mut session = Session::drive(rooms("")).unwrap();
    for _ in 0..2 {
        session.command(Command::Step { turn: 0.0, travel: 2.0 });
        run_to_rest(&mut session);
    }
    session.command(shut("south"));
    session.command(Command::GoHome { strategy: Strategy::Oracle });
    run_to_rest(&mut session);
    assert_eq!(kinds(&session)[..2], ["world_changed", "go_home"]);
    let way = session.way_home().unwrap();
    assert_eq!(way.ending, Some(Ending::Home));
    assert!(way.shortest.unwrap() > 5.5 && way.way_home > 5.5, "through the other door: {way:?}");
    assert_eq!(session.journal().mappers[0].collisions().count(), 0);
    let mut again = Session::drive(session.record().clone()).unwrap();
    again.jump(session.position());
    assert_eq!(print(&session), print(&again));
    session.jump(1);
    assert!(session.world().unwrap().doors[0].open, "before, it was open");
}

#[test]
fn the_oracle_says_that_it_cannot_where_both_doors_are_closed_on_its_way() {
    let mut session = Session::drive(rooms("")).unwrap();
    for _ in 0..2 {
        session.command(Command::Step { turn: 0.0, travel: 2.0 });
        run_to_rest(&mut session);
    }
    session.command(Command::GoHome { strategy: Strategy::Oracle });
    session.advance();
    session.command(shut("south"));
    session.advance();
    session.command(shut("north"));
    run_to_rest(&mut session);
    let way = session.way_home().unwrap();
    assert!(matches!(way.ending, Some(Ending::Stuck(_))), "{way:?}");
    assert_eq!(way.shortest, None);
    assert_eq!(session.journal().mappers[0].collisions().count(), 0);
}

#[test]
fn boxes_come_and_go_and_every_solid_keeps_its_number() {
    let mut session = Session::drive(rooms("")).unwrap();
    let before = session.solids().unwrap().clone();
    for change in [
        r#"{"what": "add_box", "center": [3,1.5], "size": [0.4,0.4]}"#,
        r#"{"what": "remove_box", "index": 0}"#,
        r#"{"what": "move_box", "index": 1, "center": [3,1.6]}"#,
    ] {
        session.command(Command::Change(serde_json::from_str(change).unwrap()));
        session.advance();
    }
    session.command(Command::Step { turn: 0.0, travel: 0.3 });
    run_to_rest(&mut session);
    assert_eq!(kinds(&session), ["world_changed"; 3]);
    let after = session.solids().unwrap();
    assert_eq!((&before.discs, before.segments.len()), (&after.discs, after.segments.len()));
    assert_eq!(after.added.len(), 4);
    let ahead = session.last_beam_solids().unwrap()[180];
    let first_added = (after.segments.len() + after.discs.len()) as u32;
    assert!(ahead.is_some_and(|solid| (first_added..first_added + 4).contains(&solid)), "{ahead:?}");
    let range = session.last_scan().unwrap().ranges[180];
    assert!((range - 1.0).abs() < 0.05, "{range}");
}

#[test]
fn nothing_is_set_down_on_the_robot_or_on_somebody() {
    let mut session =
        Session::drive(rooms(r#"{"path": [[6,1],[6,4]], "speed": 0.0, "radius": 0.25}"#)).unwrap();
    let drop = |x: f64, y: f64| {
        Command::Change(WorldChange::AddBox { center: [x, y], size: [0.4, 0.4], heading_deg: 0.0 })
    };
    assert!(session.refusal(&drop(1.5, 1.5)).unwrap().contains("the robot stands there"));
    assert!(session.refusal(&drop(6.3, 1.0)).unwrap().contains("somebody stands there"));
    assert_eq!(session.refusal(&drop(3.0, 3.0)), None);
    assert!(session.refusal(&shut("east")).unwrap().contains("south, north"));
    let upon_somebody = Command::Kidnap { position: [6.0, 1.2], heading_deg: 0.0 };
    assert!(session.refusal(&upon_somebody).is_some());
    for refused in [drop(1.5, 1.5), shut("east"), upon_somebody] {
        session.command(refused);
        session.advance();
    }
    assert!(session.record().commands().is_empty() && kinds(&session).is_empty());
}

#[test]
fn the_laser_sees_somebody_walk_and_no_wall_is_taken_for_them() {
    let person = r#"{"path": [[3,0.5],[3,3.5]], "speed": 0.5, "radius": 0.25}"#;
    let mut session = Session::drive(rooms(person)).unwrap();
    let ahead = |session: &Session| {
        let beam = 180;
        (session.last_scan().unwrap().ranges[beam], session.last_beam_solids().unwrap()[beam])
    };
    assert!(ahead(&session).0 > 5.0, "nobody is ahead yet");
    while session.people()[0].center.y < 1.45 {
        session.advance();
    }
    session.command(Command::Step { turn: 0.0, travel: 0.0 });
    run_to_rest(&mut session);
    let (range, solid) = ahead(&session);
    assert!((range - 1.25).abs() < 0.05, "{range}");
    assert_eq!(solid, Some(SOMEBODY));
    assert_eq!(wall_of(&[Some(SOMEBODY), Some(SOMEBODY), Some(3)]), None);
}

#[test]
fn somebody_stops_for_a_standing_robot_and_running_into_them_is_the_robots_fault() {
    let person = r#"{"path": [[3.5,1.5],[0.5,1.5]], "speed": 0.8, "radius": 0.25}"#;
    let mut session = Session::drive(rooms(person)).unwrap();
    for _ in 0..300 {
        session.advance();
    }
    let gap = |session: &Session| {
        let robot = session.world_from_robot().unwrap().position;
        session.people()[0].center.distance(robot) - 0.5
    };
    assert!((0.15..0.17).contains(&gap(&session)), "{}", gap(&session));
    assert!(kinds(&session).is_empty());
    session.command(Command::Step { turn: 0.0, travel: 0.5 });
    run_to_rest(&mut session);
    assert_eq!(kinds(&session), ["collision"]);
    assert!((0.0..0.001).contains(&gap(&session)), "{}", gap(&session));
    let (position, before) = (session.position(), print(&session));
    session.jump(10);
    session.jump(position);
    assert_eq!(print(&session), before);
}
