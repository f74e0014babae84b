use super::{
    CLOSEST_PAIR, NO_RECOGNITION, PERCEPTUAL, closest_pair, courses, grid, no_recognition, odometry,
    perceptual, robots, transform, whole_map,
};
use crate::{Bound, Check, Outcome, Study, metrics::ratio_estimate};

/// E3: surfaces placed in the MFIS (§3.2.3, Fig. 3.16–3.18).
pub(crate) const STUDY: Study = Study {
    name: "placement",
    line: "E3: 15 m through an office, bad robot: where surfaces are placed, and the displaced one",
    about: "The bad robot drives 15 m in 34 steps through an office (§3.2.3, Fig. 3.16 to 3.18). The thesis \
            finds a shape that is almost a perfect rectangle, few duplicates, and single surfaces put far \
            off because a bad reference was chosen; a choice by length, distance and orientation was its \
            remedy. The thesis's form stands beside its earlier rule (the closest pair) and beside a form that \
            compares a view with the whole map. Judged: duplicates per long wall and the share of displaced surfaces.",
    seeds: 200,
    shown: &[
        "shape",
        "side_angle",
        "rectangle",
        "pieces",
        "length_mapped",
        "displacement",
        "displaced_first",
        "displaced_any_first",
        "weak",
        "fallbacks",
    ],
    plan: |request| {
        let courses = courses(request, "long-office", "tour")?;
        let mappers = [odometry(), transform(), perceptual(), closest_pair(), whole_map(), no_recognition()];
        Ok(grid(&courses, &robots(&["bad"]), &mappers))
    },
    judge,
};

fn judge(outcome: &Outcome) -> Vec<Check> {
    let mut checks = Vec::new();
    let remedy = outcome.groups_of("bad", PERCEPTUAL).zip(outcome.groups_of("bad", CLOSEST_PAIR));
    for (with, without) in remedy {
        let pairs = with.pairs(&without, "displaced_any_first");
        let fewer = ratio_estimate(&pairs);
        checks.push(Check::figure(
            "choosing the reference by length, distance and orientation leaves fewer displaced surfaces than \
             choosing the closest pair (their ratio is below 1)",
            fewer,
            Bound::AtMost(1.0),
        ));
    }
    for mapper in [PERCEPTUAL, NO_RECOGNITION] {
        for group in outcome.groups_of("bad", mapper) {
            checks.push(Check::figure(
                format!("{mapper}: at most 1.3 pieces per long wall"),
                group.figure_of("pieces"),
                Bound::AtMost(1.3),
            ));
            for (name, what) in [("displaced_first", "long surfaces"), ("displaced_any_first", "surfaces")] {
                checks.push(Check::share(
                    format!("{mapper}: at most 2 % of the {what} displaced by more than 0.5 m"),
                    group.figure_of(name),
                    Bound::AtMost(0.02),
                ));
            }
        }
    }
    checks
}
