use cogmap_geometry::{DVec2, Metric, Segment};

/// Metres along the side of a cell, unless the space is so large that the cells would be too many.
const CELL: f64 = 0.15;
/// Cells along each side of the grid, at most.
const MOST_CELLS: f64 = 240.0;
/// Slits up to twice as many cells wide are taken to be free: nothing was seen in them by chance.
const SLIT: isize = 2;
/// Spikes up to twice as many cells wide are left out: a glimpse between two things that stand there.
const SPIKE: isize = 2;
/// Corners nearer than so many cells to the line between others are left out.
const SMOOTHING: f64 = 1.1;

/// A grid in which free floor is marked.
pub(super) struct Floor {
    origin: DVec2,
    cell: f64,
    width: usize,
    height: usize,
    free: Vec<bool>,
}

impl Floor {
    /// A grid that holds all points with room around; `None` where there is none or one is not a number.
    pub(super) fn around(points: impl Iterator<Item = DVec2> + Clone, room: f64) -> Option<Self> {
        let low = points.clone().reduce(DVec2::min)? - room;
        let high = points.clone().reduce(DVec2::max)? + room;
        let size = high - low;
        if !(size.is_finite() && points.into_iter().all(DVec2::is_finite)) {
            return None;
        }
        let cell = CELL.max(size.max_element() / MOST_CELLS);
        // Slits are closed by growing and shrinking, which needs room at the border.
        let border = (SLIT + 1) as f64 * cell;
        let [width, height] = [size.x, size.y].map(|length| ((length + 2.0 * border) / cell).ceil() as usize);
        Some(Self { origin: low - border, cell, width, height, free: vec![false; width * height] })
    }

    /// Marks the cells of a triangle that `belongs` agrees to.
    pub(super) fn fill(&mut self, [a, b, c]: [DVec2; 3], belongs: impl Fn(DVec2) -> bool) {
        let edges = [(a, b), (b, c), (c, a)];
        self.mark(
            [a.min(b).min(c), a.max(b).max(c)],
            |cell| {
                let sides = edges.map(|(from, to)| (to - from).perp_dot(cell - from));
                sides.iter().all(|side| *side >= 0.0) || sides.iter().all(|side| *side <= 0.0)
            },
            belongs,
        );
    }

    /// Marks the cells around a point.
    pub(super) fn fill_around(&mut self, at: DVec2, radius: f64) {
        self.mark([at - radius, at + radius], |cell| cell.distance_from(at) <= radius, |_| true);
    }

    fn mark(
        &mut self,
        [low, high]: [DVec2; 2],
        inside: impl Fn(DVec2) -> bool,
        belongs: impl Fn(DVec2) -> bool,
    ) {
        let [left, bottom] = self.index_of(low);
        let [right, top] = self.index_of(high);
        for row in bottom..=top {
            for column in left..=right {
                let middle = self.corner(column, row) + 0.5 * self.cell;
                let at = row * self.width + column;
                if !self.free[at] && inside(middle) && belongs(middle) {
                    self.free[at] = true;
                }
            }
        }
    }

    /// The outer boundary of the largest piece of free floor, smoothed.
    pub(super) fn contour(mut self) -> Vec<DVec2> {
        for (by, free) in [(SLIT, true), (SLIT + SPIKE, false), (SPIKE, true)] {
            self.free = self.grown(by, free);
        }
        self.keep_largest();
        let corners = self.boundary();
        simplified(&corners, SMOOTHING * self.cell)
    }

    fn index_of(&self, point: DVec2) -> [usize; 2] {
        let index = (point - self.origin) / self.cell;
        [(index.x as usize).min(self.width - 1), (index.y as usize).min(self.height - 1)]
    }

    fn corner(&self, column: usize, row: usize) -> DVec2 {
        self.origin + DVec2::new(column as f64, row as f64) * self.cell
    }

    fn is_free(&self, [column, row]: [isize; 2]) -> bool {
        let inside = (0..self.width as isize).contains(&column) && (0..self.height as isize).contains(&row);
        inside && self.free[row as usize * self.width + column as usize]
    }

    /// Free floor grown by so many cells; shrunk by them where `free` is false.
    fn grown(&self, by: isize, free: bool) -> Vec<bool> {
        let disc: Vec<[isize; 2]> = (-by..=by)
            .flat_map(|x| (-by..=by).map(move |y| [x, y]))
            .filter(|[x, y]| x * x + y * y <= by * by)
            .collect();
        let touched = |at: usize| {
            let [column, row] = [(at % self.width) as isize, (at / self.width) as isize];
            disc.iter().any(|[x, y]| self.is_free([column + x, row + y]) == free)
        };
        (0..self.free.len()).map(|at| if touched(at) { free } else { !free }).collect()
    }

