use cogmap_geometry::{DVec2, Pose, Segment, normalize_angle, trig};
use cogmap_mapping::{
    Placement, StepReport,
    memory::{Perceptual, PerceptualParams, StoredSurface},
    perception::{End, Surface, View},
};
use proptest::prelude::*;
use rand_core::SeedableRng;
use rand_pcg::Pcg64Mcg;

use crate::{ideal, sampled, walk::any_walk};

fn same_matches(a: &[StepReport], b: &[StepReport]) -> bool {
    let pairs =
        |report: &StepReport| -> Vec<_> { report.matches.iter().map(|m| (m.seen, m.known)).collect() };
    a.iter().zip(b).all(|(a, b)| pairs(a) == pairs(b))
}

proptest! {
    #![proptest_config(ProptestConfig { max_global_rejects: 64, ..ProptestConfig::default() })]

    #[test]
    fn two_odometry_streams_with_the_same_matches_give_a_bit_identical_map(walk in any_walk()) {
        let (first, first_reports) = walk.map(0.5);
        let (second, second_reports) = walk.map(-1.0);
        prop_assume!(same_matches(&first_reports, &second_reports));
        let used_odometry = |r: &StepReport| r.placement == Placement::Odometry;
        prop_assert!(!first_reports.iter().any(used_odometry));
        prop_assert_eq!(bits(&first), bits(&second));
    }

    #[test]
    fn odometry_errors_inside_the_gates_leave_the_map_as_perfect_odometry_makes_it(walk in any_walk()) {
        let (perfect, perfect_reports) = walk.map(0.0);
        let (noisy, noisy_reports) = walk.map(1.0);
        prop_assume!(same_matches(&perfect_reports, &noisy_reports));
        for (a, b) in perfect.memory().mfis().surfaces().iter().zip(noisy.memory().mfis().surfaces()) {
            prop_assert!(a.segment.a.distance(b.segment.a) < 1e-9);
            prop_assert!(a.segment.b.distance(b.segment.b) < 1e-9);
        }
        prop_assert_eq!(perfect.memory().mfis().surfaces().len(), noisy.memory().mfis().surfaces().len());
    }

    #[test]
    fn ideal_views_give_the_truth_whatever_odometry_says(walk in any_walk()) {
        let (mapper, reports) = walk.map(1.0);
        prop_assume!(same_matches(&reports, &walk.map(0.0).1));
        prop_assert!(reports.iter().skip(1).all(|r| r.placement == Placement::Reference));
        for stored in mapper.memory().mfis().surfaces() {
            let off = walk.distance_from_truth(stored);
            prop_assert!(off < 1e-9, "surface {:?} is {} m off", stored.id, off);
        }
        for (report, truth) in reports.iter().zip(&walk.world_from_robot) {
            let off = (walk.world_from_robot[0] * report.map_from_robot).from_here(*truth);
            prop_assert!(off.position.length() < 1e-9 && normalize_angle(off.heading).abs() < 1e-9);
        }
    }

    #[test]
    fn a_stored_surface_never_moves(walk in any_walk()) {
        let mut mapper = Perceptual::new(&PerceptualParams::default());
        let mut before: Vec<StoredSurface> = Vec::new();
        for &world_from_robot in &walk.world_from_robot {
            mapper.integrate(ideal::view(&walk.walls, world_from_robot), 0.0, world_from_robot);
            let stored = mapper.memory().mfis().surfaces();
            prop_assert_eq!(&stored[..before.len()], before.as_slice());
            before = stored.to_vec();
        }
    }

    #[test]
    fn every_surface_has_at_most_one_partner(walk in any_walk()) {
        for report in walk.map(1.0).1 {
            let mut seen: Vec<_> = report.matches.iter().map(|m| m.seen).collect();
            let mut previous: Vec<_> = report.matches.iter().map(|m| m.previous).collect();
            seen.sort_unstable();
            previous.sort_unstable();
            prop_assert!(seen.windows(2).all(|pair| pair[0] < pair[1]));
            prop_assert!(previous.windows(2).all(|pair| pair[0] < pair[1]));
        }
    }

    #[test]
    fn the_whole_first_view_is_in_the_map(walk in any_walk()) {
        let (mapper, reports) = walk.map(0.0);
        let first = &reports[0];
        prop_assert_eq!(first.placed.len(), first.view.surfaces.len());
        for (stored, seen) in mapper.memory().mfis().surfaces().iter().zip(&first.view.surfaces) {
            prop_assert_eq!(stored.segment, seen.segment);
        }
    }
}

/// Every coordinate of the map, bit by bit.
fn bits(mapper: &Perceptual) -> Vec<[u64; 4]> {
    let of = |s: &StoredSurface| {
        let Segment { a, b } = s.segment;
        [a.x, a.y, b.x, b.y].map(f64::to_bits)
    };
    mapper.memory().mfis().surfaces().iter().map(of).collect()
}

/// Every sighting of the wall is turned a little otherwise; what is placed by it is off by what this
/// sighting and the first one are off, in the fiftieth view as in the second.
#[test]
fn tracking_one_wall_for_fifty_steps_adds_no_drift_to_what_is_new() {
    let mut rng = Pcg64Mcg::seed_from_u64(1);
    let mut mapper = Perceptual::new(&PerceptualParams::default());
    let mut first_noise = 0.0;
    for step in 0..=50_u32 {
        let noise = 0.01 * sampled::gaussian(&mut rng);
        let wall = true_surface(DVec2::new(3.0, -1.5), trig::FRAC_PI_2 + noise, 3.0);
        // Never twice in one place, so that it is new each time.
        let new = true_surface(DVec2::new(-2.0, 2.0 + 1.3 * f64::from(step % 5)), 1.0, 0.4);
        let report = mapper.integrate(View { surfaces: vec![wall, new] }, 0.0, Pose::IDENTITY);
        if step == 0 {
            first_noise = noise;
            continue;
        }
        assert_eq!((report.matches.len(), report.placed.len()), (1, 1), "step {step}");
        let stored = &mapper.memory().mfis().surfaces()[report.placed[0].0 as usize];
        let drift = normalize_angle(stored.segment.heading() - 1.0);
        assert!((drift - (first_noise - noise)).abs() < 1e-9, "step {step}: {drift}");
    }
}

fn true_surface(from: DVec2, heading: f64, length: f64) -> Surface {
    let segment = Segment::new(from, from + Pose::new(0.0, 0.0, heading).forward() * length);
    let (ends, beams, range) = ([End::True; 2], [0, 9], segment.midpoint().length());
    Surface { segment, ends, beams, points: 10, residual: 0.0, range, incidence: 0.3, label: None }
}
