use std::{cmp::Reverse, collections::BinaryHeap};

use cogmap_geometry::{DVec2, Segment};

use super::planner::Planner;

/// One search over a planner's cells, best first.
pub(super) struct Search<'a> {
    planner: &'a mut Planner,
    from: DVec2,
    /// The cell around `from`.
    start: usize,
    room_at_start: f64,
    visits: Vec<Visit>,
    /// Whether the shortest way is looked for, however inconvenient.
    shortest: bool,
    open: BinaryHeap<Reverse<(u64, usize)>>,
}

/// How a cell was reached.
#[derive(Clone, Copy)]
struct Visit {
    cost: f64,
    before: Option<usize>,
    done: bool,
}

const UNSEEN: Visit = Visit { cost: f64::INFINITY, before: None, done: false };

impl<'a> Search<'a> {
    pub(super) fn new(planner: &'a mut Planner, from: DVec2) -> Self {
        let room_at_start = planner.room_at(from);
        let cells = planner.lattice.cells();
        planner.tire(cells as u64 / 16);
        let start = planner.lattice.at(from).unwrap_or(cells);
        let (visits, open) = (vec![UNSEEN; cells], BinaryHeap::new());
        let mut search = Self { planner, from, start, room_at_start, visits, shortest: false, open };
        search.reach(start, Visit { cost: 0.0, ..UNSEEN }, 0.0);
        search
    }

    /// The same search for the shortest way, however near to things it leads.
    pub(super) fn for_shortest(self) -> Self {
        Self { shortest: true, ..self }
    }

    /// The cheapest way to a point, from the start to the point; `None` where there is none.
    pub(super) fn to(mut self, goal: DVec2) -> Option<Vec<DVec2>> {
        while let Some(cell) = self.next() {
            if self.sees(cell, goal) {
                return Some(self.way(cell, goal));
            }
            self.spread(cell, |point| point.distance(goal));
        }
        None
    }

    /// The middles of all cells that a way of at most `length` metres leads to, cheapest first.
    pub(super) fn all_within(mut self, length: f64) -> Vec<DVec2> {
        let mut places = Vec::new();
        while let Some(cell) = self.next() {
            places.push(self.planner.lattice.middle(cell));
            if self.visits.get(cell).is_some_and(|visit| visit.cost < length) {
                self.spread(cell, |_| 0.0);
            }
        }
        places
    }

    /// Whether the goal is close by and the way there free.
    fn sees(&mut self, cell: usize, goal: DVec2) -> bool {
        let here = self.place(cell);
        let near = here.distance(goal) < 2.0 * self.planner.lattice.cell;
        near && {
            let keep = self.planner.kept_at(here, self.from, self.room_at_start);
            self.planner.free(Segment::new(here, goal), keep)
        }
    }

    /// The open cell with the best prospect, closed; `None` where there is none or patience is lost.
    fn next(&mut self) -> Option<usize> {
        loop {
            if !self.planner.tire(8) {
                return None;
            }
            let Reverse((_, cell)) = self.open.pop()?;
            let visit = self.visits.get_mut(cell)?;
            if !std::mem::replace(&mut visit.done, true) {
                return Some(cell);
            }
        }
    }

    fn spread(&mut self, cell: usize, prospect: impl Fn(DVec2) -> f64) {
        let here = self.place(cell);
        let Some(cost) = self.visits.get(cell).map(|visit| visit.cost) else { return };
        for next in self.planner.lattice.neighbours(cell, self.shortest) {
            let there = self.planner.lattice.middle(next);
            let room = self.planner.room(next);
            let burden = if self.shortest { 1.0 } else { self.planner.burden(room) };
            let cost = cost + here.distance(there) * burden;
            let better = self.visits.get(next).is_some_and(|visit| !visit.done && cost < visit.cost);
            if better && self.passes(cell, next) {
                self.reach(next, Visit { cost, before: Some(cell), done: false }, prospect(there));
            }
        }
    }

    fn reach(&mut self, cell: usize, visit: Visit, prospect: f64) {
        if let Some(known) = self.visits.get_mut(cell) {
            *known = visit;
            // Costs are never negative, so their bits are in the same order as they are.
            self.open.push(Reverse(((visit.cost + prospect).to_bits(), cell)));
        }
    }

    /// Whether the robot can go straight from a cell to the next.
    fn passes(&mut self, cell: usize, next: usize) -> bool {
        let (here, there) = (self.place(cell), self.place(next));
        let keep = self.planner.kept_at(there, self.from, self.room_at_start);
        let (room_here, room_there) = (self.planner.room(cell), self.planner.room(next));
        if room_there < keep {
            return false;
        }
        // No point between is nearer to anything than an end is, less half the way.
        let least = room_here.min(room_there) - here.distance(there) / 2.0;
        (cell != self.start && least >= keep) || self.planner.free(Segment::new(here, there), keep)
    }

    /// A cell's middle; in the first cell the start itself.
    fn place(&self, cell: usize) -> DVec2 {
        if cell == self.start { self.from } else { self.planner.lattice.middle(cell) }
    }

    fn way(&self, cell: usize, goal: DVec2) -> Vec<DVec2> {
        let mut way = vec![goal];
        let mut at = Some(cell);
        while let Some(cell) = at {
            way.push(self.place(cell));
            at = self.visits.get(cell).and_then(|visit| visit.before);
        }
        way.reverse();
        way
    }
}
