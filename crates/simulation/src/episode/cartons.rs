use cogmap_geometry::{DVec2, Segment, trig};

use super::{
    apply,
    reach::{Reach, legs},
};
use crate::{BoxObstacle, Obstacles, Solids, World, WorldChange, dice::Dice};

/// Sides of a carton, metres.
const CARTON: [f64; 2] = [0.32, 0.58];
/// How far cartons are put down from where the robot stands, and from where it began, metres.
const AWAY: [f64; 2] = [2.2, 1.6];
/// How many spots are tried.
const TRIES: usize = 24;
/// How far the cartons of a narrow course reach to either side of the way, metres.
const COURSE: f64 = 1.7;

/// Two to four cartons on the way that was come.
pub(super) fn dropped(world: &World, route: &[DVec2], dice: &mut Dice) -> Option<Vec<WorldChange>> {
    let wanted = dice.between(2, 4) as usize;
    let mut after = world.clone();
    let mut changes = Vec::new();
    for _ in 0..TRIES {
        let Some(spot) = spot(&after, route, dice) else { continue };
        let size = [(); 2].map(|()| centimetres(dice.within(CARTON[0], CARTON[1])));
        let change = WorldChange::AddBox { center: spot, size, heading_deg: dice.within(0.0, 180.0).round() };
        keep_if_passable(&mut after, change, route, &mut changes);
        if changes.len() == wanted {
            break;
        }
    }
    (!changes.is_empty()).then_some(changes)
}

/// Up to four pieces of furniture from beside the way, on it.
pub(super) fn moved(world: &World, route: &[DVec2], dice: &mut Dice) -> Option<Vec<WorldChange>> {
    let near = |carton: &BoxObstacle| {
        let center = DVec2::from(carton.center);
        let thick = carton.size[0].min(carton.size[1]) >= 0.25 && carton.size[0].max(carton.size[1]) <= 1.3;
        thick && route.iter().any(|point| point.distance(center) < 3.5)
    };
    let movable = (0..world.boxes.len()).filter(|&index| near(&world.boxes[index])).collect();
    let (mut after, mut changes) = (world.clone(), Vec::new());
    for index in dice.shuffled::<usize>(movable).into_iter().take(TRIES) {
        let center = DVec2::from(world.boxes[index].center);
        let about: Vec<DVec2> = route.iter().copied().filter(|point| point.distance(center) < 4.0).collect();
        let Some(spot) = spot_of(&after, route, dice.pick(&about)?, dice) else { continue };
        let heading_deg = (world.boxes[index].heading_deg + dice.within(-90.0, 90.0)).round();
        let change = WorldChange::MoveBox { index, center: spot, heading_deg };
        keep_if_passable(&mut after, change, route, &mut changes);
        if changes.len() == 4 {
            break;
        }
    }
    (!changes.is_empty()).then_some(changes)
}

fn keep_if_passable(after: &mut World, change: WorldChange, route: &[DVec2], changes: &mut Vec<WorldChange>) {
    let mut next = after.clone();
    apply(&mut next, &change);
    let Some(&end) = route.last() else { return };
    if Reach::AMPLE.leads(&next, end, next.start.position.into()) {
        *after = next;
        changes.push(change);
    }
}

/// A spot on the way for a carton.
fn spot(world: &World, route: &[DVec2], dice: &mut Dice) -> Option<[f64; 2]> {
    let on_the_way = dice.pick(route)?;
    spot_of(world, route, on_the_way, dice)
}

/// A spot near a point of the way, free, and neither where the robot stands nor where it began.
fn spot_of(world: &World, route: &[DVec2], point: DVec2, dice: &mut Dice) -> Option<[f64; 2]> {
    let spot = point + DVec2::new(dice.within(-0.3, 0.3), dice.within(-0.3, 0.3));
    let (end, start) = (*route.last()?, DVec2::from(world.start.position));
    let away = spot.distance(end) > AWAY[0] && spot.distance(start) > AWAY[1];
    let free = Obstacles::new(&Solids::of(world)).nearest(spot, 0.3).is_none();
    (away && free).then_some(spot.to_array().map(centimetres))
}

/// Cartons on both sides of a stretch of 4 to 7 m, so dense that only the way itself is left.
pub(super) fn course(world: &World, route: &[DVec2], dice: &mut Dice) -> Option<Vec<BoxObstacle>> {
    let (gap, length) = (dice.within(0.75, 0.9), dice.between(5, 8) as usize);
    let (start, end) = (DVec2::from(world.start.position), *route.last()?);
    let stretches = route.windows(length).filter(|stretch| {
        stretch.iter().all(|point| point.distance(start) > 1.6 && point.distance(end) > 1.6)
    });
    let stretches: Vec<&[DVec2]> = stretches.collect();
    (0..TRIES).find_map(|_| {
        let stretch = dice.pick(&stretches)?;
        let cartons = beside(world, route, stretch, gap, dice);
        let mut after = world.clone();
        after.boxes.extend(cartons.iter().cloned());
        let enough = cartons.len() >= length;
        (enough && Reach::AMPLE.leads(&after, end, start)).then_some(cartons)
    })
}

/// Cartons wherever there is room for one beside a stretch, and none on any part of the way.
fn beside(world: &World, route: &[DVec2], stretch: &[DVec2], gap: f64, dice: &mut Dice) -> Vec<BoxObstacle> {
    let obstacles = Obstacles::new(&Solids::of(world));
    let mut cartons: Vec<BoxObstacle> = Vec::new();
    let start = DVec2::from(world.start.position);
    for _ in 0..stretch.len() * 90 {
        let Some(point) = dice.pick(stretch) else { break };
        let side = centimetres(dice.within(CARTON[0], 0.45));
        let (sin, cos) = trig::sin_cos(dice.within(0.0, trig::TAU));
        // Half a diagonal, so that the carton may be turned as it likes.
        let reach = side * 0.708;
        let away = gap / 2.0 + reach + dice.within(0.0, COURSE);
        let center = (point + DVec2::new(cos, sin) * away).to_array().map(centimetres);
        let spot = DVec2::from(center);
        let clear = legs(start, route).all(|leg| leg.distance_to(spot) >= gap / 2.0 + reach);
        let apart = cartons.iter().all(|other| DVec2::from(other.center).distance(spot) > 2.0 * reach);
        let in_sight = obstacles.leaves_free(Segment::new(point, spot), 0.05);
        if clear && apart && in_sight && obstacles.nearest(spot, reach * 0.8).is_none() {
            let heading_deg = dice.within(0.0, 90.0).round();
            cartons.push(BoxObstacle { center, size: [side, side], heading_deg });
        }
    }
    cartons
}

fn centimetres(metres: f64) -> f64 {
    (metres * 100.0).round() / 100.0
}