    fn keep_largest(&mut self) {
        let mut open = self.free.clone();
        let mut largest = Vec::new();
        for start in 0..open.len() {
            let mut piece = Vec::new();
            let mut todo = vec![start];
            while let Some(at) = todo.pop() {
                if std::mem::take(&mut open[at]) {
                    piece.push(at);
                    // The border is never free, so all four neighbours exist.
                    todo.extend([at - 1, at + 1, at - self.width, at + self.width]);
                }
            }
            if piece.len() > largest.len() {
                largest = piece;
            }
        }
        self.free.fill(false);
        largest.into_iter().for_each(|at| self.free[at] = true);
    }

    /// Walks around the one piece that is left, keeping it on the left hand.
    fn boundary(&self) -> Vec<DVec2> {
        let Some(first) = self.free.iter().position(|free| *free) else { return Vec::new() };
        let start = [(first % self.width) as isize, (first / self.width) as isize];
        let (mut at, mut ahead) = (start, [1, 0]);
        let mut corners = Vec::new();
        loop {
            let [x, y] = ahead;
            at = [at[0] + x, at[1] + y];
            // Of the four cells around the corner, the two that lie ahead.
            let cell = |side: [isize; 2]| {
                let low = |along: isize| (along - 1) / 2;
                self.is_free([at[0] + low(x + side[0]), at[1] + low(y + side[1])])
            };
            let turned = match (cell([-y, x]), cell([y, -x])) {
                (false, _) => [-y, x],
                (true, true) => [y, -x],
                (true, false) => ahead,
            };
            if turned != ahead {
                corners.push(self.corner(at[0] as usize, at[1] as usize));
            }
            ahead = turned;
            if at == start && ahead == [1, 0] {
                return corners;
            }
        }
    }
}

/// A closed line without the corners that hardly matter (Douglas and Peucker).
fn simplified(corners: &[DVec2], tolerance: f64) -> Vec<DVec2> {
    let Some(first) = corners.first() else { return Vec::new() };
    let distance = |at: &usize| corners[*at].distance_from(*first);
    let far = (0..corners.len()).max_by(|a, b| distance(a).total_cmp(&distance(b))).unwrap_or(0);
    let closed: Vec<DVec2> = corners[far..].iter().chain(&corners[..1]).copied().collect();
    let mut kept = Vec::new();
    for half in [&corners[..=far], &closed] {
        keep(half, tolerance, &mut kept);
    }
    kept
}

/// Keeps the first corner of a line and those between that matter, not the last.
fn keep(line: &[DVec2], tolerance: f64, kept: &mut Vec<DVec2>) {
    let [first, between @ .., last] = line else { return };
    let chord = Segment::new(*first, *last);
    let off = between.iter().map(|corner| chord.distance_to(*corner));
    match off.enumerate().max_by(|(_, a), (_, b)| a.total_cmp(b)) {
        Some((at, most)) if most > tolerance => {
            keep(&line[..=at + 1], tolerance, kept);
            keep(&line[at + 1..], tolerance, kept);
        }
        _ => kept.push(*first),
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    fn triangle(corners: [[f64; 2]; 3]) -> Vec<DVec2> {
        let corners = corners.map(DVec2::from);
        let mut floor = Floor::around(corners.into_iter(), 0.4).unwrap();
        floor.fill(corners, |_| true);
        floor.contour()
    }

    proptest! {
        #[test]
        fn every_outline_goes_around_once_counter_clockwise(
            a in [-9.0f64..9.0, -9.0f64..9.0], b in [-9.0f64..9.0, -9.0f64..9.0], c in [-9.0f64..9.0, -9.0f64..9.0],
        ) {
            let outline = triangle([a, b, c]);
            let [p, q, r] = [a, b, c].map(DVec2::from);
            let true_area = 0.5 * (q - p).perp_dot(r - p).abs();
            let next = outline.iter().cycle().skip(1);
            let area: f64 = outline.iter().zip(next).map(|(a, b)| 0.5 * a.perp_dot(*b)).sum();
            let rim = (p.distance(q) + q.distance(r) + r.distance(p)) * 2.0 * CELL;
            prop_assert!(area >= 0.0 && (area - true_area).abs() <= rim + 0.5, "{} for {}", area, true_area);
        }
    }

    #[test]
    fn the_larger_of_two_pieces_is_outlined() {
        let corners = [[0.0, 0.0], [3.0, 0.0], [0.0, 3.0], [8.0, 8.0]].map(DVec2::from);
        let mut floor = Floor::around(corners.into_iter(), 0.4).unwrap();
        floor.fill([corners[0], corners[1], corners[2]], |_| true);
        floor.fill_around(corners[3], 0.4);
        assert!(floor.contour().iter().all(|corner| corner.max_element() < 4.0));
    }

    #[test]
    fn no_place_is_too_large_or_no_number() {
        assert!(Floor::around([DVec2::ZERO, DVec2::NAN].into_iter(), 0.4).is_none());
        assert!(Floor::around(std::iter::empty(), 0.4).is_none());
        let floor = Floor::around([DVec2::ZERO, DVec2::splat(1e9)].into_iter(), 0.4).unwrap();
        assert!(floor.free.len() < 100_000);
    }
}
