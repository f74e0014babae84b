use std::collections::{BTreeMap, VecDeque, btree_map::Entry};

/// An exit and the spaces on both sides of it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Edge {
    pub(super) exit: u32,
    pub(super) between: [u32; 2],
}

/// Where a space stands in the grid.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Cell {
    pub(super) column: usize,
    pub(super) row: f64,
    /// The exit through which it hangs on the space before it.
    pub(super) through: Option<u32>,
}

/// The spaces in columns by how many exits they are away from the oldest, and in rows so that no two of them
/// and no two ways between parent and child meet: a parent stands in the middle of its children. Spaces that
/// no exit joins to the others stand below them. Nothing depends on where the spaces lie.
pub(super) fn lay_out(names: &[u32], edges: &[Edge]) -> BTreeMap<u32, Cell> {
    let mut forest = Forest::default();
    for &name in names {
        if !forest.cells.contains_key(&name) {
            forest.grow(name, edges);
            forest.rows_below(name);
        }
    }
    forest.cells
}

/// Shortest ways from the oldest spaces.
#[derive(Default)]
struct Forest {
    cells: BTreeMap<u32, Cell>,
    children: BTreeMap<u32, Vec<u32>>,
    /// How many rows are taken.
    rows: u32,
}

impl Forest {
    /// Finds a shortest way to everything that can be reached from a space, exits in the order of finding.
    fn grow(&mut self, root: u32, edges: &[Edge]) {
        self.cells.insert(root, Cell::default());
        let mut open = VecDeque::from([root]);
        while let Some(here) = open.pop_front() {
            let column = self.cells.get(&here).map_or(0, |cell| cell.column) + 1;
            for edge in edges {
                let next = match edge.between {
                    [one, other] if one == here => other,
                    [one, other] if other == here => one,
                    _ => continue,
                };
                if let Entry::Vacant(free) = self.cells.entry(next) {
                    free.insert(Cell { column, row: 0.0, through: Some(edge.exit) });
                    self.children.entry(here).or_default().push(next);
                    open.push_back(next);
                }
            }
        }
    }

    /// Gives rows to a space and to all that hang on it; returns its own.
    fn rows_below(&mut self, name: u32) -> f64 {
        let children = self.children.get(&name).cloned().unwrap_or_default();
        let rows: Vec<f64> = children.into_iter().map(|child| self.rows_below(child)).collect();
        let row = match (rows.first(), rows.last()) {
            (Some(first), Some(last)) => f64::midpoint(*first, *last),
            _ => {
                self.rows += 1;
                f64::from(self.rows - 1)
            }
        };
        if let Some(cell) = self.cells.get_mut(&name) {
            cell.row = row;
        }
        row
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn edges(all: &[[u32; 2]]) -> Vec<Edge> {
        (0..).zip(all).map(|(exit, &between)| Edge { exit, between }).collect()
    }

    fn at(grid: &BTreeMap<u32, Cell>, name: u32) -> (usize, f64) {
        (grid[&name].column, grid[&name].row)
    }

    #[test]
    fn a_chain_is_one_row() {
        let grid = lay_out(&[0, 1, 2], &edges(&[[0, 1], [1, 2]]));
        assert_eq!([0, 1, 2].map(|name| at(&grid, name)), [(0, 0.0), (1, 0.0), (2, 0.0)]);
    }

    #[test]
    fn rooms_stand_below_each_other_behind_their_corridor() {
        let grid = lay_out(&[0, 1, 2, 3, 4], &edges(&[[0, 1], [1, 2], [1, 3], [1, 4]]));
        assert_eq!([2, 3, 4].map(|name| at(&grid, name)), [(2, 0.0), (2, 1.0), (2, 2.0)]);
        assert_eq!([0, 1].map(|name| at(&grid, name)), [(0, 1.0), (1, 1.0)]);
    }

    #[test]
    fn a_loop_hangs_on_its_shortest_ways_and_is_closed_by_an_exit_besides() {
        let all = edges(&[[0, 1], [1, 2], [2, 3], [3, 0]]);
        let grid = lay_out(&[0, 1, 2, 3], &all);
        assert_eq!([0, 1, 2, 3].map(|name| grid[&name].column), [0, 1, 2, 1]);
        let closing: Vec<u32> =
            (0..4).filter(|exit| grid.values().all(|c| c.through != Some(*exit))).collect();
        assert_eq!(closing, [2]);
    }

    #[test]
    fn no_two_spaces_share_a_cell_and_spaces_apart_are_shown_too() {
        let names: Vec<u32> = (0..12).collect();
        let all =
            edges(&[[0, 1], [0, 1], [1, 1], [1, 2], [1, 3], [3, 4], [3, 5], [0, 6], [7, 8], [8, 9], [8, 10]]);
        let grid = lay_out(&names, &all);
        let mut cells: Vec<(usize, u64)> =
            grid.values().map(|cell| (cell.column, (2.0 * cell.row).to_bits())).collect();
        cells.sort_unstable();
        cells.dedup();
        assert_eq!(cells.len(), names.len());
        assert_eq!((grid[&7].column, grid[&11].column), (0, 0));
        assert!(grid[&7].row > grid[&6].row && grid[&11].row > grid[&10].row);
    }
}
