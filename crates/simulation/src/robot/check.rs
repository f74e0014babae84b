use super::{BodyParams, LaserParams, OdometryErrors, Robot};
use crate::Problem;

impl Robot {
    /// Everything about this robot that could not be simulated, each with the way out.
    #[must_use]
    pub fn problems(&self) -> Vec<Problem> {
        let numbers = body(&self.body).into_iter().chain(laser(&self.laser)).chain(odometry(&self.odometry));
        let outside = |&(_, value, [low, high]): &(&str, f64, [f64; 2])| !(low..=high).contains(&value);
        let problem = |(place, value, [low, high]): (&str, f64, [f64; 2])| Problem {
            place: place.to_owned(),
            message: format!("is {value}; choose a number from {low} to {high}"),
        };
        numbers.filter(outside).map(problem).collect()
    }
}

type Bounded = (&'static str, f64, [f64; 2]);

fn body(body: &BodyParams) -> [Bounded; 7] {
    [
        ("body.axle", body.axle, [0.05, 2.0]),
        ("body.wheel_radius", body.wheel_radius, [0.01, 1.0]),
        ("body.radius", body.radius, [0.05, 1.0]),
        ("body.max_speed", body.max_speed, [0.05, 5.0]),
        ("body.max_turn_rate", body.max_turn_rate, [0.1, 20.0]),
        ("body.max_acceleration", body.max_acceleration, [0.05, 20.0]),
        ("body.max_turn_acceleration", body.max_turn_acceleration, [0.1, 100.0]),
    ]
}

#[allow(clippy::cast_precision_loss, reason = "a number too large to be exact is too large to be allowed")]
fn laser(laser: &LaserParams) -> [Bounded; 10] {
    [
        ("laser.forward", laser.forward, [-1.0, 1.0]),
        ("laser.field_of_view_deg", laser.field_of_view_deg, [1.0, 360.0]),
        ("laser.beams", laser.beams as f64, [2.0, 10_000.0]),
        ("laser.range_max", laser.range_max, [0.1, 200.0]),
        ("laser.noise", laser.noise, [0.0, 1.0]),
        ("laser.bias", laser.bias, [0.0, 1.0]),
        ("laser.grazing_dropout", laser.grazing_dropout, [0.0, 1.0]),
        ("laser.mixed_pixels", laser.mixed_pixels, [0.0, 1.0]),
        ("laser.resolution", laser.resolution, [0.0, 1.0]),
        ("laser.identity", laser.identity, [0.0, 1.0]),
    ]
}

fn odometry(errors: &OdometryErrors) -> [Bounded; 4] {
    [
        ("odometry.left_radius", errors.left_radius, [-0.2, 0.2]),
        ("odometry.right_radius", errors.right_radius, [-0.2, 0.2]),
        ("odometry.axle", errors.axle, [-0.2, 0.2]),
        ("odometry.slip", errors.slip, [0.0, 0.1]),
    ]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_named_robot_can_be_simulated_and_survives_its_file() {
        for name in Robot::NAMES {
            let robot = Robot::named(name).unwrap();
            assert_eq!(robot.problems(), []);
            let text = serde_json::to_string(&robot).unwrap();
            assert_eq!(serde_json::from_str::<Robot>(&text).unwrap(), robot);
        }
        for laser in [LaserParams::lms200_long(), LaserParams::urg()] {
            assert_eq!(Robot { laser, ..Robot::named("bad").unwrap() }.problems(), []);
        }
        assert_eq!(Robot::named("ugly"), None);
    }

    #[test]
    fn numbers_out_of_bounds_are_named() {
        let mut robot = Robot::named("good").unwrap();
        robot.laser.beams = 0;
        robot.body.axle = f64::NAN;
        let problems = robot.problems();
        let places: Vec<&str> = problems.iter().map(|p| p.place.as_str()).collect();
        assert_eq!(places, ["body.axle", "laser.beams"]);
        assert_eq!(problems[1].message, "is 0; choose a number from 2 to 10000");
    }
}
