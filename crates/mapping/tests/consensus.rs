//! What the recommended mapper promises (it is not the theory's model; see its module).

mod laser;

use cogmap_geometry::{DVec2, Pose, Segment, normalize_angle, trig};
use cogmap_mapping::{
    Event, Mapper, MapperSetup, Placement, StepReport,
    memory::{Frame, FrameId, Link, LinkKind, StoredSurface},
};
use laser::{reading, walls};
use proptest::prelude::*;

/// Two rooms that differ in size and shape, with a door between them and things standing about.
fn rooms() -> Vec<Segment> {
    let mut all = walls(&[(0.0, 0.0), (7.0, 0.0), (7.0, 2.0)]);
    all.extend(walls(&[(7.0, 3.0), (7.0, 6.0), (0.0, 6.0), (0.0, 0.0)]));
    all.extend(walls(&[
        (7.1, 2.0),
        (7.1, 0.5),
        (17.0, 0.5),
        (17.0, 4.5),
        (14.0, 4.5),
        (14.0, 9.0),
        (7.1, 9.0),
        (7.1, 3.0),
    ]));
    all.extend(walls(&[(7.0, 2.0), (7.1, 2.0)]));
    all.extend(walls(&[(7.0, 3.0), (7.1, 3.0)]));
    all.extend(walls(&[(2.6, 4.0), (3.8, 4.4), (3.5, 5.3), (2.3, 4.9), (2.6, 4.0)]));
    all.extend(walls(&[(5.0, 0.0), (5.0, 0.8), (6.1, 0.8), (6.1, 0.0)]));
    all.extend(walls(&[(10.0, 6.0), (11.2, 6.6), (10.8, 7.4), (9.6, 6.8), (10.0, 6.0)]));
    all
}

/// A robot whose odometry errs by these shares of each movement.
struct Robot {
    mapper: Mapper,
    walls: Vec<Segment>,
    truth: Pose,
    odometry: Pose,
    error: [f64; 2],
    reports: Vec<StepReport>,
    truths: Vec<Pose>,
}

impl Robot {
    fn new(walls: Vec<Segment>, truth: Pose, error: [f64; 2]) -> Self {
        let mapper = Mapper::new(&MapperSetup::Consensus(Box::default()), 1);
        let mut robot = Self {
            mapper,
            walls,
            truth,
            odometry: Pose::IDENTITY,
            error,
            reports: Vec::new(),
            truths: Vec::new(),
        };
        robot.look();
        robot
    }

    fn look(&mut self) {
        let t = self.reports.len() as f64;
        let report = self.mapper.observe(&reading(t, &self.walls, self.truth, self.odometry));
        self.reports.extend(report);
        self.truths.push(self.truth);
    }

    fn step(&mut self, turn: f64, travel: f64) {
        let [by_way, by_turn] = self.error;
        self.truth = self.truth * Pose::new(0.0, 0.0, turn) * Pose::new(travel, 0.0, 0.0);
        let (turn, travel) = (turn * (1.0 + by_turn) + by_turn * travel, travel * (1.0 + by_way));
        self.odometry = self.odometry * Pose::new(0.0, 0.0, turn) * Pose::new(travel, 0.0, 0.0);
        self.look();
    }

    /// Turns and goes there in short steps.
    fn go(&mut self, x: f64, y: f64) {
        let to = DVec2::new(x, y);
        loop {
            let ahead = to - self.truth.position;
            let turn = normalize_angle(trig::atan2(ahead.y, ahead.x) - self.truth.heading);
            if ahead.length() < 0.05 {
                return;
            }
            let turned = turn.clamp(-0.3, 0.3);
            self.step(turned, if (turn - turned).abs() < 1e-9 { ahead.length().min(0.25) } else { 0.0 });
        }
    }

    /// Has looked about in the first room.
    fn at_home() -> Self {
        let mut robot = Self::new(rooms(), Pose::new(1.0, 1.0, 0.4), [0.02, 0.03]);
        for (x, y) in [(4.0, 2.0), (6.0, 5.0), (4.5, 3.0), (1.5, 3.5), (1.2, 1.5), (4.0, 1.5)] {
            robot.go(x, y);
        }
        robot
    }

    fn lost(&self) -> Vec<usize> {
        self.reports.iter().filter(|report| report.lost.is_some()).map(|report| report.step).collect()
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 8, ..ProptestConfig::default() })]

    #[test]
    fn the_map_does_not_depend_on_odometry_where_all_is_observable(
        way in -0.08f64..0.08, turn in -0.08f64..0.08,
    ) {
        let [first, second] = [[0.0, 0.0], [way, turn]].map(|error| {
            let mut robot = Robot::new(rooms(), Pose::new(1.0, 1.0, 0.4), error);
            for (x, y) in [(4.0, 2.0), (6.0, 5.0), (4.5, 3.0)] {
                robot.go(x, y);
            }
            robot
        });
        prop_assert!(second.reports[1..].iter().all(|report| report.placement == Placement::Consensus));
        let [first, second] = [&first, &second].map(|robot| robot.mapper.mfis().surfaces());
        prop_assert_eq!(first.len(), second.len());
        for (one, other) in first.iter().zip(second) {
            prop_assert!(one.segment.a.distance(other.segment.a) < 1e-6);
            prop_assert!(one.segment.b.distance(other.segment.b) < 1e-6);
        }
    }
}

