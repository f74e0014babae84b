use crate::TICK;

/// The speed of the next tick on the way to a wanted velocity, each part changing by at most its
/// `gain`.
pub(super) fn approach(speed: [f64; 2], wanted: [f64; 2], gain: [f64; 2]) -> [f64; 2] {
    let one = |now: f64, wanted: f64, gain: f64| wanted.clamp(now - gain, now + gain);
    [one(speed[0], wanted[0], gain[0]), one(speed[1], wanted[1], gain[1])]
}

/// The speed of the next tick on the way to a place `left` ahead: as fast as `max` and
/// `acceleration` allow, yet slow enough to stop exactly there.
pub(super) fn toward(left: f64, speed: f64, max: f64, acceleration: f64) -> f64 {
    let way = left.abs();
    let faster = (speed * left.signum()).max(0.0) + acceleration * TICK;
    let half_gain = acceleration * TICK / 2.0;
    let braking = (half_gain * half_gain + 2.0 * acceleration * way).sqrt() - half_gain;
    faster.min(max).min(braking).min(way / TICK).copysign(left)
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    proptest! {
        #[test]
        fn it_stops_exactly_there_and_never_brakes_too_hard(
            way in 0.001f64..20.0, max in 0.1f64..2.0, acceleration in 0.1f64..3.0,
        ) {
            let (mut left, mut speed, mut ticks) = (way, 0.0, 0);
            while left.abs() > 1e-9 {
                let next = toward(left, speed, max, acceleration);
                prop_assert!((next - speed).abs() <= acceleration * TICK * 1.5, "{speed} to {next}");
                prop_assert!(next <= max);
                (left, speed, ticks) = (left - next * TICK, next, ticks + 1);
                prop_assert!(f64::from(ticks) * TICK < way / max + max / acceleration + 10.0);
            }
            prop_assert!(left.abs() <= 1e-9);
        }
    }

    #[test]
    fn backwards_is_forwards_mirrored() {
        assert_eq!(toward(-1.0, -0.2, 1.2, 0.8), -toward(1.0, 0.2, 1.2, 0.8));
    }
}
