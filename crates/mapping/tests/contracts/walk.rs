use cogmap_geometry::{DVec2, Pose, Segment, trig};
use cogmap_mapping::{
    StepReport,
    memory::{Perceptual, PerceptualParams, StoredSurface},
};
use proptest::prelude::*;
use rand_core::SeedableRng;
use rand_pcg::Pcg64Mcg;

use crate::{ideal, sampled};

/// How many steps a walk has.
const STEPS: usize = 12;

/// A hall with three boxes, and a walk along its free side.
#[derive(Clone, Debug)]
pub(crate) struct Walk {
    pub(crate) walls: Vec<Segment>,
    pub(crate) world_from_robot: Vec<Pose>,
    pub(crate) odometry_error: Vec<(f64, f64, f64)>,
}

prop_compose! {
    pub(crate) fn any_walk()(
        depth in 7.0f64..9.0,
        boxes in prop::collection::vec((-0.5f64..0.5, -0.3f64..0.3, 0.15f64..1.4), 3),
        turns in prop::collection::vec(-0.35f64..0.35, STEPS),
        odometry_error in prop::collection::vec((-0.12f64..0.12, -0.12f64..0.12, -0.03f64..0.03), STEPS),
    ) -> Walk {
        Walk::along_a_hall(ideal::hall(14.0, depth, &boxes), &turns, odometry_error)
    }
}

/// The same by seed, for figures over many walks.
pub(crate) fn random_walk(seed: u64) -> Walk {
    let mut rng = Pcg64Mcg::seed_from_u64(seed);
    let mut within = |most: f64| most * (2.0 * sampled::uniform(&mut rng) - 1.0);
    let boxes: Vec<_> = (0..3).map(|_| (within(0.5), within(0.3), 0.775 + within(0.625))).collect();
    let turns: Vec<f64> = (0..STEPS).map(|_| within(0.35)).collect();
    let odometry_error = (0..STEPS).map(|_| (within(0.12), within(0.12), within(0.03))).collect();
    Walk::along_a_hall(ideal::hall(14.0, 8.0 + within(1.0), &boxes), &turns, odometry_error)
}

impl Walk {
    /// Turn, then travel; steered back to the middle of the free side.
    fn along_a_hall(walls: Vec<Segment>, turns: &[f64], odometry_error: Vec<(f64, f64, f64)>) -> Self {
        let mut pose = Pose::new(1.0, 2.0, 0.0);
        let mut world_from_robot = vec![pose];
        for turn in turns {
            let steered = Pose::new(0.0, 0.0, turn - 0.6 * pose.heading + 0.3 * (2.0 - pose.position.y));
            pose = pose * steered * Pose::new(0.7, 0.0, 0.0);
            world_from_robot.push(pose);
        }
        Self { walls, world_from_robot, odometry_error }
    }

    /// Where odometry believes the robot to be; `share` of the error is on.
    pub(crate) fn odometry(&self, share: f64) -> Vec<Pose> {
        let mut odom_from_robot = vec![Pose::IDENTITY];
        for (pair, (x, y, turn)) in self.world_from_robot.windows(2).zip(&self.odometry_error) {
            let moved = pair[0].from_here(pair[1]) * Pose::new(x * share, y * share, turn * share);
            odom_from_robot.push(odom_from_robot[odom_from_robot.len() - 1] * moved);
        }
        odom_from_robot
    }

    /// The same poses, the first one being the origin.
    pub(crate) fn truth(&self) -> Vec<Pose> {
        self.world_from_robot.iter().map(|&pose| self.world_from_robot[0].from_here(pose)).collect()
    }

    /// Maps the walk as the thesis does; `share` of the odometry error is on.
    pub(crate) fn map(&self, share: f64) -> (Perceptual, Vec<StepReport>) {
        self.map_with(&PerceptualParams::default(), share)
    }

    /// Maps the walk; `share` of the odometry error is on.
    pub(crate) fn map_with(&self, params: &PerceptualParams, share: f64) -> (Perceptual, Vec<StepReport>) {
        let mut mapper = Perceptual::new(params);
        let look = |(&pose, &odom_from_robot): (&Pose, &Pose)| {
            mapper.integrate(ideal::view(&self.walls, pose), 0.0, odom_from_robot)
        };
        let reports = self.world_from_robot.iter().zip(&self.odometry(share)).map(look).collect();
        (mapper, reports)
    }

    /// How far a stored surface lies from the wall that it is a sighting of, metres.
    pub(crate) fn distance_from_truth(&self, stored: &StoredSurface) -> f64 {
        let in_world = self.world_from_robot[0] * stored.segment;
        let off = |wall: &Segment| wall.distance_to(in_world.a).max(wall.distance_to(in_world.b));
        self.walls.iter().map(off).fold(f64::INFINITY, f64::min)
    }
}

/// The largest turn of one step, radians.
const TURN: f64 = 20.0 * trig::PI / 180.0;

/// The poses of whoever goes from point to point: straight on at most `step` metres at a time, and at the
/// points by turns of at most 20°.
pub(crate) fn along(points: &[[f64; 2]], step: f64) -> Vec<Pose> {
    let mut poses: Vec<Pose> = Vec::new();
    for pair in points.windows(2) {
        let (from, to) = (DVec2::from(pair[0]), DVec2::from(pair[1]));
        let there = Pose { position: from, heading: trig::atan2(to.y - from.y, to.x - from.x) };
        while let Some(last) = poses.last().filter(|last| (*last).from_here(there).heading.abs() > TURN) {
            let turn = TURN.copysign(last.from_here(there).heading);
            poses.push(Pose { position: from, ..*last * Pose::new(0.0, 0.0, turn) });
        }
        let mut way = 0.0;
        while way < from.distance(to) - 0.01 {
            poses.push(there * Pose::new(way, 0.0, 0.0));
            way += step;
        }
    }
    let last = points[points.len() - 1];
    poses.push(Pose { position: last.into(), ..poses[poses.len() - 1] });
    poses
}

/// Around the boxes of a hall of 14 m by 9 m, twice as far as a view reaches, and back to the start.
pub(crate) fn around_the_hall() -> (Vec<Segment>, Vec<Pose>) {
    let walls = ideal::hall(14.0, 9.0, &[(0.0, 0.0, 0.4), (0.3, -0.1, 0.9), (-0.3, 0.1, 1.2)]);
    let points = [[1.5, 2.0], [12.7, 2.0], [12.7, 8.0], [1.5, 8.0], [1.5, 2.0], [2.0, 2.0]];
    (walls, along(&points, 0.7))
}

/// What bad odometry says of the poses: each step is off by some 2° and 5 %, times `factor` (1 σ).
pub(crate) fn bad_odometry(world_from_robot: &[Pose], factor: f64, rng: &mut Pcg64Mcg) -> Vec<Pose> {
    let mut odometry = vec![Pose::IDENTITY];
    for pair in world_from_robot.windows(2) {
        let moved = pair[0].from_here(pair[1]);
        let turn = 0.03 * factor * sampled::gaussian(rng);
        let stretch = 1.0 + 0.05 * factor * sampled::gaussian(rng);
        let wrong = Pose { position: moved.position * stretch, heading: moved.heading + turn };
        odometry.push(odometry[odometry.len() - 1] * wrong);
    }
    odometry
}
