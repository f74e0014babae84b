use std::sync::Arc;

use cogmap_simulation::World;

use crate::{Check, Condition, Log, Outcome, studies};

/// An experiment that is run many times.
pub struct Study {
    /// How it is called.
    pub name: &'static str,
    /// One line for people.
    pub line: &'static str,
    /// What is run, what is measured, and what the thesis found.
    pub about: &'static str,
    /// How many seeds unless told otherwise.
    pub seeds: u64,
    /// The measures on screen, by name.
    pub shown: &'static [&'static str],
    /// What to run.
    pub plan: fn(&Request) -> Result<Vec<Condition>, String>,
    /// What the runs say of what is claimed.
    pub judge: fn(&Outcome) -> Vec<Check>,
}

/// What a user asks of a study.
#[derive(Clone, Default)]
pub struct Request {
    /// Other buildings than the study's own.
    pub worlds: Vec<Arc<World>>,
    /// A recorded log with its relations.
    pub log: Option<Arc<Log>>,
    /// Factors of the noise that is added to the log's odometry, instead of the study's own.
    pub noise: Vec<f64>,
}

impl Study {
    /// All studies, in the order of the thesis.
    pub const ALL: [Self; 15] = [
        studies::calibration::STUDY,
        studies::small::STUDY,
        studies::loop_b::STUDY,
        studies::placement::STUDY,
        studies::loop_a::STUDY,
        studies::tour::STUDY,
        studies::propagation::STUDY,
        studies::independence::STUDY,
        studies::cadence::STUDY,
        studies::identity::STUDY,
        studies::kidnap::STUDY,
        studies::ablation::STUDY,
        studies::relations::STUDY,
        studies::claims::STUDY,
        studies::results::STUDY,
    ];

    /// The study of that name.
    #[must_use]
    pub fn named(name: &str) -> Option<&'static Self> {
        const ALL: &[Study] = &Study::ALL;
        ALL.iter().find(|study| study.name == name)
    }
}
