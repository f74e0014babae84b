use crate::DVec2;

/// Whether a point lies inside an outline, metres: a ray from it crosses the outline an odd number of times.
///
/// ```
/// use cogmap_geometry::{DVec2, is_inside};
///
/// let square = [[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0]].map(DVec2::from);
/// assert!(is_inside(&square, DVec2::ONE));
/// assert!(!is_inside(&square, DVec2::new(3.0, 1.0)));
/// ```
#[must_use]
pub fn is_inside(outline: &[DVec2], point: DVec2) -> bool {
    let edges = outline.iter().zip(outline.iter().cycle().skip(1));
    let crosses = |(a, b): &(&DVec2, &DVec2)| {
        (a.y > point.y) != (b.y > point.y) && point.x < a.x + (b.x - a.x) * (point.y - a.y) / (b.y - a.y)
    };
    edges.filter(crosses).count() % 2 == 1
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_bent_outline_holds_its_arms_and_not_the_corner_between_them() {
        let bent = [[0.0, 0.0], [6.0, 0.0], [6.0, 2.0], [1.0, 2.0], [1.0, 5.0], [0.0, 5.0]].map(DVec2::from);
        assert!(is_inside(&bent, DVec2::new(5.0, 1.0)) && is_inside(&bent, DVec2::new(0.5, 4.0)));
        assert!(!is_inside(&bent, DVec2::new(3.0, 3.0)));
        assert!(!is_inside(&bent, DVec2::new(f64::NAN, 1.0)) && !is_inside(&[], DVec2::ZERO));
    }
}
