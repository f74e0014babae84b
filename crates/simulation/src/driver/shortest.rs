use cogmap_geometry::{DVec2, Segment};

use super::{planner::Planner, search::Search};
use crate::World;

/// What the disc keeps from everything, so that touching counts as free, metres.
const TOUCH: f64 = -1e-4;
/// Each corner of a way is drawn toward the chord beside it so often …
const PASSES: usize = 12;
/// … by halves, down to this share.
const LEAST: f64 = 1e-3;

/// Metres of the shortest way of a disc's middle from one point to another, through a building as it is;
/// `None` where no way of about 5 cm more than its width leads there. It is found on a grid and then drawn
/// tight: never too short, a little too long at corners, and of two ways round something that differ by a few
/// per cent it may be the longer one.
#[must_use]
pub fn shortest_way(world: &World, radius: f64, from: DVec2, to: DVec2) -> Option<f64> {
    let mut planner = Planner::keeping(radius + TOUCH, world, &[from, to]);
    let keep = planner.keep.min(planner.room_at(from)).min(planner.room_at(to));
    if planner.free(Segment::new(from, to), keep - 1e-6) {
        return Some(from.distance(to));
    }
    let way = Search::new(&mut planner, from).for_shortest().to(to)?;
    let way = tighten(&mut planner, &way);
    Some(way.windows(2).map(|pair| pair[0].distance(pair[1])).sum())
}

/// Leaves out what straight lines can do without, and draws the corners that are left toward each other.
fn tighten(planner: &mut Planner, way: &[DVec2]) -> Vec<DVec2> {
    let mut way = straightened(planner, way);
    for _ in 0..PASSES {
        for k in 1..way.len().saturating_sub(1) {
            let (before, at, after) = (way[k - 1], way[k], way[k + 1]);
            let chord = Segment::new(before, after).closest_point(at);
            let mut share = 1.0;
            while share > LEAST {
                let moved = at.lerp(chord, share);
                if is_free(planner, before, moved) && is_free(planner, moved, after) {
                    way[k] = moved;
                    break;
                }
                share /= 2.0;
            }
        }
        way = straightened(planner, &way);
    }
    way
}

/// From each point on to the farthest that is seen from it.
fn straightened(planner: &mut Planner, way: &[DVec2]) -> Vec<DVec2> {
    let Some(&first) = way.first() else { return Vec::new() };
    let mut straight = vec![first];
    let mut at = 0;
    while at + 1 < way.len() {
        let beyond = (at + 2..way.len()).take_while(|&k| is_free(planner, way[at], way[k])).last();
        at = beyond.unwrap_or(at + 1);
        straight.push(way[at]);
    }
    straight
}

fn is_free(planner: &mut Planner, from: DVec2, to: DVec2) -> bool {
    planner.free(Segment::new(from, to), planner.keep)
}

#[cfg(test)]
mod tests {
    use cogmap_geometry::trig;

    use super::*;

    const RADIUS: f64 = 0.25;

    fn world(walls: &str) -> World {
        let text = format!(
            r#"{{"format": "cogmap-world/1", "name": "test", "start": {{"position": [0, 0]}}, "walls": {walls}}}"#
        );
        serde_json::from_str(&text).unwrap()
    }

    #[test]
    fn a_free_way_is_straight() {
        let way = shortest_way(&world("[[[0, 1], [5, 1]]]"), RADIUS, DVec2::ZERO, DVec2::new(3.0, -4.0));
        assert_eq!(way, Some(5.0));
    }

    #[test]
    fn around_the_end_of_a_wall_the_disc_rolls_on_it() {
        // Tangents to a circle around the wall's end, and the arc between: at most 1 % is lost to corners.
        let (from, to) = (DVec2::new(-2.0, -1.0), DVec2::new(2.0, -1.0));
        let way = shortest_way(&world("[[[0, -6], [0, 0]]]"), RADIUS, from, to).unwrap();
        let distance = from.length();
        let tangent = (distance * distance - RADIUS * RADIUS).sqrt();
        let turn = trig::atan2(1.0, 2.0) + trig::atan2(RADIUS, tangent);
        let exact = 2.0 * (tangent + RADIUS * turn);
        assert!(way >= exact - 1e-3 && way < 1.01 * exact, "{way} {exact}");
    }

    #[test]
    fn what_is_closed_has_no_way_and_a_gap_too_narrow_is_closed() {
        let room =
            |gap: f64| world(&format!("[[[-1, {gap}], [-1, 1], [1, 1], [1, -1], [-1, -1], [-1, -{gap}]]]"));
        let to = DVec2::new(-3.0, 0.5);
        assert_eq!(shortest_way(&room(0.2), RADIUS, DVec2::ZERO, to), None);
        let way = shortest_way(&room(0.35), RADIUS, DVec2::ZERO, to).unwrap();
        assert!((3.0..3.1).contains(&way), "{way}");
    }
}
