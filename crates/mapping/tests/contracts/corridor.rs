use cogmap_geometry::{DVec2, Pose, Segment, line_angle_between};
use cogmap_mapping::{
    Mapper, MapperSetup, Placement, StepReport, fallback_runs,
    perception::{Surface, View},
};
use rand_core::SeedableRng;
use rand_pcg::Pcg64Mcg;

use crate::{
    sampled::{Laser, reading},
    walk::{along, bad_odometry},
};

/// Two walls 2 m apart and far longer than the laser sees, closed 30 m ahead of the robot.
fn corridor() -> [Segment; 3] {
    let at = |x: f64, y: f64| DVec2::new(x, y);
    [
        Segment::new(at(-20.0, -1.0), at(30.0, -1.0)),
        Segment::new(at(30.0, -1.0), at(30.0, 1.0)),
        Segment::new(at(30.0, 1.0), at(-20.0, 1.0)),
    ]
}

fn map_the_corridor(seed: u64) -> (Vec<StepReport>, Vec<Pose>) {
    let walls = corridor();
    let laser = Laser { walls: &walls, range_max: 8.0, noise: 0.003 };
    let mut rng = Pcg64Mcg::seed_from_u64(seed);
    let poses = along(&[[0.0, 0.0], [28.0, 0.0]], 0.8);
    let odometry = bad_odometry(&poses, 1.0, &mut rng);
    let mut mapper = Mapper::new(&MapperSetup::named("perceptual").unwrap(), seed);
    let reports = poses.iter().zip(&odometry).map(|(&pose, &odom_from_robot)| {
        let scan = laser.scan(pose, &mut rng).0;
        mapper.observe(&reading(scan, odom_from_robot)).unwrap()
    });
    (reports.collect(), odometry)
}

/// A surface that says how far along the corridor the robot is.
fn crosses_the_corridor(view: &View) -> bool {
    let crosses = |a: &Surface, b: &Surface| {
        a.length() > 1.0
            && b.length() > 0.5
            && line_angle_between(a.segment.heading(), b.segment.heading()) > 1.0
    };
    view.surfaces.iter().any(|a| view.surfaces.iter().any(|b| crosses(a, b)))
}

#[test]
fn a_corridor_longer_than_the_range_is_mapped_by_odometry_until_something_crosses_it() {
    for seed in 0..20 {
        let (reports, odometry) = map_the_corridor(seed);
        let first_crossing = reports.iter().position(|r| crosses_the_corridor(&r.view)).unwrap();
        assert!(first_crossing > 20, "the corridor is long");
        let runs = fallback_runs(&reports);
        assert_eq!((runs.len(), runs[0].from), (1, 1), "one stretch, from the first step on: {runs:?}");
        let recovered = runs[0].recovered.unwrap();
        assert!(
            (first_crossing + 1..=first_crossing + 3).contains(&recovered),
            "{recovered} {first_crossing}"
        );
        // Until then the map is what odometry makes of it, from then on it is not.
        for (report, odom_from_robot) in reports.iter().zip(&odometry) {
            let off = report.map_from_robot.from_here(*odom_from_robot).position.length();
            let by_reference = matches!(report.placement, Placement::Reference | Placement::WeakReference);
            assert_eq!(by_reference, report.step >= recovered);
            assert!(report.step >= recovered || off < 1e-9);
        }
    }
}
