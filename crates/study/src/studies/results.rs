use super::{loop_a, loop_b, placement, small, tour};
use crate::Study;

/// The table of the README: what each mapper is worth in the thesis's experiments.
pub(crate) const STUDY: Study = Study {
    name: "results",
    line: "the README's table: E1 to E6 and E11 in one go, as Markdown",
    about: "Runs `small`, `loop-b`, `placement`, `loop-a` and `tour` and prints one table in Markdown, with what \
            is to be said honestly of the literal form and of ours.",
    seeds: 200,
    shown: &[
        "shape",
        "gap",
        "heading_gap",
        "pieces",
        "displaced",
        "blocked",
        "exits_found",
        "exits_true",
        "home_known",
    ],
    plan: |request| {
        let mut conditions = Vec::new();
        for study in [&small::STUDY, &loop_b::STUDY, &placement::STUDY, &loop_a::STUDY, &tour::STUDY] {
            conditions.extend((study.plan)(request)?);
        }
        Ok(conditions)
    },
    judge: |_| Vec::new(),
};
