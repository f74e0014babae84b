use cogmap_geometry::{DVec2, Pose, Segment};

use super::tiles::{CELL, Cell, Tiles};

/// How far before what a beam hit the floor counts as seen free, metres.
const SHORT: f64 = 0.12;
/// Beams that tell of free floor: each so many.
const EVERY: usize = 2;
/// How much is found at a place before it counts as occupied, and the most that is counted.
const OCCUPIED: i8 = 2;
const MOST: i8 = 5;
/// How often a place is seen free on the whole before a remembered wall there is given up.
const LOOKED_THROUGH: i8 = -3;
/// The sine of the angle up to which a beam grazes a wall: 20°.
pub(super) const GRAZING: f64 = 0.34;
/// Occupied cells within this many of a cell are counted there: 0.4 m.
pub(super) const CROWD: i32 = 4;
/// Seen again after so many decisions, something counts as met again.
const AGAIN: u16 = 12;

/// What is known of a cell.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Spot {
    /// Above zero: scans have hit something there; below: they have looked through.
    evidence: i8,
    /// How often it was met occupied, with something else between.
    visits: u8,
    /// Occupied cells around.
    crowd: u8,
    marks: u8,
    /// When it was last found occupied, in decisions.
    met: u16,
    /// The last scan that told anything of it.
    scan: u16,
    /// Where in the cell something stands, from its middle, in shares of [`FINE`].
    at: [i8; 2],
    /// Along which the wall there runs, as a unit vector in shares of 127.
    along: [i8; 2],
}

/// What stands in a cell is known to lie at its middle and so many steps of a millimetre.
const FINE: f64 = 0.001;

const WALL: u8 = 1;
const TRAVELLED: u8 = 2;
const SEEN_FREE: u8 = 4;
const SHUT: u8 = 8;

impl Spot {
    /// Whether anything is believed to stand there.
    pub(super) fn is_occupied(self) -> bool {
        self.is_found() || self.marks & (WALL | SHUT) != 0
    }

    /// Whether scans say so, not only the map.
    pub(super) fn is_found(self) -> bool {
        self.evidence >= OCCUPIED
    }

    /// Whether the robot's middle has passed there.
    pub(super) fn is_travelled(self) -> bool {
        self.marks & TRAVELLED != 0
    }

    /// Whether it was seen free, or passed.
    pub(super) fn is_known_free(self) -> bool {
        self.marks & (TRAVELLED | SEEN_FREE) != 0
    }

    /// Whether another beam that passes would tell nothing new.
    fn is_plainly_free(self) -> bool {
        self.evidence == LOOKED_THROUGH && self.marks & (SEEN_FREE | WALL) == SEEN_FREE
    }

    /// Occupied cells within [`CROWD`].
    pub(super) fn crowd(self) -> u8 {
        self.crowd
    }

    /// Where in the cell something stands, from its middle, metres.
    pub(super) fn at(self) -> DVec2 {
        DVec2::new(f64::from(self.at[0]), f64::from(self.at[1])) * FINE
    }

    /// Whether a beam in that direction would have met what stands there: one along a wall tells nothing of it.
    fn is_crossed_by(self, beam: DVec2) -> bool {
        if self.marks & WALL == 0 {
            return true;
        }
        let along = DVec2::new(f64::from(self.along[0]), f64::from(self.along[1])) / 127.0;
        along.perp_dot(beam).abs() > GRAZING
    }

    #[allow(clippy::cast_possible_truncation, reason = "a share of 127 fits")]
    fn runs_along(&mut self, wall: Segment) {
        let along = wall.direction().unwrap_or_default() * 127.0;
        self.along = [along.x as i8, along.y as i8];
    }

    #[allow(clippy::cast_possible_truncation, reason = "a cell is 100 mm wide")]
    fn stands_at(&mut self, cell: Cell, point: DVec2) {
        let off = ((point - cell.middle()) / FINE).clamp(DVec2::splat(-50.0), DVec2::splat(50.0));
        self.at = [off.x as i8, off.y as i8];
    }

    /// When it was last found occupied, in decisions.
    pub(super) fn met(self) -> u16 {
        self.met
    }

    /// How often it was met occupied.
    pub(super) fn visits(self) -> u8 {
        self.visits
    }
}

/// What is known of the floor, cell by cell.
#[derive(Clone, Debug, Default)]
pub(super) struct Floor {
    spots: Tiles<Spot>,
    scan: u16,
    bounds: Option<[DVec2; 2]>,
}

impl Floor {
    /// What is known of a cell.
    pub(super) fn spot(&self, cell: Cell) -> Spot {
        self.spots.get(cell)
    }

    /// Looks at the occupied cells within [`CROWD`] of a cell.
    pub(super) fn look_around(&self, cell: Cell, mut look: impl FnMut(Cell, Spot)) {
        self.spots.look_around(cell, CROWD, |at, spot| {
            if spot.is_occupied() {
                look(at, *spot);
            }
        });
    }

