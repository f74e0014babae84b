use std::sync::Arc;

use super::{
    NO_RECOGNITION, PERCEPTUAL, consensus, courses, grid, loop_b, no_recognition, odometry, perceptual,
    relations, robots, transform, treated,
};
use crate::{Check, Condition, Log, Outcome, Request, Study, Treatment};

/// Metres or radians from one view to the next.
const STEPS: [f64; 6] = [0.2, 0.4, 0.6, 0.8, 1.0, 1.2];

/// Claim C3 as a curve: the same drives seen each so many metres.
pub(crate) const STUDY: Study = Study {
    name: "cadence",
    line: "C3: the same drives seen each 0.2 to 1.2 m: where does the literal form beat the traditional one?",
    about: "The bad robot drives the loop of 90 m; of what the laser saw on the way one scan is kept each \
            0.2, 0.4, 0.6, 0.8, 1.0 and 1.2 m (or as many radians), and each counts as the end of a step \
            for every mapper. The thesis's robot took steps of 0.4 to 1.2 m. Whether the thesis's form or \
            the traditional one has the better shape depends on that length: a curve, not a verdict. With --log and \
            --relations the same is done to a real log.",
    seeds: 100,
    shown: &[
        "views",
        "shape",
        "side_angle",
        "gap",
        "heading_gap",
        "pieces",
        "displaced",
        "fallbacks",
        "partly",
        "relations",
    ],
    plan: |request| {
        let courses = courses(request, "environment-b", "loop")?;
        let mappers = [odometry(), transform(), perceptual(), no_recognition(), consensus()];
        let bases = grid(&courses, &robots(&["bad"]), &mappers);
        let sparser = STEPS.map(|every| Treatment { odometry: 1.0, every: Some(every) });
        let drives = bases.iter().flat_map(|base| treated(base, &sparser));
        let logs = request.log.iter().flat_map(|log| of_log(log, request));
        Ok(drives.chain(logs).collect())
    },
    judge,
};

fn of_log(log: &Arc<Log>, request: &Request) -> Vec<Condition> {
    let odometry = request.noise.first().copied().unwrap_or(1.0);
    let sparser = STEPS.map(|every| Treatment { odometry, every: Some(every) });
    relations::of_log(log, &sparser)
}

fn judge(outcome: &Outcome) -> Vec<Check> {
    [PERCEPTUAL, NO_RECOGNITION]
        .iter()
        .flat_map(|mapper| loop_b::against_traditional(outcome, "bad", mapper))
        .collect()
}
