use cogmap_geometry::Pose;

use crate::BodyParams;

/// How far the wheel encoders say that the two wheels have turned, radians.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct WheelTurns {
    /// Forward positive.
    pub left: f64,
    /// Forward positive.
    pub right: f64,
}

impl WheelTurns {
    /// The metres forward and the radians counter-clockwise that a program believes in which takes
    /// both wheels to be alike, the axle to be right, and nothing to slip.
    #[must_use]
    pub fn believed(self, body: &BodyParams) -> [f64; 2] {
        let [left, right] = [self.left, self.right].map(|turn| turn * body.wheel_radius);
        [f64::midpoint(left, right), (right - left) / body.axle]
    }

    /// The turns that such a program orders to go so far and to turn so much.
    #[must_use]
    pub fn ordered([forward, turn]: [f64; 2], body: &BodyParams) -> Self {
        let half = turn * body.axle / 2.0;
        Self { left: (forward - half) / body.wheel_radius, right: (forward + half) / body.wheel_radius }
    }
}

/// Adds up what the wheel encoders say (§3.1.2); knows nothing of wheels that differ or slip.
#[derive(Clone, Debug, PartialEq)]
pub struct Odometer {
    body: BodyParams,
    odom_from_robot: Pose,
}

impl Odometer {
    /// An odometer at the origin of its frame.
    #[must_use]
    pub fn new(body: &BodyParams) -> Self {
        Self { body: body.clone(), odom_from_robot: Pose::IDENTITY }
    }

    /// Takes in what the encoders counted since the last time.
    ///
    /// ```
    /// use cogmap_simulation::{BodyParams, Odometer, WheelTurns};
    /// let mut odometer = Odometer::new(&BodyParams::default());
    /// odometer.record(WheelTurns { left: 1.0, right: 1.0 });
    /// assert!((odometer.odom_from_robot().position.x - 0.0975).abs() < 1e-12);
    /// ```
    pub fn record(&mut self, turns: WheelTurns) {
        self.odom_from_robot = self.odom_from_robot * arc(turns.believed(&self.body));
    }

    /// Where odometry believes that the robot is.
    #[must_use]
    pub fn odom_from_robot(&self) -> Pose {
        self.odom_from_robot
    }
}

/// The movement along a circular arc, as seen from its start; for the small turns of one tick.
pub(crate) fn arc([forward, turn]: [f64; 2]) -> Pose {
    let (sin, cos) = cogmap_geometry::trig::sin_cos(turn / 2.0);
    let chord = if turn.abs() > 1e-9 { forward * sin / (turn / 2.0) } else { forward };
    Pose::new(chord * cos, chord * sin, turn)
}

#[cfg(test)]
mod tests {
    use cogmap_geometry::trig::{FRAC_PI_2, TAU};

    use super::*;

    #[test]
    fn a_circle_ends_where_it_began() {
        let body = BodyParams::default();
        let mut odometer = Odometer::new(&body);
        for _ in 0..1000 {
            odometer.record(WheelTurns::ordered([0.003, TAU / 1000.0], &body));
        }
        assert!(odometer.odom_from_robot().position.length() < 1e-9);
    }

    #[test]
    fn an_arc_is_exact_in_one_piece() {
        let quarter = arc([FRAC_PI_2, FRAC_PI_2]);
        assert!((quarter.position - cogmap_geometry::DVec2::ONE).length() < 1e-12);
    }

    #[test]
    fn what_is_ordered_is_believed() {
        let body = BodyParams::default();
        let [forward, turn] = WheelTurns::ordered([0.4, -0.2], &body).believed(&body);
        assert!((forward - 0.4).abs() < 1e-15 && (turn + 0.2).abs() < 1e-15);
    }
}
