use cogmap_geometry::{DVec2, Pose, Segment, line_angle_between, trig};
use cogmap_mapping::{
    Mapper, MapperSetup,
    memory::{MatchScope, Perceptual, PerceptualParams},
    perception::{End, Extraction, Surface, View, extract},
};
use rand_core::SeedableRng;
use rand_pcg::Pcg64Mcg;

use crate::{
    sampled::{Laser, reading},
    walk::{around_the_hall, bad_odometry},
};

fn wall(a: (f64, f64), b: (f64, f64)) -> Surface {
    let segment = Segment::new(DVec2::new(a.0, a.1), DVec2::new(b.0, b.1));
    let (ends, beams, range) = ([End::True; 2], [0, 9], segment.midpoint().length());
    Surface { segment, ends, beams, points: 10, residual: 0.0, range, incidence: 0.3, label: None }
}

/// Turned about its first end, as another sighting of the same object may be (Fig. 3.17).
fn turned(surface: &Surface, angle: f64) -> Surface {
    let Segment { a, b } = surface.segment;
    Surface { segment: Segment::new(a, a + Pose::new(0.0, 0.0, angle).rotate(b - a)), ..surface.clone() }
}

fn maps(views: &[&[Surface]], params: &PerceptualParams) -> Perceptual {
    let mut mapper = Perceptual::new(params);
    for surfaces in views {
        mapper.integrate(View { surfaces: surfaces.to_vec() }, 0.0, Pose::IDENTITY);
    }
    mapper
}

/// Fig. 3.17 and 3.18: the good reference is missed, a bad one takes its place, and what is new lands
/// distance times angle off. With the good reference seen it lands where it is.
#[test]
fn a_missed_match_and_a_bad_reference_displace_a_surface() {
    let (long, small, far) =
        (wall((2.0, -2.0), (2.0, 2.0)), wall((1.5, 2.4), (1.1, 2.6)), wall((7.0, -2.0), (7.0, 2.0)));
    let small_again = turned(&small, 4.0_f64.to_radians());
    let displaced = |second: &[Surface]| {
        let mapper = maps(&[&[long.clone(), small.clone()], second], &PerceptualParams::default());
        mapper.memory().mfis().surfaces()[2].segment.midpoint().distance(far.segment.midpoint())
    };
    let expected = 4.0_f64.to_radians() * far.segment.midpoint().distance(small.segment.a);
    assert!((displaced(&[small_again.clone(), far.clone()]) / expected - 1.0).abs() < 0.02);
    assert!(displaced(&[long.clone(), small_again, far.clone()]) < 1e-12);
}

/// Fig. 3.18: a reference that ends too early, in a place that it takes for its true end, shifts what is
/// placed by it by what is missing.
#[test]
fn a_shortened_reference_displaces_by_what_it_lacks() {
    let (whole, far) = (wall((2.0, -0.5), (2.0, 0.5)), wall((6.0, 2.0), (4.0, 3.0)));
    let short = wall((2.0, -0.4), (2.0, 0.4));
    let mapper = maps(&[&[whole], &[short, far.clone()]], &PerceptualParams::default());
    let stored = mapper.memory().mfis().surfaces()[1].segment;
    assert!((stored.a.distance(far.segment.a) - 0.1).abs() < 1e-12);
    assert!((stored.b.distance(far.segment.b) - 0.1).abs() < 1e-12);
}

#[test]
fn a_wall_missed_in_one_view_is_stored_twice_unless_the_mfis_is_asked() {
    let (first, second) = (wall((2.0, -2.0), (2.0, 2.0)), wall((1.0, 3.0), (-1.0, 3.0)));
    let both = [first.clone(), second];
    let views: [&[Surface]; 3] = [&both, &[first], &both];
    let stored = |scope| {
        let params = PerceptualParams { scope, ..PerceptualParams::default() };
        maps(&views, &params).memory().mfis().surfaces().len()
    };
    assert_eq!(stored(MatchScope::PreviousView), 3);
    assert_eq!(stored(MatchScope::PreviousViewThenMfis), 2);
}

/// A round leg of 0.2 m, from all sides.
#[test]
fn a_small_object_turns_with_the_viewpoint() {
    let corner = |k: i32| Pose::new(0.0, 0.0, trig::TAU * f64::from(k) / 24.0).forward() * 0.1;
    let leg: Vec<Segment> = (0..24).map(|k| Segment::new(corner(k), corner(k + 1))).collect();
    let laser = Laser { walls: &leg, range_max: 8.0, noise: 0.002 };
    let mut rng = Pcg64Mcg::seed_from_u64(1);
    let mut headings = Vec::new();
    for side in 0..12 {
        let around = Pose::new(0.0, 0.0, f64::from(side) * trig::TAU / 12.0);
        let world_from_robot = around * Pose::new(-1.2, 0.0, 0.0);
        let view = extract(&laser.scan(world_from_robot, &mut rng).0, &Extraction::default());
        assert!(view.surfaces.iter().all(|surface| surface.length() < 0.3));
        headings.extend(view.surfaces.iter().map(|surface| (world_from_robot * surface.segment).heading()));
    }
    assert!(headings.len() >= 6, "the leg is seen: {headings:?}");
    let most = headings.iter().map(|&h| line_angle_between(h, headings[0])).fold(0.0, f64::max);
    assert!(most > 1.0, "it lies in every direction: {headings:?}");
}

/// §2.3 and §3.2.3: the errors of single surfaces remain, and nothing is corrected when the robot is back.
#[test]
fn the_ends_of_a_loop_do_not_meet_and_the_map_stays() {
    let (walls, poses) = around_the_hall();
    let laser = Laser { walls: &walls, range_max: 8.0, noise: 0.005 };
    let gap = |seed: u64| {
        let mut rng = Pcg64Mcg::seed_from_u64(seed);
        let odometry = bad_odometry(&poses, 1.0, &mut rng);
        let mut mapper = Mapper::new(&MapperSetup::named("perceptual").unwrap(), seed);
        let mut before = Vec::new();
        for (&pose, &odom_from_robot) in poses.iter().zip(&odometry) {
            mapper.observe(&reading(laser.scan(pose, &mut rng).0, odom_from_robot)).unwrap();
            let stored = mapper.mfis().surfaces();
            assert_eq!(&stored[..before.len()], before.as_slice());
            before = stored.to_vec();
        }
        let last = mapper.path()[mapper.path().len() - 1].frame_from_robot;
        last.from_here(poses[0].from_here(poses[poses.len() - 1])).position.length()
    };
    let gaps: Vec<f64> = (1..=12).map(gap).collect();
    assert!(gaps.iter().all(|&gap| gap > 0.0) && gaps.iter().sum::<f64>() > 12.0 * 0.05, "{gaps:?}");
}
