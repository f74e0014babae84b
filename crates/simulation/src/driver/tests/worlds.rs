//! The worlds that come with the project keep what they promise.

use super::*;

const WORLDS: [(&str, &str); 14] = [
    ("small-office", include_str!("../../../../../worlds/small-office.world.json")),
    ("office", include_str!("../../../../../worlds/office.world.json")),
    ("long-corridor", include_str!("../../../../../worlds/long-corridor.world.json")),
    ("long-office", include_str!("../../../../../worlds/long-office.world.json")),
    ("environment-a", include_str!("../../../../../worlds/environment-a.world.json")),
    ("environment-b", include_str!("../../../../../worlds/environment-b.world.json")),
    ("tour", include_str!("../../../../../worlds/tour.world.json")),
    ("narrow-passage", include_str!("../../../../../worlds/narrow-passage.world.json")),
    ("no-passage", include_str!("../../../../../worlds/no-passage.world.json")),
    ("around-a-corner", include_str!("../../../../../worlds/around-a-corner.world.json")),
    ("shortcut", include_str!("../../../../../worlds/shortcut.world.json")),
    ("box-course", include_str!("../../../../../worlds/box-course.world.json")),
    ("u-trap", include_str!("../../../../../worlds/u-trap.world.json")),
    ("two-shortcuts", include_str!("../../../../../worlds/two-shortcuts.world.json")),
];

/// What the routes promise: their steps and their metres. Where the thesis drives one like it
/// (§3.1.4, §3.2.3), these are its figures.
const ROUTES: [(&str, &str, usize, f64); 16] = [
    ("small-office", "tour", 8, 6.0),
    ("office", "tour", 34, 15.0),
    ("office", "loop", 38, 17.5),
    ("long-corridor", "there", 34, 29.2),
    ("long-office", "tour", 34, 15.0),
    ("environment-a", "loop", 98, 120.0),
    ("environment-b", "loop", 106, 90.0),
    ("environment-b", "two-laps", 212, 180.0),
    ("tour", "tour", 80, 57.0),
    ("narrow-passage", "across", 14, 8.4),
    ("no-passage", "across", 14, 8.4),
    ("around-a-corner", "tour", 10, 9.3),
    ("shortcut", "tour", 23, 29.4),
    ("box-course", "tour", 43, 49.7),
    ("u-trap", "tour", 15, 24.3),
    ("two-shortcuts", "tour", 30, 40.2),
];
/// A step that needs a correction may add one or two.
const STEPS_MORE: usize = 2;
/// How far a route may be from its promised length, a share of it.
const LENGTH_OFF: f64 = 0.03;
/// The rim of the robot stays so far from everything, metres.
const GAP: f64 = 0.05;

fn world(name: &str) -> World {
    let (_, text) = WORLDS.iter().find(|(known, _)| *known == name).unwrap();
    serde_json::from_str(text).unwrap()
}

fn route(world: &World, name: &str) -> Vec<DVec2> {
    world.routes[name].iter().map(|&point| point.into()).collect()
}

fn bad() -> Robot {
    Robot::named("bad").unwrap()
}

#[test]
fn every_world_is_free_of_problems_and_says_what_it_is() {
    for (name, _) in WORLDS {
        let world = world(name);
        assert_eq!(world.problems(), [], "{name}");
        assert!(world.description.len() > 40 && !world.rooms.is_empty() && !world.routes.is_empty());
    }
}

#[test]
fn every_route_keeps_its_steps_and_its_length_with_every_robot() {
    for (name, route_name, steps, metres) in ROUTES {
        let world = world(name);
        let route = route(&world, route_name);
        assert_eq!(route.len(), steps, "{name} {route_name}");
        for robot in Robot::NAMES {
            let robot = Robot::named(robot).unwrap();
            for seed in 1..=20 {
                let trip = drive(&world, &robot, &route, seed).unwrap();
                let which = format!("{name} {route_name}, {} robot, seed {seed}", robot.name);
                assert_eq!(trip.collisions, 0, "{which}");
                assert!((steps..=steps + STEPS_MORE).contains(&trip.steps), "{which}: {} steps", trip.steps);
                assert!((trip.length / metres - 1.0).abs() < LENGTH_OFF, "{which}: {} m", trip.length);
                assert!(trip.gap > GAP, "{which}: {} m from something", trip.gap);
                assert!(trip.end.position.distance(*route.last().unwrap()) < 0.3, "{which}");
            }
        }
    }
}

