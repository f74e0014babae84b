use std::collections::BTreeMap;

use cogmap_geometry::{DVec2, Segment};

use super::FrameId;

/// Width of a cell, metres.
const CELL: f64 = 2.0;

/// Finds lines by where they lie: for each cell of a grid over each frame the names of those that pass
/// through it or beside it.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Index<Id> {
    cells: BTreeMap<(FrameId, i32, i32), Vec<Id>>,
}

impl<Id> Default for Index<Id> {
    fn default() -> Self {
        Self { cells: BTreeMap::new() }
    }
}

impl<Id: Copy + Ord> Index<Id> {
    pub(crate) fn insert(&mut self, frame: FrameId, segment: Segment, id: Id) {
        let pieces = (segment.length() / CELL).ceil().max(1.0);
        let mut cells = Vec::new();
        let mut share = 0.0;
        while share <= pieces {
            let (x, y) = cell_of(segment.a.lerp(segment.b, share / pieces));
            cells.push((x, y));
            share += 1.0;
        }
        cells.dedup();
        for (x, y) in cells {
            self.cells.entry((frame, x, y)).or_default().push(id);
        }
    }

    /// The lines that may come within `radius` metres of a point, by name.
    pub(crate) fn around(&self, frame: FrameId, at: DVec2, radius: f64) -> Vec<Id> {
        // Samples of a line lie at most a cell apart, so one lies within half a cell of any point of it.
        let reach = radius + CELL / 2.0;
        let ((x0, y0), (x1, y1)) = (cell_of(at - reach), cell_of(at + reach));
        each_once((x0..=x1).flat_map(|x| self.cells.range((frame, x, y0)..=(frame, x, y1))))
    }

    /// All lines of a frame, by name.
    pub(crate) fn in_frame(&self, frame: FrameId) -> Vec<Id> {
        each_once(self.cells.range((frame, i32::MIN, i32::MIN)..=(frame, i32::MAX, i32::MAX)))
    }
}

fn each_once<'a, Id: Copy + Ord + 'a, Cell>(cells: impl Iterator<Item = (Cell, &'a Vec<Id>)>) -> Vec<Id> {
    let mut found: Vec<Id> = cells.flat_map(|(_, ids)| ids.iter().copied()).collect();
    found.sort_unstable();
    found.dedup();
    found
}

#[allow(clippy::cast_possible_truncation, reason = "no building is two thousand million cells wide")]
fn cell_of(point: DVec2) -> (i32, i32) {
    ((point.x / CELL).floor() as i32, (point.y / CELL).floor() as i32)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::memory::SurfaceId;
    use proptest::prelude::*;

    prop_compose! {
        fn any_point()(x in -30.0f64..30.0, y in -30.0f64..30.0) -> DVec2 { DVec2::new(x, y) }
    }

    proptest! {
        #[test]
        fn nothing_near_is_missed(
            ends in prop::collection::vec((any_point(), any_point()), 1..40), at in any_point(), radius in 0.0f64..9.0,
        ) {
            let mut index = Index::default();
            for (id, &(a, b)) in ends.iter().enumerate() {
                index.insert(FrameId(0), Segment::new(a, b), SurfaceId(id as u32));
                index.insert(FrameId(1), Segment::new(b, b), SurfaceId(id as u32));
            }
            let found = index.around(FrameId(0), at, radius);
            for (id, &(a, b)) in ends.iter().enumerate() {
                if Segment::new(a, b).distance_to(at) <= radius {
                    prop_assert!(found.contains(&SurfaceId(id as u32)));
                }
            }
            prop_assert!(found.windows(2).all(|pair| pair[0] < pair[1]));
            prop_assert_eq!(index.in_frame(FrameId(1)).len(), ends.len());
        }
    }
}
