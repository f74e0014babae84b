use serde::{Deserialize, Serialize};

use crate::{
    Cadence, Placement, StepReport,
    memory::{Matching, Memory},
    perception::{Extraction, Reading, extract},
};

/// Every parameter of the odometry mapper.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct OdometryParams {
    /// When a scan is a view.
    pub cadence: Cadence,
    /// How points become surfaces.
    pub extraction: Extraction,
    /// When two sightings are one surface and the second need not be added.
    pub matching: Matching,
}

/// Views put together by what the wheels say, uncorrected: what any other mapper must beat.
#[derive(Clone, Debug, PartialEq)]
pub struct Odometry {
    params: OdometryParams,
    memory: Memory,
}

impl Odometry {
    /// A mapper with an empty memory.
    #[must_use]
    pub fn new(params: &OdometryParams) -> Self {
        Self { params: *params, memory: Memory::default() }
    }

    /// What it remembers.
    #[must_use]
    pub fn memory(&self) -> &Memory {
        &self.memory
    }

    pub(crate) fn observe(&mut self, reading: &Reading) -> Option<StepReport> {
        if !self.params.cadence.takes(reading, self.memory.odom_from_last()) {
            return None;
        }
        let view = extract(&reading.scan, &self.params.extraction);
        let moved = self.memory.moved_to(reading.odom_from_robot);
        let by = (Placement::Odometry, moved);
        Some(self.memory.transform(view, (reading.t, reading.odom_from_robot), by, &self.params.matching))
    }
}
