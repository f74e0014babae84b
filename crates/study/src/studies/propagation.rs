use super::{
    NO_RECOGNITION, ODOMETRY, PERCEPTUAL, TRANSFORM, consensus, courses, grid, no_recognition, odometry,
    perceptual, robots, transform,
};
use crate::{Bound, Check, Group, Outcome, Study};

/// An error that grows with no larger exponent does not propagate: a random walk of the position has
/// 0.5, an error that stays local has 0, a turn that stays for good has 1 or more.
const LOCAL: f64 = 0.5;

/// E12: errors that add up (§2.3, Fig. 2.5, 2.6 and 3.3).
pub(crate) const STUDY: Study = Study {
    name: "propagation",
    line: "E12: two laps of the loop: walls mapped twice, and how errors grow with distance",
    about: "Both robots drive the loop of 90 m twice (§2.3, Fig. 2.5, 2.6 and 3.3). In a traditional map each \
            small error of a turn stays, adds to the others, and puts the second lap beside the first. \
            Judged: how often each wall stands in the map, and the exponent with which the error of what \
            the map says of two places grows with the way between them (2 to 64 m): 0 for errors that stay \
            local, 0.5 for a random walk of the position, 1.5 for one of the heading.",
    seeds: 100,
    shown: &[
        "error_2",
        "error_4",
        "error_8",
        "error_16",
        "error_32",
        "error_64",
        "pieces",
        "length_mapped",
        "blocked_steps",
    ],
    plan: |request| {
        let courses = courses(request, "environment-b", "two-laps")?;
        let mappers = [odometry(), transform(), perceptual(), no_recognition(), consensus()];
        Ok(grid(&courses, &robots(&["good", "bad"]), &mappers))
    },
    judge,
};

fn judge(outcome: &Outcome) -> Vec<Check> {
    let mut checks = Vec::new();
    for robot in ["good", "bad"] {
        for mapper in [ODOMETRY, TRANSFORM, PERCEPTUAL, NO_RECOGNITION] {
            checks.extend(outcome.groups_of(robot, mapper).map(|group| local(&group)));
        }
    }
    checks
}

/// Whether errors stay where they are made.
pub(crate) fn local(group: &Group<'_>) -> Check {
    Check::figure(
        format!(
            "{} robot, {}: errors grow with distance to the power of at most {LOCAL}",
            group.robot(),
            group.label()
        ),
        group.exponent(),
        Bound::AtMost(LOCAL),
    )
}
