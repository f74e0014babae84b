use cogmap_geometry::normalize_angle;
use cogmap_mapping::MapperSetup;
use rand_core::SeedableRng;
use rand_pcg::Pcg64Mcg;

use super::*;
use crate::{Body, Obstacles, Odometer, SessionRecord, Solids, Source, World, WorldChange};

/// What became of a drive.
pub(crate) struct Trip {
    pub(crate) steps: usize,
    pub(crate) collisions: usize,
    pub(crate) length: f64,
    /// How close the robot came to anything, metres from its rim; at most half a metre.
    pub(crate) gap: f64,
    pub(crate) end: Pose,
    /// Odometry's heading less the true one, radians, not wrapped.
    pub(crate) heading_error: f64,
    /// Metres between where odometry believes and where the robot is.
    pub(crate) position_error: f64,
}

/// Drives a route from the world's start, without a laser.
pub(crate) fn drive(world: &World, robot: &Robot, route: &[DVec2], seed: u64) -> Result<Trip, String> {
    let obstacles = Obstacles::new(&Solids::of(world));
    let mut driver = Driver::new(world, robot, route)?;
    let [x, y] = world.start.position;
    let start = Pose::new(x, y, world.start.heading_deg.to_radians());
    let (mut body, mut odometer) = (Body::new(robot, start), Odometer::new(&robot.body));
    let mut rng = Pcg64Mcg::seed_from_u64(seed);
    let mut trip = Trip {
        steps: 0,
        collisions: 0,
        length: 0.0,
        gap: 0.5,
        end: start,
        heading_error: 0.0,
        position_error: 0.0,
    };
    while let Some(command) = driver.next_command(body.world_from_robot()) {
        trip.steps += 1;
        body.command(&command);
        loop {
            let (before, believed) = (body.world_from_robot(), odometer.odom_from_robot());
            let tick = body.tick(&obstacles, &mut rng);
            odometer.record(tick.turns);
            let after = body.world_from_robot();
            trip.collisions += usize::from(tick.collision.is_some());
            trip.length += before.position.distance(after.position);
            trip.heading_error += normalize_angle(odometer.odom_from_robot().heading - believed.heading)
                - normalize_angle(after.heading - before.heading);
            let near = obstacles.nearest(after.position, robot.body.radius + 0.5);
            trip.gap = near.map_or(trip.gap, |n| trip.gap.min(n.distance - robot.body.radius));
            if tick.step_end.is_some() {
                break;
            }
        }
    }
    trip.end = body.world_from_robot();
    trip.position_error = (start * odometer.odom_from_robot().position).distance(trip.end.position);
    Ok(trip)
}

/// A closed loop of 90 m around a block of 27 m by 18 m in steps of 0.85 m, either way round.
fn loop_of_90_metres(clockwise: bool) -> (World, Vec<DVec2>) {
    let side = if clockwise { -1.0 } else { 1.0 };
    let corners = [[0.0, 0.0], [27.0, 0.0], [27.0, 18.0], [0.0, 18.0], [0.0, 0.0]].map(DVec2::from);
    let legs = corners.windows(2).flat_map(|ends| {
        let steps = (ends[0].distance(ends[1]) / 0.85).round() as u32;
        (1..=steps).map(move |k| ends[0].lerp(ends[1], f64::from(k) / f64::from(steps)))
    });
    let route = legs.map(|point| DVec2::new(point.x, side * point.y)).collect();
    let text = r#"{"format": "cogmap-world/1", "name": "Loop", "start": {"position": [0, 0]}}"#;
    (serde_json::from_str(text).unwrap(), route)
}

fn loop_of_environment_b() -> (World, Vec<DVec2>) {
    let text = include_str!("../../../../worlds/environment-b.world.json");
    let world: World = serde_json::from_str(text).unwrap();
    let route = world.routes["loop"].iter().map(|&point| point.into()).collect();
    (world, route)
}

fn median(mut numbers: Vec<f64>) -> f64 {
    numbers.sort_by(f64::total_cmp);
    numbers[numbers.len() / 2]
}

/// Median heading error, degrees, and mean position error, metres, at the end of loops that take turns.
fn drift(name: &str, loops: &[(World, Vec<DVec2>)], seeds: std::ops::Range<u64>) -> [f64; 2] {
    let robot = Robot::named(name).unwrap();
    let trip = |seed: u64| {
        let (world, route) = &loops[seed as usize % loops.len()];
        drive(world, &robot, route, seed).unwrap()
    };
    let trips: Vec<Trip> = seeds.map(trip).collect();
    let heading = median(trips.iter().map(|t| t.heading_error.abs().to_degrees()).collect());
    [heading, trips.iter().map(|t| t.position_error).sum::<f64>() / trips.len() as f64]
}

