use cogmap_geometry::{DVec2, Segment};

use super::reach::legs;
use crate::{Obstacles, Person, Solids, World, dice::Dice};

/// How far from the robot's first and last spot people keep, metres.
const AWAY: f64 = 2.0;
/// How much room somebody needs around the middle, metres.
const ROOM: f64 = 0.35;
/// How far somebody walks to either side of the way at most, metres.
const FAR: f64 = 4.0;
/// How many crossings are tried.
const TRIES: usize = 30;

/// One to three people whose paths cross the way at right angles, as far as there is room.
pub(super) fn crossing(world: &World, route: &[DVec2], dice: &mut Dice) -> Option<Vec<Person>> {
    let obstacles = Obstacles::new(&Solids::of(world));
    let (start, end) = (DVec2::from(world.start.position), *route.last()?);
    let legs: Vec<Segment> = legs(start, route).collect();
    let wanted = dice.between(1, 3) as usize;
    let mut people: Vec<Person> = Vec::new();
    for _ in 0..TRIES {
        let leg = dice.pick(&legs)?;
        let (middle, Some(ahead)) = (leg.midpoint(), leg.direction()) else { continue };
        if middle.distance(start) < AWAY || middle.distance(end) < AWAY || people.len() == wanted {
            continue;
        }
        let ends = [1.0, -1.0].map(|side| farthest(&obstacles, middle, ahead.perp() * side));
        if ends[0].distance(ends[1]) < 1.5 || ends.iter().any(|spot| spot.distance(start) < 1.0) {
            continue;
        }
        let path = ends.map(|spot| spot.to_array().map(|c| (c * 100.0).round() / 100.0)).to_vec();
        let (speed, radius) = (dice.within(0.5, 1.1), dice.within(0.2, 0.26));
        people.push(Person {
            path,
            speed: (speed * 100.0).round() / 100.0,
            radius: (radius * 100.0).round() / 100.0,
        });
    }
    (!people.is_empty()).then_some(people)
}

/// The last spot in a direction that leaves room for somebody all the way.
fn farthest(obstacles: &Obstacles, from: DVec2, direction: DVec2) -> DVec2 {
    let mut reach = 0.0;
    while reach < FAR && obstacles.nearest(from + direction * (reach + 0.1), ROOM).is_none() {
        reach += 0.1;
    }
    from + direction * reach
}
