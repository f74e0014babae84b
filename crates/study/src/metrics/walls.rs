use cogmap_geometry::{DVec2, Segment};

/// Two pieces of a wall belong together if they meet this closely, metres …
const TOUCHING: f64 = 0.02;
/// … and are turned against each other by no more than this, radians.
const STRAIGHT: f64 = 0.01;
/// A surface this long is one that a map's shape rests on, metres.
pub const LONG: f64 = 1.0;

/// A surface of a map, and what it is in truth.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mapped {
    /// Where the map has it, metres.
    pub in_map: Segment,
    /// Where it truly was when it was stored, in the world, metres.
    pub in_world: Segment,
    /// The wall that most of its points lie on, as [`Walls`] numbers them.
    pub wall: Option<usize>,
}

impl Mapped {
    /// Whether it counts among the long ones.
    #[must_use]
    pub fn is_long(&self) -> bool {
        self.in_map.length() >= LONG
    }
}

/// The straight walls that truly stand in a building: pieces that go on straight are one wall.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Walls {
    lines: Vec<Segment>,
    wall_of_solid: Vec<usize>,
}

impl Walls {
    /// Joins the pieces of straight walls; a post is a wall without length.
    #[must_use]
    pub fn of(segments: &[Segment], posts: &[DVec2]) -> Self {
        let posts = posts.iter().map(|&middle| Segment::new(middle, middle));
        let solids: Vec<Segment> = segments.iter().copied().chain(posts).collect();
        let mut group: Vec<usize> = (0..solids.len()).collect();
        for second in 1..solids.len() {
            for first in 0..second {
                if goes_on(solids[first], solids[second]) {
                    let (from, to) = (group[second].max(group[first]), group[second].min(group[first]));
                    group.iter_mut().filter(|g| **g == from).for_each(|g| *g = to);
                }
            }
        }
        let mut walls = Self::default();
        let mut number = vec![None; solids.len()];
        for (solid, &leader) in solids.iter().zip(&group) {
            let wall = *number[leader].get_or_insert_with(|| {
                walls.lines.push(*solid);
                walls.lines.len() - 1
            });
            walls.lines[wall] = spanning(walls.lines[wall], *solid);
            walls.wall_of_solid.push(wall);
        }
        walls
    }

    /// Each wall from end to end, metres.
    #[must_use]
    pub fn lines(&self) -> &[Segment] {
        &self.lines
    }

    /// The wall that a solid is a piece of.
    #[must_use]
    pub fn of_solid(&self, solid: u32) -> Option<usize> {
        self.wall_of_solid.get(solid as usize).copied()
    }
}

fn goes_on(first: Segment, second: Segment) -> bool {
    let touch =
        [first.a, first.b].iter().any(|p| [second.a, second.b].iter().any(|q| p.distance(*q) < TOUCHING));
    touch && first.length() > 0.0 && second.length() > 0.0 && first.angle_to(second) < STRAIGHT
}

/// The longest line between ends of the two.
fn spanning(first: Segment, second: Segment) -> Segment {
    let ends = [first.a, first.b, second.a, second.b];
    let mut longest = first;
    for (k, &a) in ends.iter().enumerate() {
        for &b in &ends[k + 1..] {
            if a.distance(b) > longest.length() {
                longest = Segment::new(a, b);
            }
        }
    }
    longest
}

#[cfg(test)]
mod tests {
    use super::*;

    fn line(ax: f64, ay: f64, bx: f64, by: f64) -> Segment {
        Segment::new(DVec2::new(ax, ay), DVec2::new(bx, by))
    }

    #[test]
    fn a_wall_drawn_in_pieces_is_one_wall_and_a_corner_makes_two() {
        let pieces = [line(0.0, 0.0, 2.0, 0.0), line(2.0, 0.0, 5.0, 0.0), line(5.0, 0.0, 5.0, 3.0)];
        let walls = Walls::of(&pieces, &[DVec2::ONE]);
        assert_eq!(walls.lines()[0], line(0.0, 0.0, 5.0, 0.0));
        assert_eq!((0..4).map(|solid| walls.of_solid(solid).unwrap()).collect::<Vec<_>>(), [0, 0, 1, 2]);
        assert_eq!(walls.of_solid(4), None);
    }

    #[test]
    fn a_doorway_parts_a_wall() {
        let walls = Walls::of(&[line(0.0, 0.0, 2.0, 0.0), line(2.9, 0.0, 5.0, 0.0)], &[]);
        assert_eq!(walls.lines().len(), 2);
    }
}
