use cogmap_geometry::{DVec2, Segment};
use proptest::prelude::*;
use rand_core::SeedableRng;

use super::*;
use crate::Disc;

fn laser(params: &LaserParams, seed: u64) -> (Laser, Pcg64Mcg) {
    let mut rng = Pcg64Mcg::seed_from_u64(seed);
    (Laser::new(params, &mut rng), rng)
}

fn wall(a: [f64; 2], b: [f64; 2]) -> Segment {
    Segment::new(a.into(), b.into())
}

/// A panel 2 m ahead, before a wall 5 m ahead.
fn panel_before_a_wall() -> RayGrid {
    RayGrid::new(&[wall([2.0, -0.6], [2.0, 0.6]), wall([5.0, -9.0], [5.0, 9.0])], &[])
}

#[test]
fn a_faultless_laser_measures_the_truth() {
    let (laser, mut rng) = laser(&LaserParams::default().faultless(), 1);
    let (scan, solids) = laser.scan(&panel_before_a_wall(), Pose::IDENTITY, &mut rng);
    assert!((scan.ranges[180] - 2.0).abs() < 1e-9 && solids[180] == Some(0));
    let ahead_left = scan.point(180 + 60).unwrap();
    assert!((ahead_left.x - 5.0).abs() < 1e-9 && solids[240] == Some(1));
    assert_eq!((scan.ranges[0], solids[0]), (f64::INFINITY, None));
}

#[test]
fn a_share_of_the_solids_can_be_told_apart_and_the_ranges_stay() {
    let walls: Vec<Segment> = (0..180_i32)
        .map(|k| {
            let at = |degrees: f64| Pose::new(0.0, 0.0, degrees.to_radians()).forward() * 4.0;
            wall(at(f64::from(k - 90)).into(), at(f64::from(k - 89)).into())
        })
        .collect();
    let grid = RayGrid::new(&walls, &[]);
    let look = |identity: f64| {
        let (laser, mut rng) = laser(&LaserParams { identity, ..LaserParams::default() }, 5);
        laser.scan(&grid, Pose::IDENTITY, &mut rng)
    };
    let (plain, solids) = look(0.0);
    assert!(plain.labels.is_empty());
    let (half, _) = look(0.5);
    let known = half.labels.iter().flatten().count();
    assert!((120..240).contains(&known), "{known} of 361 beams");
    for (label, solid) in half.labels.iter().zip(&solids) {
        assert!(label.is_none() || label == solid);
    }
    let (all, _) = look(1.0);
    assert_eq!(all.labels, solids);
    assert!([&half, &all].iter().all(|scan| scan.ranges == plain.ranges));
}

#[test]
fn nothing_is_seen_beyond_the_range() {
    let far = RayGrid::new(&[wall([8.0, -1.0], [8.0, 1.0]), wall([8.3, 1.0], [8.3, 3.0])], &[]);
    let (laser, mut rng) = laser(&LaserParams::default(), 3);
    let (scan, _) = laser.scan(&far, Pose::IDENTITY, &mut rng);
    assert!(scan.range(180).is_some());
    assert!((190..240).all(|beam| scan.range(beam).is_none_or(|r| r < 8.19)));
    assert!((240..361).all(|beam| scan.range(beam).is_none()));
}

#[test]
fn the_noise_has_the_named_spread_and_a_bias_that_lasts_for_the_run() {
    let params = LaserParams { bias: 0.02, mixed_pixels: 0.0, ..LaserParams::default() };
    let (laser, mut rng) = laser(&params, 5);
    let grid = RayGrid::new(&[wall([4.0, -1.0], [4.0, 1.0])], &[]);
    let mut sample = || laser.scan(&grid, Pose::IDENTITY, &mut rng).0.ranges[180] - 4.0;
    let errors: Vec<f64> = (0..2000).map(|_| sample()).collect();
    let mean = errors.iter().sum::<f64>() / 2000.0;
    let spread = (errors.iter().map(|e| (e - mean) * (e - mean)).sum::<f64>() / 2000.0).sqrt();
    assert!((spread - 0.005).abs() < 0.0005, "{spread}");
    assert!((mean - laser.bias).abs() < 0.0005 && laser.bias.abs() > 0.001, "{mean}");
}

#[test]
fn ranges_come_in_whole_millimetres_and_the_long_mode_in_centimetres() {
    for (params, unit) in [(LaserParams::default(), 0.001), (LaserParams::lms200_long(), 0.01)] {
        let (laser, mut rng) = laser(&params, 1);
        let (scan, _) = laser.scan(&panel_before_a_wall(), Pose::IDENTITY, &mut rng);
        let seen = scan.ranges.iter().filter(|r| r.is_finite());
        assert!(seen.clone().count() > 100);
        assert!(seen.map(|r| r / unit).all(|units| (units - units.round()).abs() < 1e-6));
    }
}

