use std::ops::RangeInclusive;

use cogmap_geometry::DVec2;

use super::solid::Solid;

/// Cells that a solid is listed in on average, at most about: bounds the memory.
const LISTINGS_PER_SOLID: f64 = 6.0;
/// Cells for each solid, about, where the solids are short.
const CELLS_PER_SOLID: f64 = 1.0;
/// Cells along the longer side at most.
const SIDE_MAX: f64 = 1024.0;
/// Metres; finer cells than this help no laser.
const SIZE_MIN: f64 = 0.25;
/// Share of a cell by which solids reach into its neighbours: far above any
/// rounding, so that no beam slips between two cells.
const MARGIN: f64 = 1e-6;

/// Which solids each square of a uniform grid may touch.
pub(super) struct Cells {
    /// Lowest corner, metres.
    pub(super) low: DVec2,
    /// Side of a cell, metres.
    pub(super) size: f64,
    /// Cells along x and along y.
    pub(super) counts: [usize; 2],
    /// With depth along x and with depth along y.
    lists: [Lists; 2],
}

/// The ids listed for each cell; the cells of one depth lie side by side, so
/// that any run of them is one slice.
struct Lists {
    starts: Vec<u32>,
    ids: Vec<u32>,
}

impl Cells {
    /// Lists each solid under its index.
    pub(super) fn new(solids: &[Solid]) -> Self {
        let bounds = || solids.iter().filter_map(Solid::bounds);
        let low = bounds().map(|[low, _]| low).reduce(DVec2::min).unwrap_or_default();
        let high = bounds().map(|[_, high]| high).reduce(DVec2::max).unwrap_or_default();
        let around = bounds().map(|[low, high]| (high - low).element_sum()).sum();
        let size = cell_size(high - low, around, solids.len() as f64);
        let counts = ((high - low) / size).to_array().map(|side| side as usize + 2);
        let low = low - size * 0.5;
        let lists = [0, 1].map(|axis| Lists::new(solids, axis, &Columns { low, size, counts }));
        Self { low, size, counts, lists }
    }

    /// The ids listed for the cells `rows` of column `column`, depth along `axis`.
    pub(super) fn ids(&self, axis: usize, column: usize, rows: RangeInclusive<usize>) -> &[u32] {
        let lists = &self.lists[axis];
        let row_of_cells = column * self.counts[1 - axis];
        let start = lists.starts[row_of_cells + rows.start()];
        let end = lists.starts[row_of_cells + rows.end() + 1];
        &lists.ids[start as usize..end as usize]
    }
}

fn cell_size(extent: DVec2, around: f64, solids: f64) -> f64 {
    let solids = solids.max(1.0);
    let by_area = (extent.x * extent.y / (CELLS_PER_SOLID * solids)).sqrt();
    let by_listings = around / (LISTINGS_PER_SOLID * solids);
    by_area.max(by_listings).max(extent.max_element() / SIDE_MAX).max(SIZE_MIN)
}

/// The grid alone, while it is being filled.
struct Columns {
    low: DVec2,
    size: f64,
    counts: [usize; 2],
}

impl Columns {
    /// The cells that a stretch of coordinates along `axis` reaches.
    fn reached(&self, axis: usize, [from, to]: [f64; 2]) -> RangeInclusive<usize> {
        let cell = |at: f64| ((at - self.low.to_array()[axis]) / self.size).max(0.0);
        let last = self.counts[axis] - 1;
        let [first, end] = [cell(from) - MARGIN, cell(to) + MARGIN].map(|at| (at as usize).min(last));
        first..=end
    }

    /// Lower and upper edge of a column, metres along `axis`.
    fn edges(&self, axis: usize, column: usize) -> [f64; 2] {
        let edge = |at: f64| self.low.to_array()[axis] + at * self.size;
        [edge(column as f64 - MARGIN), edge(column as f64 + 1.0 + MARGIN)]
    }
}

impl Lists {
    fn new(solids: &[Solid], axis: usize, grid: &Columns) -> Self {
        let wide = grid.counts[1 - axis];
        let mut listed = Vec::new();
        for (id, solid) in solids.iter().enumerate() {
            let Some([low, high]) = solid.bounds() else { continue };
            for column in grid.reached(axis, [low.to_array()[axis], high.to_array()[axis]]) {
                let Some(across) = solid.across(axis, grid.edges(axis, column)) else { continue };
                listed.extend(grid.reached(1 - axis, across).map(|row| (column * wide + row, id as u32)));
            }
        }
        listed.sort_unstable();
        let mut starts = vec![0; grid.counts[axis] * wide + 1];
        listed.iter().for_each(|(cell, _)| starts[cell + 1] += 1);
        (1..starts.len()).for_each(|cell| starts[cell] += starts[cell - 1]);
        Self { starts, ids: listed.into_iter().map(|(_, id)| id).collect() }
    }
}
