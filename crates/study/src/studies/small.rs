use super::{
    CONSENSUS, ODOMETRY, PERCEPTUAL, TRANSFORM, consensus, courses, grid, odometry, perceptual, robots,
    transform,
};
use crate::{Bound, Check, Outcome, Study, metrics::Rate};

/// E1: the small office (§3.1.4, Fig. 3.5 and 3.6).
pub(crate) const STUDY: Study = Study {
    name: "small",
    line: "E1: 6 m through a small office, good and bad robot: the traditional map is fair",
    about: "Both robots drive 6 m in 8 steps through a small office (§3.1.4, Fig. 3.5 and 3.6). The thesis \
            finds most surfaces of the traditional map fairly accurate with either robot, with a few \
            displaced duplicates for the bad one: at this scale the correction works. Judged: duplicates \
            of long walls, displacement of long surfaces, and whether the correction turns the robot \
            nearer to the truth than raw odometry does.",
    seeds: 200,
    shown: &[
        "way",
        "steps",
        "shape",
        "displacement",
        "pieces",
        "length_mapped",
        "displaced",
        "gap",
        "heading_gap",
    ],
    plan: |request| {
        let courses = courses(request, "small-office", "tour")?;
        let mappers = [odometry(), transform(), perceptual(), consensus()];
        Ok(grid(&courses, &robots(&["good", "bad"]), &mappers))
    },
    judge,
};

fn judge(outcome: &Outcome) -> Vec<Check> {
    let mut checks = Vec::new();
    for (robot, most_pieces, farthest) in [("good", 1.2, 0.03), ("bad", 1.5, 0.08)] {
        for mapper in [TRANSFORM, PERCEPTUAL, CONSENSUS] {
            for group in outcome.groups_of(robot, mapper) {
                checks.push(Check::figure(
                    format!("{robot} robot, {mapper}: at most {most_pieces} pieces per long wall"),
                    group.figure_of("pieces"),
                    Bound::AtMost(most_pieces),
                ));
                checks.push(Check::figure(
                    format!(
                        "{robot} robot, {mapper}: median displacement of long surfaces at most {farthest} m"
                    ),
                    group.figure_of("displacement"),
                    Bound::AtMost(farthest),
                ));
            }
        }
        let corrected = outcome.groups_of(robot, TRANSFORM).zip(outcome.groups_of(robot, ODOMETRY));
        for (transform, odometry) in corrected {
            let mut better = Rate::default();
            transform
                .pairs(&odometry, "heading_gap")
                .iter()
                .for_each(|(with, without)| better.count(with < without));
            checks.push(Check::rate(
                format!("{robot} robot: the corrected heading is nearer to the truth than raw odometry's in at least 90 % of runs"),
                better,
                Bound::AtLeast(0.9),
            ));
        }
    }
    checks
}
