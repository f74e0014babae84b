use cogmap_geometry::{DVec2, Segment};

use super::reach::legs;
use crate::{Obstacles, Person, Solids, World, WorldChange, dice::Dice};

/// How far from the robot's first and last spot people keep, metres.
const AWAY: f64 = 2.0;
/// How far apart people stand when they come, metres.
const APART: f64 = 0.6;
/// How much room somebody needs around the middle, metres.
const ROOM: f64 = 0.35;
/// How far somebody walks to either side at most, metres.
const FAR: f64 = 4.0;
/// Shorter paths are not worth walking, metres.
const SHORT: f64 = 2.5;
/// How many spots are tried.
const TRIES: usize = 30;

/// One to three people who walk across the way where there is room, else along it, keeping to one side.
pub(super) fn crossing(world: &World, route: &[DVec2], dice: &mut Dice) -> Option<Vec<WorldChange>> {
    let obstacles = Obstacles::new(&Solids::of(world));
    let (start, end) = (DVec2::from(world.start.position), *route.last()?);
    let legs: Vec<Segment> = legs(start, route).collect();
    let wanted = dice.between(1, 3) as usize;
    let mut people: Vec<Person> = Vec::new();
    for _ in 0..TRIES {
        let leg = dice.pick(&legs)?;
        let (middle, Some(ahead)) = (leg.midpoint(), leg.direction()) else { continue };
        let sideways = if dice.falls(50) { ahead.perp() } else { -ahead.perp() };
        let across = path(&obstacles, middle, sideways);
        let aside = farthest(&obstacles, middle, sideways);
        let path = across.or_else(|| path(&obstacles, aside, ahead));
        let free = |path: &[DVec2; 2]| {
            let way = Segment::new(path[0], path[1]);
            [start, end].iter().all(|&spot| way.distance_to(spot) > AWAY)
        };
        let Some(path) = path.filter(free) else { continue };
        let path = path.map(|spot| spot.to_array().map(centimetres)).to_vec();
        let comes = DVec2::from(path[0]);
        if people.iter().any(|other| comes.distance(other.path[0].into()) < APART) {
            continue;
        }
        let (speed, radius) = (centimetres(dice.within(0.5, 1.1)), centimetres(dice.within(0.2, 0.26)));
        people.push(Person { path, speed, radius });
        if people.len() == wanted {
            break;
        }
    }
    (!people.is_empty()).then(|| people.into_iter().map(WorldChange::AddPerson).collect())
}

fn centimetres(metres: f64) -> f64 {
    (metres * 100.0).round() / 100.0
}

/// The ends of a path through a spot, where there is room for one that is worth walking.
fn path(obstacles: &Obstacles, spot: DVec2, direction: DVec2) -> Option<[DVec2; 2]> {
    let ends = [1.0, -1.0].map(|side| farthest(obstacles, spot, direction * side));
    (ends[0].distance(ends[1]) >= SHORT).then_some(ends)
}

/// The last spot in a direction that leaves room for somebody all the way.
fn farthest(obstacles: &Obstacles, from: DVec2, direction: DVec2) -> DVec2 {
    let mut reach = 0.0;
    while reach < FAR && obstacles.nearest(from + direction * (reach + 0.1), ROOM).is_none() {
        reach += 0.1;
    }
    from + direction * reach
}
