//! The worlds that come with the project keep what they promise.

use super::*;

const WORLDS: [(&str, &str); 3] = [
    ("small-office", include_str!("../../../../../worlds/small-office.world.json")),
    ("office", include_str!("../../../../../worlds/office.world.json")),
    ("long-corridor", include_str!("../../../../../worlds/long-corridor.world.json")),
];

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

/// Drives a route with the bad robot on many seeds; the numbers of steps, lengths and least gap seen.
fn drives(name: &str, route_name: &str, seeds: u64) -> ([usize; 2], [f64; 2], f64) {
    let world = world(name);
    let route = route(&world, route_name);
    let (mut steps, mut lengths, mut gap) = ([usize::MAX, 0], [f64::INFINITY, 0.0_f64], f64::INFINITY);
    for seed in 0..seeds {
        let trip = drive(&world, &bad(), &route, seed).unwrap();
        assert_eq!(trip.collisions, 0, "{name} {route_name} {seed}");
        assert!(trip.end.position.distance(*route.last().unwrap()) < 0.3, "{name} {route_name} {seed}");
        steps = [steps[0].min(trip.steps), steps[1].max(trip.steps)];
        lengths = [lengths[0].min(trip.length), lengths[1].max(trip.length)];
        gap = gap.min(trip.gap);
    }
    println!("{name} {route_name}: {steps:?} steps, {lengths:.2?} m, least gap {gap:.3} m");
    (steps, lengths, gap)
}

#[test]
fn every_world_is_free_of_problems_and_says_what_it_is() {
    for (name, _) in WORLDS {
        let world = world(name);
        assert_eq!(world.problems(), [], "{name}");
        assert!(world.description.len() > 40 && world.rooms.len() > 1 && !world.routes.is_empty());
    }
}

#[test]
fn the_tour_of_the_small_office_is_6_metres_in_8_steps() {
    let (steps, lengths, gap) = drives("small-office", "tour", 100);
    assert_eq!(steps, [8, 8]);
    assert!(lengths[0] > 5.8 && lengths[1] < 6.3 && gap > 0.05);
}

#[test]
fn the_tour_of_the_office_is_15_metres_in_34_steps() {
    let (steps, lengths, gap) = drives("office", "tour", 100);
    assert_eq!(steps, [34, 34]);
    assert!(lengths[0] > 14.6 && lengths[1] < 15.6 && gap > 0.05);
}

#[test]
fn the_other_routes_are_driven_a_step_a_point_too() {
    for (name, route_name, points) in [("office", "loop", 38), ("long-corridor", "there", 34)] {
        let (steps, _, gap) = drives(name, route_name, 40);
        assert_eq!(steps, [points, points]);
        assert!(gap > 0.05);
    }
}

#[test]
fn in_the_middle_of_the_long_corridor_no_end_can_be_seen() {
    let world = world("long-corridor");
    let grid = crate::RayGrid::new(&Solids::of(&world).segments, &[]);
    for x in [14.5, 16.0, 17.5] {
        let fan = crate::Fan {
            origin: DVec2::new(x, 2.5),
            heading: 0.0,
            spacing: 0.5_f64.to_radians(),
            beams: 720,
            range_max: 8.19,
        };
        let mut hits = Vec::new();
        grid.cast(&fan, &mut hits);
        let walls: std::collections::BTreeSet<u32> = hits.iter().flatten().map(|hit| hit.solid).collect();
        assert_eq!(walls.len(), 2, "{x}");
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
