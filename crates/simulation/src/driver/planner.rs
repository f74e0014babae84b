use cogmap_geometry::{DVec2, Segment};

use super::{lattice::Lattice, search::Search};
use crate::{Obstacles, Solids, World};

/// How far the person keeps the robot from everything, metres.
pub(super) const CLEARANCE: f64 = 0.05;
/// How much wider than that a way must be for the errors of the smallest steps, metres.
const SPARE: f64 = 0.02;
/// Where there is room, the person keeps so much more, metres.
const COMFORT: f64 = 0.25;
/// Within this distance of where it stands the robot may stay as close to things as it is, metres.
const LEEWAY: f64 = 0.5;
/// How many solids are looked at before a building counts as too intricate to plan in.
const PATIENCE: u64 = 60_000_000;

/// Finds ways for a round robot through a building that it knows exactly.
#[derive(Clone)]
pub(crate) struct Planner {
    pub(super) obstacles: Obstacles,
    pub(super) lattice: Lattice,
    /// What the middle of the robot keeps from everything, metres.
    pub(super) keep: f64,
    /// Metres from a cell's middle to the nearest solid, up to what is comfortable; NaN: not yet known.
    room: Vec<f32>,
    patience: u64,
}

impl Planner {
    /// A planner for a robot of a radius, metres, in a world and as far as a route leads.
    pub(crate) fn new(world: &World, route: &[DVec2], radius: f64) -> Self {
        Self::keeping(radius + CLEARANCE + SPARE, world, route)
    }

    /// A planner that keeps a robot's middle so far from everything, metres.
    pub(super) fn keeping(keep: f64, world: &World, route: &[DVec2]) -> Self {
        let obstacles = Obstacles::new(&Solids::of(world));
        let start = DVec2::from(world.start.position);
        let finite = route.iter().copied().filter(|point| point.is_finite());
        let known = finite.chain(obstacles.bounds().into_iter().flatten());
        let (low, high) = known.fold((start, start), |(low, high), p| (low.min(p), high.max(p)));
        let lattice = Lattice::over(low - 1.0, high + 1.0);
        let room = vec![f32::NAN; lattice.cells()];
        Self { obstacles, lattice, keep, room, patience: PATIENCE }
    }

    /// The same planner in the same building, which was changed meanwhile.
    pub(super) fn within(&self, world: &World) -> Self {
        let obstacles = Obstacles::new(&Solids::of(world));
        let room = vec![f32::NAN; self.lattice.cells()];
        Self { obstacles, lattice: self.lattice.clone(), keep: self.keep, room, patience: PATIENCE }
    }

    /// The points to pass on the way, the last being `to` itself: only that one where the straight
    /// way is free. An error says what is wrong with `to`.
    pub(crate) fn way(&mut self, from: DVec2, to: DVec2) -> Result<Vec<DVec2>, String> {
        if !to.is_finite() {
            return Err("is not a place: expected two numbers".to_owned());
        }
        if let Some(nearest) = self.obstacles.nearest(to, self.keep) {
            let [x, y] = nearest.point.to_array();
            let (gap, keep) = (nearest.distance.max(0.0), self.keep);
            return Err(format!(
                "is {gap:.2} m from a solid at [{x:.2}, {y:.2}], and the robot keeps {keep:.2} m: move the point"
            ));
        }
        if self.free(Segment::new(from, to), self.keep) {
            return Ok(vec![to]);
        }
        let way = Search::new(self, from).to(to);
        way.map(|way| self.pull_tight(&way)).ok_or_else(|| match self.patience {
            0 => "lies in a world too intricate to plan through: leave some solids out".to_owned(),
            _ => "cannot be reached from the point before: open a door, widen a gap or move the point"
                .to_owned(),
        })
    }

    /// All that can be reached from a point on ways of at most `length` metres: places a cell apart,
    /// nearest first.
    pub(crate) fn reachable(&mut self, from: DVec2, length: f64) -> Vec<DVec2> {
        Search::new(self, from).all_within(length)
    }

    /// Whether the robot can go straight between two points, from where it may stand close to things.
    pub(super) fn leads_free(&mut self, from: DVec2, to: DVec2) -> bool {
        let keep = self.keep.min(self.room_at(from) - 0.001);
        self.free(Segment::new(from, to), keep)
    }

    /// Whether a point lies about the building and leaves the robot room.
    pub(super) fn has_place(&self, point: DVec2) -> bool {
        self.lattice.at(point).is_some() && self.obstacles.nearest(point, self.keep).is_none()
    }

    /// Metres to the nearest solid, at most what is comfortable.
    pub(crate) fn room_at(&self, point: DVec2) -> f64 {
        let comfort = self.keep + COMFORT;
        self.obstacles.nearest(point, comfort).map_or(comfort, |nearest| nearest.distance)
    }

    /// What the robot keeps from everything at a point on a way that begins at `from`, where it may
    /// stand closer than it should.
    pub(super) fn kept_at(&self, point: DVec2, from: DVec2, room_at_start: f64) -> f64 {
        if point.distance(from) < LEEWAY { self.keep.min(room_at_start) } else { self.keep }
    }

