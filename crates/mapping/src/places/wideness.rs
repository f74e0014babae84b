use cogmap_geometry::{DVec2, Metric, Segment, normalize_angle, trig};
use serde::{Deserialize, Serialize};

use super::{Form, nearby::Near};

/// How wide it is at a point of the way (§3.2.2, Fig. 3.14).
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Wideness {
    /// Metres of way since the first view, as the map has it.
    pub way: f64,
    /// Metres from what is on the left to what is on the right.
    pub width: f64,
    /// From what is on the left to what is on the right, in the map, metres.
    pub chord: Segment,
}

/// How wideness is measured: each 0.1 m of the way between two views, against what is remembered.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Looking {
    /// Nothing is seen farther off than this on either side, metres: the laser's range.
    pub range: f64,
    /// Shorter surfaces are debris and do not bound a space (`recommended`), metres.
    pub debris: f64,
}

impl Default for Looking {
    fn default() -> Self {
        Self { range: 8.0, debris: 0.3 }
    }
}

/// The angle between two of the chords that are compared, radians; a chord takes in whatever lies within half of
/// that, so that none slips through between the two faces of a wall.
const STEP: f64 = 5.0 * trig::PI / 180.0;
/// Chords of the recommended form are turned at most so many steps to either side: 50°.
const TURNS: usize = 10;
/// The literal form looks so many steps to either side of left and of right: 10°, or it would see no jamb
/// between the two faces of a wall.
const WINDOW: usize = 2;

/// No point of a surface is nearer than the surface by more than this, metres.
const ROUNDING: f64 = 1e-9;

/// From what is on the left of a point of the way to what is on its right.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Chord {
    pub(super) width: f64,
    pub(super) segment: Segment,
}

impl Chord {
    pub(super) fn between(segment: Segment) -> Self {
        Self { width: segment.length(), segment }
    }
}

/// The chord through a point of the way: perpendicular to it in the literal form (§3.2.2: the distance
/// of geometry to left and right), the narrowest within 50° of that in the recommended one.
pub(super) fn chord_at(at: DVec2, direction: DVec2, near: &[Near], form: Form, params: &Looking) -> Chord {
    let (turns, debris) = match form {
        Form::Literal => (WINDOW, 0.0),
        Form::Recommended => (TURNS, params.debris),
    };
    let mut profile = Profile::new(at, direction.perp(), turns, params.range);
    for surface in near {
        if surface.length >= debris {
            let distance = surface.segment.distance_to(at);
            if distance < params.range {
                profile.take_in(surface.segment, distance);
            }
        }
    }
    match form {
        Form::Literal => profile.left_and_right(),
        Form::Recommended => profile.narrowest(),
    }
}

/// How far it is to the nearest surface point in each direction, on the left and on the right.
struct Profile {
    at: DVec2,
    left: DVec2,
    turns: usize,
    /// Along the edge of what is looked at on a side, a little outside; x is outward.
    edge: DVec2,
    /// For each side and turn: distance and point.
    sides: [Vec<(f64, DVec2)>; 2],
}

impl Profile {
    fn new(at: DVec2, left: DVec2, turns: usize, range: f64) -> Self {
        let free = |side: f64| {
            (0..=2 * turns)
                .map(|bin| {
                    let (sin, cos) = trig::sin_cos(angle_of(bin, turns));
                    (range, at + (left * cos + left.perp() * sin) * side * range)
                })
                .collect()
        };
        let (sin, cos) = trig::sin_cos(angle_of(2 * turns, turns) + STEP / 2.0 + 1e-6);
        Self { at, left, turns, edge: DVec2::new(cos, sin), sides: [free(1.0), free(-1.0)] }
    }

    /// Takes in a surface that is so many metres off.
    fn take_in(&mut self, segment: Segment, distance: f64) {
        for (side, sign) in [1.0, -1.0].into_iter().enumerate() {
            let axis = self.left * sign;
            let local = |point: DVec2| {
                let off = point - self.at;
                DVec2::new(off.dot(axis), off.dot(axis.perp()))
            };
            let local = Segment::new(local(segment.a), local(segment.b));
            if !self.is_beside(local) && !self.is_hidden(side, distance) {
                self.take_in_side((side, axis), local, distance);
            }
        }
    }

