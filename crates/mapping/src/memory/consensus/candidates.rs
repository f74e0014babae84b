use cogmap_geometry::{Pose, trig};

use super::{known::Known, line::Line};

/// For each line of a view the remembered ones that it could be, near a pose: found once, so that
/// the steps of an alignment look at a handful each.
pub(super) struct Candidates {
    of_line: Vec<Vec<Line>>,
    /// Metres of the view that have a candidate at all.
    possible: f64,
    total: f64,
}

impl Candidates {
    pub(super) fn around(view: &[Line], known: &Known, pose: Pose, reach: f64, angle: f64) -> Self {
        let mut of_line = Vec::with_capacity(view.len());
        let (mut possible, mut total) = (0.0, 0.0);
        let parallel = trig::cos(angle);
        for line in view {
            let placed = line.seen_from(pose);
            let near: Vec<Line> = known
                .facing(placed.heading, angle)
                .filter(|other| {
                    placed.along.dot(other.along) >= parallel
                        && placed.may_be(other)
                        && within(&placed, other, reach)
                })
                .copied()
                .collect();
            total += line.length;
            if !near.is_empty() {
                possible += line.length;
            }
            of_line.push(near);
        }
        Self { of_line, possible, total }
    }

    pub(super) fn of(&self, index: usize) -> &[Line] {
        self.of_line.get(index).map_or(&[], Vec::as_slice)
    }

    /// The largest share of the view that could match from here.
    pub(super) fn possible_fraction(&self) -> f64 {
        if self.total > 0.0 { self.possible / self.total } else { 0.0 }
    }
}

/// Whether a line passes within `reach` metres of another, roughly.
fn within(placed: &Line, other: &Line, reach: f64) -> bool {
    let (s, t) = (placed.at(other.a), placed.at(other.b()));
    if s.max(t) < -reach || s.min(t) > placed.length + reach {
        return false;
    }
    let (p, q) = (other.across(placed.a), other.across(placed.b()));
    p * q < 0.0 || p.abs().min(q.abs()) <= reach
}
