use cogmap_mapping::MapperSetup;
use cogmap_simulation::{Command, Robot, SessionRecord, Source, Strategy, World};

use super::*;
use crate::{MemoryOptions, WorldOptions, memory_scene, world_scene};

/// A robot that went round a corner.
fn driven(robot: &str) -> Session {
    let world: World = serde_json::from_str(
        r#"{"format": "cogmap-world/1", "name": "Bend", "start": {"position": [1, 1]},
            "walls": [[[0,0],[9,0],[9,8],[7,8],[7,2],[0,2],[0,0]]]}"#,
    )
    .unwrap();
    let source = Source::world(world, Robot::named(robot).unwrap());
    let mappers = vec![MapperSetup::named("consensus").unwrap()];
    let mut session = Session::drive(SessionRecord::new(source, mappers, 1)).unwrap();
    let bend = std::f64::consts::FRAC_PI_2;
    for (turn, travel) in [(0.0, 3.5), (0.0, 3.5), (bend, 2.0), (0.0, 2.5)] {
        session.command(Command::Step { turn, travel });
        while session.advance() && !session.at_rest() {}
    }
    session
}

/// The same robot, told to go home.
fn session(strategy: &str) -> Session {
    let mut session = driven("perfect");
    session.command(Command::GoHome { strategy: Strategy::named(strategy).unwrap() });
    session
}

fn advance_to_decision(session: &mut Session, count: usize) {
    while session.journal().decisions.len() < count {
        assert!(session.advance() && session.homing().is_some(), "the robot decides {count} times");
    }
}

fn shapes(scene: &Scene, mark: HomingMark) -> Vec<Shape> {
    let items = scene.still.iter().chain(&scene.changing).filter(|item| item.role == mark.into());
    items.map(|item| item.shape.clone()).collect()
}

fn length(shapes: &[Shape]) -> f64 {
    let of = |points: &Vec<DVec2>| points.windows(2).map(|pair| pair[0].distance(pair[1])).sum::<f64>();
    shapes.iter().map(|shape| if let Shape::Polyline(points) = shape { of(points) } else { 0.0 }).sum()
}

#[test]
fn before_the_robot_is_told_to_go_home_nothing_of_it_is_drawn() {
    let mut session = session("recommended");
    session.jump(0);
    for scene in
        [memory_scene(&session, 0, MemoryOptions::default()), world_scene(&session, WorldOptions::default())]
    {
        let drawn = scene.still.iter().chain(&scene.changing);
        assert_eq!(drawn.filter(|item| matches!(item.role, Role::Homing(_))).count(), 0);
    }
}

#[test]
fn the_option_that_was_chosen_is_an_arrow_and_the_others_lead_home_too() {
    let mut session = session("faithful");
    advance_to_decision(&mut session, 1);
    let decision = session.journal().decisions[0].clone();
    assert!(decision.chosen.is_some(), "{}", decision.why);
    let scene = memory_scene(&session, 0, MemoryOptions::default());
    let [Shape::Arrow(arrow)] = &shapes(&scene, HomingMark::Chosen)[..] else { panic!("one arrow") };
    let map_from_here = session.mappers()[0].mfis().map_from_frame(decision.frame);
    assert_eq!(arrow[..], [0, 1].map(|k| map_from_here * decision.way[k]));
    let open = decision.options.iter().filter(|option| !option.barred).count();
    for mark in [HomingMark::Seen, HomingMark::Assumed] {
        assert_eq!(shapes(&scene, mark).len(), open - 1, "{mark:?}");
    }
}