    /// Whether a surface lies behind or wholly past an edge of what is looked at on a side.
    fn is_beside(&self, local: Segment) -> bool {
        let both = |past: &dyn Fn(DVec2) -> bool| past(local.a) && past(local.b);
        let other = DVec2::new(self.edge.x, -self.edge.y);
        both(&|point| point.x < 0.0)
            || both(&|point| self.edge.perp_dot(point) > 0.0)
            || both(&|point| other.perp_dot(point) < 0.0)
    }

    /// Whether there is something nearer in every direction of a side.
    fn is_hidden(&self, side: usize, distance: f64) -> bool {
        self.sides[side].iter().all(|(nearest, _)| distance > nearest + ROUNDING)
    }

    /// The part of a surface on one side; `local.x` is outward.
    fn take_in_side(&mut self, (side, axis): (usize, DVec2), local: Segment, distance: f64) {
        let (from, to) = (bearing(local.a), bearing(local.b));
        let half_span = normalize_angle(to - from) / 2.0;
        let centre = normalize_angle(from + half_span);
        for bin in 0..=2 * self.turns {
            if distance > self.sides[side][bin].0 + ROUNDING {
                continue;
            }
            // Angles from the middle of the surface, so that none wraps around.
            let off = normalize_angle(angle_of(bin, self.turns) - centre);
            let reach = half_span.abs();
            let (first, last) = ((off - STEP / 2.0).max(-reach), (off + STEP / 2.0).min(reach));
            if first > last {
                continue;
            }
            if let Some(point) = nearest_between(local, centre + first, centre + last)
                && point.norm() < self.sides[side][bin].0
            {
                let at = self.at + axis * point.x + axis.perp() * point.y;
                self.sides[side][bin] = (point.norm(), at);
            }
        }
    }

    /// The nearest points on the left and on the right.
    fn left_and_right(&self) -> Chord {
        let nearest = |side: &[(f64, DVec2)]| {
            side.iter()
                .copied()
                .fold(side[self.turns], |best, next| if next.0 < best.0 { next } else { best })
        };
        let [left, right] = self.sides.each_ref().map(|side| nearest(side));
        Chord { width: left.0 + right.0, segment: Segment::new(left.1, right.1) }
    }

    /// The narrowest chord; of equals the one that is turned least.
    fn narrowest(&self) -> Chord {
        let [left, right] = &self.sides;
        let chord = |bin: usize| Chord {
            width: left[bin].0 + right[bin].0,
            segment: Segment::new(left[bin].1, right[bin].1),
        };
        let mut best = chord(self.turns);
        for turn in 1..=self.turns {
            for other in [chord(self.turns - turn), chord(self.turns + turn)] {
                if other.width < best.width {
                    best = other;
                }
            }
        }
        best
    }
}

#[allow(clippy::cast_precision_loss, reason = "there are 21 turns")]
fn angle_of(bin: usize, turns: usize) -> f64 {
    (bin as f64 - turns as f64) * STEP
}

fn bearing(point: DVec2) -> f64 {
    trig::atan2(point.y, point.x)
}

