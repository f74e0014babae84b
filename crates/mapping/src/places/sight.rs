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
