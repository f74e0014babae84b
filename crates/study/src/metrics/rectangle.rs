use cogmap_geometry::{DVec2, Segment, trig};

/// How well surfaces fit the sides of a rectangle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RectangleFit {
    /// Root mean square distance of the surfaces' ends from their sides, metres.
    pub rms: f64,
    /// Root mean square angle between the surfaces and their sides, by length, radians.
    pub angle: f64,
}

/// Fits a rectangle to the surfaces that show its four sides; `None` where there are none.
///
/// Its direction is the mean of theirs, by length, modulo a right angle; each pair of sides lies at
/// the mean offsets of the surfaces on either side of the middle.
#[must_use]
pub fn rectangle_fit(surfaces: &[Segment]) -> Option<RectangleFit> {
    let (mut sin, mut cos, mut length) = (0.0, 0.0, 0.0);
    for surface in surfaces {
        let (s, c) = trig::sin_cos(4.0 * surface.heading());
        (sin, cos) = (sin + s * surface.length(), cos + c * surface.length());
        length += surface.length();
    }
    let turn = trig::atan2(sin, cos) / 4.0;
    let (s, c) = trig::sin_cos(turn);
    let axes = [DVec2::new(c, s), DVec2::new(-s, c)];
    let (mut squares, mut turned) = (0.0, 0.0);
    for along in 0..2 {
        let is_along = |surface: &&Segment| {
            let direction = surface.direction().unwrap_or(DVec2::ZERO);
            direction.dot(axes[along]).abs() > direction.dot(axes[1 - along]).abs()
        };
        let sides: Vec<Segment> = surfaces.iter().filter(is_along).copied().collect();
        squares += squares_from_two_lines(&sides, axes[1 - along]);
        for side in &sides {
            let angle = side.angle_to(Segment::new(DVec2::ZERO, axes[along]));
            turned += angle * angle * side.length();
        }
    }
    (length > 0.0).then(|| RectangleFit { rms: (squares / length).sqrt(), angle: (turned / length).sqrt() })
}

/// Of surfaces on two parallel lines, the squared distances of their ends from the line that they
/// are nearer to, by length.
fn squares_from_two_lines(surfaces: &[Segment], across: DVec2) -> f64 {
    let offset = |surface: &Segment| across.dot(surface.midpoint());
    let (least, most) = surfaces
        .iter()
        .map(offset)
        .fold((f64::INFINITY, f64::NEG_INFINITY), |(least, most), o| (o.min(least), o.max(most)));
    let middle = f64::midpoint(least, most);
    let mut squares = 0.0;
    for high in [false, true] {
        let side = || surfaces.iter().filter(|s| (offset(s) > middle) == high);
        let length: f64 = side().map(|s| s.length()).sum();
        let line = side().map(|s| offset(s) * s.length()).sum::<f64>() / length;
        let square = |end: DVec2| (across.dot(end) - line) * (across.dot(end) - line);
        squares += side().map(|s| f64::midpoint(square(s.a), square(s.b)) * s.length()).sum::<f64>();
    }
    squares
}

#[cfg(test)]
mod tests {
    use cogmap_geometry::Pose;
    use proptest::prelude::*;

    use super::*;

    fn line(ax: f64, ay: f64, bx: f64, by: f64) -> Segment {
        Segment::new(DVec2::new(ax, ay), DVec2::new(bx, by))
    }

    fn room() -> Vec<Segment> {
        vec![
            line(0.0, 0.0, 6.0, 0.0),
            line(6.0, 0.0, 6.0, 4.0),
            line(6.0, 4.0, 1.0, 4.0),
            line(0.0, 4.0, 0.0, 0.0),
        ]
    }

    proptest! {
        #[test]
        fn a_rectangle_fits_itself_however_it_lies(x in -9.0f64..9.0, y in -9.0f64..9.0, turn in -3.0f64..3.0) {
            let laid: Vec<Segment> = room().into_iter().map(|side| Pose::new(x, y, turn) * side).collect();
            let fit = rectangle_fit(&laid).unwrap();
            prop_assert!(fit.rms < 1e-9 && fit.angle < 1e-7, "{fit:?}");
        }
    }

    #[test]
    fn a_side_seen_twice_0_2_apart_is_off_by_a_tenth_each() {
        let mut surfaces = vec![line(0.0, 0.0, 4.0, 0.0), line(0.0, 3.9, 2.0, 3.9), line(2.0, 4.1, 4.0, 4.1)];
        let fit = rectangle_fit(&surfaces).unwrap();
        assert!((fit.rms - (0.01_f64 * 4.0 / 8.0).sqrt()).abs() < 1e-12 && fit.angle < 1e-9);
        surfaces.clear();
        assert_eq!(rectangle_fit(&surfaces), None);
    }
}
