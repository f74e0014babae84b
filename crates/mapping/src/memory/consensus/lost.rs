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
    /// The doubt is gone as soon as no more than this share of the beams contradicts.
    pub settled: f64,
    /// The robot is lost after so many doubted views in a row; none of them is mapped.
    pub views: u32,
}

impl Default for Loss {
    fn default() -> Self {
        Self { on: true, fraction: 0.6, contradiction: 0.16, evidence: 40, settled: 0.1, views: 2 }
    }
}

impl Loss {
    /// Whether a view that fits badly, or follows a doubted one, cannot have been taken where the robot
    /// believes to be.
    pub(super) fn doubts(&self, already: bool, agreement: Agreement) -> bool {
        let least = if already { self.settled } else { self.contradiction };
        agreement.evidence() >= self.evidence && agreement.contradiction() > least
    }
}
