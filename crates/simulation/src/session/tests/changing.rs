use super::*;

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
    let far = Command::Kidnap { position: [1e300, 0.0], heading_deg: 0.0 };
    assert!(session.refusal(&far).unwrap().contains("from the origin"));
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
    for _ in 0..150 {
        session.advance();
    }
    let gap = |session: &Session| {
        let robot = session.world_from_robot().unwrap().position;
        session.people()[0].center.distance(robot) - 0.5
    };
    assert!((0.45..0.47).contains(&gap(&session)), "{}", gap(&session));
    assert!(kinds(&session).is_empty());
    session.command(Command::Step { turn: 0.0, travel: 0.6 });
    while kinds(&session).is_empty() && session.advance() {}
    assert!((0.0..0.001).contains(&gap(&session)), "{}", gap(&session));
    run_to_rest(&mut session);
    assert_eq!(kinds(&session), ["collision"]);
    let (position, before) = (session.position(), print(&session));
    session.jump(10);
    session.jump(position);
    assert_eq!(print(&session), before);
}

#[test]
fn wheels_that_get_worse_mislead_odometry_from_then_on_and_not_before() {
    // Of each of two steps, by how much odometry and the truth differ in where it led, metres.
    let drive = |odometry: Option<f64>| {
        let mut session = Session::drive(rooms("")).unwrap();
        let mut off = Vec::new();
        for _ in 0..2 {
            let poses = |session: &Session| [session.world_from_robot().unwrap(), session.odom_from_robot()];
            let before = poses(&session);
            session.command(Command::Step { turn: 0.0, travel: 0.8 });
            run_to_rest(&mut session);
            let after = poses(&session);
            let [truth, believed] = [0, 1].map(|k| after[k].from_here(before[k]).position);
            off.push(truth.distance(believed));
            if let Some(odometry) = odometry {
                session.command(Command::Change(WorldChange::Noise(Noise { odometry, laser: 1.0 })));
            }
        }
        (session, off)
    };
    let ((_, usual), (worn, worse), (_, faultless)) = (drive(None), drive(Some(20.0)), drive(Some(0.0)));
    assert_eq!([usual[0].to_bits(); 2], [worse[0].to_bits(), faultless[0].to_bits()]);
    assert!(worse[1] > 5.0 * usual[1], "{usual:?} {worse:?}");
    assert!(faultless[1] < 1e-9 && usual[1] > 1e-3, "{usual:?} {faultless:?}");
    assert_eq!(worn.noise().odometry, 20.0);
    let mut again = Session::drive(worn.record().clone()).unwrap();
    again.jump(worn.position());
    assert_eq!(print(&worn), print(&again));
    assert_eq!(kinds(&worn), ["world_changed"], "the second is the same again");
}

#[test]
fn a_laser_that_gets_worse_spreads_what_it_sees() {
    let mut session = Session::drive(rooms("")).unwrap();
    let ranges = |session: &Session| session.last_scan().unwrap().ranges.clone();
    session.command(Command::Step { turn: 0.0, travel: 0.0 });
    run_to_rest(&mut session);
    let usual = ranges(&session);
    session.command(Command::Change(WorldChange::Noise(Noise { odometry: 1.0, laser: 20.0 })));
    session.command(Command::Step { turn: 0.0, travel: 0.0 });
    run_to_rest(&mut session);
    let worse = ranges(&session);
    let spread = |ranges: &[f64]| {
        let steps = ranges.windows(3).map(|three| (three[0] - 2.0 * three[1] + three[2]).abs());
        let mut steps: Vec<f64> = steps.filter(|step| step.is_finite()).collect();
        steps.sort_by(f64::total_cmp);
        steps[steps.len() / 2]
    };
    assert!(spread(&worse) > 5.0 * spread(&usual), "{} {}", spread(&worse), spread(&usual));
}
