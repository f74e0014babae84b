use super::{
    NO_RECOGNITION, PERCEPTUAL, consensus, courses, grid, loop_b, no_recognition, odometry, perceptual,
    robots, transform,
};
use crate::{Bound, Check, Outcome, Study};

/// E4: environment A (§3.2.3, Fig. 3.19–3.21).
pub(crate) const STUDY: Study = Study {
    name: "loop-a",
    line: "E4: 120 m through large rooms and corridors longer than the laser sees, bad robot",
    about: "The bad robot drives a loop of 120 m in 98 steps through large rooms and long corridors (§3.2.3, \
            Fig. 3.19 to 3.21). The thesis finds the layout captured well, ends that almost match, a clear \
            way, and one view in a corridor in which no common surface was found, so that odometry placed \
            it; two steps later a reference was found again. Judged: the closing gap and the heading at the \
            end, the way, and whether odometry decided only where what was in view could not: nothing, or \
            parallel walls.",
    seeds: 200,
    shown: &[
        "shape",
        "gap",
        "gap_share",
        "heading_gap",
        "pieces",
        "displaced",
        "blocked",
        "blocked_then",
        "fallbacks",
        "fallbacks_excused",
        "longest_fallback",
        "partly",
        "partly_excused",
    ],
    plan: |request| {
        let courses = courses(request, "environment-a", "loop")?;
        let mappers = [odometry(), transform(), perceptual(), no_recognition(), consensus()];
        Ok(grid(&courses, &robots(&["bad"]), &mappers))
    },
    judge,
};

fn judge(outcome: &Outcome) -> Vec<Check> {
    let mut checks = Vec::new();
    for mapper in [PERCEPTUAL, NO_RECOGNITION] {
        for group in outcome.groups_of("bad", mapper) {
            for (measure, most, what) in [
                ("gap_share", 1.0, "closing gap at most 1 % of the way"),
                ("heading_gap", 5.0, "turned by at most 5° at the end"),
            ] {
                checks.push(Check::rate(
                    format!("{mapper}: {what} in at least 90 % of runs"),
                    group.rate(|values| values.get(measure).map(|value| value <= most)),
                    Bound::AtLeast(0.9),
                ));
            }
            for name in ["fallbacks_excused", "partly_excused"] {
                let what = if name == "partly_excused" { "partly by odometry" } else { "by odometry" };
                checks.push(Check::share(
                    format!("{mapper}: at least 95 % of the views placed {what} had no other choice"),
                    group.figure_of(name),
                    Bound::AtLeast(0.95),
                ));
            }
        }
        checks.extend(loop_b::of_map(outcome, "bad", mapper));
        checks.extend(loop_b::against_traditional(outcome, "bad", mapper));
    }
    checks
}
