//! The way home in designed worlds, with every strategy: it ends at home, and its session gives the
//! same files again.

use cogmap_formats::{run, session, world};
use cogmap_geometry::DVec2;
use cogmap_mapping::MapperSetup;
use cogmap_simulation::{
    Command, Driver, Ending, Robot, Session, SessionRecord, Source, Strategy, WorldChange,
};

/// Two worlds: their names and files.
const WORLDS: [(&str, &str); 2] = [
    ("small-office", include_str!("../../worlds/small-office.world.json")),
    ("office", include_str!("../../worlds/office.world.json")),
];

/// Within so many metres of its start a robot is home.
const HOME: f64 = 1.5;

/// The bad robot at the end of the first route of a world.
fn driven(name: &str, file: &str) -> Session {
    let (world, robot) = (world::read(file, name).unwrap(), Robot::named("bad").unwrap());
    let (_, route) = world.routes.first_key_value().unwrap();
    let route: Vec<DVec2> = route.iter().map(|&point| point.into()).collect();
    let mut driver = Driver::new(&world, &robot, &route).unwrap();
    let mapper = MapperSetup::named("consensus").unwrap();
    let record = SessionRecord::new(Source::world(world, robot), vec![mapper], 7);
    let mut session = Session::drive(record).unwrap();
    driver.drive(&mut session);
    session
}

fn go_home(session: &mut Session, strategy: &str) {
    session.command(Command::GoHome { strategy: Strategy::named(strategy).unwrap() });
    while session.advance() && !session.at_rest() {}
}

fn files(session: &Session) -> Vec<run::RunFile> {
    run::files(session, run::Extras::default())
}

fn again(record: &SessionRecord) -> Session {
    let read = session::read(&session::write(record), "session.json").unwrap();
    let mut again = Session::drive(read.record).unwrap();
    again.jump(again.end());
    again
}

#[test]
fn every_strategy_goes_home_and_its_session_gives_the_same_files() {
    for (name, file) in WORLDS {
        let mut session = driven(name, file);
        let end = session.position();
        for strategy in Strategy::names() {
            session.jump(end);
            go_home(&mut session, strategy);
            let way = session.way_home().unwrap();
            assert_eq!(way.ending, Some(Ending::Home), "{name}, {strategy}");
            assert!(way.distance <= HOME, "{name}, {strategy}: {} m", way.distance);
            assert_eq!(session.journal().mappers[0].collisions().count(), 0, "{name}, {strategy}");
            let (before, last) = (files(&session), session.position());
            assert_eq!(files(&again(session.record())), before, "{name}, {strategy}");
            session.jump((end + last) / 2);
            assert!(session.homing().is_some());
            session.jump(last);
            assert_eq!(files(&session), before, "{name}, {strategy}: after looking back");
        }
    }
}

#[test]
fn a_box_in_the_way_is_in_the_log_and_the_robot_does_not_run_into_it() {
    let (name, file) = WORLDS[0];
    let mut session = driven(name, file);
    session.command(Command::GoHome { strategy: Strategy::named("retrace").unwrap() });
    while session.journal().decisions.len() < 3 {
        session.advance();
    }
    let ahead = session.world_from_robot().unwrap() * DVec2::new(0.9, 0.0);
    let change = WorldChange::AddBox { center: ahead.into(), size: [0.5, 0.5], heading_deg: 30.0 };
    assert_eq!(session.refusal(&Command::Change(change.clone())), None);
    session.command(Command::Change(change));
    while session.advance() && !session.at_rest() {}
    let text = run::events(&session, 0);
    let place = |kind: &str| text.find(&format!("\"kind\":\"{kind}\"")).unwrap();
    assert!(place("go_home") < place("world_changed"), "{text}");
    assert!(text.contains("\"what\":\"add_box\""), "{text}");
    assert!(!text.contains("\"kind\":\"collision\""), "{text}");
    assert_eq!(files(&again(session.record())), files(&session));
}

#[test]
fn a_user_who_stops_the_robot_is_in_the_log_and_replays() {
    let (name, file) = WORLDS[0];
    let mut session = driven(name, file);
    session.command(Command::GoHome { strategy: Strategy::named("retrace").unwrap() });
    for _ in 0..200 {
        session.advance();
    }
    session.command(Command::Stop);
    while session.advance() && !session.at_rest() {}
    let text = run::events(&session, 0);
    assert!(text.contains("\"kind\":\"stopped\""), "{text}");
    assert!(run::report(&session, run::Extras::default()).contains("\"ending\": \"stopped\""));
    assert_eq!(files(&again(session.record())), files(&session));
}
