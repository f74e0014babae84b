use std::sync::Arc;

use super::{CONSENSUS, consensus, no_recognition, odometry, perceptual, transform};
use crate::{Bound, Check, Condition, Ground, Log, Outcome, Study, Treatment};

/// Factors of the noise that is added to the log's odometry.
const NOISE: [f64; 2] = [1.0, 10.0];
/// How sparse the scans become, metres or radians.
const SPARSE: f64 = 0.85;

/// A real robot's log against relations matched by hand.
pub(crate) const STUDY: Study = Study {
    name: "relations",
    line: "a real robot's log against relations matched by hand (--log, --relations)",
    about: "A recorded log is mapped again and its trajectory compared with relations between its poses that \
            people matched by hand, as the SLAM benchmark of Kümmerle et al. (2009) does: mean translational \
            error, poses densified by the log's odometry. Noise is added to its odometry (1 and 10 times, or \
            as --odometry-noise says), once with a scan each 0.85 m only. `relations` is the trajectory as it \
            was believed online and never rewritten; `network` reads each relation from the links between \
            local frames. The thesis has nothing like it; figures for the Intel log from the literature are \
            0.220 m (scan matching), 0.070 m (particle filter) and 0.031 m (graph mapping).",
    seeds: 7,
    shown: &[
        "relations",
        "relations_network",
        "views",
        "surfaces",
        "frames",
        "recognised",
        "fallbacks",
        "partly",
    ],
    plan: |request| {
        let log = request.log.as_ref().ok_or("this study needs a log: --log FILE --relations FILE")?;
        let noise = if request.noise.is_empty() { &NOISE[..] } else { &request.noise };
        let dense = noise.iter().map(|&odometry| Treatment { odometry, every: None });
        let sparse = Treatment { odometry: noise[0], every: Some(SPARSE) };
        let treatments: Vec<Treatment> = dense.chain([sparse]).collect();
        Ok(of_log(log, &treatments))
    },
    judge,
};

/// Every mapper on a log, a condition for each treatment.
pub(crate) fn of_log(log: &Arc<Log>, treatments: &[Treatment]) -> Vec<Condition> {
    let mappers = vec![odometry(), transform(), perceptual(), no_recognition(), consensus()];
    let condition = |&treatment: &Treatment| Condition {
        ground: Ground::Log(Arc::clone(log)),
        treatment,
        mappers: mappers.clone(),
        times: 1,
    };
    treatments.iter().map(condition).collect()
}

fn judge(outcome: &Outcome) -> Vec<Check> {
    let check = |group: crate::Group<'_>| {
        let treatment = group.of().treatment;
        let most = match (treatment.every, treatment.odometry) {
            (Some(_), _) => 0.1,
            (None, noise) if noise > 1.0 => 0.08,
            _ => 0.06,
        };
        Check::figure(
            format!("{}, {CONSENSUS}: at most {most} m mean error online (median)", group.of().title()),
            group.figure_of("relations"),
            Bound::AtMost(most),
        )
    };
    outcome.groups_of("real", CONSENSUS).map(check).collect()
}