/// The point of a line nearest to the origin between two bearings.
fn nearest_between(line: Segment, first: f64, last: f64) -> Option<DVec2> {
    let foot = line.closest_point(DVec2::ZERO);
    let middle = (first + last) / 2.0;
    if foot.norm() < 1e-9 || normalize_angle(bearing(foot) - middle).abs() <= (last - first) / 2.0 + 1e-9 {
        return Some(foot);
    }
    let along = line.b - line.a;
    let at = |angle: f64| {
        let (sin, cos) = trig::sin_cos(angle);
        let ray = DVec2::new(cos, sin);
        let range = line.a.perp_dot(along) / ray.perp_dot(along);
        (range.is_finite() && range > 0.0).then(|| ray * range)
    };
    match (at(first), at(last)) {
        (Some(a), Some(b)) => Some(if a.norm() <= b.norm() { a } else { b }),
        (a, b) => a.or(b),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn near(lines: &[([f64; 2], [f64; 2])]) -> Vec<Near> {
        let of = |(a, b): &([f64; 2], [f64; 2])| Near::new(Segment::new(DVec2::from(*a), DVec2::from(*b)));
        lines.iter().map(of).collect()
    }

    #[test]
    fn wideness_is_left_plus_right() {
        let corridor = near(&[([-5.0, 1.0], [5.0, 1.0]), ([-5.0, -0.5], [5.0, -0.5])]);
        for form in [Form::Literal, Form::Recommended] {
            let chord = chord_at(DVec2::ZERO, DVec2::X, &corridor, form, &Looking::default());
            assert!((chord.width - 1.5).abs() < 1e-9);
            assert!(chord.segment.a.distance(DVec2::new(0.0, 1.0)) < 1e-9);
            assert!(chord.segment.b.distance(DVec2::new(0.0, -0.5)) < 1e-9);
        }
    }

    #[test]
    fn the_narrowest_chord_sees_a_door_that_is_entered_obliquely() {
        let wall = near(&[([0.0, 0.45], [0.0, 4.0]), ([0.0, -4.0], [0.0, -0.45])]);
        let oblique = DVec2::new(1.0, 0.8).normalize();
        let chord = chord_at(DVec2::ZERO, oblique, &wall, Form::Recommended, &Looking::default());
        assert!((chord.width - 0.9).abs() < 1e-9);
    }

    #[test]
    fn no_chord_slips_through_between_the_faces_of_a_wall() {
        let wall = near(&[
            ([-0.06, 0.45], [-0.06, 4.0]),
            ([0.06, 0.45], [0.06, 4.0]),
            ([-0.06, -4.0], [-0.06, -0.45]),
            ([0.06, -4.0], [0.06, -0.45]),
        ]);
        for form in [Form::Literal, Form::Recommended] {
            assert!(chord_at(DVec2::ZERO, DVec2::X, &wall, form, &Looking::default()).width < 0.93);
        }
    }

    proptest! {
        #[test]
        fn what_is_left_out_as_hidden_or_beside_is_not_nearest(
            ends in prop::collection::vec((-4.0f64..4.0, -4.0f64..4.0, -4.0f64..4.0, -4.0f64..4.0), 1..12),
        ) {
            let lines: Vec<_> = ends.iter().map(|&(a, b, c, d)| ([a, b], [c, d])).collect();
            let near = near(&lines);
            for turns in [WINDOW, TURNS] {
                let [mut all, mut some] = [(); 2].map(|()| Profile::new(DVec2::ZERO, DVec2::Y, turns, 8.0));
                for surface in &near {
                    some.take_in(surface.segment, surface.segment.distance_to(DVec2::ZERO));
                    // At no distance nothing is hidden.
                    for (side, axis) in [DVec2::Y, -DVec2::Y].into_iter().enumerate() {
                        let local = |point: DVec2| DVec2::new(point.dot(axis), point.dot(axis.perp()));
                        let local = Segment::new(local(surface.segment.a), local(surface.segment.b));
                        all.take_in_side((side, axis), local, 0.0);
                    }
                }
                prop_assert_eq!(&all.sides, &some.sides);
            }
        }

        #[test]
        fn nothing_is_seen_beyond_the_lasers_range(
            ends in prop::collection::vec((-4.0f64..4.0, -4.0f64..4.0, -4.0f64..4.0, -4.0f64..4.0), 0..12),
        ) {
            let lines: Vec<_> = ends.iter().map(|&(a, b, c, d)| ([a, b], [c, d])).collect();
            let looking = Looking { debris: 0.0, ..Looking::default() };
            let width = |form| chord_at(DVec2::ZERO, DVec2::X, &near(&lines), form, &looking).width;
            for form in [Form::Literal, Form::Recommended] {
                prop_assert!((0.0..=2.0 * looking.range + 1e-9).contains(&width(form)));
            }
        }
    }
}
