use cogmap_geometry::DVec2;
use cogmap_scene::Stroke;

/// A hairline that is part of a wider line with round ends, in pixels of the page.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Hair {
    /// How far to the left of the line's middle.
    aside: f64,
    /// How far over the line's ends.
    over: f64,
}

/// Wider lines than this are drawn as such, in pixels of the canvas.
const BUNDLED: f64 = 4.0;

/// The hairlines that a line is drawn as: browsers draw a path of many hairlines much faster than one of wide
/// lines, or than the wide lines one by one. None for hairlines, for very wide lines, and for lines that let the
/// ground through, which must not do so twice where they meet.
pub(super) fn hairs(stroke: Stroke, density: f64) -> Vec<Hair> {
    let width = stroke.width * density;
    if width <= 1.0 || width > BUNDLED || stroke.colour.alpha < u8::MAX {
        return Vec::new();
    }
    let count = width.ceil();
    let hair = |k: f64| {
        let aside = (width - 1.0) * (k / (count - 1.0) - 0.5);
        let radius = width / 2.0;
        Hair { aside: aside / density, over: (radius * radius - aside * aside).sqrt() / density }
    };
    (0..count as u32).map(f64::from).map(hair).collect()
}

/// The direction of a line, a unit vector.
pub(super) fn along([a, b]: [DVec2; 2]) -> DVec2 {
    (b - a).try_normalize().unwrap_or(DVec2::X)
}

impl Hair {
    /// Where it runs for a line in a direction.
    pub(super) fn beside(self, [a, b]: [DVec2; 2], along: DVec2) -> [DVec2; 2] {
        let (aside, over) = (along.perp() * -self.aside, along * self.over);
        [a + aside - over, b + aside + over]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use cogmap_scene::Colour;

    #[test]
    fn a_line_of_two_pixels_is_two_hairlines_with_round_ends() {
        let stroke = |alpha, width| Stroke { colour: Colour::solid(0).with_alpha(alpha), width };
        let [left, right] = hairs(stroke(u8::MAX, 2.0), 1.0)[..] else { panic!("two") };
        assert_eq!((left.aside, right.aside), (-0.5, 0.5));
        let line = [DVec2::new(10.0, 5.0), DVec2::new(20.0, 5.0)];
        let [from, to] = right.beside(line, along(line));
        assert!((from.y - 4.5).abs() < 1e-12 && (to.y - 4.5).abs() < 1e-12);
        assert!(
            (10.0 - from.x - 0.75f64.sqrt()).abs() < 1e-12 && (to.x - 20.0 - 0.75f64.sqrt()).abs() < 1e-12
        );
        assert_eq!(hairs(stroke(u8::MAX, 1.5), 2.0).len(), 3);
        for whole in [stroke(u8::MAX, 1.0), stroke(u8::MAX, 5.0), stroke(90, 2.0)] {
            assert!(hairs(whole, 1.0).is_empty());
        }
    }
}
