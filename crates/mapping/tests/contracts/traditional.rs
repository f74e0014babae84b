use cogmap_geometry::{Pose, Segment, line_angle_between};
use cogmap_mapping::{
    StepReport,
    traditional::{Transform, TransformParams},
};
use rand_core::SeedableRng;
use rand_pcg::Pcg64Mcg;

use crate::{
    ideal,
    walk::{bad_odometry, random_walk},
};

/// A walk seen ideally and mapped with a share of its odometry error.
struct Run {
    truth: Vec<Pose>,
    odometry: Vec<Pose>,
    reports: Vec<StepReport>,
    map: Vec<Segment>,
}

fn run(seed: u64, share: f64) -> Run {
    let walk = random_walk(seed);
    let truth = walk.truth();
    let odometry = bad_odometry(&truth, share, &mut Pcg64Mcg::seed_from_u64(seed));
    let mut mapper = Transform::new(&TransformParams::default(), seed);
    let look = |(&pose, &odom_from_robot): (&Pose, &Pose)| {
        mapper.integrate(ideal::view(&walk.walls, pose), 0.0, odom_from_robot)
    };
    let reports = walk.world_from_robot.iter().zip(&odometry).map(look).collect();
    let map = mapper.memory().mfis().surfaces().iter().map(|stored| stored.segment).collect();
    Run { truth, odometry, reports, map }
}

impl Run {
    /// The true, the measured and the corrected movement of a step.
    fn movements(&self, step: usize) -> [Pose; 3] {
        let mapped = |step: usize| self.reports[step].map_from_robot;
        [
            self.truth[step - 1].from_here(self.truth[step]),
            self.odometry[step - 1].from_here(self.odometry[step]),
            mapped(step - 1).from_here(mapped(step)),
        ]
    }
}

/// How far off a movement is; a radian counts as much as a metre.
fn off(truth: Pose, moved: Pose) -> f64 {
    let error = truth.from_here(moved);
    error.position.length() + error.heading.abs()
}

/// Three recognised surfaces at least, and not all of one direction.
fn well_determined(report: &StepReport) -> bool {
    let headings: Vec<f64> =
        report.matches.iter().map(|m| report.view.surfaces[m.seen].segment.heading()).collect();
    headings.len() >= 3 && headings.iter().any(|&h| line_angle_between(h, headings[0]) > 0.5)
}

#[test]
fn with_perfect_odometry_the_traditional_map_is_nearly_the_truth() {
    let (mut exact, mut all) = (0, 0);
    for seed in 1..=30 {
        let run = run(seed, 0.0);
        for step in 1..run.truth.len() {
            let [moved, _, mapped] = run.movements(step);
            assert!(off(moved, mapped) < 0.05, "seed {seed} step {step} is {} off", off(moved, mapped));
            exact += usize::from(off(moved, mapped) < 0.005);
            all += 1;
        }
    }
    assert!(exact * 100 >= all * 95, "{exact} of {all}");
}

#[test]
fn the_corrected_movement_is_nearer_to_the_truth_than_odometry_in_95_of_100_steps() {
    let (mut better, mut all) = (0, 0);
    for seed in 1..=60 {
        let run = run(seed, 2.0);
        for step in (1..run.truth.len()).filter(|&step| well_determined(&run.reports[step])) {
            let [moved, measured, mapped] = run.movements(step);
            all += 1;
            better += usize::from(off(moved, mapped) < off(moved, measured));
        }
    }
    assert!(all > 200 && better * 100 >= all * 95, "{better} of {all}");
}

#[test]
fn only_changes_that_lower_the_mean_error_are_accepted() {
    let run = run(4, 1.0);
    let corrections: Vec<_> = run.reports.iter().filter_map(|report| report.correction.as_ref()).collect();
    assert_eq!(corrections.len(), run.reports.len() - 1);
    assert!(corrections.iter().all(|c| c.errors.windows(2).all(|pair| pair[1] < pair[0])));
    assert!(corrections.iter().all(|c| c.errors.len() > 3));
}

#[test]
fn the_same_seed_gives_the_same_traditional_map() {
    assert_eq!(run(5, 1.0).map, run(5, 1.0).map);
}

/// §3.1.3: the movement has two parameters, turn and travel; to the side nothing is corrected.
#[test]
fn a_correction_turns_and_travels_and_does_nothing_else() {
    let run = run(6, 1.0);
    for step in 1..run.truth.len() {
        let correction = run.reports[step].correction.as_ref().unwrap();
        let [_, measured, mapped] = run.movements(step);
        let turned = Pose::new(0.0, 0.0, correction.turn);
        let travelled = turned.rotate(measured.position.normalize()) * correction.travel;
        assert!(mapped.position.distance(turned * measured.position + travelled) < 1e-9);
        assert!(turned.rotate(measured.forward()).distance(mapped.forward()) < 1e-9);
    }
}
