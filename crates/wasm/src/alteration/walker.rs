use cogmap_geometry::{
    DVec2, Segment,
    trig::{self, PI},
};
use cogmap_simulation::{Command, Fan, Person, RayGrid, Session, Solids, WorldChange};

use super::{Objection, to_millimetres};

/// Metres per second of somebody who strolls, and metres from their middle to their elbows.
const SPEED: f64 = 0.8;
const RADIUS: f64 = 0.25;
/// Somebody walks no less than this to and fro, metres, …
const SHORTEST: f64 = 1.0;
/// … no farther than this from where they came, …
const FARTHEST: f64 = 4.0;
/// … and keeps so far from what stands at the ends.
const CLEAR: f64 = 0.5;
/// In so many directions a way for them is looked for.
const WAYS: usize = 24;

/// Somebody who comes to a point and walks to and fro along the longest free stretch that leads through it.
pub(super) fn walker(session: &Session, at: DVec2) -> Result<Command, Objection> {
    let walk = session.solids().and_then(|solids| longest(solids, at)).ok_or_else(|| Objection::Person {
        reason: format!("there is no room to walk {SHORTEST} m to and fro"),
    })?;
    // They come where the person points, and go to one end first.
    let path = [at, walk.a, walk.b].map(to_millimetres).to_vec();
    Ok(Command::Change(WorldChange::AddPerson(Person { path, speed: SPEED, radius: RADIUS })))
}

/// The longest free stretch through a point; `None` where nobody fits in, or all are short.
fn longest(solids: &Solids, at: DVec2) -> Option<Segment> {
    let grid = RayGrid::new(&solids.segments, &solids.discs);
    let (beams, range_max) = (2 * WAYS, FARTHEST + CLEAR);
    let fan = Fan { origin: at, heading: 0.0, spacing: PI / WAYS as f64, beams, range_max };
    let mut hits = Vec::new();
    grid.cast_with(&fan, &solids.added, &[], &mut hits);
    let ranges: Vec<f64> = hits.iter().map(|hit| hit.map_or(range_max, |hit| hit.range)).collect();
    if ranges.iter().any(|&range| range < RADIUS) {
        return None;
    }
    let end = |beam: usize| {
        let (sin, cos) = trig::sin_cos(fan.spacing * beam as f64);
        at + DVec2::new(cos, sin) * (ranges[beam] - CLEAR).max(0.0)
    };
    let walks = (0..WAYS).map(|way| Segment::new(end(way), end(way + WAYS)));
    walks
        .filter(|walk| walk.length() >= SHORTEST)
        .max_by(|one, other| one.length().total_cmp(&other.length()))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A room of 10 m × 2 m.
    fn room() -> Solids {
        let world = r#"{ "format": "cogmap-world/1", "name": "Room", "start": {"position": [1, 1]},
            "walls": [[[0,0],[10,0],[10,2],[0,2],[0,0]]] }"#;
        Solids::of(&cogmap_formats::world::read(world, "room").unwrap())
    }

    #[test]
    fn somebody_walks_along_a_room_and_keeps_off_its_walls() {
        let walk = longest(&room(), DVec2::new(3.0, 1.0)).unwrap();
        assert!((walk.length() - 6.5).abs() < 0.2, "2.5 m to the west, 4 m to the east: {walk:?}");
        assert!([walk.a, walk.b].iter().all(|end| (0.4..1.6).contains(&end.y)), "{walk:?}");
    }

    #[test]
    fn nobody_comes_into_a_wall_or_a_corner() {
        assert_eq!(longest(&room(), DVec2::new(5.0, 0.1)), None);
        assert_eq!(longest(&room(), DVec2::new(f64::NAN, 1.0)), None);
    }
}
