use cogmap_geometry::{Metric, Pose, trig};
use serde::{Deserialize, Serialize};

use crate::perception::{Moment, Reading};

/// When a scan counts as a view. The thesis scans at the ends of steps only (§3.1.3); while a person
/// drives by velocity, distance and turn stand in for the steps.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Cadence {
    /// While rolling, a view each so many metres.
    pub distance: f64,
    /// While rolling, a view each so many radians.
    pub turn: f64,
}

impl Default for Cadence {
    fn default() -> Self {
        Self { distance: 0.5, turn: 20.0 * trig::PI / 180.0 }
    }
}

impl Cadence {
    /// Whether the reading is a view, the last one having been taken at `odom_from_last`.
    #[must_use]
    pub fn takes(&self, reading: &Reading, odom_from_last: Option<Pose>) -> bool {
        let Some(odom_from_last) = odom_from_last else { return true };
        match reading.moment {
            Moment::StepEnd => true,
            Moment::WithinStep => false,
            Moment::Rolling => {
                let moved = odom_from_last.from_here(reading.odom_from_robot);
                moved.position.norm() >= self.distance || moved.heading.abs() >= self.turn
            }
        }
    }
}