#[test]
fn what_navigation_forgot_is_drawn_faded_and_nothing_is_lost() {
    let mut session = session("faithful");
    advance_to_decision(&mut session, 1);
    let count = |options: MemoryOptions| -> [usize; 2] {
        let scene = memory_scene(&session, 0, options);
        let of = |faded: bool| -> usize {
            let is = |role: Role| role == HomingMark::Forgotten.into();
            let surface = |role| matches!(role, Role::SurfaceOfView(_) | Role::DebrisOfView(_));
            let items = scene.still.iter().filter(|it| if faded { is(it.role) } else { surface(it.role) });
            items.map(|it| if let Shape::Segments(all) = &it.shape { all.len() } else { 0 }).sum()
        };
        [of(false), of(true)]
    };
    let [trusted, faded] = count(MemoryOptions::default());
    let all = session.mappers()[0].mfis().remembered().count();
    assert!(faded > 0 && trusted + faded == all, "{trusted} and {faded} of {all}");
    assert_eq!(count(MemoryOptions { homing: false, ..MemoryOptions::default() }), [all, 0]);
}

#[test]
fn the_way_out_and_the_way_home_each_have_their_colour_in_both_views() {
    let mut session = session("recommended");
    while session.advance() && session.homing().is_some() {}
    assert!(session.world_from_robot().unwrap().position.distance(DVec2::ONE) < 0.6);
    for scene in
        [memory_scene(&session, 0, MemoryOptions::default()), world_scene(&session, WorldOptions::default())]
    {
        for mark in [HomingMark::WayOut, HomingMark::WayHome] {
            let length = length(&shapes(&scene, mark));
            assert!((8.0..13.0).contains(&length), "{mark:?} in {}: {length} m", scene.title);
        }
        assert_eq!(shapes(&scene, HomingMark::Home).len(), 1);
    }
}

#[test]
fn home_is_drawn_where_the_run_began() {
    let session = session("recommended");
    let memory = memory_scene(&session, 0, MemoryOptions { home: true, ..MemoryOptions::default() });
    let [Shape::Signs(home)] = &shapes(&memory, HomingMark::Home)[..] else { panic!("one home") };
    assert!(home.len() == 1 && home[0].length() < 1e-9, "{home:?}");
    let world = world_scene(&session, WorldOptions { home: true, ..WorldOptions::default() });
    assert_eq!(shapes(&world, HomingMark::Home), [Shape::Signs(vec![DVec2::ONE])]);
}

#[test]
fn a_path_is_cut_where_the_robot_was_told_to_go_home() {
    let at = |x: f64| DVec2::new(x, 0.0);
    let path: Vec<_> = (0..5).map(|k| (f64::from(k), at(f64::from(k)))).collect();
    let cut = pieces(&path, &[[1.0, 3.0]], &[]);
    assert_eq!(
        cut,
        [
            (false, vec![at(0.0), at(1.0)]),
            (true, vec![at(1.0), at(2.0), at(3.0)]),
            (false, vec![at(3.0), at(4.0)]),
        ]
    );
}

#[test]
fn a_path_has_a_gap_where_the_robot_was_carried() {
    let at = |x: f64| DVec2::new(x, 0.0);
    let path: Vec<_> = (0..5).map(|k| (f64::from(k), at(f64::from(k)))).collect();
    let cut = pieces(&path, &[], &[1.5]);
    assert_eq!(cut, [(false, vec![at(0.0), at(1.0)]), (false, vec![at(2.0), at(3.0), at(4.0)])]);
    let ways = |session: &Session| {
        let scene = world_scene(session, WorldOptions::default());
        let items = scene.still.iter().chain(&scene.changing).filter(|item| item.role == Role::TruePath);
        items.filter(|item| matches!(&item.shape, Shape::Polyline(way) if way.len() > 1)).count()
    };
    let mut session = driven("perfect");
    let before = ways(&session);
    session.command(Command::Kidnap { position: [1.0, 1.0], heading_deg: 0.0 });
    session.advance();
    assert_eq!(ways(&session), before - 1, "no line leads to where it was carried");
    session.command(Command::Step { turn: 0.0, travel: 1.0 });
    while session.advance() && !session.at_rest() {}
    assert_eq!(ways(&session), before + 1, "its way goes on there");
}
