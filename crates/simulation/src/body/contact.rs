use cogmap_geometry::DVec2;

use crate::Surroundings;

/// The gap that is left between a body and what it touches, metres: rounding never closes it.
const SKIN: f64 = 1e-6;

/// Where a round body came to, and the point of the solid that it pressed against.
pub(super) struct Slide {
    pub(super) position: DVec2,
    pub(super) touched: Option<DVec2>,
}

/// Moves a disc that stands free; what it meets on the way pushes it back along its normal, so that
/// it slides along walls. It never penetrates: where nothing helps it stays.
pub(super) fn slide(from: DVec2, movement: DVec2, radius: f64, around: Surroundings<'_>) -> Slide {
    let mut slide = Slide { position: from, touched: None };
    let pieces = (movement.length() / (radius / 4.0)).ceil().clamp(1.0, 1e4);
    for _ in 0..pieces as usize {
        slide_a_little(&mut slide, movement / pieces, radius, around);
    }
    slide
}

/// A movement of at most a quarter of the radius, so that the middle stays on its side of all walls.
fn slide_a_little(slide: &mut Slide, movement: DVec2, radius: f64, around: Surroundings<'_>) {
    let before = slide.position;
    let mut position = before + movement;
    for _ in 0..8 {
        let Some((_, nearest)) = around.nearest(position, radius) else {
            if position.distance(before) < radius * 0.75 {
                slide.position = position;
            }
            return;
        };
        slide.touched = Some(nearest);
        let Some(away) = (position - nearest).try_normalize() else { return };
        position = nearest + away * (radius + SKIN);
    }
}

#[cfg(test)]
mod tests {
    use cogmap_geometry::Segment;
    use proptest::prelude::*;

    use super::*;
    use crate::{Disc, Obstacles, Solids};

    const RADIUS: f64 = 0.25;

    fn corner(angle: f64) -> Obstacles {
        let (sin, cos) = cogmap_geometry::trig::sin_cos(angle);
        let walls = [DVec2::new(99.0, 0.0), DVec2::new(cos, sin) * 99.0];
        let segments = walls.map(|end| Segment::new(DVec2::ZERO, end)).to_vec();
        Obstacles::new(&Solids {
            segments,
            discs: vec![Disc { center: DVec2::new(3.0, 0.5), radius: 0.02 }],
            ..Solids::default()
        })
    }

    #[test]
    fn it_slides_along_a_wall_instead_of_sticking() {
        let slide = slide(DVec2::new(5.0, 0.26), DVec2::new(0.1, -0.1), RADIUS, (&corner(3.0)).into());
        assert!(slide.touched.is_some());
        assert!((slide.position - DVec2::new(5.1, RADIUS)).length() < 1e-5, "{}", slide.position);
    }

    proptest! {
        #[test]
        fn it_never_penetrates_whatever_it_is_told(
            angle in 0.45f64..3.1,
            moves in prop::collection::vec((-0.6f64..0.6, -0.6f64..0.6), 1..60),
        ) {
            let obstacles = corner(angle);
            let (sin, cos) = cogmap_geometry::trig::sin_cos(angle);
            let mut position = DVec2::new(8.0, 0.5);
            for (x, y) in moves {
                let next = slide(position, DVec2::new(x - 0.2, y - 0.1), RADIUS, (&obstacles).into()).position;
                prop_assert!(obstacles.nearest(next, RADIUS - 1e-9).is_none());
                prop_assert!(next.y > 0.0 && DVec2::new(cos, sin).perp_dot(next) < 0.0, "between the walls");
                position = next;
            }
        }
    }
}
