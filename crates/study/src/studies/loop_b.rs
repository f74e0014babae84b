use super::{
    CONSENSUS, NO_RECOGNITION, PERCEPTUAL, TRANSFORM, consensus, courses, grid, no_recognition, odometry,
    perceptual, robots, transform,
};
use crate::{Bound, Check, Group, Outcome, Study, metrics::Rate};

/// E2, E5 and E6: the loop of 90 m through environment B (§3.1.4, §3.2.3, Fig. 3.7–3.9 and 3.22–3.24).
pub(crate) const STUDY: Study = Study {
    name: "loop-b",
    line: "E2, E5, E6: the loop of 90 m, good and bad robot: traditional map, MFIS, ASRs and loop",
    about: "Both robots drive the loop of 90 m in 106 steps (§3.1.4, Fig. 3.7 to 3.9; §3.2.3, Fig. 3.22 to \
            3.24), and every mapper is fed the same readings. The thesis finds the traditional map \
            extremely skewed for the bad robot (a heading error of almost 90° at the end, a route like a \
            triangle, duplicates in the way), the MFIS of a good shape whose ends do not fully connect, \
            and a loop found by the network. What is said of a map's shape is said of the mappers that \
            recognise no place; the network is scored apart, on the one that does.",
    seeds: 1000,
    shown: &[
        "shape",
        "shape_share",
        "side_angle",
        "gap",
        "heading_gap",
        "pieces",
        "length_mapped",
        "displaced",
        "blocked",
        "blocked_then",
        "fallbacks",
        "partly",
        "asrs",
        "exits_found",
        "exits_true",
        "home_known",
        "false_closures",
    ],
    plan: |request| {
        let courses = courses(request, "environment-b", "loop")?;
        let mappers = [odometry(), transform(), perceptual(), no_recognition(), consensus()];
        Ok(grid(&courses, &robots(&["good", "bad"]), &mappers))
    },
    judge,
};

fn judge(outcome: &Outcome) -> Vec<Check> {
    let mut checks = Vec::new();
    for robot in ["good", "bad"] {
        for mapper in [PERCEPTUAL, NO_RECOGNITION] {
            checks.extend(against_traditional(outcome, robot, mapper));
        }
        checks.extend(of_map(outcome, robot, NO_RECOGNITION));
        checks.extend(of_network(outcome, robot, PERCEPTUAL));
        checks.extend(of_network(outcome, robot, CONSENSUS));
    }
    checks
}

/// Whether a mapper's shape is better than the traditional one's on the same drives.
pub(crate) fn against_traditional(outcome: &Outcome, robot: &str, mapper: &str) -> Vec<Check> {
    let pairs = outcome.groups_of(robot, mapper).zip(outcome.groups_of(robot, TRANSFORM));
    pairs.map(|(ours, traditional)| lower_shape(&ours, &traditional)).collect()
}

/// Whether the first has the better shape.
pub(crate) fn lower_shape(ours: &Group<'_>, traditional: &Group<'_>) -> Check {
    let mut lower = Rate::default();
    ours.pairs(traditional, "shape").iter().for_each(|(ours, theirs)| lower.count(ours < theirs));
    let title = ours.of().title();
    let criterion =
        format!("{title}, {}: lower shape error than {TRANSFORM} in at least 95 % of runs", ours.label());
    Check::rate(criterion, lower, Bound::AtLeast(0.95))
}

/// What a good map has: walls that stand once, where they belong, and a free way.
pub(crate) fn of_map(outcome: &Outcome, robot: &str, mapper: &str) -> Vec<Check> {
    let mut checks = Vec::new();
    for group in outcome.groups_of(robot, mapper) {
        let who = format!("{robot} robot, {mapper}");
        checks.push(Check::figure(
            format!("{who}: at most 1.3 pieces per long wall"),
            group.figure_of("pieces"),
            Bound::AtMost(1.3),
        ));
        checks.push(Check::share(
            format!("{who}: at most 1 % of the long surfaces displaced by more than 0.5 m"),
            group.figure_of("displaced"),
            Bound::AtMost(0.01),
        ));
        let free = group.rate(|values| values.get("blocked").map(|blocked| blocked == 0.0));
        checks.push(Check::rate(
            format!("{who}: nothing in the map stands in the driven way in at least 95 % of runs"),
            free,
            Bound::AtLeast(0.95),
        ));
    }
    checks
}

/// What a good network has: the exits that there are and no others, as many spaces as rooms, and the
/// loop.
pub(crate) fn of_network(outcome: &Outcome, robot: &str, mapper: &str) -> Vec<Check> {
    let mut checks = Vec::new();
    for group in outcome.groups_of(robot, mapper) {
        let who = format!("{robot} robot, {mapper}");
        for (name, what, bound) in [
            (
                "exits_found",
                "an exit is found, at most 0.5 m off, for at least 95 % of the doorways",
                Bound::AtLeast(0.95),
            ),
            ("exits_true", "at least 95 % of the exits are doorways", Bound::AtLeast(0.95)),
            (
                "asrs_fit",
                "as many spaces as rooms to a quarter, in at least 95 % of runs",
                Bound::AtLeast(0.95),
            ),
            ("home_known", "start and end share a space in at least 98 % of runs", Bound::AtLeast(0.98)),
            ("false_closures", "at most 0.5 % of new rooms are taken for old ones", Bound::AtMost(0.005)),
        ] {
            checks.push(Check::share(format!("{who}: {what}"), group.figure_of(name), bound));
        }
    }
    checks
}
