use super::{
    NO_RECOGNITION, PERCEPTUAL, TRANSFORM, consensus, courses, grid, no_recognition, odometry, perceptual,
    robots, transform, treated,
};
use crate::{Bound, Check, Group, Outcome, Study, Treatment, metrics::Rate};

/// How many times the bad robot's error.
const FACTORS: [f64; 4] = [1.0, 3.0, 6.0, 10.0];

/// A shape error that becomes no more than so many times as large, and so many metres, has not grown.
const GROWTH: (f64, f64) = (1.5, 0.05);

/// Claims C1 and C2: the same drives with ever worse odometry.
pub(crate) const STUDY: Study = Study {
    name: "odometry-independence",
    line: "C1, C2: the same drives with 1, 3, 6 and 10 times the bad robot's odometry errors",
    about: "The bad robot drives the loop of 90 m; then the error of each measured movement is made 3, 6 and \
            10 times what it was, while what truly happened and what the laser saw stay the same. A map \
            into which movement measurements do not enter (§2.3) stays the same as well.",
    seeds: 200,
    shown: &["shape", "side_angle", "gap", "heading_gap", "pieces", "displaced", "fallbacks", "partly"],
    plan: |request| {
        let courses = courses(request, "environment-b", "loop")?;
        let mappers = [odometry(), transform(), perceptual(), no_recognition(), consensus()];
        let bases = grid(&courses, &robots(&["bad"]), &mappers);
        let worse = FACTORS.map(|odometry| Treatment { odometry, every: None });
        Ok(bases.iter().flat_map(|base| treated(base, &worse)).collect())
    },
    judge,
};

fn judge(outcome: &Outcome) -> Vec<Check> {
    let mut checks = Vec::new();
    for mapper in [TRANSFORM, PERCEPTUAL, NO_RECOGNITION] {
        let groups: Vec<Group<'_>> = outcome.groups_of("bad", mapper).collect();
        for of_course in groups.chunks(FACTORS.len()) {
            if let [mild, .., hard] = of_course {
                checks.push(steady(mild, hard));
            }
        }
    }
    checks
}

/// Whether a map stays as good when odometry becomes ten times worse.
pub(crate) fn steady(mild: &Group<'_>, hard: &Group<'_>) -> Check {
    let mut steady = Rate::default();
    let grows_little = |(mild, hard): &(f64, f64)| *hard <= GROWTH.0 * mild + GROWTH.1;
    mild.pairs(hard, "shape").iter().for_each(|pair| steady.count(grows_little(pair)));
    let criterion = format!(
        "{} robot, {}: with ten times the odometry errors the shape error grows by at most half (and 5 cm) in at \
         least 95 % of runs",
        mild.robot(),
        mild.label()
    );
    Check::rate(criterion, steady, Bound::AtLeast(0.95))
}
