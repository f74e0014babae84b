use std::collections::BTreeMap;

use cogmap_geometry::{DVec2, Segment};

use super::{FrameId, SurfaceId};

/// Width of a cell, metres.
const CELL: f64 = 2.0;

/// Finds surfaces by where they lie: for each cell of a grid over each frame the surfaces that pass
/// through it or beside it.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Index {
    cells: BTreeMap<(FrameId, i32, i32), Vec<SurfaceId>>,
}

impl Index {
    pub(super) fn insert(&mut self, frame: FrameId, segment: Segment, id: SurfaceId) {
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

    /// The surfaces that may come within `radius` metres of a point, in the order of storing.
    pub(super) fn around(&self, frame: FrameId, at: DVec2, radius: f64) -> Vec<SurfaceId> {
        // Samples of a surface lie at most a cell apart, so one lies within half a cell of any point of it.
        let reach = radius + CELL / 2.0;
        let ((x0, y0), (x1, y1)) = (cell_of(at - reach), cell_of(at + reach));
        let mut found: Vec<SurfaceId> = (x0..=x1)
            .flat_map(|x| self.cells.range((frame, x, y0)..=(frame, x, y1)))
            .flat_map(|(_, ids)| ids.iter().copied())
            .collect();
        found.sort_unstable();
        found.dedup();
        found
    }
}

#[allow(clippy::cast_possible_truncation, reason = "no building is two thousand million cells wide")]
fn cell_of(point: DVec2) -> (i32, i32) {
    ((point.x / CELL).floor() as i32, (point.y / CELL).floor() as i32)
}

#[cfg(test)]
mod tests {
    use super::*;
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
        }
    }
}
