use cogmap_geometry::{DVec2, Segment, trig};

use crate::{BoxObstacle, Disc, Door, World};

mod obstacles;

pub use obstacles::{Nearest, Obstacles, Surroundings};

/// How thick a door leaf is, metres. The world file has leaves without thickness; one that stood so would be
/// invisible to a laser that looks along it.
const LEAF_THICKNESS: f64 = 0.04;

/// The edge of a box that was taken away: no beam and no body meets it.
const NOWHERE: Segment = Segment { a: DVec2::NAN, b: DVec2::NAN };

/// What stands in a world, ready for beams and bodies to run into.
///
/// A solid's number counts the segments first (walls, then the edges of boxes, then the faces of door leaves),
/// then the discs, then the edges of boxes set down later, as [`Hit::solid`](crate::Hit::solid) does:
/// whatever is changed in the world, a number always means the same thing.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Solids {
    /// Walls, box edges and the faces of door leaves, metres.
    pub segments: Vec<Segment>,
    /// Posts, metres.
    pub discs: Vec<Disc>,
    /// Edges of boxes that were set down since the beginning, metres.
    pub added: Vec<Segment>,
}

impl Solids {
    /// The solids of a world, its doors as they stand.
    ///
    /// ```
    /// use cogmap_simulation::{Solids, World};
    /// let text = r#"{"format": "cogmap-world/1", "name": "Closet", "start": {"position": [0, 0]},
    ///     "walls": [[[-1, -1], [1, -1], [1, 1]]],
    ///     "boxes": [{"center": [0, 0.7], "size": [0.4, 0.2]}]}"#;
    /// let world: World = serde_json::from_str(text).unwrap();
    /// assert_eq!(Solids::of(&world).segments.len(), 2 + 4);
    /// ```
    #[must_use]
    pub fn of(world: &World) -> Self {
        let boxes: Vec<_> = world.boxes.iter().cloned().map(Some).collect();
        Self::numbered(world, &boxes, boxes.len())
    }

    /// The solids of a world that is changing: its boxes by their numbers, of which so many are the file's.
    pub(crate) fn numbered(world: &World, boxes: &[Option<BoxObstacle>], from_file: usize) -> Self {
        let walls = world.walls.iter().flat_map(|wall| wall.windows(2));
        let walls =
            walls.filter_map(|ends| Some(Segment::new((*ends.first()?).into(), (*ends.last()?).into())));
        let (boxes, added) = boxes.split_at(from_file.min(boxes.len()));
        let edges = |carton: &Option<BoxObstacle>| carton.as_ref().map_or([NOWHERE; 4], BoxObstacle::edges);
        let segments = walls
            .chain(boxes.iter().flat_map(edges))
            .chain(world.doors.iter().flat_map(Door::faces))
            .collect();
        let discs = world.posts.iter().map(|post| Disc { center: post.center.into(), radius: post.radius });
        Self { segments, discs: discs.collect(), added: added.iter().flat_map(edges).collect() }
    }
}

impl BoxObstacle {
    /// Its corners, counter-clockwise.
    #[must_use]
    pub fn corners(&self) -> [DVec2; 4] {
        let (sin, cos) = trig::sin_cos(self.heading_deg.to_radians());
        let along = DVec2::new(cos, sin) * (self.size[0] / 2.0);
        let across = DVec2::new(-sin, cos) * (self.size[1] / 2.0);
        let center = DVec2::from(self.center);
        [center - along - across, center + along - across, center + along + across, center - along + across]
    }

    /// Its four sides, counter-clockwise.
    #[must_use]
    pub fn edges(&self) -> [Segment; 4] {
        ring(self.corners())
    }

    /// Whether a point lies inside it.
    #[must_use]
    pub fn contains(&self, point: DVec2) -> bool {
        self.edges().iter().all(|edge| (edge.b - edge.a).perp_dot(point - edge.a) >= 0.0)
    }
}

impl Door {
    /// The four faces of the leaf as it stands, counter-clockwise: it is 4 cm thick.
    #[must_use]
    pub fn faces(&self) -> [Segment; 4] {
        let Segment { a, b } = self.leaf();
        let across = (b - a).normalize_or_zero().perp() * (LEAF_THICKNESS / 2.0);
        ring([a - across, b - across, b + across, a + across])
    }

    /// The middle of the leaf as it stands: on the line to the latch, or turned open counter-clockwise by 90°.
    #[must_use]
    pub fn leaf(&self) -> Segment {
        let (hinge, latch) = (DVec2::from(self.hinge), DVec2::from(self.latch));
        Segment::new(hinge, if self.open { hinge + (latch - hinge).perp() } else { latch })
    }
}

fn ring([a, b, c, d]: [DVec2; 4]) -> [Segment; 4] {
    [Segment::new(a, b), Segment::new(b, c), Segment::new(c, d), Segment::new(d, a)]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_open_door_stands_at_a_right_angle_counter_clockwise() {
        let door = Door { name: "d".into(), hinge: [4.0, 3.0], latch: [4.9, 3.0], open: true };
        assert!((door.leaf().b - DVec2::new(4.0, 3.9)).length() < 1e-12);
        let closed = Door { open: false, ..door };
        assert_eq!(closed.leaf().b, DVec2::new(4.9, 3.0));
    }

    #[test]
    fn a_door_leaf_is_seen_from_its_edge() {
        let door = Door { name: "d".into(), hinge: [4.0, 3.0], latch: [4.9, 3.0], open: true };
        let [right, edge, left, jamb] = door.faces();
        assert!((edge.length() - 0.04).abs() < 1e-12 && (jamb.length() - 0.04).abs() < 1e-12);
        assert!(edge.midpoint().distance(DVec2::new(4.0, 3.9)) < 1e-12);
        assert!((right.a.x - 4.02).abs() < 1e-12 && (left.a.x - 3.98).abs() < 1e-12);
        assert!(right.direction().unwrap().perp_dot(left.b - right.a) > 0.0, "counter-clockwise");
    }

    #[test]
    fn a_turned_box_keeps_its_size_and_contains_its_middle() {
        let carton = BoxObstacle { center: [2.0, -1.0], size: [0.6, 0.4], heading_deg: 30.0 };
        let [length, width, ..] = carton.edges().map(Segment::length);
        assert!((length - 0.6).abs() < 1e-12 && (width - 0.4).abs() < 1e-12);
        assert!(carton.contains(DVec2::new(2.0, -1.0)));
        assert!(!carton.contains(DVec2::new(2.25, -1.18)), "the corner is turned away");
    }
}
