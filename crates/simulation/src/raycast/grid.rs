use cogmap_geometry::Segment;

use super::{
    Disc, Fan, Hit, beams::Beams, cells::Cells, frame::Frame, outlook::Outlook, solid::Solid, sweep::Sweep,
};

/// Solids that stand still, arranged so that casting a fan looks only at those
/// near the beams.
///
/// ```
/// use cogmap_geometry::{DVec2, Segment};
/// use cogmap_simulation::{Fan, RayGrid};
///
/// let wall = Segment::new(DVec2::new(2.0, -1.0), DVec2::new(2.0, 1.0));
/// let ahead = Fan { origin: DVec2::ZERO, heading: 0.0, spacing: 0.1, beams: 3, range_max: 8.0 };
/// let mut hits = Vec::new();
/// RayGrid::new(&[wall], &[]).cast(&ahead, &mut hits);
/// assert_eq!(hits[0].map(|hit| hit.range), Some(2.0));
/// ```
pub struct RayGrid {
    solids: Vec<Solid>,
    cells: Cells,
}

impl RayGrid {
    /// Arranges `segments`, seen from both sides, and `discs`.
    #[must_use]
    pub fn new(segments: &[Segment], discs: &[Disc]) -> Self {
        let solids = Solid::all(segments, discs);
        let cells = Cells::new(&solids);
        Self { solids, cells }
    }

    /// How many solids it holds.
    pub(crate) fn len(&self) -> usize {
        self.solids.len()
    }

    /// Replaces `hits` by what each beam of `fan` meets first.
    pub fn cast(&self, fan: &Fan, hits: &mut Vec<Option<Hit>>) {
        self.cast_with(fan, &[], &[], hits);
    }

    /// As [`RayGrid::cast`], with things that move and so are in no grid: doors,
    /// people, boxes just dropped.
    pub fn cast_with(&self, fan: &Fan, segments: &[Segment], discs: &[Disc], hits: &mut Vec<Option<Hit>>) {
        hits.clear();
        if !fan.is_sound() || fan.beams == 0 {
            hits.resize(fan.beams, None);
            return;
        }
        let moving = Solid::all(segments, discs);
        let (fan, reversed) = fan.counter_clockwise();
        let [x, y] = fan.directions();
        let mut first = 0;
        while first < fan.beams {
            let (quadrant, run) = fan.quadrant_from(first);
            first = run.end;
            let frame = Frame::new(fan.origin, quadrant);
            let beams = Beams::new(&fan, frame, [&x[run.clone()], &y[run]]);
            let mut sweep = Sweep::new(frame, beams);
            for (id, solid) in
                (self.solids.len()..).zip(&moving).filter(|(_, solid)| solid.bounds().is_some())
            {
                sweep.lay(id as u32, solid);
            }
            self.advance(&mut sweep);
            sweep.collect(|id| self.solids.get(id).or_else(|| moving.get(id - self.solids.len())), hits);
        }
        if reversed {
            hits.reverse();
        }
    }

    /// Lays the grid's solids onto the beams, column by column away from the
    /// sensor, as long as a beam still sees past what it met.
    fn advance(&self, sweep: &mut Sweep) {
        let outlook = Outlook::new(&self.cells, sweep.frame);
        let mut open = vec![sweep.beams.all()];
        for column in outlook.columns() {
            let depths = outlook.depths(column);
            let mut next_row = 0;
            for beams in &open {
                let Some(rows) = outlook.rows(sweep.beams.spread(beams, depths), next_row) else { continue };
                next_row = rows.end() + 1;
                for &id in outlook.ids(column, rows) {
                    sweep.lay(id, &self.solids[id as usize]);
                }
            }
            open = sweep.beams.still_open(&open, depths[1]);
            if open.is_empty() {
                break;
            }
        }
    }
}
