mod along;

use std::{cmp::Reverse, collections::BinaryHeap};

use cogmap_geometry::DVec2;

use super::{
    footing::{Ease, NO_WAY},
    tiles::{CELL, Cell, Tiles},
};

/// The eight ways on, counter-clockwise.
const WAYS: [[i32; 2]; 8] = [[1, 0], [1, 1], [0, 1], [-1, 1], [-1, 0], [-1, -1], [0, -1], [1, -1]];
/// Within so many cells of the robot and of home every cell counts, farther off only each third: 4 m. On the
/// way that the robot has gone every cell counts too: it may have led through a gap that thirds step over.
const FINE: i32 = 40;
/// Farther off a step leads over so many cells; what is free for the robot's middle in a door may be less.
const COARSE: i32 = 3;
/// Home is reached within so many cells.
const REACHED: f64 = 2.0;
/// Where it cannot be, the way may end so near, metres, …
pub(super) const NEAR_HOME: f64 = 1.2;
/// … each metre that is missing costing so much.
const SHORT_OF_HOME: f64 = 60.0;
/// No way is looked for beyond so many cells, where gaps are looked at …
const PATIENCE: usize = 20_000;
/// … and where they are not.
const LONG_PATIENCE: usize = 35_000;
/// How far around what was seen a way may lead, metres, …
const MARGIN: f64 = 3.0;
/// … and where all ways within that are closed.
const WIDE_MARGIN: f64 = 10.0;
/// A cell that costs so much, in tenths a metre, lies in a remembered wall.
const IN_A_WALL: u16 = 900;

/// A way over the floor, and what it costs; a metre of free floor costs 1.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Way {
    /// Its corners, without its beginning, metres.
    pub(super) corners: Vec<DVec2>,
    /// What it costs, what is missing to home included.
    pub(super) cost: f64,
}

/// Looks for a way (A*).
pub(super) struct Search<'a> {
    ease: Ease<'a>,
    home: DVec2,
    nodes: Tiles<Node>,
    /// What a metre costs at a cell, in tenths; 0: not asked yet.
    eases: Tiles<u16>,
    bounds: [Cell; 2],
    open: BinaryHeap<Open>,
    /// Nodes at the bounds, from where ways lead beyond.
    beyond: Vec<Cell>,
    expanded: usize,
    /// Whether every cell near something that stands counts, so that no gap is stepped over.
    thorough: bool,
}

#[derive(Clone, Copy, Debug, Default)]
struct Node {
    /// The least cost known so far, in tenths of a millimetre of free floor; 0: not reached yet.
    cost: u32,
    /// The way that led there, and from how many cells away.
    way: u8,
    step: u8,
}

fn is_coarse(cell: Cell) -> bool {
    cell.x.rem_euclid(COARSE) == 0 && cell.y.rem_euclid(COARSE) == 0
}

/// What the step to a neighbour costs, in tenths a cell, by what a metre costs there and around; `None` as in
/// [`Search::stretch`].
fn to_neighbour(here: u16, around: &[u16; 8], way: usize) -> Option<u32> {
    let beside = [around[(way + 7) % 8], around[(way + 1) % 8]];
    let diagonal = way % 2 == 1;
    let open = around[way] != NO_WAY && !(diagonal && beside.contains(&NO_WAY));
    open.then(|| (u32::from(here) + u32::from(around[way])).div_ceil(2))
}

/// A node on the heap, or the end: what it costs and may still cost, and how it was reached.
type Open = Reverse<(u32, u32, Cell, bool)>;

impl<'a> Search<'a> {
    /// A search on what one decision makes of the floor, for a way to a point, metres.
    pub(super) fn new(ease: Ease<'a>, home: DVec2) -> Self {
        Self {
            ease,
            home,
            nodes: Tiles::default(),
            eases: Tiles::default(),
            bounds: [ease.robot; 2],
            open: BinaryHeap::new(),
            beyond: Vec::new(),
            expanded: 0,
            thorough: false,
        }
    }

    /// The cheapest way from where the robot is; `None` where there is none. A home that is closed in
    /// must not flood the world: the search keeps to what was seen and a margin. A `wide` search looks at narrow
    /// gaps as well, and goes on beyond the margin where all ways within it are closed; where the building is too
    /// large for that, it looks at wide gaps only.
    pub(super) fn way(&mut self, wide: bool) -> Option<Vec<Cell>> {
        self.begin(wide);
        let near = self.next_end();
        if !wide || near.as_ref().is_some_and(|way| self.leads_home(way)) {
            return near;
        }
        let way = self.way_beyond(near);
        if way.is_some() || !self.has_lost_patience() {
            return way;
        }
        self.begin(false);
        self.next_end()
    }

    fn way_beyond(&mut self, near: Option<Vec<Cell>>) -> Option<Vec<Cell>> {
        self.bound(WIDE_MARGIN);
        for cell in std::mem::take(&mut self.beyond) {
            let cost = self.nodes.get(cell).cost;
            self.open.push(Reverse((cost.saturating_add(self.ahead(cell)), cost, cell, false)));
        }
        self.next_end().or(near)
    }

    fn begin(&mut self, thorough: bool) {
        self.thorough = thorough;
        self.nodes = Tiles::default();
        self.open.clear();
        self.beyond.clear();
        self.expanded = 0;
        self.bound(MARGIN);
        let start = self.ease.robot;
        self.nodes.get_mut(start).cost = 1;
        self.open.push(Reverse((self.ahead(start), 1, start, false)));
    }

