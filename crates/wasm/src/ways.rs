//! Ways that somebody draws into the world for the robot to follow.

use cogmap_geometry::{DVec2, Segment};
use cogmap_simulation::{Driver, Session, Source};
use serde::Serialize;
use tsify::Tsify;

/// How far a drawn line may be from the straight pieces that it becomes, metres.
const TOLERANCE: f64 = 0.1;
/// What lies this near to the robot at the beginning of a line is where it is already, metres.
const HERE: f64 = 0.35;
/// A line that begins this near to the robot was begun at the robot, which has moved since, metres.
const BEGUN: f64 = 1.5;
/// A way that is so much longer than what was drawn leads around something, metres.
const DETOUR: f64 = 0.5;
/// No hand draws more points; what follows is left out.
const POINTS_MAX: usize = 5000;

/// What becomes of a way that somebody drew.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Tsify)]
#[serde(tag = "kind", rename_all = "snake_case")]
pub enum Followed {
    /// The robot follows it.
    Going {
        /// How long it is, metres.
        metres: f64,
        /// Whether it leads around something that the line went through.
        around: bool,
    },
    /// Nowhere along the line has the robot room.
    NoRoom,
    /// A part of it cannot be reached.
    Unreachable,
    /// The line does not lead away from where the robot is.
    NoLine,
    /// Only a robot in a building can follow a way.
    NoBuilding,
}

/// Whoever drives a robot along a line, and what there is to say; an error says why nobody does.
pub(crate) fn driver(session: &Session, line: &[DVec2]) -> Result<(Driver, Followed), Followed> {
    let (Source::World { robot, .. }, Some(world), Some(pose)) =
        (&session.record().source, session.world(), session.world_from_robot())
    else {
        return Err(Followed::NoBuilding);
    };
    let from = pose.position;
    let line: Vec<_> = line.iter().copied().filter(|point| point.is_finite()).take(POINTS_MAX).collect();
    let line = simplified(line.get(joined(&line, from)..).unwrap_or_default());
    let begin = line.iter().position(|point| point.distance(from) > HERE).ok_or(Followed::NoLine)?;
    let line = line.get(begin..).unwrap_or_default();
    let driver = Driver::along(world, robot, from, line).map_err(|_| Followed::Unreachable)?;
    let driver = driver.ok_or(Followed::NoRoom)?;
    let metres = length(from, driver.ahead());
    let around = metres > length(from, line.iter().copied()) + DETOUR;
    Ok((driver, Followed::Going { metres, around }))
}

/// Where the robot, which moved while it was drawn, comes upon a line that was begun near it: at the point nearest to
/// it before the line leaves its surroundings.
fn joined(line: &[DVec2], from: DVec2) -> usize {
    let near = line.iter().map(|point| point.distance(from)).enumerate();
    let near = near.take_while(|(_, away)| *away < BEGUN);
    near.min_by(|(_, one), (_, other)| one.total_cmp(other)).map_or(0, |(index, _)| index)
}

/// Metres from a point along others.
pub(crate) fn length(from: DVec2, points: impl Iterator<Item = DVec2>) -> f64 {
    points.fold((0.0, from), |(sum, at), next| (sum + at.distance(next), next)).0
}

/// A line of as few points as stay near to it (Douglas–Peucker).
fn simplified(line: &[DVec2]) -> Vec<DVec2> {
    let Some(last) = line.len().checked_sub(1) else { return Vec::new() };
    let mut kept = vec![false; line.len()];
    let mut open = vec![[0, last]];
    while let Some([from, to]) = open.pop() {
        let (Some(a), Some(b)) = (line.get(from), line.get(to)) else { continue };
        let piece = Segment::new(*a, *b);
        let between = line.iter().enumerate().take(to).skip(from + 1);
        let away = between.map(|(index, point)| (index, piece.distance_to(*point)));
        let farthest = away.fold((from, TOLERANCE), |best, next| if next.1 > best.1 { next } else { best }).0;
        for end in [from, to] {
            kept[end] = true;
        }
        if farthest > from {
            open.extend([[from, farthest], [farthest, to]]);
        }
    }
    line.iter().zip(kept).filter_map(|(point, kept)| kept.then_some(*point)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_shaky_line_becomes_its_corners() {
        let shake = |step: u32| if step.is_multiple_of(2) { 0.03 } else { -0.03 };
        let right = (0..=40).map(|step| DVec2::new(f64::from(step) * 0.1, shake(step)));
        let up = (1..=30).map(|step| DVec2::new(4.0 + shake(step), f64::from(step) * 0.1));
        let line: Vec<_> = right.chain(up).collect();
        let few = simplified(&line);
        assert_eq!(few.len(), 3, "{few:?}");
        assert!(few[1].distance(DVec2::new(4.0, 0.0)) < 0.15);
        assert_eq!((few[0], few[2]), (line[0], line[70]));
        assert_eq!(simplified(&line[..1]), line[..1]);
        assert!(simplified(&[]).is_empty());
    }

    #[test]
    fn a_robot_that_moved_along_a_line_goes_on_from_where_it_is() {
        let line: Vec<_> = (0..100).map(|step| DVec2::new(f64::from(step) * 0.1, 0.2)).collect();
        assert_eq!(joined(&line, DVec2::new(1.0, 0.0)), 10);
        assert_eq!(joined(&line, DVec2::new(5.0, 0.0)), 0, "what begins far away is gone to");
        assert_eq!(joined(&[], DVec2::ZERO), 0);
    }

    #[test]
    fn a_way_is_as_long_as_its_pieces() {
        let points = [DVec2::new(3.0, 4.0), DVec2::new(3.0, 5.0)];
        assert_eq!(length(DVec2::ZERO, points.into_iter()), 6.0);
    }
}
