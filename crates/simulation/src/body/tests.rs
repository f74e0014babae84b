use cogmap_geometry::{Segment, normalize_angle, trig::FRAC_PI_2};
use proptest::prelude::*;
use rand_core::SeedableRng;

use super::*;
use crate::{Obstacles, Odometer, Solids};

fn robot(name: &str) -> Robot {
    Robot::named(name).unwrap()
}

fn room(walls: &[[[f64; 2]; 2]]) -> Obstacles {
    let segments = walls.iter().map(|[a, b]| Segment::new((*a).into(), (*b).into())).collect();
    Obstacles::new(&Solids { segments, ..Solids::default() })
}

fn square() -> Obstacles {
    let corners = [[-2.0, -2.0], [2.0, -2.0], [2.0, 2.0], [-2.0, 2.0]];
    room(&[0, 1, 2, 3].map(|k| [corners[k], corners[(k + 1) % 4]]))
}

struct Trip {
    body: Body,
    odometer: Odometer,
    collisions: Vec<DVec2>,
    end: Option<StepEnd>,
    seconds: f64,
}

fn step(robot: &Robot, obstacles: &Obstacles, turn: f64, travel: f64, seed: u64) -> Trip {
    let mut body = Body::new(robot, Pose::IDENTITY);
    let mut rng = Pcg64Mcg::seed_from_u64(seed);
    body.command(&Command::Step { turn, travel });
    let odometer = Odometer::new(&robot.body);
    let mut trip = Trip { body, odometer, collisions: Vec::new(), end: None, seconds: 0.0 };
    while trip.end.is_none() && trip.seconds < 200.0 {
        let tick = trip.body.tick(obstacles, &mut rng);
        trip.odometer.record(tick.turns);
        trip.collisions.extend(tick.collision);
        (trip.end, trip.seconds) = (tick.step_end, trip.seconds + TICK);
    }
    trip
}

#[test]
fn a_perfect_step_goes_exactly_where_it_was_told_and_odometry_agrees() {
    let trip = step(&robot("perfect"), &room(&[]), FRAC_PI_2, 0.85, 1);
    let pose = trip.body.world_from_robot();
    assert!((pose.position - DVec2::new(0.0, 0.85)).length() < 1e-9, "{pose:?}");
    assert!((pose.heading - FRAC_PI_2).abs() < 1e-9);
    assert!((trip.odometer.odom_from_robot().position - pose.position).length() < 1e-9);
    assert_eq!(trip.end, Some(StepEnd::Done));
    assert!(trip.body.at_rest() && trip.seconds < 4.0);
}

#[test]
fn the_encoders_of_a_bad_robot_say_what_was_ordered_and_the_floor_saw_something_else() {
    let trip = step(&robot("bad"), &room(&[]), 1.0, 2.0, 3);
    let (odom, truth) = (trip.odometer.odom_from_robot(), trip.body.world_from_robot());
    assert!((odom.heading - 1.0).abs() < 1e-9);
    assert!((odom.position.length() - 2.0).abs() < 1e-9);
    let error = (odom.position - truth.position).length();
    assert!((0.001..0.4).contains(&error), "{error}");
}

#[test]
fn a_step_against_a_wall_ends_and_is_one_collision() {
    let wall = room(&[[[1.0, -3.0], [1.0, 3.0]]]);
    let trip = step(&robot("perfect"), &wall, 0.0, 5.0, 1);
    assert_eq!(trip.end, Some(StepEnd::Stalled));
    assert_eq!(trip.collisions.len(), 1);
    assert!((trip.collisions[0] - DVec2::new(1.0, 0.0)).length() < 1e-6);
    assert!((trip.body.world_from_robot().position.x - 0.75).abs() < 1e-3);
    assert!((trip.odometer.odom_from_robot().position.x - 0.75).abs() < 0.02, "a wall holds the wheels");
    assert!(trip.body.at_rest() && trip.seconds < 4.0, "{}", trip.seconds);
}

#[test]
fn it_slides_along_a_wall_and_odometry_does_not_notice() {
    let wall = room(&[[[-9.0, 1.0], [9.0, 1.0]]]);
    let trip = step(&robot("perfect"), &wall, 0.5, 4.0, 1);
    let truth = trip.body.world_from_robot().position;
    assert_eq!(trip.end, Some(StepEnd::Done));
    assert!(truth.x > 3.0 && (truth.y - 0.75).abs() < 1e-3, "{truth}");
    assert!(trip.odometer.odom_from_robot().position.y > 1.5);
    assert_eq!(trip.collisions.len(), 1);
}

#[test]
fn velocity_driving_speeds_up_gently_and_stops_when_told() {
    let mut body = Body::new(&robot("perfect"), Pose::IDENTITY);
    let mut rng = Pcg64Mcg::seed_from_u64(1);
    body.command(&Command::Drive { linear: 9.0, angular: 0.5 });
    for _ in 0..100 {
        let before = body.speed();
        body.tick(&room(&[]), &mut rng);
        assert!(body.speed()[0] - before[0] <= 0.8 * TICK + 1e-12);
    }
    assert_eq!(body.speed(), [1.2, 0.5]);
    body.command(&Command::Stop);
    for _ in 0..80 {
        body.tick(&room(&[]), &mut rng);
    }
    assert!(body.at_rest());
}

#[test]
fn a_step_ordered_under_way_begins_when_the_robot_stands() {
    let mut body = Body::new(&robot("perfect"), Pose::IDENTITY);
    let mut rng = Pcg64Mcg::seed_from_u64(1);
    body.command(&Command::Drive { linear: 1.0, angular: 0.0 });
    for _ in 0..60 {
        body.tick(&room(&[]), &mut rng);
    }
    body.command(&Command::Step { turn: -FRAC_PI_2, travel: 1.0 });
    let mut ticks = 0;
    while body.tick(&room(&[]), &mut rng).step_end.is_none() {
        ticks += 1;
        assert!(ticks < 500);
    }
    assert!((body.world_from_robot().position.y + 1.0).abs() < 1e-9);
}

fn any_command() -> impl Strategy<Value = Command> {
    prop_oneof![
        (-2.0f64..2.0, -3.0f64..3.0).prop_map(|(linear, angular)| Command::Drive { linear, angular }),
        (-4.0f64..4.0, -3.0f64..3.0).prop_map(|(turn, travel)| Command::Step { turn, travel }),
        Just(Command::Step { turn: f64::NAN, travel: f64::INFINITY }),
        Just(Command::Stop),
    ]
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn no_command_drives_the_robot_into_a_wall(
        commands in prop::collection::vec((any_command(), 1usize..150), 1..12), seed in 0u64..99,
    ) {
        let (obstacles, robot) = (square(), robot("bad"));
        let mut body = Body::new(&robot, Pose::IDENTITY);
        let mut rng = Pcg64Mcg::seed_from_u64(seed);
        for (command, ticks) in commands {
            body.command(&command);
            for _ in 0..ticks {
                body.tick(&obstacles, &mut rng);
                let pose = body.world_from_robot();
                prop_assert!(pose.position.abs().max_element() <= 1.75 + 1e-9, "{pose:?}");
            }
        }
    }

    #[test]
    fn every_step_ends(turn in -10.0f64..10.0, travel in -60.0f64..60.0, seed in 0u64..99) {
        let trip = step(&robot("bad"), &square(), turn, travel, seed);
        prop_assert!(trip.end.is_some());
        prop_assert!(trip.body.at_rest());
        prop_assert!(normalize_angle(trip.odometer.odom_from_robot().heading - turn).abs() < 1e-6);
    }
}