#[test]
fn grazing_beams_are_lost_and_square_ones_are_not() {
    let params = LaserParams { noise: 0.0, bias: 0.0, ..LaserParams::default() };
    let (laser, mut rng) = laser(&params, 2);
    let corridor = RayGrid::new(&[wall([-1.0, 0.4], [99.0, 0.4]), wall([-1.0, -0.4], [99.0, -0.4])], &[]);
    let mut seen = [0, 0];
    for _ in 0..50 {
        let (scan, _) = laser.scan(&corridor, Pose::IDENTITY, &mut rng);
        seen[0] += (350..361).filter(|&beam| scan.range(beam).is_some()).count();
        seen[1] += (187..198).filter(|&beam| scan.range(beam).is_some()).count();
    }
    assert!(seen[0] == 550, "{seen:?}");
    assert!((400..540).contains(&seen[1]), "{seen:?}");
}

#[test]
fn a_depth_edge_gives_points_that_lie_on_nothing() {
    let (laser, mut rng) = laser(&LaserParams::default(), 4);
    let mut between = 0;
    for _ in 0..200 {
        let (scan, solids) = laser.scan(&panel_before_a_wall(), Pose::IDENTITY, &mut rng);
        for (beam, solid) in solids.iter().enumerate() {
            let Some(point) = scan.point(beam).filter(|_| solid.is_none()) else { continue };
            assert!(point.y.abs() > 0.5 && (1.9..5.1).contains(&point.x), "{point}");
            between += 1;
        }
    }
    assert!((120..280).contains(&between), "two edges, half of the time: {between}");
}

/// The points that a scan has of one solid, from the first to the last, in the world.
fn sighting(pose: Pose, grid: &RayGrid, seed: u64) -> Segment {
    let (laser, mut rng) = laser(&LaserParams::default(), seed);
    let (scan, solids) = laser.scan(grid, pose, &mut rng);
    let of_panel: Vec<DVec2> = (0..361)
        .filter(|&beam| solids[beam] == Some(0))
        .filter_map(|beam| Some((pose * scan.robot_from_laser) * scan.point(beam)?))
        .collect();
    Segment::new(*of_panel.first().unwrap(), *of_panel.last().unwrap())
}

#[test]
fn the_same_wall_seen_from_two_places_has_another_length_and_direction() {
    let grid = panel_before_a_wall();
    let near = sighting(Pose::new(0.5, 0.0, 0.0), &grid, 1);
    let far = sighting(Pose::new(-3.5, -2.5, 0.4), &grid, 1);
    assert!((near.length() - far.length()).abs() > 0.01, "{} {}", near.length(), far.length());
    assert!(near.angle_to(far) > 0.001);
    assert!(near.length() < 1.25 && far.length() > 1.0);
}

proptest! {
    #[test]
    fn a_scan_is_the_same_for_the_same_seed_and_never_leaves_its_bounds(
        x in -20.0f64..20.0, y in -20.0f64..20.0, heading in -9.0f64..9.0, seed: u64, beams in 0usize..400,
    ) {
        let disc = Disc { center: DVec2::new(x, y + 1.0), radius: 0.4 };
        let grid = RayGrid::new(&[wall([-3.0, -3.0], [30.0, 9.0])], &[disc]);
        let params = LaserParams { beams, ..LaserParams::urg() };
        let once = || {
            let (laser, mut rng) = laser(&params, seed);
            laser.scan(&grid, Pose::new(x, y, heading), &mut rng)
        };
        let (scan, solids) = once();
        prop_assert_eq!((&scan.ranges, &solids), (&once().0.ranges, &once().1));
        prop_assert_eq!((scan.ranges.len(), solids.len()), (beams, beams));
        prop_assert!(scan.ranges.iter().all(|&r| r == f64::INFINITY || (r > 0.0 && r < 4.0)));
        prop_assert!(solids.iter().flatten().all(|&solid| solid < 2));
    }
}

#[test]
fn a_scanner_of_240_degrees_sees_a_little_behind() {
    let behind = RayGrid::new(&[wall([-1.0, 0.6], [-1.0, 3.0])], &[]);
    let seen = |params: &LaserParams| {
        let (laser, mut rng) = laser(params, 1);
        let (scan, _) = laser.scan(&behind, Pose::new(0.0, 0.0, 0.0), &mut rng);
        scan.ranges.iter().filter(|r| r.is_finite()).count()
    };
    assert_eq!(seen(&LaserParams::default()), 0);
    assert!(seen(&LaserParams::urg()) > 20);
}
