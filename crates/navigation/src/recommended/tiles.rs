use std::sync::Arc;

use cogmap_geometry::DVec2;

/// The side of a cell, metres.
pub(super) const CELL: f64 = 0.1;
/// Cells on a metre.
const PER_METRE: f64 = 10.0;
/// Cells on the side of a tile, a power of two.
const SIDE: i32 = 1 << BITS;
const BITS: i32 = 5;
const AREA: usize = (SIDE * SIDE) as usize;
/// A number to which this is added is rounded to a whole one, which stands in the lowest bits of the sum.
const WHOLE: f64 = 6_755_399_441_055_744.0;
/// No cell is kept farther from the origin than this, in cells: 3 km.
const FAR: i32 = 30_000;

/// A square of the floor.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct Cell {
    pub(super) x: i32,
    pub(super) y: i32,
}

impl Cell {
    /// The cell that a point lies in.
    #[inline]
    pub(super) fn at(point: DVec2) -> Self {
        Self { x: Self::index(point.x), y: Self::index(point.y) }
    }

    /// Rounds down; conversions of numbers that may be out of range are slow, and so is the library's `floor`.
    #[allow(clippy::cast_possible_truncation, reason = "the lowest bits are meant")]
    #[inline]
    fn index(along: f64) -> i32 {
        let along = (along * PER_METRE).clamp(f64::from(-FAR), f64::from(FAR));
        let whole = along + WHOLE;
        (whole.to_bits() as i32) - i32::from(along < whole - WHOLE)
    }

    /// Its middle, metres.
    #[inline]
    pub(super) fn middle(self) -> DVec2 {
        DVec2::new(f64::from(self.x) + 0.5, f64::from(self.y) + 0.5) * CELL
    }

    pub(super) fn moved(self, [dx, dy]: [i32; 2]) -> Self {
        Self { x: self.x + dx, y: self.y + dy }
    }

    /// Squared distance between the middles, in cells.
    #[inline]
    pub(super) fn distance_squared(self, other: Self) -> i32 {
        let (dx, dy) = (self.x - other.x, self.y - other.y);
        dx * dx + dy * dy
    }
}

/// Something about each cell of the floor, kept only where it was ever written. A clone shares
/// everything until one of the two is written to.
#[derive(Clone, Debug, Default)]
pub(super) struct Tiles<T> {
    low: [i32; 2],
    size: [i32; 2],
    tiles: Vec<Option<Arc<[T; AREA]>>>,
}

impl<T: Copy + Default> Tiles<T> {
    /// What is known of a cell.
    #[inline]
    pub(super) fn get(&self, cell: Cell) -> T {
        let (tile, within) = split(cell);
        match self.slot(tile).and_then(|slot| self.tiles[slot].as_ref()) {
            Some(tile) => tile[within],
            None => T::default(),
        }
    }

    /// Looks at what is known of the cells of a disc, `around` cells to each side of its middle.
    #[inline]
    pub(super) fn look_around(&self, middle: Cell, around: i32, mut look: impl FnMut(Cell, &T)) {
        let mut half = 0;
        for dy in -around..=around {
            let reach = around * around - dy * dy;
            while (half + 1) * (half + 1) <= reach {
                half += 1;
            }
            while half * half > reach {
                half -= 1;
            }
            self.look_along(middle.moved([-half, dy]), middle.x + half, &mut look);
        }
    }

    /// Looks at what is known of the cells of a row from one to the `last`.
    #[inline]
    fn look_along(&self, first: Cell, last: i32, look: &mut impl FnMut(Cell, &T)) {
        let mut from = first;
        while from.x <= last {
            let to = last.min(from.x | (SIDE - 1));
            let (tile, within) = split(from);
            if let Some(tile) = self.slot(tile).and_then(|slot| self.tiles[slot].as_ref()) {
                for (x, known) in (from.x..=to).zip(&tile[within..]) {
                    look(Cell { x, y: from.y }, known);
                }
            }
            from.x = to + 1;
        }
    }

    /// What is known of a cell, for writing.
    #[inline]
    pub(super) fn get_mut(&mut self, cell: Cell) -> &mut T {
        let (tile, within) = split(cell);
        let slot = match self.slot(tile) {
            Some(slot) => slot,
            None => self.grow(tile),
        };
        let tile = self.tiles[slot].get_or_insert_with(|| Arc::new([T::default(); AREA]));
        &mut Arc::make_mut(tile)[within]
    }

    #[allow(clippy::cast_sign_loss, reason = "both are checked to be positive")]
    #[inline]
    fn slot(&self, tile: [i32; 2]) -> Option<usize> {
        let [x, y] = [tile[0] - self.low[0], tile[1] - self.low[1]];
        let inside = (0..self.size[0]).contains(&x) && (0..self.size[1]).contains(&y);
        inside.then_some((y * self.size[0] + x) as usize)
    }

