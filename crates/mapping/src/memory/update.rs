use serde::{Deserialize, Serialize};

use super::Match;
use crate::perception::{Surface, View};

/// When the map takes in what is new in a view.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Update {
    /// The rule.
    pub policy: UpdatePolicy,
    /// Of a view of which so large a share is known, by length, nothing is needed (our reading of the
    /// theory's "too few").
    pub known_enough: f64,
}

impl Default for Update {
    fn default() -> Self {
        Self { policy: UpdatePolicy::EveryStep, known_enough: 0.7 }
    }
}

/// Which views the map takes in.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum UpdatePolicy {
    /// All: the thesis's program, so as not to miss any surface (§3.2.1).
    #[default]
    EveryStep,
    /// The theory's limiting points (§2.3): a view describes the space that the robot is about to enter,
    /// and the next one is needed where it shows too little that is known. In between the robot knows
    /// from references where it is, and stores nothing.
    WhenNeeded,
}

impl Update {
    pub(super) fn needs(&self, view: &View, matches: &[Match]) -> bool {
        match self.policy {
            UpdatePolicy::EveryStep => true,
            UpdatePolicy::WhenNeeded => {
                let all: f64 = view.surfaces.iter().map(Surface::length).sum();
                let known: f64 =
                    matches.iter().filter_map(|m| view.surfaces.get(m.seen)).map(Surface::length).sum();
                known < self.known_enough * all
            }
        }
    }
}
