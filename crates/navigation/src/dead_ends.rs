use cogmap_geometry::{DVec2, Pose, Segment, trig};

use crate::{Anchored, Atlas, surroundings::Surroundings};

/// How far to both sides a closed way is felt along, in steps of [`FEEL`].
const FEELS: u32 = 20;
/// Metres.
const FEEL: f64 = 0.2;
/// The cosine of 45°: a way that crosses a mark at more is another way.
const ALIKE: f64 = 0.7;
/// A mark so near and in view is looked at again, metres …
const REVISIT: f64 = 4.0;
/// … if it lies within this of straight ahead, radians.
const IN_VIEW: f64 = 80.0 * trig::PI / 180.0;
/// How far beyond a mark the robot must see for it to be wrong, metres.
const BEYOND: f64 = 0.5;

/// The rough memory of options that were tried and turned out closed (§3.3.3): when the walls that closed
/// them have been forgotten, the robot still knows not to try again. The thesis asks for such a
/// mechanism and leaves its form open; each mark is a line across the way that was tried, as wide as
/// what closed it was seen to be.
#[derive(Clone, Debug, Default)]
pub(crate) struct DeadEnds {
    marks: Vec<Anchored<Mark>>,
}

/// A way that was tried and is closed.
#[derive(Clone, Copy, Debug)]
struct Mark {
    /// The line across it, metres.
    across: Segment,
    /// The direction in which it was tried, a unit vector.
    along: DVec2,
}

impl DeadEnds {
    /// Whether a way leads through a known dead end.
    pub(crate) fn bar(&self, way: &[DVec2], atlas: &Atlas) -> bool {
        let mut legs = way.windows(2).map(|ends| Segment::new(ends[0], ends[1]));
        legs.any(|leg| self.here(atlas).any(|mark| mark.bars(leg)))
    }

    /// Remembers that a way was found closed where a disc on it touches something; what is known of the
    /// surroundings says how wide.
    pub(crate) fn remember(&mut self, closed: Closed, surroundings: &Surroundings, atlas: &Atlas) {
        let Closed { at, along, radius } = closed;
        let (across, front) = (along.perp(), at + along * radius);
        let blocked = |side: f64, k: u32| {
            let beside = across * (side * FEEL * f64::from(k));
            let way = Segment::new(at + beside - along * radius, at + beside + along * (2.0 * radius));
            !surroundings.leave_free(way, radius)
        };
        let [left, right] = [1.0, -1.0].map(|side| {
            let wide = (1..=FEELS).take_while(|&k| blocked(side, k)).last().unwrap_or(0);
            front + across * (side * FEEL * f64::from(wide))
        });
        self.marks.push(atlas.keep(Mark { across: Segment::new(left, right), along }));
    }

    /// New evidence: a mark that the present view sees through was wrong, or the way is open again.
    pub(crate) fn look_again(&mut self, view: &[DVec2], here_from_robot: Pose, atlas: &Atlas) {
        self.marks.retain(|&mark| {
            let Some(frame) = atlas.here_from(mark.frame) else { return true };
            let seen = here_from_robot.inverse() * (frame * mark.value.across).midpoint();
            let in_view = trig::atan2(seen.y, seen.x).abs() < IN_VIEW && seen.length() < REVISIT;
            let through = Segment::new(DVec2::ZERO, seen * (1.0 + BEYOND / seen.length().max(BEYOND)));
            !in_view || view.iter().any(|&point| through.distance_to(point) < FEEL)
        });
    }

    fn here<'a>(&'a self, atlas: &'a Atlas) -> impl Iterator<Item = Mark> + 'a {
        self.marks.iter().filter_map(|mark| {
            let frame = atlas.here_from(mark.frame)?;
            Some(Mark { across: frame * mark.value.across, along: frame.rotate(mark.value.along) })
        })
    }
}

impl Mark {
    /// Whether a leg crosses it in about the direction that was tried.
    fn bars(self, leg: Segment) -> bool {
        let alike = leg.direction().is_some_and(|direction| direction.dot(self.along) >= ALIKE);
        alike && self.across.crossing(leg).is_some()
    }
}

/// Where a tried way turned out closed.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Closed {
    /// Where a disc on it first touches something.
    pub(crate) at: DVec2,
    /// The direction of the way there, a unit vector.
    pub(crate) along: DVec2,
    /// The disc's, metres.
    pub(crate) radius: f64,
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A bay open to the west: two sides and an end, and the way that was tried into it.
    fn bay() -> (Surroundings, Closed) {
        let wall = |x1, y1, x2, y2| Segment::new(DVec2::new(x1, y1), DVec2::new(x2, y2));
        let surfaces = vec![wall(0.0, -1.5, 9.0, -1.5), wall(9.0, -1.5, 9.0, 1.5), wall(9.0, 1.5, 0.0, 1.5)];
        let closed = Closed { at: DVec2::new(8.75, 0.2), along: DVec2::X, radius: 0.25 };
        (Surroundings { surfaces, points: Vec::new() }, closed)
    }

    fn marked() -> (DeadEnds, Atlas) {
        let (bay, closed) = bay();
        let (mut dead_ends, atlas) = (DeadEnds::default(), Atlas::single());
        dead_ends.remember(closed, &bay, &atlas);
        (dead_ends, atlas)
    }

    #[test]
    fn a_dead_end_is_barred_on_its_whole_width_and_no_farther() {
        let (dead_ends, atlas) = marked();
        for y in [-1.4, 0.0, 1.4] {
            assert!(dead_ends.bar(&[DVec2::new(-2.0, y), DVec2::new(20.0, y)], &atlas), "{y}");
        }
        assert!(!dead_ends.bar(&[DVec2::new(-2.0, 3.0), DVec2::new(20.0, 3.0)], &atlas));
    }

    #[test]
    fn what_is_seen_through_is_no_dead_end() {
        let (mut dead_ends, atlas) = marked();
        let before = Pose::new(6.0, 0.0, 0.0);
        dead_ends.look_again(&[DVec2::new(3.0, 0.05)], before, &atlas);
        let way = [DVec2::ZERO, DVec2::new(20.0, 0.0)];
        assert!(dead_ends.bar(&way, &atlas), "the end is still seen");
        dead_ends.look_again(&[DVec2::new(3.0, 1.5)], before, &atlas);
        assert!(!dead_ends.bar(&way, &atlas), "somebody took the end away");
    }
}
