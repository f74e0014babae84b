use cogmap_geometry::{DVec2, Metric, Segment, trig};
use serde::{Deserialize, Serialize};

use super::{ExitId, Now, Places};
use crate::{
    memory::FrameId,
    perception::{End, Surface, View},
};

/// Which gaps of a view may be exits (`recommended`, ours; the thesis finds exits after crossing only).
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Gaps {
    /// Narrower gaps are no doors, metres.
    pub min_width: f64,
    /// Wider ones neither, metres.
    pub max_width: f64,
    /// A wall that is seen through a gap and reaches no farther behind it closes it: a niche, not a door;
    /// the robot would find no room there, metres.
    pub min_depth: f64,
    /// Gaps farther off than this are not looked at, metres.
    pub range: f64,
    /// Two gaps are one when their middles lie so near to each other, metres.
    pub same: f64,
}

impl Default for Gaps {
    fn default() -> Self {
        Self { min_width: 0.6, max_width: 1.5, min_depth: 0.5, range: 5.0, same: 0.5 }
    }
}

/// An exit seen ahead, or beside the way, that the robot need not have gone through.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hypothesis {
    /// The local frame that it is given in.
    pub frame: FrameId,
    /// From one jamb to the other when it was first seen, metres.
    pub segment: Segment,
    /// The view that first saw it.
    pub step: usize,
    /// In how many views it was seen.
    pub views: u32,
    /// The exit that it turned out to be when the robot went through it.
    pub confirmed: Option<ExitId>,
}

/// So many surfaces of a view may be seen through a gap.
const SEEN_THROUGH: usize = 8;
/// Walls beside a gap are turned less than this against it, as the cosine: 30°.
const BESIDE: f64 = 0.866;

/// The gaps of a view between two walls that truly end there, with something farther off behind.
fn gaps_of(view: &View, debris: f64, params: &Gaps) -> Vec<Segment> {
    let surfaces = &view.surfaces;
    let mut gaps = Vec::new();
    for (right, wall) in surfaces.iter().enumerate().filter(|(_, wall)| wall.length() >= debris) {
        if wall.ends[1] != End::True {
            continue;
        }
        for left in right + 1..(right + 2 + SEEN_THROUGH).min(surfaces.len()) {
            let other = &surfaces[left];
            let gap = Segment::new(other.segment.a, wall.segment.b);
            let fits = (params.min_width..=params.max_width).contains(&gap.length())
                && gap.midpoint().norm() <= params.range;
            let is_room = |seen: &Surface| {
                seen.length() < debris || reach_beyond(gap, seen.segment) >= params.min_depth
            };
            let behind =
                surfaces[right + 1..left].iter().all(|seen| is_beyond(gap, seen.segment) && is_room(seen));
            let flush = turned_little(gap, wall.segment) || turned_little(gap, other.segment);
            if fits && behind && flush && other.length() >= debris && other.ends[0] == End::True {
                gaps.push(gap);
                break;
            }
        }
    }
    gaps
}

/// Whether a surface lies on the far side of a gap seen from the robot.
fn is_beyond(gap: Segment, surface: Segment) -> bool {
    let side = |point: DVec2| gap.offset_of(point).unwrap_or(0.0);
    side(surface.midpoint()) * side(DVec2::ZERO) < 0.0
}

/// How far behind a gap a surface reaches, metres.
fn reach_beyond(gap: Segment, surface: Segment) -> f64 {
    let depth = |point: DVec2| gap.offset_of(point).unwrap_or(0.0).abs();
    depth(surface.a).max(depth(surface.b))
}

fn turned_little(gap: Segment, wall: Segment) -> bool {
    trig::cos(gap.angle_to(wall)) >= BESIDE
}

impl Places {
    /// Remembers the gaps of a view as exits that may be.
    pub(super) fn look_ahead(&mut self, now: Now<'_>) {
        let here = now.here;
        for gap in gaps_of(&now.report.view, self.params.looking.debris, &self.params.gaps) {
            let segment = here.frame_from_robot * gap;
            match self.hypothesis_at(segment) {
                Some(known) => self.network.see_again(known),
                None => {
                    let (frame, step) = (here.frame, here.step);
                    let new = Hypothesis { frame, segment, step, views: 1, confirmed: None };
                    self.nearby.hypotheses.push(self.network.suppose(new));
                }
            }
        }
    }

    /// The robot has gone through an exit there: what was seen ahead is confirmed.
    pub(super) fn confirm(&mut self, segment: Segment, exit: ExitId) {
        if let Some(known) = self.hypothesis_at(segment) {
            self.network.confirm(known, exit);
        }
    }

    fn hypothesis_at(&self, segment: Segment) -> Option<usize> {
        let distance = |hypothesis: &Hypothesis| {
            let here_from_frame = self.nearby.here_from(hypothesis.frame)?;
            Some((here_from_frame * hypothesis.segment.midpoint()).distance_from(segment.midpoint()))
        };
        let near = self.nearby.hypotheses.iter();
        near.filter_map(|&index| Some((index, distance(self.network.hypotheses().get(index)?)?)))
            .filter(|(_, distance)| *distance <= self.params.gaps.same)
            .min_by(|a, b| a.1.total_cmp(&b.1))
            .map(|(index, _)| index)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A wall ahead of the robot with an opening in it, and a wall so far behind the opening.
    fn wall_with_opening(depth: f64) -> View {
        let surface = |a: [f64; 2], b: [f64; 2]| Surface {
            segment: Segment::new(a.into(), b.into()),
            ends: [End::True; 2],
            beams: [0, 0],
            points: 20,
            residual: 0.0,
            range: 2.0,
            incidence: 0.0,
            label: None,
        };
        let behind = 2.0 + depth;
        let walls = [
            surface([2.0, -2.0], [2.0, -0.45]),
            surface([behind, -0.45], [behind, 0.45]),
            surface([2.0, 0.45], [2.0, 2.0]),
        ];
        View { surfaces: walls.to_vec() }
    }

    #[test]
    fn a_door_is_supposed_where_there_is_room_behind_and_not_in_a_niche() {
        let gaps = |depth| gaps_of(&wall_with_opening(depth), 0.4, &Gaps::default()).len();
        assert_eq!((gaps(3.0), gaps(0.12)), (1, 0));
    }
}
