use cogmap_geometry::DVec2;

/// The part of a line that lies in a picture of that size grown by `margin` pixels on each side;
/// `None` where nothing does, or where an end is not finite (Liang and Barsky 1984).
pub(crate) fn clip(line: [DVec2; 2], size: DVec2, margin: f64) -> Option<[DVec2; 2]> {
    let [from, to] = line;
    let along = to - from;
    let (min, max) = (DVec2::splat(-margin), size + margin);
    let within = |end: DVec2| end.cmpge(min).all() && end.cmple(max).all();
    if within(from) && within(to) {
        return Some(line);
    }
    if !(from.is_finite() && to.is_finite()) {
        return None;
    }
    let (mut enter, mut leave) = (0.0_f64, 1.0_f64);
    let edges = [
        (-along.x, from.x - min.x),
        (along.x, max.x - from.x),
        (-along.y, from.y - min.y),
        (along.y, max.y - from.y),
    ];
    for (outward, distance) in edges {
        if outward < 0.0 {
            enter = enter.max(distance / outward);
        } else if outward > 0.0 {
            leave = leave.min(distance / outward);
        } else if distance < 0.0 {
            return None;
        }
    }
    let start = if enter > 0.0 { from + along * enter } else { from };
    let end = if leave < 1.0 { from + along * leave } else { to };
    (enter <= leave).then_some([start, end])
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    const SIZE: DVec2 = DVec2::new(640.0, 480.0);

    prop_compose! {
        fn any_point()(x in -2000.0f64..3000.0, y in -2000.0f64..3000.0) -> DVec2 { DVec2::new(x, y) }
    }

    fn inside(point: DVec2, slack: f64) -> bool {
        point.cmpge(DVec2::splat(-slack)).all() && point.cmple(SIZE + slack).all()
    }

    proptest! {
        #[test]
        fn exactly_the_visible_part_is_kept(a in any_point(), b in any_point()) {
            let kept = clip([a, b], SIZE, 0.0);
            for i in 0..=50 {
                let point = a.lerp(b, f64::from(i) / 50.0);
                if let Some([from, to]) = kept {
                    let on_kept = from.distance(point) + to.distance(point) <= from.distance(to) + 1e-6;
                    prop_assert!(!on_kept || inside(point, 1e-6));
                    prop_assert!(on_kept || !inside(point, -1e-6));
                } else {
                    prop_assert!(!inside(point, -1e-6));
                }
            }
        }
    }

    #[test]
    fn a_line_without_a_finite_end_is_not_drawn() {
        assert_eq!(clip([DVec2::NAN, DVec2::ONE], SIZE, 0.0), None);
        assert_eq!(clip([DVec2::ONE, DVec2::INFINITY], SIZE, 0.0), None);
    }
}
