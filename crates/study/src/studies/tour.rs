use super::{CONSENSUS, PERCEPTUAL, consensus, courses, grid, no_recognition, perceptual, robots};
use crate::{Bound, Check, Outcome, Study};

/// The nodes of the network after the tour of twelve spaces whose last is part of the first.
const NODES: f64 = 11.0;

/// E11: the tour of twelve spaces (§2.3, Fig. 2.7 and 2.8).
pub(crate) const STUDY: Study = Study {
    name: "tour",
    line: "E11: twelve local spaces, the last of which is part of the first: eleven nodes",
    about: "Both robots drive the theory's example (§2.3, Fig. 2.7 and 2.8): a tour of twelve local spaces, the \
            last of which is part of the first. Judged: exits against the doorways that were crossed, the \
            number of spaces, and whether the network ends with eleven nodes, its loop closed.",
    seeds: 1000,
    shown: &[
        "asrs",
        "rooms",
        "network_edits",
        "exits_found",
        "exits_true",
        "exit_error",
        "home_known",
        "revisits_known",
        "false_closures",
        "purity",
        "room_f1",
    ],
    plan: |request| {
        let courses = courses(request, "tour", "tour")?;
        let mappers = [perceptual(), no_recognition(), consensus()];
        Ok(grid(&courses, &robots(&["good", "bad"]), &mappers))
    },
    judge,
};

fn judge(outcome: &Outcome) -> Vec<Check> {
    let mut checks = Vec::new();
    for robot in ["good", "bad"] {
        for mapper in [PERCEPTUAL, CONSENSUS] {
            for group in outcome.groups_of(robot, mapper) {
                let eleven = group.rate(|values| values.get("asrs").map(|asrs| (asrs - NODES).abs() < 0.5));
                checks.push(Check::rate(
                    format!(
                        "{robot} robot, {mapper}: the network ends with eleven nodes in at least 95 % of runs"
                    ),
                    eleven,
                    Bound::AtLeast(0.95),
                ));
            }
            checks.extend(super::loop_b::of_network(outcome, robot, mapper));
        }
    }
    checks
}