    /// Whether a way ends at home and leads through no wall.
    fn leads_home(&mut self, way: &[Cell]) -> bool {
        let ends = way.last().is_some_and(|end| end.middle().distance(self.home) <= (REACHED + 1.0) * CELL);
        ends && !way.windows(2).any(|pair| {
            let (from, to) = (pair[0].middle(), pair[1].middle());
            [0.0, 1.0 / 3.0, 2.0 / 3.0]
                .iter()
                .any(|&share| self.ease(Cell::at(from.lerp(to, share))) >= IN_A_WALL)
        })
    }

    /// Keeps the search to what was seen and a margin, metres.
    fn bound(&mut self, margin: f64) {
        let robot = self.ease.robot.middle();
        let [low, high] = self.ease.floor.bounds().unwrap_or([robot; 2]);
        let low = low.min(robot).min(self.home) - margin;
        let high = high.max(robot).max(self.home) + margin;
        self.bounds = [Cell::at(low), Cell::at(high)];
    }

    /// Searches on to the cheapest of all ends, which stays one of those that the search may end at.
    fn next_end(&mut self) -> Option<Vec<Cell>> {
        while let Some(next) = self.open.pop() {
            let Reverse((_, cost, cell, end)) = next;
            if end {
                self.open.push(next);
                return Some(self.back_from(cell));
            }
            if self.nodes.get(cell).cost != cost {
                continue;
            }
            self.expanded += 1;
            if self.has_lost_patience() {
                return None;
            }
            if let Some(missing) = self.missing(cell) {
                self.open.push(Reverse((cost.saturating_add(missing), cost, cell, true)));
            }
            self.expand(cell, cost);
        }
        None
    }

    fn has_lost_patience(&self) -> bool {
        self.expanded > if self.thorough { PATIENCE } else { LONG_PATIENCE }
    }

    fn expand(&mut self, cell: Cell, cost: u32) {
        let fine = self.is_fine(cell);
        let step = if fine || !is_coarse(cell) { 1 } else { COARSE };
        let here = self.ease(cell).min(NO_WAY - 1);
        let around = WAYS.map(|to| self.ease(cell.moved(to)));
        let mut at_bounds = false;
        for (way, [dx, dy]) in (0_u8..).zip(WAYS) {
            let to = cell.moved([dx * step, dy * step]);
            if !self.is_within(to) {
                at_bounds = true;
                continue;
            }
            if !fine && !is_coarse(to) {
                continue;
            }
            let next = cell.moved([dx, dy]);
            let first = to_neighbour(here, &around, usize::from(way));
            let rest = first.and_then(|_| self.stretch(next, [dx, dy], step - 1));
            let Some(ease) = first.zip(rest).map(|(first, rest)| first + rest) else { continue };
            let length = if dx != 0 && dy != 0 { 141 } else { 100 };
            let cost = cost.saturating_add(ease * length);
            let known = self.nodes.get(to).cost;
            if known == 0 || cost < known {
                #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "1 or 3")]
                let step = step as u8;
                *self.nodes.get_mut(to) = Node { cost, way, step };
                self.open.push(Reverse((cost.saturating_add(self.ahead(to)), cost, to, false)));
            }
        }
        if at_bounds {
            self.beyond.push(cell);
        }
    }

    /// What a stretch of some cells costs, in tenths a cell; `None` where something stands in its way or
    /// beside it: a way cuts no corners.
    fn stretch(&mut self, cell: Cell, [dx, dy]: [i32; 2], step: i32) -> Option<u32> {
        let mut sum = 0;
        let mut last = self.ease(cell).min(NO_WAY - 1);
        for k in 0..step {
            let at = cell.moved([dx * k, dy * k]);
            let next = self.ease(at.moved([dx, dy]));
            let cut = dx != 0
                && dy != 0
                && (self.ease(at.moved([dx, 0])) == NO_WAY || self.ease(at.moved([0, dy])) == NO_WAY);
            if next == NO_WAY || cut {
                return None;
            }
            sum += (u32::from(last) + u32::from(next)).div_ceil(2);
            last = next;
        }
        Some(sum)
    }

    fn is_fine(&self, cell: Cell) -> bool {
        cell.distance_squared(self.ease.robot) <= FINE * FINE
            || cell.distance_squared(Cell::at(self.home)) <= FINE * FINE
            || self.is_narrow(cell)
    }

    fn is_narrow(&self, cell: Cell) -> bool {
        let spot = self.ease.floor.spot(cell);
        spot.is_travelled() || (self.thorough && spot.crowd() > 0)
    }

    fn is_within(&self, cell: Cell) -> bool {
        let [low, high] = self.bounds;
        (low.x..=high.x).contains(&cell.x) && (low.y..=high.y).contains(&cell.y)
    }

    /// What a metre costs at a cell, in tenths.
    #[inline]
    fn ease(&mut self, cell: Cell) -> u16 {
        match self.eases.get(cell) {
            0 => self.ask(cell),
            known => known,
        }
    }

    /// Works out what a metre costs at a cell, once in a decision: apart, so that asking again stays quick.
    #[cold]
    fn ask(&mut self, cell: Cell) -> u16 {
        let ease = self.ease.cost(cell);
        *self.eases.get_mut(cell) = ease;
        ease
    }

    /// The cells of the way that led to one, from the start.
    fn back_from(&self, end: Cell) -> Vec<Cell> {
        let mut cells = vec![end];
        let mut cell = end;
        while cell != self.ease.robot {
            let Node { way, step, .. } = self.nodes.get(cell);
            let [dx, dy] = WAYS[usize::from(way) % WAYS.len()];
            cell = cell.moved([-dx * i32::from(step), -dy * i32::from(step)]);
            cells.push(cell);
        }
        cells.reverse();
        cells
    }
}

#[cfg(test)]
mod tests;