    /// The room around a cell's middle, metres, at most what is comfortable.
    pub(super) fn room(&mut self, cell: usize) -> f64 {
        let Some(known) = self.room.get(cell).copied() else { return 0.0 };
        if !known.is_nan() {
            return f64::from(known);
        }
        let room = self.measure(self.lattice.middle(cell));
        if let Some(known) = self.room.get_mut(cell) {
            *known = room as f32;
        }
        room
    }

    fn measure(&mut self, middle: DVec2) -> f64 {
        let mut room = self.keep + COMFORT;
        for (_, solid) in self.obstacles.around(middle - room, middle + room) {
            self.patience = self.patience.saturating_sub(1);
            room = room.min(solid.nearest(middle).0);
            if self.patience == 0 || room <= 0.0 {
                return 0.0;
            }
        }
        room
    }

    /// Whether the robot's middle can go straight and keep its distance everywhere.
    pub(super) fn free(&mut self, way: Segment, keep: f64) -> bool {
        let (low, high) = (way.a.min(way.b) - keep, way.a.max(way.b) + keep);
        for (_, solid) in self.obstacles.around(low, high) {
            self.patience = self.patience.saturating_sub(1);
            if self.patience == 0 || solid.distance_to(way) < keep {
                return false;
            }
        }
        true
    }

    /// Does some work; whether patience is left for more.
    pub(super) fn tire(&mut self, work: u64) -> bool {
        self.patience = self.patience.saturating_sub(work);
        self.patience > 0
    }

    /// Begins with fresh patience.
    pub(crate) fn rest(&mut self) {
        self.patience = PATIENCE;
    }

    /// How inconvenient it is to be so near to things: 1 where there is ample room.
    pub(super) fn burden(&self, room: f64) -> f64 {
        1.0 + 3.0 * ((self.keep + COMFORT - room) / COMFORT).clamp(0.0, 1.0)
    }

    /// Leaves out the points of a way that a straight line makes needless, as long as that line has
    /// no less room than the points; the first point is where the way begins.
    fn pull_tight(&mut self, way: &[DVec2]) -> Vec<DVec2> {
        let mut tight = Vec::new();
        let (Some(&start), Some(&end)) = (way.first(), way.last()) else { return tight };
        let room: Vec<f64> = way.iter().map(|&point| self.room_at(point)).collect();
        let (mut anchor, mut least) = (start, f64::INFINITY);
        for (pair, rooms) in way.windows(2).zip(room.windows(2)) {
            let (&[here, next], &[room_here, room_next]) = (pair, rooms) else { continue };
            least = least.min(room_here).min(room_next);
            let keep = self.keep.min(least).max(least - 0.01);
            if here != anchor && !self.free(Segment::new(anchor, next), keep) {
                tight.push(here);
                (anchor, least) = (here, room_here.min(room_next));
            }
        }
        tight.push(end);
        tight
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn world(walls: &str) -> World {
        let text = format!(
            r#"{{"format": "cogmap-world/1", "name": "test", "start": {{"position": [0, 0]}}, "walls": {walls}}}"#
        );
        serde_json::from_str(&text).unwrap()
    }

    #[test]
    fn a_free_straight_way_has_no_points_to_pass() {
        let mut planner = Planner::new(&world("[[[0, 1], [5, 1]]]"), &[], 0.25);
        assert_eq!(planner.way(DVec2::ZERO, DVec2::new(5.0, 0.0)), Ok(vec![DVec2::new(5.0, 0.0)]));
    }

    #[test]
    fn the_way_around_a_wall_keeps_its_distance_and_turns_seldom() {
        let mut planner = Planner::new(&world("[[[2, -1.5], [2, 4]], [[-2, 4], [6, 4]]]"), &[], 0.25);
        let way = planner.way(DVec2::ZERO, DVec2::new(4.0, 0.0)).unwrap();
        assert!((3..=6).contains(&way.len()), "{way:?}");
        let mut from = DVec2::ZERO;
        for to in way {
            assert!(planner.obstacles.leaves_free(Segment::new(from, to), 0.32 - 1e-6), "{from} {to}");
            from = to;
        }
    }

    #[test]
    fn a_doorway_of_80_centimetres_is_wide_enough_and_one_of_55_is_not() {
        for (half, passes) in [(0.4, true), (0.275, false)] {
            let walls = format!(
                "[[[2, -9], [2, {}]], [[2, {half}], [2, 9]], [[-9,-9],[9,-9],[9,9],[-9,9],[-9,-9]]]",
                -half
            );
            let mut planner = Planner::new(&world(&walls), &[], 0.25);
            let way = planner.way(DVec2::new(0.0, 3.0), DVec2::new(4.0, 3.0));
            assert_eq!(way.is_ok(), passes);
            assert!(way.is_ok() || way.unwrap_err().contains("cannot be reached"));
        }
    }

    #[test]
    fn a_heap_of_walls_ends_the_search_in_time() {
        let heap = (0..4000).map(|k| format!("[[-9, {0}], [9, -{0}]]", f64::from(k) / 900.0));
        let walls = format!("[{}]", heap.collect::<Vec<_>>().join(","));
        let mut planner = Planner::new(&world(&walls), &[], 0.25);
        assert!(planner.way(DVec2::new(0.0, -8.0), DVec2::new(0.0, 8.0)).is_err());
    }
}
