use cogmap_geometry::Pose;
use cogmap_mapping::{
    Mapper, MapperSetup, Placement, StepReport,
    perception::{Extraction, Scan, extract},
};
use rand_core::SeedableRng;
use rand_pcg::Pcg64Mcg;

use crate::{
    sampled::{Laser, reading},
    walk::{Walk, around_the_hall, bad_odometry, random_walk},
};

/// Along a hall with odometry that misleads by more than the gates allow; `share` of the walls, in
/// twentieths, can be told apart.
fn along(share: u32, seed: u64) -> (Vec<Pose>, Vec<StepReport>) {
    let Walk { walls, world_from_robot: poses, .. } = random_walk(seed);
    let laser = Laser { walls: &walls, range_max: 20.0, noise: 0.003 };
    let mut rng = Pcg64Mcg::seed_from_u64(seed);
    let odometry = bad_odometry(&poses, 6.0, &mut rng);
    let mut mapper = Mapper::new(&MapperSetup::named("perceptual").unwrap(), seed);
    let look = |(&pose, &odom_from_robot): (&Pose, &Pose)| {
        let (scan, hits) = laser.scan(pose, &mut rng);
        let known = |wall: &u32| wall * 7 % 20 < share;
        let labels = hits.into_iter().map(|wall| wall.filter(known)).collect();
        mapper.observe(&reading(Scan { labels, ..scan }, odom_from_robot)).unwrap()
    };
    let reports = poses.iter().zip(&odometry).map(look).collect();
    (poses, reports)
}

#[test]
fn a_surface_carries_the_label_of_most_of_its_beams() {
    let (walls, poses) = around_the_hall();
    let laser = Laser { walls: &walls, range_max: 20.0, noise: 0.0 };
    let (scan, labels) = laser.scan(poses[0], &mut Pcg64Mcg::seed_from_u64(1));
    assert!(extract(&scan, &Extraction::default()).surfaces.iter().all(|surface| surface.label.is_none()));
    let labelled = extract(&Scan { labels, ..scan.clone() }, &Extraction::default());
    assert!(labelled.surfaces.len() >= 4);
    for surface in &labelled.surfaces {
        let wall = walls[surface.label.unwrap() as usize];
        let middle = poses[0] * surface.segment.midpoint();
        assert!(wall.distance_to(middle) < 0.01);
    }
    // Labels change nothing else.
    let plain = extract(&scan, &Extraction::default());
    assert!(
        plain
            .surfaces
            .iter()
            .zip(&labelled.surfaces)
            .all(|(a, b)| a.segment == b.segment && a.ends == b.ends)
    );
}

/// Chapter 4: with unique objects the rough movement would no longer be needed.
#[test]
fn what_can_be_told_apart_is_recognised_where_odometry_misleads() {
    let count = |share: u32| -> (usize, f64) {
        let runs = (1..=30).map(|seed| along(share, seed)).map(|(poses, reports)| {
            let lost = reports.iter().filter(|r| r.placement == Placement::Odometry).count();
            let last = reports.last().unwrap().map_from_robot;
            (lost, last.from_here(poses[0].from_here(poses[poses.len() - 1])).position.length())
        });
        runs.fold((0, 0.0), |(lost, off), run| (lost + run.0, off + run.1 / 30.0))
    };
    let [none, half, all] = [0, 10, 20].map(count);
    assert!(none.0 > 2 * half.0 && half.0 > 2 * all.0, "{none:?} {half:?} {all:?}");
    assert!(all.1 < half.1 && half.1 < none.1, "{none:?} {half:?} {all:?}");
}
