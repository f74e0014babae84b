use cogmap_geometry::{DVec2, Segment};

use super::{Building, rect::metres, space::Space};
use crate::{
    BodyParams, Start, World,
    dice::Dice,
    driver::{AMPLE, AWAY, Planner, Tour},
};

/// How many outings are begun before the last resort.
const TRIES: usize = 60;
/// How many spots of a room are tried.
const SPOTS: usize = 12;

/// Where a robot begins, and where it is taken from there.
pub(super) struct Outing {
    pub(super) start: Start,
    /// Points after the start, a step of the thesis's long drives apart, metres.
    pub(super) route: Vec<[f64; 2]>,
}

impl Outing {
    /// A way of 10 to 60 m from one space by way of up to two others to a last one, through a door at
    /// least, that ends well away from where it began.
    pub(super) fn drawn(building: &Building, world: &World, dice: &mut Dice) -> Option<Self> {
        let mut planner = Planner::new(world, &[], BodyParams::default().radius);
        (0..TRIES).find_map(|_| {
            planner.rest();
            let start = spot(&building.spaces, &mut planner, dice)?;
            let mut tour = Tour::from(start);
            for _ in 0..dice.pick(&[1, 1, 2, 2, 3])? {
                let next = spot(&building.spaces, &mut planner, dice);
                tour = tour.extended(next, &mut planner)?;
            }
            let away = tour.points.last()?.distance(start) >= AWAY;
            if !(away && tour.is_fitting() && passes_a_door(building, &tour)) {
                return None;
            }
            let heading_deg = f64::from(dice.between(-179, 180));
            let route = tour.in_steps().into_iter().map(|point| point.to_array()).collect();
            Some(Self { start: Start { position: start.to_array(), heading_deg }, route })
        })
    }
}

/// A spot on whole centimetres with ample room around it, in a space drawn at random.
fn spot(spaces: &[Space], planner: &mut Planner, dice: &mut Dice) -> Option<DVec2> {
    let room = spaces.get(dice.between(0, spaces.len() as i32 - 1) as usize)?.rect;
    let ample = BodyParams::default().radius + AMPLE;
    (0..SPOTS).find_map(|_| {
        let point = [0, 1].map(|axis| dice.between(room.low[axis] + 40, room.high[axis] - 40));
        let point = DVec2::from(metres(point));
        (planner.room_at(point) >= ample).then_some(point)
    })
}

fn passes_a_door(building: &Building, tour: &Tour) -> bool {
    let legs = tour.points.iter().zip(tour.points.iter().skip(1)).map(|(&a, &b)| Segment::new(a, b));
    let leaves = building.doorways.iter().filter_map(|doorway| doorway.leaf.as_ref());
    let sills = leaves.map(|leaf| Segment::new(leaf.hinge.into(), leaf.latch.into()));
    let sills: Vec<Segment> = sills.collect();
    legs.into_iter().any(|leg| sills.iter().any(|sill| sill.crossing(leg).is_some()))
}
