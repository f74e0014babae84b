use cogmap_mapping::perception::Moment;

use super::*;

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

#[test]
fn a_robot_that_would_wait_for_ever_gives_up_in_the_end() {
    let mut session = Session::drive(record()).unwrap();
    session.command(Command::Step { turn: 0.0, travel: 2.0 });
    run_to_rest(&mut session);
    let patient = r#"{"strategy": "retrace", "patience": 1000000}"#;
    session.command(Command::GoHome { strategy: serde_json::from_str(patient).unwrap() });
    session.advance();
    let behind = WorldChange::AddBox { center: [1.9, 2.0], size: [0.3, 3.0], heading_deg: 0.0 };
    session.command(Command::Change(behind));
    run_to_rest(&mut session);
    let way = session.way_home().unwrap();
    assert!(
        matches!(way.ending, Some(Ending::Stuck(why)) if why.to_string().contains("decisions")),
        "{way:?}"
    );
    assert!((200..300).contains(&way.decisions.len()), "{}", way.decisions.len());
    assert_eq!(session.journal().mappers[0].collisions().count(), 0);
    assert!(session.time() > 90.0, "it waits half a second before it looks again");
}
