use serde::{Deserialize, Serialize};

/// A robot: its body, its laser and how much its wheels lie.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Robot {
    /// `perfect`, `good`, `bad`, or a name of one's own.
    pub name: String,
    /// What moves.
    pub body: BodyParams,
    /// What sees.
    pub laser: LaserParams,
    /// What measures the movement.
    pub odometry: OdometryErrors,
}

/// A differential drive with a round footprint; the defaults are a Pioneer 3-DX.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct BodyParams {
    /// Distance between the wheels, metres.
    pub axle: f64,
    /// Metres.
    pub wheel_radius: f64,
    /// Radius of the footprint, metres.
    pub radius: f64,
    /// Metres per second.
    pub max_speed: f64,
    /// Radians per second.
    pub max_turn_rate: f64,
    /// Metres per second squared.
    pub max_acceleration: f64,
    /// Radians per second squared.
    pub max_turn_acceleration: f64,
}

impl Default for BodyParams {
    fn default() -> Self {
        Self {
            axle: 0.33,
            wheel_radius: 0.0975,
            radius: 0.25,
            max_speed: 1.2,
            max_turn_rate: 300.0_f64.to_radians(),
            max_acceleration: 0.8,
            max_turn_acceleration: 6.0,
        }
    }
}

/// A planar laser range finder; the defaults are a SICK LMS200 in millimetre mode.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct LaserParams {
    /// How far ahead of the robot's centre it sits, metres.
    pub forward: f64,
    /// Degrees, centred straight ahead.
    pub field_of_view_deg: f64,
    /// Number of beams, the first and the last on the edges of the field of view.
    pub beams: usize,
    /// Metres.
    pub range_max: f64,
    /// Random error along the beam, metres (1 σ).
    pub noise: f64,
    /// Error along the beam that stays the same for a whole run, metres (1 σ over robots).
    pub bias: f64,
    /// Share of beams lost at grazing incidence (90°); falls to none at normal incidence.
    pub grazing_dropout: f64,
    /// Share of beams on a depth edge that return a range in between.
    pub mixed_pixels: f64,
}

impl Default for LaserParams {
    fn default() -> Self {
        Self {
            forward: 0.0,
            field_of_view_deg: 180.0,
            beams: 361,
            range_max: 8.19,
            noise: 0.005,
            bias: 0.003,
            grazing_dropout: 0.5,
            mixed_pixels: 0.5,
        }
    }
}

/// How the wheel encoders' story differs from what happened.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct OdometryErrors {
    /// The left wheel is larger than the program believes by this share of its radius.
    pub left_radius: f64,
    /// The right wheel is larger than the program believes by this share of its radius.
    pub right_radius: f64,
    /// The axle is longer than the program believes by this share.
    pub axle: f64,
    /// Random slip of each wheel, metres per square root of a metre travelled (1 σ).
    pub slip: f64,
}
