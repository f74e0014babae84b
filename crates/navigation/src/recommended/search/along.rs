use cogmap_geometry::DVec2;

use super::{
    super::{
        footing::NO_WAY,
        tiles::{CELL, Cell},
    },
    NEAR_HOME, REACHED, SHORT_OF_HOME, Search,
};

/// Lines by which a way is pulled tight are no longer than this while it has many points, metres: what that takes
/// grows with the way then, and not with its square.
const REACH: f64 = 6.0;

/// What ways cost along straight lines, and what is still to come.
impl Search<'_> {
    /// What the way from a cell to home costs at least.
    pub(super) fn ahead(&self, cell: Cell) -> u32 {
        let home = Cell::at(self.home);
        let (dx, dy) = (cell.x.abs_diff(home.x), cell.y.abs_diff(home.y));
        let straight = 1000 * dx.max(dy) + 410 * dx.min(dy);
        #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a small constant")]
        straight.saturating_sub((REACHED * 1410.0) as u32)
    }

    /// What it costs to end at a cell instead of at home; `None` where that is too far.
    pub(super) fn missing(&self, cell: Cell) -> Option<u32> {
        let distance = cell.middle().distance(self.home);
        let missing = (distance - REACHED * CELL).max(0.0);
        #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "at most 600,000")]
        (distance <= NEAR_HOME).then_some((missing * SHORT_OF_HOME * 10_000.0) as u32)
    }

    /// What the straight line between two points costs; `None` where it is not free.
    pub(in super::super) fn line(&mut self, from: DVec2, to: DVec2) -> Option<f64> {
        let length = from.distance(to);
        #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "lengths are short")]
        let pieces = ((length / (0.5 * CELL)).ceil() as u32).clamp(1, 100_000);
        let mut sum = 0.0;
        for k in 0..pieces {
            let share = (f64::from(k) + 0.5) / f64::from(pieces);
            let ease = self.ease(Cell::at(from.lerp(to, share)));
            if ease == NO_WAY {
                return None;
            }
            sum += f64::from(ease);
        }
        Some(0.1 * sum / f64::from(pieces) * length)
    }

    /// What a way costs from a point along its corners, what is missing to home included.
    pub(in super::super) fn cost(&mut self, from: DVec2, corners: &[DVec2]) -> Option<f64> {
        let mut cost = 0.0;
        let mut last = from;
        for &corner in corners {
            cost += self.line(last, corner)?;
            last = corner;
        }
        let missing = (last.distance(self.home) - REACHED * CELL).max(0.0);
        (missing <= NEAR_HOME).then_some(cost + missing * SHORT_OF_HOME)
    }

    /// Leaves out the points of a way that straight lines can do without at no more cost: first those that
    /// lines of [`REACH`] can, then those that lines of any length can.
    pub(in super::super) fn pull_tight(&mut self, from: DVec2, points: &[DVec2]) -> Vec<DVec2> {
        let corners = self.pull_within(REACH, from, points);
        self.pull_within(f64::INFINITY, from, &corners)
    }

    fn pull_within(&mut self, reach: f64, from: DVec2, points: &[DVec2]) -> Vec<DVec2> {
        let mut corners = Vec::new();
        let (mut at, mut next) = (from, 0);
        while next < points.len() {
            let mut along = self.line(at, points[next]).unwrap_or(f64::INFINITY);
            let mut last = next;
            for k in next + 1..points.len() {
                if at.distance(points[k]) > reach {
                    break;
                }
                along += self.line(points[k - 1], points[k]).unwrap_or(f64::INFINITY);
                match self.line(at, points[k]) {
                    Some(straight) if straight <= along + 0.02 => {
                        last = k;
                        along = straight;
                    }
                    Some(_) => {}
                    None => break,
                }
            }
            at = points[last];
            corners.push(at);
            next = last + 1;
        }
        corners
    }
}
