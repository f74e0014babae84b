use std::ops::{Range, RangeInclusive};

use super::{cells::Cells, frame::Frame};

/// The grid's cells in the order that a frame sees them: column 0 nearest to
/// its back, rows counted from right to left.
pub(super) struct Outlook<'a> {
    cells: &'a Cells,
    axis: usize,
    /// Whether columns and rows count against the grid's own order.
    mirrored: [bool; 2],
    /// Where the frame's origin lies, in columns and rows.
    at: [f64; 2],
    /// Columns and rows.
    counts: [usize; 2],
}

impl<'a> Outlook<'a> {
    pub(super) fn new(cells: &'a Cells, frame: Frame) -> Self {
        let axis = frame.axis();
        let mirrored = frame.mirrored();
        let inside = ((frame.origin() - cells.low) / cells.size).to_array();
        let counts = [cells.counts[axis], cells.counts[1 - axis]];
        let from_side = |side: usize, at: f64| if mirrored[side] { counts[side] as f64 - at } else { at };
        let at = [from_side(0, inside[axis]), from_side(1, inside[1 - axis])];
        Self { cells, axis, mirrored, at, counts }
    }

    /// The columns from the frame's origin on.
    pub(super) fn columns(&self) -> Range<usize> {
        self.at[0].max(0.0) as usize..self.counts[0]
    }

    /// Depths between which a column lies, metres.
    pub(super) fn depths(&self, column: usize) -> [f64; 2] {
        let depth = |edge: usize| ((edge as f64 - self.at[0]) * self.cells.size).max(0.0);
        [depth(column), depth(column + 1)]
    }

    /// The rows between two distances to the left, metres, from `next` on.
    pub(super) fn rows(&self, [low, high]: [f64; 2], next: usize) -> Option<RangeInclusive<usize>> {
        let row = |left: f64| self.at[1] + left / self.cells.size;
        let (first, last) = (row(low), row(high));
        // Casting takes what is negative to 0.
        let rows = (first as usize).max(next)..=(last as usize).min(self.counts[1] - 1);
        (last >= 0.0 && !rows.is_empty()).then_some(rows)
    }

    /// The solids listed in the cells `rows` of `column`.
    pub(super) fn ids(&self, column: usize, rows: RangeInclusive<usize>) -> &'a [u32] {
        let column = if self.mirrored[0] { self.counts[0] - 1 - column } else { column };
        let (first, last) = rows.into_inner();
        let rows = match self.mirrored[1] {
            true => self.counts[1] - 1 - last..=self.counts[1] - 1 - first,
            false => first..=last,
        };
        self.cells.ids(self.axis, column, rows)
    }
}
