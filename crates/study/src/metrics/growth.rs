use cogmap_geometry::trig;

use super::Sample;

/// Root mean square error, metres, of what the map says of all stretches of the way that are that
/// long: where the robot is seen from where it was; `None` where the way is shorter.
#[must_use]
#[allow(clippy::cast_precision_loss, reason = "a run has a few thousand views")]
pub fn error_over(samples: &[Sample], length: f64) -> Option<f64> {
    let mut along = vec![0.0];
    for pair in samples.windows(2) {
        let step = pair[0].world_from_robot.position.distance(pair[1].world_from_robot.position);
        along.push(along.last().copied().unwrap_or(0.0) + step);
    }
    let (mut sum, mut count) = (0.0, 0_usize);
    for (start, from) in samples.iter().enumerate() {
        let end = along.partition_point(|&at| at < along[start] + length);
        let Some(to) = samples.get(end) else { break };
        let truly = from.world_from_robot.from_here(to.world_from_robot);
        let off = truly.from_here(from.map_from_robot.from_here(to.map_from_robot));
        sum += off.position.length_squared();
        count += 1;
    }
    (count > 0).then(|| (sum / count as f64).sqrt())
}

/// The exponent with which errors grow with distance: the slope of log(error) against log(distance)
/// of `(distance, error)`. A constant error of the heading gives about 2, a random walk of the
/// heading 1.5, a random walk of the position 0.5, a bounded error 0.
#[must_use]
#[allow(clippy::cast_precision_loss, reason = "a curve has a few points")]
pub fn growth_exponent(curve: &[(f64, f64)]) -> Option<f64> {
    let usable = curve.iter().filter(|(distance, error)| *distance > 0.0 && *error > 0.0);
    let logs: Vec<(f64, f64)> = usable.map(|(d, e)| (trig::ln(*d), trig::ln(*e))).collect();
    let count = logs.len() as f64;
    let (mx, my) = logs.iter().fold((0.0, 0.0), |(x, y), log| (x + log.0 / count, y + log.1 / count));
    let (xy, xx) =
        logs.iter().fold((0.0, 0.0), |(xy, xx), (x, y)| (xy + (x - mx) * (y - my), xx + (x - mx) * (x - mx)));
    (xx > 0.0).then(|| xy / xx)
}

#[cfg(test)]
mod tests {
    use cogmap_geometry::Pose;
    use proptest::prelude::*;

    use super::*;

    proptest! {
        #[test]
        fn a_power_law_gives_its_exponent(exponent in 0.0f64..3.0, scale in 0.001f64..1.0) {
            let curve: Vec<(f64, f64)> =
                [1.0, 2.0, 5.0, 20.0].map(|d| (d, scale * libm_pow(d, exponent))).to_vec();
            prop_assert!((growth_exponent(&curve).unwrap() - exponent).abs() < 1e-9);
        }
    }

    fn libm_pow(base: f64, exponent: f64) -> f64 {
        trig::exp(exponent * trig::ln(base))
    }

    #[test]
    fn a_way_believed_a_tenth_too_long_is_off_by_a_tenth_of_every_stretch() {
        let at = |k: u32| Sample {
            world_from_robot: Pose::new(f64::from(k), 0.0, 0.0),
            map_from_robot: Pose::new(1.1 * f64::from(k), 0.0, 0.0),
        };
        let samples: Vec<Sample> = (0..20).map(at).collect();
        for length in [1.0, 4.0, 16.0] {
            assert!((error_over(&samples, length).unwrap() - 0.1 * length).abs() < 1e-9);
        }
        assert_eq!(error_over(&samples, 20.0), None);
    }

    #[test]
    fn one_point_has_no_slope() {
        assert_eq!(growth_exponent(&[(1.0, 1.0)]), None);
        assert_eq!(growth_exponent(&[(1.0, 1.0), (2.0, 0.0)]), None);
    }
}
