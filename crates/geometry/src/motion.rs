use crate::{DVec2, Pose, trig};

/// The rigid motion that carries the first of each pair of points nearest to the second: least squares of the
/// distances, no scaling, in closed form. `None` of nothing; where the points say nothing about directions, as those
/// of a robot that never moved, it turns by `heading`.
///
/// ```
/// use cogmap_geometry::{DVec2, Pose, fit_motion};
///
/// let onto_from = Pose::new(3.0, -1.0, 0.7);
/// let points = [DVec2::ZERO, DVec2::new(2.0, 0.5), DVec2::new(1.0, 4.0)];
/// let found = fit_motion(&points.map(|point| [point, onto_from * point]), 0.0).unwrap();
/// assert!((found.position - onto_from.position).length() < 1e-12);
/// ```
#[must_use]
#[allow(clippy::cast_precision_loss, reason = "a run has a few thousand views")]
pub fn fit_motion(pairs: &[[DVec2; 2]], heading: f64) -> Option<Pose> {
    if pairs.is_empty() {
        return None;
    }
    let count = pairs.len() as f64;
    let from_middle = pairs.iter().map(|[from, _]| *from).sum::<DVec2>() / count;
    let onto_middle = pairs.iter().map(|[_, onto]| *onto).sum::<DVec2>() / count;
    let (mut dot, mut cross) = (0.0, 0.0);
    for [from, onto] in pairs {
        let (from, onto) = (*from - from_middle, *onto - onto_middle);
        dot += from.dot(onto);
        cross += from.perp_dot(onto);
    }
    let turn = if dot == 0.0 && cross == 0.0 { heading } else { trig::atan2(cross, dot) };
    let shift = onto_middle - Pose::new(0.0, 0.0, turn).rotate(from_middle);
    Some(Pose::new(shift.x, shift.y, turn))
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    const WAY: [(f64, f64); 5] = [(0.0, 0.0), (3.0, 0.5), (2.0, 4.0), (-1.0, 2.0), (-2.5, -0.5)];

    fn error(motion: Pose, pairs: &[[DVec2; 2]]) -> f64 {
        pairs.iter().map(|[from, onto]| (motion * *from).distance_squared(*onto)).sum()
    }

    proptest! {
        #[test]
        fn a_known_motion_is_found(x in -9.0f64..9.0, y in -9.0f64..9.0, turn in -3.0f64..3.0) {
            let known = Pose::new(x, y, turn);
            let found = fit_motion(&WAY.map(DVec2::from).map(|point| [point, known * point]), 0.0).unwrap();
            let off = known.from_here(found);
            prop_assert!(off.position.length() < 1e-9 && off.heading.abs() < 1e-9);
        }

        #[test]
        fn no_other_motion_fits_better(
            noise in proptest::collection::vec((-0.5f64..0.5, -0.5f64..0.5), 5), x in -0.2f64..0.2, turn in -0.2f64..0.2,
        ) {
            let known = Pose::new(2.0, -1.0, 0.8);
            let pairs: Vec<_> = WAY
                .into_iter()
                .zip(noise)
                .map(|(point, noise)| [point.into(), known * DVec2::from(point) + DVec2::from(noise)])
                .collect();
            let found = fit_motion(&pairs, 0.0).unwrap();
            let other = found * Pose::new(x, -x, turn);
            prop_assert!(error(found, &pairs) <= error(other, &pairs) + 1e-12);
        }
    }

    #[test]
    fn a_point_that_stands_still_keeps_the_heading_that_is_given() {
        let still = [[DVec2::new(1.0, 0.0), DVec2::new(0.0, 2.0)]; 2];
        let found = fit_motion(&still, 0.5).unwrap();
        assert_eq!(found.heading, 0.5);
        assert!((found * still[0][0]).distance(still[0][1]) < 1e-12);
        assert_eq!(fit_motion(&[], 0.5), None);
    }
}
