use serde::{Deserialize, Serialize};

use super::look::Agreement;

/// When the robot notices that it is not where it believed to be. Entering new space is no reason: what
/// is new contradicts nothing.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Loss {
    /// Whether to notice at all.
    pub on: bool,
    /// A view is doubted when less than this share of it fits what is remembered …
    pub fraction: f64,
    /// … and more than this share of its beams contradicts what was seen free just before …
    pub contradiction: f64,
    /// … of so many that tell anything.
    pub evidence: u32,
    /// A doubt is gone as soon as no more than this share of the beams contradicts.
    pub settled: f64,
    /// The robot is lost after so many doubted views in a row; none of them is mapped.
    pub views: u32,
}

impl Default for Loss {
    fn default() -> Self {
        Self { on: true, fraction: 0.6, contradiction: 0.15, evidence: 40, settled: 0.1, views: 2 }
    }
}

impl Loss {
    /// Whether a view, of which so much fits, cannot have been taken where the robot believes to be; one
    /// that follows a doubted view is doubted more easily.
    pub(super) fn doubts(&self, fraction: f64, agreement: Agreement, already: bool) -> bool {
        let contradiction = agreement.contradiction();
        let doubted = if already {
            contradiction > self.settled
        } else {
            fraction < self.fraction && contradiction > self.contradiction
        };
        doubted && agreement.evidence() >= self.evidence
    }
}
