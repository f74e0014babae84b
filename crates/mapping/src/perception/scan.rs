use cogmap_geometry::{DVec2, Pose, trig};
use serde::{Deserialize, Serialize};

/// One sweep of a planar range finder (§3.1.1): beams of equal spacing, counter-clockwise.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Scan {
    /// Where the laser sits on the robot.
    pub robot_from_laser: Pose,
    /// Bearing of beam 0 in the laser's frame, radians.
    pub angle_min: f64,
    /// Angle from one beam to the next, radians.
    pub angle_increment: f64,
    /// Readings at or beyond this range, metres, mean that nothing was seen.
    pub range_max: f64,
    /// Distances, metres, one a beam; infinite or not a number where nothing was seen (REP-117).
    pub ranges: Vec<f64>,
    /// What a camera would recognise at each beam; `None` where it knows nothing by sight. Empty without
    /// such a sensor: the thesis's robot has none, and wishes for one (chapter 4).
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub labels: Vec<Option<u32>>,
}

impl Scan {
    /// Bearing of a beam in the laser's frame, radians.
    #[must_use]
    #[allow(clippy::cast_precision_loss, reason = "a scan has a few hundred beams")]
    pub fn bearing(&self, beam: usize) -> f64 {
        self.angle_min + self.angle_increment * beam as f64
    }

    /// The distance that a beam measured, metres; `None` where it saw nothing.
    #[must_use]
    pub fn range(&self, beam: usize) -> Option<f64> {
        let range = *self.ranges.get(beam)?;
        (range > 0.0 && range < self.range_max).then_some(range)
    }

    /// The point that a beam hit, in the laser's frame; `None` where it saw nothing.
    #[must_use]
    pub fn point(&self, beam: usize) -> Option<DVec2> {
        let range = self.range(beam)?;
        let (sin, cos) = trig::sin_cos(self.bearing(beam));
        Some(DVec2::new(range * cos, range * sin))
    }
}

/// How the robot was moving when it took a scan; some mappers map only what was seen at rest.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Moment {
    /// At the end of a step: turn, travel, scan (§3.1.3). Scans of a recorded log count as these.
    StepEnd,
    /// On the way, between the two ends of a step.
    WithinStep,
    /// While a person drives by velocity.
    Rolling,
}

/// What reaches a mapper: a scan, and where odometry believes it was taken. Nothing else does.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Reading {
    /// Seconds.
    pub t: f64,
    /// The robot in the odometry's frame (REP-105); drifts without bound.
    pub odom_from_robot: Pose,
    /// Whether the robot had come to rest.
    pub moment: Moment,
    /// What the laser saw.
    pub scan: Scan,
}
