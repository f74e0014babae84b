use cogmap_simulation::Robot;

use super::{
    NO_RECOGNITION, PERCEPTUAL, TRANSFORM, closest_pair, courses, grid, no_recognition, perceptual, robots,
    transform, whole_map,
};
use crate::{Bound, Check, Group, Outcome, Study, metrics::paired};

/// Shares of the things in the world that can be told apart by sight.
const SHARES: [f64; 5] = [0.0, 0.25, 0.5, 0.75, 1.0];

/// Claim C8: what recognising by sight would bring (chapter 4).
pub(crate) const STUDY: Study = Study {
    name: "identity",
    line: "C8: a share of the surfaces, 0 to 100 %, can be told apart by sight",
    about: "The robot gets a sense that the thesis's lacks and its last chapter wishes for: of the things in \
            the world 0, 25, 50, 75 or 100 % can be told apart by sight, drawn anew with each seed. The loop of \
            90 m is driven as in `loop-b`; the robots' names say the share. If mapping problems come from \
            recognition (claim C8), they go as the share rises; what remains comes from placement.",
    seeds: 100,
    shown: &["shape", "side_angle", "gap", "pieces", "displaced", "displaced_any", "weak", "fallbacks"],
    plan: |request| {
        let courses = courses(request, "environment-b", "loop")?;
        let mappers = [transform(), perceptual(), closest_pair(), whole_map(), no_recognition()];
        Ok(grid(&courses, &seeing(&robots(&["bad"]), &SHARES), &mappers))
    },
    judge: |outcome| {
        let of = |mapper: &&str| all_by_sight(&outcome.groups_of("bad", mapper).collect::<Vec<_>>(), outcome);
        [TRANSFORM, PERCEPTUAL, NO_RECOGNITION].iter().flat_map(of).collect()
    },
};

/// Each robot with each share of labelled things; without any it keeps its name.
pub(crate) fn seeing(robots: &[Robot], shares: &[f64]) -> Vec<Robot> {
    let seeing = |robot: &Robot, share: f64| {
        let mut robot = robot.clone();
        robot.laser.identity = share;
        if share > 0.0 {
            robot.name = with_sight(&robot.name, share);
        }
        robot
    };
    robots.iter().flat_map(|robot| shares.iter().map(move |&share| seeing(robot, share))).collect()
}

/// What a robot is called that can tell such a share of things apart.
fn with_sight(robot: &str, share: f64) -> String {
    format!("{robot}, {:.0} % by sight", share * 100.0)
}

/// Whether hardly anything of the shape error remains when everything can be told apart.
pub(crate) fn all_by_sight(blind: &[Group<'_>], outcome: &Outcome) -> Vec<Check> {
    let check = |blind: &Group<'_>| {
        let sighted = with_sight(blind.robot(), 1.0);
        let sighted = outcome
            .groups_of(&sighted, blind.label())
            .find(|group| group.of().place() == blind.of().place())?;
        // The second value over the first: what remains.
        let remains = paired(&blind.pairs(&sighted, "shape")).and_then(|paired| paired.ratio);
        let who = format!("{} robot, {}", blind.robot(), blind.label());
        let criterion =
            format!("{who}: told apart by sight, at most 10 % of the shape error remains (median)");
        Some(Check::share(criterion, remains, Bound::AtMost(0.1)))
    };
    blind.iter().filter_map(check).collect()
}
