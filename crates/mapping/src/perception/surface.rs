use cogmap_geometry::{Pose, Segment};
use serde::{Deserialize, Serialize};

/// Why a surface ends where it does, as far as one scan can tell.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum End {
    /// The object itself ends here: a corner, a jamb, an edge with free space behind it.
    True,
    /// Something nearer hides the rest.
    Occlusion,
    /// The sensor's limit: its range, or the edge of its field of view.
    RangeLimit,
}

/// A straight piece of boundary seen in one scan (§3.1.1), in the robot's frame at that moment.
/// Seen from the robot, `segment.a` is the clockwise end and `segment.b` the counter-clockwise one,
/// so a surface knows its visible side.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Surface {
    /// The fitted line between its two ends, metres.
    pub segment: Segment,
    /// Why it ends at `segment.a` and at `segment.b`.
    pub ends: [End; 2],
    /// First and last beam that hit it.
    pub beams: [usize; 2],
    /// Number of points that it was fitted to.
    pub points: usize,
    /// Root mean square distance of the points from the line, metres.
    pub residual: f64,
    /// Mean range of its points from the laser, metres.
    pub range: f64,
    /// Mean angle between the beams and the surface's normal, `[0, π/2]` radians.
    pub incidence: f64,
    /// Which thing it is, if the robot can tell that by sight; a laser alone cannot.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub label: Option<u32>,
}

impl Surface {
    /// Metres from end to end.
    #[must_use]
    pub fn length(&self) -> f64 {
        self.segment.length()
    }

    /// The same surface seen from another frame.
    #[must_use]
    pub fn seen_from(&self, other_from_robot: Pose) -> Self {
        Self { segment: other_from_robot * self.segment, ..self.clone() }
    }
}

/// The surfaces of one scan, in the robot's frame, in the order of their beams.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct View {
    /// Counter-clockwise.
    pub surfaces: Vec<Surface>,
}
