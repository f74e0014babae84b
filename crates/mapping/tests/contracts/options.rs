use cogmap_geometry::{DVec2, Pose, Segment};
use cogmap_mapping::{
    StepReport,
    memory::{
        MatchScope, Perceptual, PerceptualParams, ReferenceQuality, ReferenceRule, Update, UpdatePolicy,
    },
    perception::{End, Surface, View},
};

use crate::walk::{Walk, random_walk};

fn with_scope() -> PerceptualParams {
    PerceptualParams { scope: MatchScope::PreviousViewThenMfis, ..PerceptualParams::default() }
}

fn when_needed() -> PerceptualParams {
    let update = Update { policy: UpdatePolicy::WhenNeeded, ..Update::default() };
    PerceptualParams { update, ..PerceptualParams::default() }
}

/// Walks of which the thesis's form makes the truth of ideal views, whatever odometry says.
fn walks() -> Vec<Walk> {
    let walks: Vec<Walk> = (1..=40).map(random_walk).collect();
    let good = |walk: &Walk| farthest_off(walk, &walk.map(1.0).1) < 1e-9;
    let good: Vec<Walk> = walks.into_iter().filter(good).collect();
    assert!(good.len() > 30, "{} of 40", good.len());
    good
}

/// How far the robot ever believed to be from where it was, metres.
fn farthest_off(walk: &Walk, reports: &[StepReport]) -> f64 {
    let off = |(report, pose): (&StepReport, &Pose)| report.map_from_robot.from_here(*pose).position.length();
    reports.iter().zip(&walk.truth()).map(off).fold(0.0, f64::max)
}

fn stored(mapper: &Perceptual) -> usize {
    mapper.memory().mfis().surfaces().len()
}

#[test]
fn compared_with_the_mfis_too_a_wall_that_was_hidden_is_not_stored_again() {
    let (mut literal, mut extended) = (0, 0);
    for walk in walks() {
        literal += stored(&walk.map(1.0).0);
        let (mapper, reports) = walk.map_with(&with_scope(), 1.0);
        extended += stored(&mapper);
        assert!(farthest_off(&walk, &reports) < 1e-9);
    }
    assert!(extended < literal);
}

#[test]
fn a_view_compared_with_the_mfis_gives_every_surface_one_partner_at_most() {
    for report in walks().iter().flat_map(|walk| walk.map_with(&with_scope(), 1.0).1) {
        let mut known: Vec<_> = report.matches.iter().map(|m| m.known).collect();
        let mut seen: Vec<_> = report.matches.iter().map(|m| m.seen).collect();
        assert!(seen.is_sorted());
        known.sort_unstable();
        known.dedup();
        seen.dedup();
        assert_eq!((known.len(), seen.len()), (report.matches.len(), report.matches.len()));
    }
}

/// §2.3: between limiting points the robot knows where it is, and the map stays as it was.
#[test]
fn a_view_is_stored_only_when_too_little_of_it_is_known() {
    let (mut taken, mut needed) = (0, 0);
    for walk in walks() {
        let (every_step, all) = walk.map(1.0);
        let (mapper, reports) = walk.map_with(&when_needed(), 1.0);
        assert!(reports[0].stored && all.iter().all(|report| report.stored));
        taken += reports.len();
        needed += reports.iter().filter(|report| report.stored).count();
        assert!(stored(&mapper) < stored(&every_step));
        assert!(farthest_off(&walk, &reports) < 1e-9);
        for report in &reports {
            let length = |s: &Surface| s.segment.length();
            let all: f64 = report.view.surfaces.iter().map(length).sum();
            let known: f64 = report.matches.iter().map(|m| length(&report.view.surfaces[m.seen])).sum();
            assert_eq!(report.stored, known < 0.7 * all);
            assert!(report.stored || report.placed.is_empty());
        }
    }
    assert!(needed * 2 < taken);
}

/// §3.2.1, step 6, before and after §3.2.3's change.
#[test]
fn the_closest_pair_is_the_reference_where_quality_is_not_asked_for() {
    let wall = |a: (f64, f64), b: (f64, f64)| {
        let segment = Segment::new(DVec2::new(a.0, a.1), DVec2::new(b.0, b.1));
        let range = segment.midpoint().length();
        let (ends, beams) = ([End::True; 2], [0, 9]);
        Surface { segment, ends, beams, points: 10, residual: 0.0, range, incidence: 0.3, label: None }
    };
    let before = View { surfaces: vec![wall((2.0, -2.0), (2.0, 2.0)), wall((4.0, 2.5), (3.6, 2.5))] };
    // The long wall seems to have moved a little, the small thing has not.
    let after = View { surfaces: vec![wall((2.03, -2.0), (2.03, 2.0)), wall((4.0, 2.5), (3.6, 2.5))] };
    let chosen = |rule: ReferenceRule| {
        let reference = ReferenceQuality { rule, ..ReferenceQuality::default() };
        let mut mapper = Perceptual::new(&PerceptualParams { reference, ..PerceptualParams::default() });
        mapper.integrate(before.clone(), 0.0, Pose::IDENTITY);
        mapper.integrate(after.clone(), 1.0, Pose::IDENTITY).references[0]
    };
    assert_eq!(chosen(ReferenceRule::Quality).seen, 0);
    let closest = chosen(ReferenceRule::ClosestPair);
    assert_eq!(closest.seen, 1);
    assert!(closest.map_from_robot.position.length() < 1e-12);
}

#[test]
fn older_sessions_mean_the_thesis_s_program() {
    let params: PerceptualParams = serde_json::from_str(r#"{"matching": {"distance": 0.4}}"#).unwrap();
    let matching = cogmap_mapping::memory::Matching { distance: 0.4, ..PerceptualParams::default().matching };
    assert_eq!(params, PerceptualParams { matching, ..PerceptualParams::default() });
    assert_eq!((params.scope, params.update.policy), (MatchScope::PreviousView, UpdatePolicy::EveryStep));
    assert_eq!((params.reference.rule, params.spaces), (ReferenceRule::Quality, None));
    let form = r#"{"scope": "previous_view_then_mfis", "update": {"policy": "when_needed"}, "spaces": 3}"#;
    let params: PerceptualParams = serde_json::from_str(form).unwrap();
    assert_eq!(
        serde_json::from_str::<PerceptualParams>(&serde_json::to_string(&params).unwrap()).unwrap(),
        params
    );
}
