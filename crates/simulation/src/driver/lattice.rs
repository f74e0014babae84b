use cogmap_geometry::DVec2;

/// The finest cells, metres.
const CELL: f64 = 0.05;
/// The most cells; a larger floor gets coarser ones.
const CELLS_MAX: f64 = 4e6;

/// Square cells over a stretch of floor, numbered row by row.
#[derive(Clone)]
pub(super) struct Lattice {
    low: DVec2,
    columns: usize,
    rows: usize,
    /// Edge of a cell, metres.
    pub(super) cell: f64,
}

impl Lattice {
    /// Cells over the box between two corners.
    pub(super) fn over(low: DVec2, high: DVec2) -> Self {
        let size = (high - low).max(DVec2::splat(CELL));
        let cell = CELL.max((size.x * size.y / CELLS_MAX).sqrt()).max(size.max_element() / CELLS_MAX);
        let [columns, rows] = (size / cell).to_array().map(|cells| cells as usize + 1);
        Self { low, columns, rows, cell }
    }

    pub(super) fn cells(&self) -> usize {
        self.columns * self.rows
    }

    /// The cell around a point; `None` outside.
    pub(super) fn at(&self, point: DVec2) -> Option<usize> {
        let [x, y] = ((point - self.low) / self.cell).to_array();
        let inside = x >= 0.0 && y >= 0.0 && x < self.columns as f64 && y < self.rows as f64;
        inside.then(|| y as usize * self.columns + x as usize)
    }

    pub(super) fn middle(&self, cell: usize) -> DVec2 {
        let (column, row) = (cell % self.columns, cell / self.columns);
        self.low + (DVec2::new(column as f64, row as f64) + 0.5) * self.cell
    }

    /// The up to eight cells around a cell; `all_round` with those a chess knight's move away, so that a way has
    /// sixteen directions to choose from and none is longer than it must be by over 2.8 %.
    pub(super) fn neighbours(&self, cell: usize, all_round: bool) -> impl Iterator<Item = usize> + use<> {
        const STEPS: [[isize; 2]; 16] = [
            [1, 0],
            [0, 1],
            [-1, 0],
            [0, -1],
            [1, 1],
            [-1, 1],
            [-1, -1],
            [1, -1],
            [2, 1],
            [1, 2],
            [-1, 2],
            [-2, 1],
            [-2, -1],
            [-1, -2],
            [1, -2],
            [2, -1],
        ];
        let (columns, rows) = (self.columns, self.rows);
        STEPS.into_iter().take(if all_round { 16 } else { 8 }).filter_map(move |[dx, dy]| {
            let column = (cell % columns).checked_add_signed(dx).filter(|&c| c < columns)?;
            let row = (cell / columns).checked_add_signed(dy).filter(|&r| r < rows)?;
            Some(row * columns + column)
        })
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    proptest! {
        #[test]
        fn a_point_lies_in_the_cell_that_it_is_given(
            x in -50.0f64..50.0, y in -50.0f64..50.0, w in 0.1f64..3e4, h in 0.1f64..3e4, s in 0.0f64..1.0,
        ) {
            let low = DVec2::new(x, y);
            let lattice = Lattice::over(low, low + DVec2::new(w, h));
            let point = low + DVec2::new(w, h) * s;
            let middle = lattice.middle(lattice.at(point).unwrap());
            prop_assert!((middle - point).abs().max_element() <= lattice.cell * 0.5001);
            prop_assert!(lattice.cells() < 9_000_000);
        }
    }

    #[test]
    fn a_corner_has_three_neighbours_and_the_middle_eight() {
        let lattice = Lattice::over(DVec2::ZERO, DVec2::splat(0.12));
        assert_eq!(lattice.cells(), 9);
        assert_eq!(lattice.neighbours(0, false).count(), 3);
        assert_eq!(lattice.neighbours(4, false).count(), 8);
        assert_eq!(lattice.at(DVec2::new(-0.1, 0.0)), None);
    }
}
