use super::{
    NO_RECOGNITION, PERCEPTUAL, TRANSFORM, consensus, courses, grid, levels, no_recognition, odometry,
    perceptual, robots, transform,
};
use crate::{Bound, Check, Outcome, Study, condition::Treatment, metrics::Rate};

/// How many times the bad robot's error.
const FACTORS: [f64; 4] = [1.0, 3.0, 6.0, 10.0];

/// Claims C1 and C2: the same drives with ever worse odometry.
pub(crate) const STUDY: Study = Study {
    name: "odometry-independence",
    line: "C1, C2: the same drives with 1, 3, 6 and 10 times the bad robot's odometry errors",
    about: "The bad robot drives the loop of 90 m; then the error of each measured movement is made 3, 6 and \
            10 times what it was, while what truly happened and what the laser saw stay the same. A map \
            into which movement measurements do not enter (§2.3) stays the same as well.",
    seeds: 200,
    level: Some("times the bad robot's odometry errors"),
    shown: &["shape", "side_angle", "gap", "heading_gap", "pieces", "displaced", "fallbacks", "partly"],
    plan: |request| {
        let courses = courses(request, "environment-b", "loop")?;
        let mappers = [odometry(), transform(), perceptual(), no_recognition(), consensus()];
        let bases = grid(&courses, &robots(&["bad"]), &mappers);
        let worse = |factor| Treatment { odometry: factor, every: None };
        Ok(bases.iter().flat_map(|base| levels(base, &FACTORS, worse)).collect())
    },
    judge,
};

fn judge(outcome: &Outcome) -> Vec<Check> {
    let mut checks = Vec::new();
    for mapper in [TRANSFORM, PERCEPTUAL, NO_RECOGNITION] {
        let groups: Vec<_> = outcome.groups_of("bad", mapper).collect();
        for of_course in groups.chunks(FACTORS.len()) {
            let [first, .., last] = of_course else { continue };
            let mut steady = Rate::default();
            // A tenth of the true scale of things, 5 cm, is no difference.
            let same = |(mild, hard): &(f64, f64)| *hard <= 1.5 * mild + 0.05;
            first.pairs(last, "shape").iter().for_each(|pair| steady.count(same(pair)));
            checks.push(Check::rate(
                format!(
                    "{mapper}: with ten times the error the shape error grows by no more than half \
                     (and 5 cm) in at least 95 % of runs"
                ),
                steady,
                Bound::AtLeast(0.95),
            ));
        }
    }
    checks
}
