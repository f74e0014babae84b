use glam::DVec2;
use serde::{Deserialize, Serialize};

use crate::{Metric, line_angle_between, trig};

/// A straight line between two points, metres; `a` to `b` has a direction.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Segment {
    /// First end.
    pub a: DVec2,
    /// Second end.
    pub b: DVec2,
}

impl Segment {
    /// The segment from `a` to `b`.
    #[must_use]
    pub fn new(a: DVec2, b: DVec2) -> Self {
        Self { a, b }
    }

    /// Metres from end to end.
    #[must_use]
    pub fn length(self) -> f64 {
        self.a.distance_from(self.b)
    }

    /// The point half-way.
    #[must_use]
    pub fn midpoint(self) -> DVec2 {
        (self.a + self.b) * 0.5
    }

    /// Direction from `a` to `b` as an angle, radians; 0 for a point.
    #[must_use]
    pub fn heading(self) -> f64 {
        let along = self.b - self.a;
        trig::atan2(along.y, along.x)
    }

    /// Unit vector from `a` to `b`; `None` where both ends coincide.
    #[must_use]
    pub fn direction(self) -> Option<DVec2> {
        (self.b - self.a).unit()
    }

    /// The same line from `b` to `a`.
    #[must_use]
    pub fn reversed(self) -> Self {
        Self::new(self.b, self.a)
    }

    /// How far along the segment `point` projects, as a share of its length:
    /// 0 at `a`, 1 at `b`, outside beyond the ends; 0 for a point.
    #[must_use]
    pub fn share_of(self, point: DVec2) -> f64 {
        let along = self.b - self.a;
        let squared = along.length_squared();
        if squared > 0.0 { (point - self.a).dot(along) / squared } else { 0.0 }
    }

    /// The point of the segment nearest to `point`.
    #[must_use]
    pub fn closest_point(self, point: DVec2) -> DVec2 {
        self.a + (self.b - self.a) * self.share_of(point).clamp(0.0, 1.0)
    }

    /// Metres from `point` to the segment.
    #[must_use]
    pub fn distance_to(self, point: DVec2) -> f64 {
        self.closest_point(point).distance_from(point)
    }

    /// Signed metres from the infinite line to `point`, positive on the left of
    /// `a` to `b`; `None` where both ends coincide.
    #[must_use]
    pub fn offset_of(self, point: DVec2) -> Option<f64> {
        Some(self.direction()?.perp_dot(point - self.a))
    }

    /// How far the two lines are turned against each other, `[0, π/2]` radians.
    #[must_use]
    pub fn angle_to(self, other: Self) -> f64 {
        line_angle_between(self.heading(), other.heading())
    }

    /// Where the two segments cross; `None` where they do not or are parallel.
    #[must_use]
    pub fn crossing(self, other: Self) -> Option<DVec2> {
        let (p, q) = (self.b - self.a, other.b - other.a);
        let cross = p.perp_dot(q);
        if cross == 0.0 {
            return None;
        }
        let between = other.a - self.a;
        let (s, t) = (between.perp_dot(q) / cross, between.perp_dot(p) / cross);
        let inside = (0.0..=1.0).contains(&s) && (0.0..=1.0).contains(&t);
        inside.then(|| self.a + p * s)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    prop_compose! {
        fn any_point()(x in -50.0f64..50.0, y in -50.0f64..50.0) -> DVec2 { DVec2::new(x, y) }
    }

    proptest! {
        #[test]
        fn the_closest_point_is_on_the_segment(a in any_point(), b in any_point(), p in any_point()) {
            let segment = Segment::new(a, b);
            let nearest = segment.closest_point(p);
            let via = nearest.distance(a) + nearest.distance(b);
            prop_assert!((via - segment.length()).abs() < 1e-9);
            for share in [0.0, 0.25, 0.5, 0.75, 1.0] {
                prop_assert!(p.distance(a.lerp(b, share)) >= segment.distance_to(p) - 1e-9);
            }
        }

        #[test]
        fn a_crossing_lies_on_both(a in any_point(), b in any_point(), c in any_point(), d in any_point()) {
            let (first, second) = (Segment::new(a, b), Segment::new(c, d));
            if let Some(point) = first.crossing(second) {
                prop_assert!(first.distance_to(point) < 1e-6);
                prop_assert!(second.distance_to(point) < 1e-6);
            }
        }
    }

    #[test]
    fn the_offset_is_positive_on_the_left() {
        let segment = Segment::new(DVec2::ZERO, DVec2::new(4.0, 0.0));
        assert_eq!(segment.offset_of(DVec2::new(1.0, 2.0)), Some(2.0));
        assert_eq!(segment.offset_of(DVec2::new(1.0, -2.0)), Some(-2.0));
        assert_eq!(Segment::new(DVec2::ONE, DVec2::ONE).offset_of(DVec2::ZERO), None);
    }
}