#[test]
fn raw_odometry_is_off_by_10_and_90_degrees_after_90_metres() {
    let free = vec![loop_of_90_metres(false), loop_of_90_metres(true)];
    for (place, loops) in [("free", free), ("environment B", vec![loop_of_environment_b()])] {
        for (name, wanted) in [("good", 10.0), ("bad", 90.0)] {
            let [heading, position] = drift(name, &loops, 1001..1201);
            println!(
                "{place}, {name}: median heading error {heading:.1}°, mean position error {position:.2} m"
            );
            assert!((heading / wanted - 1.0).abs() < 0.2, "{place}, {name}: {heading}");
        }
    }
}

#[test]
fn raw_odometry_of_the_perfect_robot_is_the_truth() {
    let [heading, position] = drift("perfect", &[loop_of_90_metres(false), loop_of_environment_b()], 0..2);
    assert!(heading < 1e-6 && position < 1e-6, "{heading} {position}");
}

#[test]
fn a_driver_that_sees_a_door_being_shut_takes_the_other_one() {
    let text = r#"{ "format": "cogmap-world/1", "name": "Rooms", "start": {"position": [1.5, 1.5]},
        "walls": [[[0,0],[8,0],[8,5],[0,5],[0,0]], [[4,0],[4,1]], [[4,2],[4,3.5]], [[4,4.5],[4,5]]],
        "doors": [{"name": "south", "hinge": [4,2], "latch": [4,1], "open": true}] }"#;
    let (world, robot) = (serde_json::from_str::<World>(text).unwrap(), Robot::named("good").unwrap());
    let target = DVec2::new(6.5, 1.5);
    let mut driver = Driver::new(&world, &robot, &[target]).unwrap();
    let mapper = MapperSetup::named("odometry").unwrap();
    let record = SessionRecord::new(Source::world(world, robot), vec![mapper], 3);
    let mut session = Session::drive(record).unwrap();
    session.command(Command::Change(WorldChange::Door { name: "south".to_owned(), open: false }));
    session.advance();
    driver.see(session.world().unwrap());
    driver.drive(&mut session);
    assert_eq!(session.journal().mappers[0].collisions().count(), 0);
    assert!(session.world_from_robot().unwrap().position.distance(target) < 0.4);
}

mod worlds;

#[test]
fn a_drawn_way_leads_around_what_is_in_the_way_and_leaves_out_what_has_no_room() {
    let world: World = serde_json::from_str(
        r#"{"format": "cogmap-world/1", "name": "Rooms", "start": {"position": [1, 2.5]},
            "walls": [[[0, 0], [8, 0], [8, 5], [0, 5], [0, 0]], [[4, 0], [4, 2]], [[4, 3], [4, 5]]]}"#,
    )
    .unwrap();
    let robot = Robot::named("perfect").unwrap();
    let from = DVec2::new(1.0, 4.0);
    // Straight through the wall, with points in it and beyond the building.
    let line =
        [[2.0, 4.0], [3.9, 4.0], [6.0, 4.0], [7.9, 4.0], [500.0, 4.0], [f64::NAN, 0.0]].map(DVec2::from);
    let mut driver = Driver::along(&world, &robot, from, &line).unwrap().unwrap();
    let ahead: Vec<_> = driver.ahead().collect();
    assert_eq!(ahead.first(), Some(&line[0]));
    assert_eq!(ahead.last(), Some(&line[2]));
    assert!(
        ahead.iter().any(|point| (point.x - 4.0).abs() < 0.5 && (2.0..3.0).contains(&point.y)),
        "{ahead:?}"
    );
    let Some(Command::Step { turn, travel }) = driver.next_command(Pose::new(1.0, 4.0, 0.0)) else {
        panic!("there is a way to go");
    };
    assert!(turn.abs() < 1e-9 && (travel - 1.0).abs() < 1e-9);

    assert!(Driver::along(&world, &robot, from, &line[3..]).unwrap().is_none());
    let outside = [DVec2::new(-0.5, -0.5)];
    assert!(Driver::along(&world, &robot, from, &outside).err().unwrap().contains("cannot be reached"));
}
