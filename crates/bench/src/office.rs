use cogmap_geometry::{
    DVec2, Segment,
    trig::{self, FRAC_PI_2, TAU},
};
use rand_core::{Rng, SeedableRng};
use rand_pcg::Pcg32;

/// Metres across a corridor.
const CORRIDOR: f64 = 2.0;
/// Metres from a corridor to a room's back wall.
const ROOM_DEPTH: f64 = 5.0;
/// Metres; a corridor with the rooms on both sides of it.
const WING: f64 = CORRIDOR + 2.0 * ROOM_DEPTH;
/// Metres of a door.
const DOOR: f64 = 0.9;
/// Metres along the corridor that a room takes on average.
const ROOM_WIDTH: f64 = 4.5;
/// Segments of a room on average: walls, door, furniture.
const ROOM_SEGMENTS: f64 = 12.0;
/// Metres of free space around a pose: more than half the depth of any furniture,
/// so that none lies inside some.
const CLEARANCE: f64 = 0.42;

/// Wings of rooms along corridors, doors open at any angle, furnished.
pub(crate) struct Office {
    pub(crate) segments: Vec<Segment>,
    size: DVec2,
    dice: Pcg32,
}

impl Office {
    /// An office of about so many segments, about as long as wide.
    pub(crate) fn new(segments: usize) -> Self {
        let rooms = segments as f64 / ROOM_SEGMENTS;
        let wings = (rooms * ROOM_WIDTH * 0.5 / WING).sqrt().round().max(1.0);
        let size = DVec2::new(CORRIDOR + rooms * ROOM_WIDTH * 0.5 / wings, wings * WING);
        let mut office = Self { segments: Vec::new(), size, dice: Pcg32::seed_from_u64(segments as u64) };
        office.outline();
        for wing in 0..wings as usize {
            office.wing(wing as f64 * WING);
        }
        office
    }

    /// A point clear of everything, and a heading.
    pub(crate) fn free_pose(&mut self) -> (DVec2, f64) {
        loop {
            let point = DVec2::new(self.between(0.0, self.size.x), self.between(0.0, self.size.y));
            if self.segments.iter().all(|segment| segment.distance_to(point) > CLEARANCE) {
                return (point, self.between(0.0, TAU));
            }
        }
    }

    fn outline(&mut self) {
        let (right, top) = (DVec2::new(self.size.x, 0.0), DVec2::new(0.0, self.size.y));
        self.wall(DVec2::ZERO, right);
        self.wall(top, self.size);
        self.wall(DVec2::ZERO, top);
        self.wall(right, self.size);
    }

    /// A corridor along x with rooms on both sides; a cross corridor joins all
    /// wings at x = 0.
    fn wing(&mut self, y: f64) {
        for (corridor_y, outwards) in [(y + ROOM_DEPTH, -1.0), (y + ROOM_DEPTH + CORRIDOR, 1.0)] {
            let mut x = CORRIDOR;
            while x < self.size.x {
                let left = self.size.x - x;
                let width = self.between(ROOM_WIDTH - 1.5, ROOM_WIDTH + 1.5);
                let width = if left < 1.7 * ROOM_WIDTH { left } else { width };
                self.room(DVec2::new(x, corridor_y), width, outwards);
                x += width;
            }
        }
    }

    /// A room with its corner at the corridor's wall; `outwards` is 1 where it
    /// lies above the corridor, -1 below.
    fn room(&mut self, corner: DVec2, width: f64, outwards: f64) {
        let depth = DVec2::new(0.0, ROOM_DEPTH * outwards);
        let far = corner + DVec2::new(width, 0.0);
        let hinge = corner + DVec2::new(self.between(0.2, width - DOOR - 0.2), 0.0);
        self.wall(corner, corner + depth);
        self.wall(corner, hinge);
        self.wall(hinge + DVec2::new(DOOR, 0.0), far);
        if outwards < 0.0 {
            self.wall(corner + depth, far + depth);
        }
        let angle = self.between(0.0, FRAC_PI_2) * outwards;
        self.wall(hinge, hinge + DVec2::new(trig::cos(angle), trig::sin(angle)) * DOOR);
        for _ in 0..self.between(1.0, 4.0) as usize {
            let across = DVec2::new(self.between(1.0, width - 1.0), 0.0);
            let center = corner + across + depth * self.between(0.3, 0.85);
            self.furniture(center);
        }
    }

    /// A cupboard, a table or a chair, mostly along the walls.
    fn furniture(&mut self, center: DVec2) {
        let sizes = [(1.2, 0.4), (1.6, 0.8), (0.5, 0.5)];
        let (long, deep) = sizes[self.between(0.0, sizes.len() as f64) as usize % sizes.len()];
        let askew = if self.between(0.0, 1.0) < 0.7 { 0.0 } else { self.between(-0.4, 0.4) };
        let angle = askew + self.between(0.0, 4.0).floor() * FRAC_PI_2;
        let along = DVec2::new(trig::cos(angle), trig::sin(angle)) * (long * 0.5);
        let aside = DVec2::new(-trig::sin(angle), trig::cos(angle)) * (deep * 0.5);
        let corners = [along + aside, aside - along, -along - aside, along - aside].map(|c| center + c);
        for k in 0..4 {
            self.wall(corners[k], corners[(k + 1) % 4]);
        }
    }

    fn wall(&mut self, a: DVec2, b: DVec2) {
        self.segments.push(Segment::new(a, b));
    }

    fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * (f64::from(self.dice.next_u32()) / 4_294_967_296.0)
    }
}