#[test]
fn nothing_stored_ever_moves() {
    let mut robot = Robot::new(rooms(), Pose::new(1.0, 1.0, 0.4), [0.03, -0.05]);
    let mut before: (Vec<StoredSurface>, Vec<Frame>, Vec<Link>) = Default::default();
    for (x, y) in [(4.0, 2.0), (6.0, 2.5), (9.0, 2.5), (12.0, 5.0), (9.0, 2.5), (6.0, 2.5), (1.5, 3.5)] {
        robot.go(x, y);
        let mfis = robot.mapper.mfis();
        assert_eq!(mfis.surfaces()[..before.0.len()], before.0);
        assert_eq!(mfis.frames()[..before.1.len()], before.1);
        assert_eq!(mfis.links()[..before.2.len()], before.2);
        before = (mfis.surfaces().to_vec(), mfis.frames().to_vec(), mfis.links().to_vec());
    }
    assert!(before.0.len() > 20 && before.1.len() > 2);
}

#[test]
fn going_into_new_space_is_no_loss() {
    let mut robot = Robot::at_home();
    for (x, y) in [(6.0, 2.5), (8.0, 2.5), (12.0, 3.0), (12.5, 6.0), (15.5, 2.5)] {
        robot.go(x, y);
    }
    assert_eq!(robot.lost(), []);
}

#[test]
fn a_robot_moved_unseen_notices_it_and_maps_nothing_into_the_place_it_left() {
    for (x, y, heading) in [(12.0, 5.0, 0.3), (15.0, 2.0, 3.0), (9.0, 3.0, 1.5), (12.0, 1.5, -2.0)] {
        let mut robot = Robot::at_home();
        let (moved_in, frames) = (robot.reports.len(), robot.mapper.mfis().frames().len());
        robot.truth = Pose::new(x, y, heading);
        for _ in 0..8 {
            robot.step(0.2, 0.15);
        }
        let lost = robot.lost();
        assert_eq!(lost.len(), 1);
        assert!((moved_in..moved_in + 3).contains(&lost[0]), "moved in {moved_in}, noticed in {}", lost[0]);
        let told = robot.reports[lost[0]].events();
        assert!(told.iter().any(|event| matches!(event, Event::Lost { .. })));
        let since = robot.mapper.mfis().surfaces().iter().filter(|surface| surface.step >= moved_in);
        assert!(since.clone().count() > 0);
        assert!(since.into_iter().all(|surface| surface.frame.0 as usize >= frames));
        let ways = robot.mapper.mfis().ways_from(FrameId(0), f64::INFINITY);
        assert!(ways.keys().all(|frame| (frame.0 as usize) < frames), "nothing joins the two");
    }
}

#[test]
fn a_lost_robot_finds_itself_back_in_a_room_that_it_knows() {
    let mut robot = Robot::at_home();
    robot.truth = Pose::new(13.0, 2.0, 2.0);
    robot.go(11.0, 3.0);
    robot.go(12.5, 5.0);
    robot.truth = Pose::new(5.5, 4.0, -2.5);
    for (x, y) in [(4.5, 3.0), (1.5, 3.5), (1.2, 1.5), (4.0, 1.5), (5.5, 4.5), (4.5, 3.0)] {
        robot.go(x, y);
    }
    assert_eq!(robot.lost().len(), 2);
    let mfis = robot.mapper.mfis();
    assert!(mfis.links().iter().any(|link| link.kind == LinkKind::Recognised));
    let here = robot.mapper.path().last().unwrap();
    let from_start =
        mfis.ways_from(FrameId(0), f64::INFINITY)[&here.frame].here_from_frame * here.frame_from_robot;
    let truly = robot.truths[0].from_here(robot.truth);
    assert!(from_start.position.distance(truly.position) < 0.05, "{from_start:?} {truly:?}");
}

#[test]
fn odometry_decides_along_a_corridor_only_and_says_so() {
    let corridor = walls(&[(-40.0, 0.0), (60.0, 0.0)]).into_iter().chain(walls(&[(60.0, 2.0), (-40.0, 2.0)]));
    let mut robot = Robot::new(corridor.collect(), Pose::new(0.0, 1.0, 0.3), [0.1, 0.02]);
    for turn in [-0.3, 0.2, -0.1, 0.1, 0.0] {
        robot.step(turn, 0.4);
    }
    let start = robot.truths[0];
    for report in &robot.reports[1..] {
        assert_eq!(report.placement, Placement::PartlyOdometry);
        let along = start.rotate(report.open.unwrap());
        assert!(along.y.abs() < 1e-3 && (along.length() - 1.0).abs() < 1e-9, "{along}");
    }
    let across = start * robot.reports.last().unwrap().map_from_robot.position;
    assert!((across.y - robot.truth.position.y).abs() < 1e-3, "across it, the walls decide");
}
