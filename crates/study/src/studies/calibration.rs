use super::{ODOMETRY, courses, grid, odometry, robots};
use crate::{Bound, Check, Outcome, Study};

/// The calibration of the two robots (§3.1.4): raw odometry over the loop of 90 m.
pub(crate) const STUDY: Study = Study {
    name: "calibration",
    line: "the two robots: how far raw odometry is off at the end of the loop of 90 m",
    about: "Both robots drive the loop of 90 m and only their wheels are asked where they are. The thesis says of \
            its bad robot that the traditional map ends turned by almost 90° (§3.1.4). Ours are set by raw \
            odometry, so that no mapper is tuned to fail: about 90° in the median for `bad`, about 10° for \
            `good`. The parameters are frozen; this study only shows them.",
    seeds: 200,
    shown: &["way", "steps", "heading_gap", "gap", "shape"],
    plan: |request| {
        let courses = courses(request, "environment-b", "loop")?;
        Ok(grid(&courses, &robots(&["good", "bad"]), &[odometry()]))
    },
    judge: calibrated,
};

/// Whether the robots err as much as they are meant to.
pub(crate) fn calibrated(outcome: &Outcome) -> Vec<Check> {
    let mut checks = Vec::new();
    for (robot, degrees) in [("good", 10.0), ("bad", 90.0)] {
        for group in outcome.groups_of(robot, ODOMETRY) {
            let figure = group.figure_of("heading_gap");
            for (word, bound) in
                [("less", Bound::AtLeast(degrees * 0.8)), ("more", Bound::AtMost(degrees * 1.2))]
            {
                let criterion =
                    format!("{robot} robot: at the end not a fifth {word} than {degrees}° off (median)");
                checks.push(Check::figure(criterion, figure, bound));
            }
        }
    }
    checks
}
