use rand_pcg::Pcg64Mcg;

use crate::{BodyParams, OdometryErrors, WheelTurns, chance};

/// The metres forward and radians that the floor sees when the wheels turn: their true radii, the
/// true axle, and slip that no encoder notices (§3.1.2).
pub(super) fn roll(
    turns: WheelTurns,
    body: &BodyParams,
    errors: &OdometryErrors,
    rng: &mut Pcg64Mcg,
) -> [f64; 2] {
    let mut on_floor = |turn: f64, radius_error: f64| {
        let rolled = turn * body.wheel_radius;
        let slip =
            if errors.slip > 0.0 { errors.slip * rolled.abs().sqrt() * chance::gaussian(rng) } else { 0.0 };
        rolled * (1.0 + radius_error) + slip
    };
    let left = on_floor(turns.left, errors.left_radius);
    let right = on_floor(turns.right, errors.right_radius);
    [f64::midpoint(left, right), (right - left) / (body.axle * (1.0 + errors.axle))]
}

#[cfg(test)]
mod tests {
    use rand_core::SeedableRng;

    use super::*;

    #[test]
    fn wheels_without_errors_do_what_the_encoders_say() {
        let body = BodyParams::default();
        let turns = WheelTurns { left: 0.1, right: 0.3 };
        let mut rng = Pcg64Mcg::seed_from_u64(1);
        assert_eq!(roll(turns, &body, &OdometryErrors::default(), &mut rng), turns.believed(&body));
    }

    #[test]
    fn a_larger_right_wheel_turns_the_robot_to_the_left() {
        let errors = OdometryErrors { right_radius: 0.01, ..OdometryErrors::default() };
        let turns = WheelTurns { left: 10.0, right: 10.0 };
        let mut rng = Pcg64Mcg::seed_from_u64(1);
        let [forward, turn] = roll(turns, &BodyParams::default(), &errors, &mut rng);
        assert!((forward - 0.975 * 1.005).abs() < 1e-12);
        assert!((turn - 0.975 * 0.01 / 0.33).abs() < 1e-12);
    }
}
