use super::{
    NO_RECOGNITION, PERCEPTUAL, courses, grid, no_recognition, odometry, perceptual, robots, transform,
};
use crate::{Bound, Check, Outcome, Study, measure::Measure};

/// E3: surfaces placed in the MFIS (§3.2.3, Fig. 3.16–3.18).
pub(crate) const STUDY: Study = Study {
    name: "placement",
    line: "E3: 15 m through an office, bad robot: where surfaces are placed, and the displaced one",
    about: "The bad robot drives 15 m in 34 steps through an office (§3.2.3, Fig. 3.16 to 3.18). The thesis \
            finds a shape that is almost a perfect rectangle, few duplicates, and single surfaces put far \
            off because a bad reference was chosen; a choice by length, distance and orientation was its \
            remedy. Judged: duplicates per long wall and the share of displaced surfaces.",
    seeds: 200,
    level: None,
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
        let mappers = [odometry(), transform(), perceptual(), no_recognition()];
        Ok(grid(&courses, &robots(&["bad"]), &mappers))
    },
    judge,
};

fn judge(outcome: &Outcome) -> Vec<Check> {
    let mut checks = Vec::new();
    for mapper in [PERCEPTUAL, NO_RECOGNITION] {
        for group in outcome.groups_of("bad", mapper) {
            let figure = |name| Measure::named(name).and_then(|measure| group.figure(measure));
            checks.push(Check::figure(
                format!("{mapper}: at most 1.3 pieces per long wall"),
                figure("pieces"),
                Bound::AtMost(1.3),
            ));
            for (name, what) in [("displaced_first", "long surfaces"), ("displaced_any_first", "surfaces")] {
                checks.push(Check::share(
                    format!("{mapper}: at most 2 % of the {what} displaced by more than 0.5 m"),
                    figure(name),
                    Bound::AtMost(0.02),
                ));
            }
        }
    }
    checks
}