    /// The corners of what was travelled and seen, metres.
    pub(super) fn bounds(&self) -> Option<[DVec2; 2]> {
        self.bounds
    }

    /// A scan: what its beams hit is occupied, what they passed is free.
    pub(super) fn see(&mut self, floor_from_laser: Pose, points: &[DVec2], moment: u16) {
        self.scan = self.scan.wrapping_add(1).max(1);
        for &point in points {
            let point = floor_from_laser * point;
            self.hit(point, moment);
        }
        let laser = floor_from_laser.position;
        self.widen(&[laser]);
        for &point in points.iter().step_by(EVERY) {
            let beam = floor_from_laser * point - laser;
            let length = beam.length();
            let along = beam / length.max(1e-9);
            let mut way = 0.5 * CELL;
            while way < length - SHORT {
                self.pass(Cell::at(laser + along * way), along);
                way += CELL;
            }
        }
    }

    /// The robot does not fit through there, however free it looks: beams do.
    pub(super) fn block(&mut self, point: DVec2, moment: u16) {
        let cell = Cell::at(point);
        self.change(cell, |spot| {
            spot.stands_at(cell, point);
            spot.marks |= SHUT;
            spot.visits = spot.visits.saturating_add(1);
            spot.met = moment;
        });
    }

    fn hit(&mut self, point: DVec2, moment: u16) {
        let (cell, scan) = (Cell::at(point), self.scan);
        self.change(cell, |spot| {
            if spot.scan == scan {
                return;
            }
            spot.scan = scan;
            spot.stands_at(cell, point);
            spot.evidence = (spot.evidence.max(-1) + 1).min(MOST);
            if spot.is_occupied() {
                if spot.visits == 0 || moment.wrapping_sub(spot.met) > AGAIN {
                    spot.visits = spot.visits.saturating_add(1);
                }
                spot.met = moment;
            }
        });
    }

    fn pass(&mut self, cell: Cell, beam: DVec2) {
        let scan = self.scan;
        let spot = self.spots.get(cell);
        if spot.is_plainly_free() || spot.scan == scan || !spot.is_crossed_by(beam) {
            return;
        }
        self.change(cell, |spot| {
            spot.scan = scan;
            spot.evidence = (spot.evidence - 1).max(LOOKED_THROUGH);
            spot.marks |= SEEN_FREE;
            if spot.evidence == LOOKED_THROUGH {
                spot.marks &= !WALL;
            }
        });
    }

    /// A wall of the map.
    pub(super) fn remember_wall(&mut self, wall: Segment) {
        self.widen(&[wall.a, wall.b]);
        self.trace(wall, 0, |cell, spot| {
            if !spot.is_occupied() {
                spot.stands_at(cell, wall.closest_point(cell.middle()));
            }
            if spot.evidence > LOOKED_THROUGH && !spot.is_travelled() {
                spot.marks |= WALL;
                spot.runs_along(wall);
            }
        });
    }

    /// A stretch that the robot has gone: where its middle was nothing stands.
    pub(super) fn travel(&mut self, stretch: Segment) {
        self.trace(stretch, 1, |_, spot| {
            spot.marks = (spot.marks | TRAVELLED) & !(WALL | SHUT);
        });
        self.widen(&[stretch.a, stretch.b]);
    }

    fn widen(&mut self, points: &[DVec2]) {
        for &point in points {
            let [low, high] = self.bounds.unwrap_or([point; 2]);
            self.bounds = Some([low.min(point), high.max(point)]);
        }
    }

    /// Changes the cells that a line crosses, and those around.
    fn trace(&mut self, line: Segment, around: i32, change: impl Fn(Cell, &mut Spot)) {
        #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "lengths are short")]
        let pieces = ((line.length() / (0.5 * CELL)).ceil() as u32).clamp(1, 10_000);
        let mut last = None;
        for k in 0..=pieces {
            let cell = Cell::at(line.a.lerp(line.b, f64::from(k) / f64::from(pieces)));
            if last.replace(cell) == Some(cell) {
                continue;
            }
            for dy in -around..=around {
                for dx in -around..=around {
                    let cell = cell.moved([dx, dy]);
                    self.change(cell, |spot| change(cell, spot));
                }
            }
        }
    }

    /// Changes a cell, and keeps the count of occupied cells around its neighbours.
    fn change(&mut self, cell: Cell, change: impl Fn(&mut Spot)) {
        let spot = self.spots.get_mut(cell);
        let was = spot.is_occupied();
        change(spot);
        let is = spot.is_occupied();
        if was == is {
            return;
        }
        for dy in -CROWD..=CROWD {
            for dx in -CROWD..=CROWD {
                if dx * dx + dy * dy <= CROWD * CROWD {
                    let crowd = &mut self.spots.get_mut(cell.moved([dx, dy])).crowd;
                    *crowd = if is { crowd.saturating_add(1) } else { crowd.saturating_sub(1) };
                }
            }
        }
    }
}

#[cfg(test)]
mod tests;
