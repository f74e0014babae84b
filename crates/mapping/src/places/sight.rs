use cogmap_geometry::{DVec2, Segment};

/// Samples of a surface lie at most so far apart, metres.
const SPACING: f64 = 0.2;
/// A surface that comes this near to a jamb and lies on both sides of the exit spans it, metres.
const JAMB: f64 = 0.3;

/// Which share of a surface was seen through an exit (§3.2.2, Fig. 3.15): the line of sight from where
/// it was first seen crosses the passage itself. A long surface is decided point by point.
pub(super) fn share_through(exit: Segment, eye: DVec2, surface: Segment) -> f64 {
    let points = samples(surface);
    let through = points.iter().filter(|&&point| Segment::new(eye, point).crossing(exit).is_some()).count();
    #[allow(clippy::cast_precision_loss, reason = "a surface has a few hundred samples")]
    let share = through as f64 / points.len() as f64;
    share
}

/// Whether a surface belongs to the space behind an exit: most of it was seen through the passage, and it
/// does not span a jamb.
pub(super) fn is_behind(exit: Segment, eye: DVec2, surface: Segment) -> bool {
    share_through(exit, eye, surface) > 0.5 && !spans_jamb(exit, surface)
}

/// Whether a surface lies on both sides of an exit's line beside one of its jambs.
fn spans_jamb(exit: Segment, surface: Segment) -> bool {
    let (Some(a), Some(b)) = (exit.offset_of(surface.a), exit.offset_of(surface.b)) else { return false };
    let deep = a.abs().min(b.abs()) > JAMB / 2.0;
    a * b < 0.0 && deep && (surface.distance_to(exit.a) < JAMB || surface.distance_to(exit.b) < JAMB)
}

/// Points of a surface, its ends left out, where neighbours meet.
pub(super) fn samples(surface: Segment) -> Vec<DVec2> {
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "no surface is that long")]
    let pieces = (surface.length() / SPACING).ceil().clamp(1.0, 1e4) as u32;
    let at = |piece: u32| surface.a.lerp(surface.b, (f64::from(piece) + 0.5) / f64::from(pieces));
    (0..pieces).map(at).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    /// A door in a wall along y = 4, from x = 1 to x = 2.
    fn door() -> Segment {
        Segment::new(DVec2::new(1.0, 4.0), DVec2::new(2.0, 4.0))
    }

    fn wall(a: [f64; 2], b: [f64; 2]) -> Segment {
        Segment::new(DVec2::from(a), DVec2::from(b))
    }

    #[test]
    fn what_is_seen_through_the_door_lies_behind_it() {
        assert!(is_behind(door(), DVec2::new(1.5, 2.0), wall([0.8, 7.0], [2.2, 7.0])));
    }

    #[test]
    fn a_wall_of_an_l_shaped_room_behind_the_exits_line_stays_in_the_room() {
        // The room goes on to y = 8 beside the door; the wall at its far end lies behind the line y = 4.
        let far_end = wall([4.0, 8.0], [7.0, 8.0]);
        assert!(door().offset_of(far_end.midpoint()).unwrap() > 0.0);
        assert!(!is_behind(door(), DVec2::new(5.0, 2.0), far_end));
    }

    #[test]
    fn a_long_wall_goes_where_most_of_it_was_seen() {
        let eye = DVec2::new(1.5, 3.0);
        // Through the door the eye sees x from 0 to 3 at y = 6.
        assert!(is_behind(door(), eye, wall([0.0, 6.0], [5.0, 6.0])));
        assert!(!is_behind(door(), eye, wall([0.0, 6.0], [9.0, 6.0])));
    }

    #[test]
    fn a_surface_that_spans_the_jamb_stays() {
        let leaf = wall([1.9, 3.6], [2.0, 6.0]);
        assert!(share_through(door(), DVec2::new(1.2, 1.0), leaf) > 0.5);
        assert!(!is_behind(door(), DVec2::new(1.2, 1.0), leaf));
    }

    proptest! {
        #[test]
        fn nothing_on_the_robots_own_side_is_behind(
            eye in (-9.0f64..9.0, -9.0f64..3.9), a in (-9.0f64..9.0, -9.0f64..3.9), b in (-9.0f64..9.0, -9.0f64..3.9),
        ) {
            let surface = wall([a.0, a.1], [b.0, b.1]);
            prop_assert_eq!(share_through(door(), DVec2::new(eye.0, eye.1), surface), 0.0);
        }
    }
}
