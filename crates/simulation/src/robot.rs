use serde::{Deserialize, Serialize};

mod check;

/// A robot: its body, its laser and how much its wheels lie. Of a robot file only the name is
/// needed: the rest defaults to a Pioneer 3-DX with a SICK LMS200 and faultless odometry.
///
/// ```
/// use cogmap_simulation::Robot;
/// let robot: Robot = serde_json::from_str(
///     r#"{"name": "mine", "laser": {"noise": 0.02}, "odometry": {"slip": 0.004}}"#).unwrap();
/// assert!(robot.problems().is_empty());
/// assert_eq!(robot.body, Robot::named("bad").unwrap().body);
/// ```
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Robot {
    /// `perfect`, `good`, `bad`, or a name of one's own.
    pub name: String,
    /// What moves.
    #[serde(default)]
    pub body: BodyParams,
    /// What sees.
    #[serde(default)]
    pub laser: LaserParams,
    /// What measures the movement.
    #[serde(default)]
    pub odometry: OdometryErrors,
}

impl Robot {
    /// The names that [`Robot::named`] knows.
    pub const NAMES: [&str; 3] = ["perfect", "good", "bad"];

    /// A robot by name: `perfect` has no errors at all; `good` and `bad` are the two robots of
    /// §3.1.4, whose raw odometry is off by about 10° and 90° after a loop of 90 m.
    #[must_use]
    pub fn named(name: &str) -> Option<Self> {
        let (laser, odometry) = match name {
            "perfect" => (LaserParams::default().faultless(), OdometryErrors::default()),
            "good" => (LaserParams::default(), OdometryErrors::good()),
            "bad" => (LaserParams::default(), OdometryErrors::bad()),
            _ => return None,
        };
        Some(Self { name: name.to_owned(), body: BodyParams::default(), laser, odometry })
    }
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
    /// Share of depth edges that one of the two beams at the edge reports as a range in between.
    pub mixed_pixels: f64,
    /// Ranges are rounded to multiples of this, metres; 0 keeps them as they are.
    pub resolution: f64,
    /// Share of the world's solids that can be told apart by sight: a second sensor, which the thesis's
    /// robot lacks and its last chapter wishes for. Which solids chance decides, anew each run; with a
    /// greater share the same ones and more.
    pub identity: f64,
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
            resolution: 0.001,
            identity: 0.0,
        }
    }
}

impl LaserParams {
    /// A SICK LMS200 in centimetre mode: ten times the reach, a tenth of the resolution.
    #[must_use]
    pub fn lms200_long() -> Self {
        Self { range_max: 81.9, resolution: 0.01, ..Self::default() }
    }

    /// A small scanner in the manner of a Hokuyo URG: 240° in 683 beams, 4 m.
    #[must_use]
    pub fn urg() -> Self {
        let field = Self { field_of_view_deg: 240.0, beams: 683, range_max: 4.0, ..Self::default() };
        Self { noise: 0.01, bias: 0.005, ..field }
    }

    /// The same scanner without any error.
    #[must_use]
    pub fn faultless(self) -> Self {
        Self { noise: 0.0, bias: 0.0, grazing_dropout: 0.0, mixed_pixels: 0.0, resolution: 0.0, ..self }
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

impl OdometryErrors {
    /// So many times these errors.
    #[must_use]
    pub fn times(&self, times: f64) -> Self {
        let Self { left_radius, right_radius, axle, slip } = *self;
        let [left_radius, right_radius, axle, slip] =
            [left_radius, right_radius, axle, slip].map(|error| error * times);
        Self { left_radius, right_radius, axle, slip }
    }

    /// The newer robot of §3.1.4: after a loop of 90 m its odometry is off by 10° (median) and 3 m.
    #[must_use]
    pub fn good() -> Self {
        Self { left_radius: -0.000_33, right_radius: 0.000_33, axle: 0.005, slip: 0.0027 }
    }

    /// The older robot of §3.1.4, its left wheel more worn than its right one: after a loop of 90 m
    /// its odometry is off by 90° (median) and 23 m.
    #[must_use]
    pub fn bad() -> Self {
        Self { left_radius: -0.0029, right_radius: 0.0029, axle: 0.02, slip: 0.006 }
    }
}
