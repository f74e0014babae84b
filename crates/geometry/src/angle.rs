use crate::trig::{FRAC_PI_2, PI, TAU};

/// The same direction as `angle`, in `(-π, π]`.
///
/// ```
/// use cogmap_geometry::{normalize_angle, trig::PI};
/// assert!((normalize_angle(3.0 * PI) - PI).abs() < 1e-12);
/// ```
#[must_use]
pub fn normalize_angle(angle: f64) -> f64 {
    if -PI < angle && angle <= PI {
        return angle;
    }
    angle + ((PI - angle) / TAU).floor() * TAU
}

/// How far the undirected lines with headings `a` and `b` are turned against
/// each other, in `[0, π/2]`.
#[must_use]
pub fn line_angle_between(a: f64, b: f64) -> f64 {
    let difference = normalize_angle(a - b).abs();
    if difference > FRAC_PI_2 { PI - difference } else { difference }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn a_normalized_angle_lies_in_the_half_open_circle(angle in -1e3f64..1e3) {
            let normal = normalize_angle(angle);
            prop_assert!(normal > -PI - 1e-12 && normal <= PI + 1e-12);
            let (s, c) = crate::trig::sin_cos(angle - normal);
            prop_assert!(s.abs() < 1e-9 && c > 0.999);
        }

        #[test]
        fn lines_have_no_direction(a in -4.0f64..4.0, b in -4.0f64..4.0) {
            let there = line_angle_between(a, b);
            prop_assert!((0.0..=FRAC_PI_2 + 1e-12).contains(&there));
            prop_assert!((there - line_angle_between(a + PI, b)).abs() < 1e-9);
            prop_assert!((there - line_angle_between(b, a)).abs() < 1e-9);
        }
    }
}
