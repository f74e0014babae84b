use glam::DVec2;

use crate::Metric;

/// A straight line fitted to points by total least squares.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LineFit {
    /// The points' mean, on the line.
    pub centroid: DVec2,
    /// Unit vector along the line.
    pub direction: DVec2,
    /// Root mean square distance of the points from the line, metres.
    pub residual: f64,
}

impl LineFit {
    /// The point of the line nearest to `point`.
    #[must_use]
    pub fn project(&self, point: DVec2) -> DVec2 {
        self.centroid + self.direction * self.direction.dot(point - self.centroid)
    }

    /// Metres from the line to `point`, positive on the left of its direction.
    #[must_use]
    pub fn offset_of(&self, point: DVec2) -> f64 {
        self.direction.perp_dot(point - self.centroid)
    }
}

/// Fits a line that minimises the summed squared perpendicular distances; it
/// points from the first point to the last. `None` for fewer than two distinct
/// points.
///
/// ```
/// use cogmap_geometry::{DVec2, fit_line};
/// let line = fit_line(&[DVec2::ZERO, DVec2::new(1.0, 1.0), DVec2::new(2.0, 2.0)]).unwrap();
/// assert!(line.residual < 1e-12);
/// ```
#[must_use]
#[allow(clippy::cast_precision_loss, reason = "a scan has a few hundred points")]
pub fn fit_line(points: &[DVec2]) -> Option<LineFit> {
    let (first, last) = (*points.first()?, *points.last()?);
    let count = points.len() as f64;
    let centroid = points.iter().fold(DVec2::ZERO, |sum, &p| sum + p) / count;
    let (mut xx, mut xy, mut yy) = (0.0, 0.0, 0.0);
    for &point in points {
        let d = point - centroid;
        xx += d.x * d.x;
        xy += d.x * d.y;
        yy += d.y * d.y;
    }
    let direction = principal_axis(xx, xy, yy)?;
    let direction = if direction.dot(last - first) < 0.0 { -direction } else { direction };
    let squared: f64 = points.iter().map(|&p| direction.perp_dot(p - centroid)).map(|d| d * d).sum();
    Some(LineFit { centroid, direction, residual: (squared / count).sqrt() })
}

/// Unit eigenvector of the larger eigenvalue of `[[xx, xy], [xy, yy]]`, without
/// trigonometry; `None` for the zero matrix.
fn principal_axis(xx: f64, xy: f64, yy: f64) -> Option<DVec2> {
    let half = (xx - yy) * 0.5;
    let root = (half * half + xy * xy).sqrt();
    // Of the two equivalent forms, the one that does not cancel.
    let axis = if half >= 0.0 { DVec2::new(half + root, xy) } else { DVec2::new(xy, root - half) };
    axis.unit().or_else(|| (xx + yy > 0.0).then_some(DVec2::X))
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn a_line_is_found_whatever_its_direction(
            angle in -3.2f64..3.2, x in -9.0f64..9.0, y in -9.0f64..9.0, n in 2usize..40,
        ) {
            let (sin, cos) = crate::trig::sin_cos(angle);
            let (origin, along) = (DVec2::new(x, y), DVec2::new(cos, sin));
            let points: Vec<DVec2> = (0..n).map(|i| origin + along * (i as f64 * 0.1)).collect();
            let line = fit_line(&points).unwrap();
            prop_assert!(line.residual < 1e-9);
            prop_assert!(line.direction.dot(along) > 1.0 - 1e-9);
        }

        #[test]
        fn no_other_direction_fits_better(noise in prop::collection::vec(-0.1f64..0.1, 5..30), turn in -0.5f64..0.5) {
            let points: Vec<DVec2> =
                noise.iter().enumerate().map(|(i, &n)| DVec2::new(i as f64 * 0.3, n)).collect();
            let line = fit_line(&points).unwrap();
            let (sin, cos) = crate::trig::sin_cos(turn);
            let turned = DVec2::new(
                cos * line.direction.x - sin * line.direction.y,
                sin * line.direction.x + cos * line.direction.y,
            );
            let other = LineFit { direction: turned, ..line };
            let sum = |l: &LineFit| points.iter().map(|&p| l.offset_of(p)).map(|d| d * d).sum::<f64>();
            prop_assert!(sum(&line) <= sum(&other) + 1e-12);
        }
    }

    #[test]
    fn a_single_point_is_no_line() {
        assert_eq!(fit_line(&[]), None);
        assert_eq!(fit_line(&[DVec2::ONE, DVec2::ONE]), None);
    }
}
