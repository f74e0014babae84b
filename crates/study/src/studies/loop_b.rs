use super::{
    CONSENSUS, NO_RECOGNITION, ODOMETRY, PERCEPTUAL, TRANSFORM, consensus, courses, grid, no_recognition,
    odometry, perceptual, robots, transform,
};
use crate::{Bound, Check, Outcome, Study, measure::Measure, metrics::Rate};

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
    seeds: 200,
    level: None,
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
        "fallbacks",
        "partly",
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
    for (robot, degrees) in [("good", 10.0), ("bad", 90.0)] {
        for group in outcome.groups_of(robot, ODOMETRY) {
            let figure = Measure::named("heading_gap").and_then(|measure| group.figure(measure));
            for bound in [Bound::AtLeast(degrees * 0.8), Bound::AtMost(degrees * 1.2)] {
                let criterion = format!(
                    "{robot} robot: raw odometry ends turned by about {degrees}° (±20 %) in the median"
                );
                checks.push(Check::figure(criterion, figure, bound));
            }
        }
        for mapper in [PERCEPTUAL, NO_RECOGNITION] {
            checks.extend(against_traditional(outcome, robot, mapper));
        }
        checks.extend(of_map(outcome, robot, NO_RECOGNITION));
        for group in outcome.groups_of(robot, CONSENSUS) {
            let closed = group.rate(|values| values.get("loop_closed").map(|closed| closed > 0.0));
            let criterion =
                format!("{robot} robot, {CONSENSUS}: the network closes the loop in at least 98 % of runs");
            checks.push(Check::rate(criterion, closed, Bound::AtLeast(0.98)));
        }
    }
    checks
}

/// Whether a mapper's shape is better than the traditional one's on the same drives.
pub(crate) fn against_traditional(outcome: &Outcome, robot: &str, mapper: &str) -> Vec<Check> {
    let pairs = outcome.groups_of(robot, mapper).zip(outcome.groups_of(robot, TRANSFORM));
    let check = |(ours, traditional): (crate::Group<'_>, crate::Group<'_>)| {
        let mut lower = Rate::default();
        ours.pairs(&traditional, "shape").iter().for_each(|(ours, theirs)| lower.count(ours < theirs));
        Check::rate(
            format!("{robot} robot, {mapper}: lower shape error than {TRANSFORM} in at least 95 % of runs"),
            lower,
            Bound::AtLeast(0.95),
        )
    };
    pairs.map(check).collect()
}

/// What a good map has: walls that stand once, where they belong, and a free way.
pub(crate) fn of_map(outcome: &Outcome, robot: &str, mapper: &str) -> Vec<Check> {
    let mut checks = Vec::new();
    for group in outcome.groups_of(robot, mapper) {
        let figure = |name| Measure::named(name).and_then(|measure| group.figure(measure));
        let who = format!("{robot} robot, {mapper}");
        checks.push(Check::figure(
            format!("{who}: at most 1.3 pieces per long wall"),
            figure("pieces"),
            Bound::AtMost(1.3),
        ));
        checks.push(Check::share(
            format!("{who}: at most 1 % of the long surfaces displaced by more than 0.5 m"),
            figure("displaced"),
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