#[test]
fn the_loops_end_where_they_begin() {
    for (name, route_name) in [("environment-a", "loop"), ("environment-b", "loop"), ("tour", "tour")] {
        let world = world(name);
        let end = *route(&world, route_name).last().unwrap();
        assert!(end.distance(world.start.position.into()) < 0.05, "{name}");
    }
}

#[test]
fn on_the_way_through_the_long_corridors_no_end_can_be_seen() {
    let all_round = [14.5, 16.0, 17.5].map(|x| ("long-corridor", DVec2::new(x, 2.5), 720));
    let southward = [14.0, 16.0, 18.0].map(|y| ("environment-a", DVec2::new(1.1, y), 361));
    for (name, origin, beams) in all_round.into_iter().chain(southward) {
        let grid = crate::RayGrid::new(&Solids::of(&world(name)).segments, &[]);
        let spacing = 0.5_f64.to_radians();
        let fan = crate::Fan { origin, heading: -cogmap_geometry::trig::PI, spacing, beams, range_max: 8.19 };
        let mut hits = Vec::new();
        grid.cast(&fan, &mut hits);
        let walls: std::collections::BTreeSet<u32> = hits.iter().flatten().map(|hit| hit.solid).collect();
        assert_eq!(walls.len(), 2, "{name} {origin}");
        assert!(hits.iter().any(Option::is_none));
    }
}

#[test]
fn random_routes_are_long_enough_lead_away_and_never_touch_anything() {
    for (name, _) in WORLDS {
        let world = world(name);
        let (mut steps, mut metres) = (0, 0.0);
        for seed in 0..12 {
            let route = random_route(&world, &bad(), seed).unwrap();
            assert_eq!(route, random_route(&world, &bad(), seed).unwrap());
            let trip = drive(&world, &bad(), &route, seed).unwrap();
            let end = *route.last().unwrap();
            assert_eq!(trip.collisions, 0, "{name} {seed}");
            assert!(trip.end.position.distance(end) < 0.3, "{name} {seed}: {} {end}", trip.end.position);
            assert!((9.5..63.0).contains(&trip.length), "{name} {seed}: {}", trip.length);
            assert!(end.distance(world.start.position.into()) >= 6.0);
            assert!(trip.gap > 0.01, "{name} {seed}: {}", trip.gap);
            (steps, metres) = (steps + trip.steps, metres + trip.length);
        }
        println!("{name}: {steps} steps for {metres:.0} m of random routes");
    }
}

#[test]
fn a_point_behind_a_closed_door_is_named() {
    let mut world = world("office");
    for door in &mut world.doors {
        door.open = false;
    }
    let error = Driver::new(&world, &bad(), &[DVec2::new(5.5, 3.0), DVec2::new(1.5, 5.5)]).err().unwrap();
    assert!(error.starts_with("point 2 of the route, [1.5, 5.5], cannot be reached"), "{error}");
    assert!(world.problems().iter().any(|problem| problem.place.starts_with("routes.tour[")));
}

#[test]
fn a_leg_across_the_building_is_led_around_and_cut_into_steps() {
    let world = world("office");
    let kitchen = DVec2::new(10.6, 1.2);
    for seed in 0..10 {
        let trip = drive(&world, &bad(), &[kitchen], seed).unwrap();
        assert_eq!(trip.collisions, 0);
        assert!(trip.end.position.distance(kitchen) < 0.3, "{}", trip.end.position);
        assert!(trip.length < 14.0 && trip.steps < 40, "{} m, {} steps", trip.length, trip.steps);
    }
}
