use std::collections::BTreeMap;

use cogmap_geometry::Segment;

use super::{AsrId, Places, sight};
use crate::memory::{Mfis, SurfaceId};

/// A piece of wall lies on another when it is this near, metres …
const NEAR: f64 = 0.3;
/// … and looks the same way, as the cosine of the turn: 20°. The other face of a wall looks the other way.
const SAME_WAY: f64 = 0.94;

/// How much of an outline lies on another, as a share of its length: compares shape and size, and not
/// only where the two lie (§3.2.4 asks for it).
pub(super) fn share_on(newer: &[Segment], older: &[Segment]) -> f64 {
    let (mut covered, mut total) = (0.0, 0.0);
    for surface in newer {
        let Some(direction) = surface.direction() else { continue };
        let same_way =
            |other: &&Segment| other.direction().is_some_and(|other| other.dot(direction) >= SAME_WAY);
        let beside: Vec<&Segment> = older.iter().filter(same_way).collect();
        for point in sight::samples(*surface) {
            total += 1.0;
            covered += f64::from(u8::from(beside.iter().any(|other| other.distance_to(point) <= NEAR)));
        }
    }
    if total > 0.0 { covered / total } else { 0.0 }
}

impl Places {
    /// The surfaces of each space in the robot's frame, oldest first, as far as they are near; debris has no part
    /// in a shape.
    pub(super) fn outlines_here(&self, mfis: &Mfis) -> BTreeMap<AsrId, Vec<Segment>> {
        let mut near: Vec<(SurfaceId, Segment)> = Vec::new();
        for (frame, here_from_frame) in self.nearby.frames() {
            near.extend(mfis.in_frame(frame).map(|stored| (stored.id, here_from_frame * stored.segment)));
        }
        near.retain(|(_, segment)| segment.length() >= self.params.looking.debris);
        near.sort_unstable_by_key(|(id, _)| *id);
        let mut outlines: BTreeMap<AsrId, Vec<Segment>> = BTreeMap::new();
        for (id, segment) in near {
            if let Some(asr) = self.network.asr_of(id) {
                outlines.entry(asr).or_default().push(segment);
            }
        }
        outlines
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use cogmap_geometry::{DVec2, Pose};
    use proptest::prelude::*;

    /// A room as it is seen from inside: counter-clockwise walls, visible from the left.
    fn room(width: f64, depth: f64) -> Vec<Segment> {
        let corners = [[0.0, 0.0], [width, 0.0], [width, depth], [0.0, depth]].map(DVec2::from);
        (0..4).map(|i| Segment::new(corners[i], corners[(i + 1) % 4])).collect()
    }

    proptest! {
        #[test]
        fn an_outline_lies_on_itself_however_little_it_is_moved(
            x in -0.1f64..0.1, y in -0.1f64..0.1, turn in -0.02f64..0.02,
        ) {
            let moved: Vec<Segment> = room(5.0, 4.0).iter().map(|&wall| Pose::new(x, y, turn) * wall).collect();
            prop_assert!(share_on(&moved, &room(5.0, 4.0)) > 0.99);
        }
    }

    #[test]
    fn a_room_of_another_size_does_not_fit() {
        assert!(share_on(&room(8.0, 2.5), &room(5.0, 4.0)) < 0.6);
    }

    #[test]
    fn the_other_face_of_a_wall_is_another_wall() {
        let outside: Vec<Segment> = room(5.0, 4.0).iter().map(|wall| wall.reversed()).collect();
        assert_eq!(share_on(&outside, &room(5.0, 4.0)), 0.0);
    }
}
