use std::collections::BTreeSet;

use cogmap_geometry::DVec2;

use super::*;
use crate::{BodyParams, Robot, Session, SessionRecord, Source, driver::Driver};

/// A room counts as reached where a disc of this radius can stand in it, metres.
const DISC: f64 = 0.35;

/// A thousand floors differ in their rooms, not only in their furniture.
#[test]
fn a_thousand_seeds_make_a_thousand_different_floors() {
    let plan = |seed| {
        let building = Building::drawn(&mut Dice::new(seed));
        let rooms: Vec<[[i32; 2]; 2]> = building.spaces.iter().map(|s| [s.rect.low, s.rect.high]).collect();
        rooms
    };
    let plans: BTreeSet<_> = (0..1000).map(plan).collect();
    assert_eq!(plans.len(), 1000);
}

#[test]
fn the_same_seed_makes_the_same_floor() {
    assert_eq!(Building::generate(3), Building::generate(3));
    assert_ne!(Building::generate(3).walls, Building::generate(4).walls);
}

#[test]
fn every_floor_can_be_simulated_and_has_a_way_out_of_10_to_60_metres() {
    for seed in 0..24 {
        let world = Building::generate(seed);
        assert_eq!(world.problems(), [], "seed {seed}");
        let start = DVec2::from(world.start.position);
        let route: Vec<DVec2> = world.routes[OUT].iter().map(|&point| point.into()).collect();
        let points = std::iter::once(&start).chain(&route);
        let length: f64 = points.zip(&route).map(|(a, b)| a.distance(*b)).sum();
        assert!((10.0 - 1e-9..=60.0 + 1e-9).contains(&length), "seed {seed}: {length}");
        assert!(route.last().unwrap().distance(start) >= 6.0, "seed {seed}");
    }
}

/// What the walls hide from a disc is not asked of it: each room's middle stands for the room, or a
/// spot near it where furniture leaves one.
#[test]
fn every_room_can_be_reached() {
    for seed in 100..140 {
        let world = Building::generate(seed);
        let mut planner = crate::driver::Planner::new(&world, &[], DISC - 0.07);
        let reached = planner.reachable(world.start.position.into(), f64::INFINITY);
        for room in &world.rooms {
            let [low, high] = [room.outline[0], room.outline[2]].map(DVec2::from);
            let inside = |point: &&DVec2| point.cmpgt(low).all() && point.cmplt(high).all();
            let spots = reached.iter().filter(inside).count();
            assert!(spots as f64 * 0.05 * 0.05 > 0.5, "seed {seed}: {} is shut off", room.name);
        }
    }
}

#[test]
fn the_person_at_the_controls_gets_a_bad_robot_out_without_touching_anything() {
    for seed in 0..6 {
        let world = Building::generate(seed);
        let robot = Robot::named("bad").unwrap();
        let route: Vec<DVec2> = world.routes[OUT].iter().map(|&point| point.into()).collect();
        let mut driver = Driver::new(&world, &robot, &route).unwrap();
        let mut session =
            Session::drive(SessionRecord::new(Source::world(world, robot), Vec::new(), seed)).unwrap();
        driver.drive(&mut session);
        let end = session.world_from_robot().unwrap().position;
        assert!(end.distance(*route.last().unwrap()) < 0.5, "seed {seed}: gave up at {end}");
        let gap = crate::Obstacles::new(session.solids().unwrap()).nearest(end, BodyParams::default().radius);
        assert_eq!(gap, None);
    }
}

#[test]
fn no_leaf_stands_in_a_doorway() {
    for seed in 0..200 {
        let building = Building::drawn(&mut Dice::new(seed));
        let leaves: Vec<_> = building.doorways.iter().filter_map(|d| d.leaf.as_ref()).collect();
        for doorway in &building.doorways {
            let Rect { low, high } = doorway.opening.grown(-1);
            let (low, high) = (DVec2::from(metres(low)), DVec2::from(metres(high)));
            if doorway.opening.area() > 0.0 {
                for leaf in leaves.iter().filter(|leaf| leaf.open).map(|leaf| leaf.leaf()) {
                    let middle = low.midpoint(high);
                    let near = leaf.distance_to(middle);
                    assert!(near > 0.4, "seed {seed}: {leaf:?} {middle}");
                }
            }
        }
    }
}
