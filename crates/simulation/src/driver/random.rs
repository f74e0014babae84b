use cogmap_geometry::DVec2;
use rand_core::SeedableRng;
use rand_pcg::Pcg64Mcg;

use super::planner::Planner;
use crate::{Robot, World, chance};

/// How long a random route may be, metres.
const LENGTHS: [f64; 2] = [10.0, 60.0];
/// How far from its start it ends at least, metres.
pub(crate) const AWAY: f64 = 6.0;
/// Its points lie at most so far apart, metres: a step of the thesis's long drives.
const STEP: f64 = 0.85;
/// The room that the places to visit have around them besides the robot's own, metres.
pub(crate) const AMPLE: f64 = 0.15;
/// How many ways are begun, and how many places are drawn for each, before giving up.
const TRIES: usize = 20;

/// A route through places drawn at random, 10–60 m long, that ends at least 6 m from the start: the
/// same for the same seed.
pub fn random_route(world: &World, robot: &Robot, seed: u64) -> Result<Vec<DVec2>, String> {
    let mut planner = Planner::new(world, &[], robot.body.radius);
    let start = DVec2::from(world.start.position);
    let mut places = planner.reachable(start, LENGTHS[1]);
    places.retain(|&place| planner.room_at(place) >= robot.body.radius + AMPLE);
    let mut rng = Pcg64Mcg::seed_from_u64(seed);
    let ends: Vec<DVec2> = places.iter().copied().filter(|place| place.distance(start) >= AWAY).collect();
    let tour = (0..if ends.is_empty() { 0 } else { TRIES }).find_map(|_| {
        planner.rest();
        let tour = Tour::through(&places, &mut planner, start, &mut rng);
        tour.extended(draw(&ends, &mut rng), &mut planner).filter(Tour::is_fitting)
    });
    tour.map(|tour| tour.in_steps()).ok_or_else(|| {
        format!("found no way of 10 to 60 m that ends {AWAY} m from the start: choose a route of your own")
    })
}

fn draw(places: &[DVec2], rng: &mut Pcg64Mcg) -> Option<DVec2> {
    places.get((chance::uniform(rng) * places.len() as f64) as usize).copied()
}

/// A way under construction.
#[derive(Clone)]
pub(crate) struct Tour {
    length: f64,
    pub(crate) points: Vec<DVec2>,
}

impl Tour {
    /// A way that has only just begun.
    pub(crate) fn from(start: DVec2) -> Self {
        Self { length: 0.0, points: vec![start] }
    }

    /// Visits places drawn at random until it is as long as it was drawn to be.
    fn through(places: &[DVec2], planner: &mut Planner, start: DVec2, rng: &mut Pcg64Mcg) -> Self {
        let wanted = LENGTHS[1] * 0.8 * chance::uniform(rng);
        let mut tour = Self::from(start);
        for _ in 0..TRIES {
            let longer = tour.extended(draw(places, rng), planner);
            tour = longer.filter(|tour| tour.length <= LENGTHS[1]).unwrap_or(tour);
            if tour.length >= wanted {
                break;
            }
        }
        tour
    }

    /// Whether it is as long as an outing should be.
    pub(crate) fn is_fitting(&self) -> bool {
        (LENGTHS[0]..=LENGTHS[1]).contains(&self.length)
    }

    /// The same and on to a place; `None` where nothing leads there.
    pub(crate) fn extended(&self, to: Option<DVec2>, planner: &mut Planner) -> Option<Self> {
        let mut tour = self.clone();
        for point in planner.way(*tour.points.last()?, to?).ok()? {
            tour.length += tour.points.last()?.distance(point);
            tour.points.push(point);
        }
        Some(tour)
    }

    /// Its points after the start, with others between so that none is more than a step from the next.
    pub(crate) fn in_steps(&self) -> Vec<DVec2> {
        let legs = self.points.iter().zip(self.points.iter().skip(1));
        let split = legs.flat_map(|(&from, &to)| {
            let steps = (from.distance(to) / STEP).ceil().max(1.0);
            (1..=steps as u32).map(move |k| from.lerp(to, f64::from(k) / steps))
        });
        split.collect()
    }
}
