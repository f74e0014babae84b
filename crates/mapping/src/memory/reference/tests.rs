use super::*;
use crate::{
    Placement,
    memory::{PairError, Perceptual, PerceptualParams},
    perception::View,
};

fn wall(a: (f64, f64), b: (f64, f64), ends: [End; 2]) -> Surface {
    let segment = Segment::new(DVec2::new(a.0, a.1), DVec2::new(b.0, b.1));
    let range = segment.midpoint().length();
    Surface { segment, ends, beams: [0, 9], points: 10, residual: 0.0, range, incidence: 0.3, label: None }
}

/// What a robot finds that has stored `before` and now sees `after`, all recognised in this order.
fn ranked(before: &[Surface], after: &[Surface]) -> Vec<Reference> {
    let mut mapper = Perceptual::new(&PerceptualParams::default());
    mapper.integrate(View { surfaces: before.to_vec() }, 0.0, Pose::IDENTITY);
    let fit = PairError { d1: 0.0, d2: 0.0, phi: 0.0, error: 0.0 };
    let matches: Vec<Match> = (0..after.len())
        .map(|seen| Match {
            seen,
            previous: Some(seen),
            known: mapper.memory().mfis().surfaces()[seen].id,
            fit,
        })
        .collect();
    rank_references(after, &matches, mapper.memory().mfis(), &ReferenceQuality::default())
}

#[test]
fn a_long_near_wall_is_a_better_reference_than_a_short_far_one() {
    let view = [
        wall((6.0, 3.0), (6.0, 3.5), [End::True; 2]),
        wall((2.0, -1.5), (2.0, 1.5), [End::True; 2]),
        wall((3.0, 2.0), (2.4, 2.4), [End::True; 2]),
    ];
    let references = ranked(&view, &view);
    assert_eq!(references.len(), 3);
    assert_eq!(references[0].seen, 1);
    assert!(references[0].map_from_robot.position.length() < 1e-12);
}

/// Fig. 3.17 and 3.18: one sighting of the reference is turned by a few degrees, so the error does
/// not cancel, and what is placed by it lands about distance × angle off.
#[test]
fn a_bad_reference_displaces_by_distance_times_angle() {
    let angle = 3.0_f64.to_radians();
    let stored = wall((2.0, -0.5), (2.0, 0.5), [End::True; 2]);
    let turned = Surface {
        segment: Segment::new(
            stored.segment.a,
            stored.segment.a + DVec2::new(-trig::sin(angle), trig::cos(angle)),
        ),
        ..stored.clone()
    };
    let by = ranked(&[stored], &[turned])[0];
    for far in [2.0, 4.0, 8.0] {
        let at = DVec2::new(2.0, -0.5) + DVec2::new(0.0, far);
        let displaced = (by.map_from_robot * at).distance(at);
        assert!((displaced / (far * angle) - 1.0).abs() < 0.02, "{displaced} m at {far} m");
    }
}

#[test]
fn a_wall_without_a_true_end_is_fixed_by_one_that_crosses_it() {
    let hidden = [End::Occlusion; 2];
    let before = [wall((3.0, -1.0), (3.0, 1.0), hidden), wall((1.0, 2.0), (-1.0, 2.0), hidden)];
    // The same two walls, other parts of them, after a move of (0.5, 0.25).
    let after = [wall((2.5, -0.4), (2.5, 0.5), hidden), wall((0.9, 1.75), (-0.2, 1.75), hidden)];
    let references = ranked(&before, &after);
    assert!(matches!(references[0].along, Along::Crossing(_)));
    assert!(references[0].map_from_robot.position.distance(DVec2::new(0.5, 0.25)) < 1e-12);
}

/// §3.2.3: two walls that run beyond the sensor's limits cannot say how far along them the robot is.
#[test]
fn a_corridor_offers_no_reference_and_odometry_places_that_view_alone() {
    let limit = [End::RangeLimit; 2];
    let corridor = |shift: f64| View {
        surfaces: vec![
            wall((0.0, -1.0), (7.0 + shift, -1.0), limit),
            wall((7.0 + shift, 1.0), (0.0, 1.0), limit),
        ],
    };
    let mut mapper = Perceptual::new(&PerceptualParams::default());
    mapper.integrate(corridor(0.0), 0.0, Pose::IDENTITY);
    let report = mapper.integrate(corridor(0.1), 1.0, Pose::new(1.0, 0.0, 0.02));
    assert_eq!(report.matches.len(), 2);
    assert_eq!(report.placement, Placement::Odometry);
    assert_eq!(report.map_from_robot, Pose::new(1.0, 0.0, 0.02));
}

/// A wall tracked over many views keeps its first stored place and direction.
#[test]
fn tracking_a_wall_for_fifty_steps_does_not_drift() {
    let mut mapper = Perceptual::new(&PerceptualParams::default());
    for step in 0..=50_i32 {
        let robot = Pose::new(0.05 * f64::from(step), 0.0, 0.0);
        let world =
            [wall((5.0, -1.5), (5.0, 1.5), [End::True; 2]), wall((5.0, 2.0), (3.5, 2.6), [End::True; 2])];
        let surfaces = world.iter().map(|surface| surface.seen_from(robot.inverse())).collect();
        let report = mapper.integrate(View { surfaces }, 0.0, robot);
        assert!(report.map_from_robot.from_here(robot).position.length() < 1e-12);
        assert!(report.map_from_robot.heading.abs() < 1e-12);
    }
    assert_eq!(mapper.memory().mfis().surfaces().len(), 2);
}

#[test]
fn a_pair_that_puts_the_robot_elsewhere_is_set_aside() {
    let before = [
        wall((3.0, -1.0), (3.0, 1.0), [End::True; 2]),
        wall((1.0, 2.0), (-1.0, 2.0), [End::True; 2]),
        wall((-1.0, -2.0), (1.0, -2.0), [End::True; 2]),
        wall((4.0, 2.0), (3.0, 3.0), [End::True; 2]),
    ];
    let mut after = before.clone();
    after[3].segment = Segment::new(DVec2::new(4.3, 2.3), DVec2::new(3.3, 3.3));
    let references = ranked(&before, &after);
    assert_eq!(references.len(), 3);
    assert!(references.iter().all(|reference| reference.seen != 3));
}