    /// Widens what can be kept so that a tile fits in.
    fn grow(&mut self, tile: [i32; 2]) -> usize {
        let span = |low: i32, size: i32, tile: i32| {
            let [first, last] = if size == 0 { [tile; 2] } else { [low, low + size - 1] };
            let low = first.min(tile - 1);
            (low, last.max(tile + 1) - low + 1)
        };
        let (x, width) = span(self.low[0], self.size[0], tile[0]);
        let (y, height) = span(self.low[1], self.size[1], tile[1]);
        let mut wider = Self { low: [x, y], size: [width, height], tiles: Vec::new() };
        #[allow(clippy::cast_sign_loss, reason = "sizes are positive")]
        wider.tiles.resize((wider.size[0] * wider.size[1]) as usize, None);
        for y in 0..self.size[1] {
            for x in 0..self.size[0] {
                let tile = [self.low[0] + x, self.low[1] + y];
                if let (Some(from), Some(to)) = (self.slot(tile), wider.slot(tile)) {
                    wider.tiles[to] = self.tiles[from].take();
                }
            }
        }
        *self = wider;
        self.slot(tile).unwrap_or(0)
    }
}

#[allow(clippy::cast_sign_loss, reason = "the lowest bits alone are positive")]
#[inline]
fn split(cell: Cell) -> ([i32; 2], usize) {
    let within = ((cell.y & (SIDE - 1)) << BITS) | (cell.x & (SIDE - 1));
    ([cell.x >> BITS, cell.y >> BITS], within as usize)
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn what_was_written_is_read_and_nothing_else(cells in prop::collection::btree_map((-300i32..300, -300i32..300), 1u32.., 1..40)) {
            let mut tiles = Tiles::<u32>::default();
            for (&(x, y), &value) in &cells {
                *tiles.get_mut(Cell { x, y }) = value;
            }
            for (&(x, y), &value) in &cells {
                prop_assert_eq!(tiles.get(Cell { x, y }), value);
                let beside = cells.get(&(x + 1, y)).copied().unwrap_or(0);
                prop_assert_eq!(tiles.get(Cell { x: x + 1, y }), beside);
            }
        }

        #[test]
        fn a_look_around_meets_what_was_written_and_nothing_else(
            cells in prop::collection::btree_map((-40i32..40, -40i32..40), 1u32.., 1..40), x in -40i32..40, y in -40i32..40,
        ) {
            let mut tiles = Tiles::<u32>::default();
            for (&(x, y), &value) in &cells {
                *tiles.get_mut(Cell { x, y }) = value;
            }
            let mut met = std::collections::BTreeMap::new();
            tiles.look_around(Cell { x, y }, 4, |at, &value| {
                assert!(met.insert((at.x, at.y), value).is_none(), "no cell twice");
            });
            met.retain(|_, value| *value != 0);
            let near = cells.into_iter().filter(|((at_x, at_y), _)| (at_x - x).pow(2) + (at_y - y).pow(2) <= 16);
            prop_assert_eq!(met, near.collect());
        }

        #[test]
        fn a_cell_begins_at_whole_tenths(along in -2900.0..2900.0, whole in -30_000i32..30_000) {
            prop_assert_eq!(f64::from(Cell::index(along)), (along * PER_METRE).floor());
            let begin = f64::from(whole) / PER_METRE;
            prop_assert_eq!(f64::from(Cell::index(begin)), (begin * PER_METRE).floor());
        }

        #[test]
        fn the_middle_of_a_cell_lies_in_it(x in -3000i32..3000, y in -3000i32..3000) {
            let cell = Cell { x, y };
            prop_assert_eq!(Cell::at(cell.middle()), cell);
            let corner = cell.middle() - 0.499 * CELL;
            prop_assert_eq!(Cell::at(corner), cell);
        }
    }

    #[test]
    fn what_is_too_far_is_kept_at_the_edge() {
        let far = [f64::INFINITY, 1e300, -1e300, f64::NEG_INFINITY, -0.0, -1e-300, f64::NAN];
        assert_eq!(far.map(Cell::index), [FAR, FAR, -FAR, -FAR, 0, -1, 0]);
    }

    #[test]
    fn a_clone_keeps_what_it_had() {
        let mut tiles = Tiles::<u32>::default();
        *tiles.get_mut(Cell { x: 3, y: 4 }) = 7;
        let kept = tiles.clone();
        *tiles.get_mut(Cell { x: 3, y: 4 }) = 8;
        assert_eq!((kept.get(Cell { x: 3, y: 4 }), tiles.get(Cell { x: 3, y: 4 })), (7, 8));
    }
}
