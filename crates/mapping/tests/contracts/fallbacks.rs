use cogmap_geometry::Pose;
use cogmap_mapping::{
    Placement, StepReport, fallback_runs,
    memory::{Perceptual, PerceptualParams},
    perception::View,
};
use rand_core::SeedableRng;
use rand_pcg::Pcg64Mcg;

use crate::{
    ideal, sampled,
    walk::{Walk, random_walk},
};

/// Mean distance of the stored surfaces from the truth, metres, and the number of fallbacks. So many times
/// the robot sees nothing for one view; the same views go dark whatever the number, and more of them.
fn map_error(seed: u64, blindings: usize) -> (f64, usize) {
    let walk = random_walk(seed);
    let mut rng = Pcg64Mcg::seed_from_u64(seed);
    let mut order: Vec<(u64, usize)> =
        [2, 4, 6, 8].iter().map(|&view| (sampled::uniform(&mut rng).to_bits(), view)).collect();
    order.sort_unstable();
    let dark: Vec<usize> = order.iter().take(blindings).map(|&(_, view)| view).collect();
    let (mapper, reports) = half_blind(&walk, &dark, 1.0);
    let truth = walk.truth();
    let errors = mapper.memory().mfis().surfaces().iter().map(|stored| {
        let seen = &reports[stored.step].view.surfaces[stored.index_in_view];
        let expected = truth[stored.step] * seen.segment;
        expected.a.distance(stored.segment.a).max(expected.b.distance(stored.segment.b))
    });
    let errors: Vec<f64> = errors.collect();
    let fallbacks = reports.iter().filter(|r| r.placement == Placement::Odometry).count();
    assert_eq!(fallback_runs(&reports).iter().map(|run| run.views).sum::<usize>(), fallbacks);
    (errors.iter().sum::<f64>() / errors.len() as f64, fallbacks)
}

/// Maps a walk of which some views are dark.
fn half_blind(walk: &Walk, dark: &[usize], share: f64) -> (Perceptual, Vec<StepReport>) {
    let mut mapper = Perceptual::new(&PerceptualParams::default());
    let poses = walk.world_from_robot.iter().zip(walk.odometry(share)).enumerate();
    let reports = poses.map(|(index, (&pose, odom_from_robot))| {
        let view = if dark.contains(&index) { View::default() } else { ideal::view(&walk.walls, pose) };
        mapper.integrate(view, 0.0, odom_from_robot)
    });
    let reports = reports.collect();
    (mapper, reports)
}

#[test]
fn the_map_gets_worse_in_the_mean_with_every_forced_fallback() {
    // A wrong match would be another error than the one that is looked at here.
    let seeds: Vec<u64> = (1..=60).filter(|&seed| map_error(seed, 0).0 < 1e-9).collect();
    assert!(seeds.len() > 40, "ideal views mostly give the truth: {}", seeds.len());
    let mean = |blindings: usize| {
        let runs: Vec<(f64, usize)> = seeds.iter().map(|&seed| map_error(seed, blindings)).collect();
        assert!(runs.iter().all(|&(_, fallbacks)| fallbacks >= blindings));
        runs.iter().map(|run| run.0).sum::<f64>() / runs.len() as f64
    };
    let means = [0, 1, 2, 3, 4].map(mean);
    assert!(means.windows(2).all(|pair| pair[1] > 1.1 * pair[0]), "{means:?}");
}

/// One view by odometry displaces what comes after it, and the next reference is as good as any.
#[test]
fn a_fallback_is_for_one_view_alone() {
    let walk = random_walk(1);
    let (_, reports) = half_blind(&walk, &[4], 1.0);
    let truth = walk.truth();
    let off = |step: usize| truth[step].from_here(reports[step].map_from_robot);
    for report in &reports[1..] {
        let by_odometry = report.step == 4 || report.step == 5;
        assert_eq!(report.placement == Placement::Odometry, by_odometry, "view {}", report.step);
    }
    let displacement = |step: usize| reports[step].map_from_robot * truth[step].inverse();
    assert!(off(3).position.length() < 1e-9 && off(5).position.length() > 0.01);
    for step in 6..reports.len() {
        let more: Pose = displacement(5).from_here(displacement(step));
        assert!(more.position.length() < 1e-9 && more.heading.abs() < 1e-9, "view {step} adds nothing");
    }
}
