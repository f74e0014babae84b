use cogmap_geometry::Segment;

use super::Mapped;

/// Two pieces are joined where the gap between them is no longer than this, metres …
const GAP: f64 = 0.5;
/// … they are turned against each other by no more than this, radians …
const ANGLE: f64 = 5.0 * cogmap_geometry::trig::PI / 180.0;
/// … and lie no farther than this beside each other, metres.
const OFFSET: f64 = 0.15;

/// How often long walls stand in a map.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Duplicates {
    /// Long walls of which the map holds a long surface.
    pub walls: usize,
    /// Pieces that their long surfaces make once those are joined that go on from each other; one a
    /// wall is ideal.
    pub pieces: usize,
    /// Metres of their long surfaces together.
    pub mapped: f64,
    /// Metres of true wall that those surfaces show.
    pub shown: f64,
}

/// Counts how often the true long walls stand in the map, by their long surfaces.
#[must_use]
pub fn duplicates(surfaces: &[Mapped], walls: &[Segment]) -> Duplicates {
    let mut found = Duplicates::default();
    for (number, wall) in walls.iter().enumerate().filter(|(_, wall)| wall.length() >= super::LONG) {
        let of_wall: Vec<&Mapped> =
            surfaces.iter().filter(|s| s.wall == Some(number) && s.is_long()).collect();
        if of_wall.is_empty() {
            continue;
        }
        let in_map: Vec<Segment> = of_wall.iter().map(|s| s.in_map).collect();
        found.walls += 1;
        found.pieces += pieces(&in_map);
        found.mapped += in_map.iter().map(|s| s.length()).sum::<f64>();
        found.shown += covered(*wall, of_wall.iter().map(|s| s.in_world));
    }
    found
}

/// How many pieces remain when those are joined that go on from each other.
fn pieces(surfaces: &[Segment]) -> usize {
    let mut group: Vec<usize> = (0..surfaces.len()).collect();
    for second in 1..surfaces.len() {
        for first in 0..second {
            if group[first] != group[second] && go_on(surfaces[first], surfaces[second]) {
                let (from, to) = (group[second], group[first]);
                group.iter_mut().filter(|g| **g == from).for_each(|g| *g = to);
            }
        }
    }
    group.sort_unstable();
    group.dedup();
    group.len()
}

fn go_on(first: Segment, second: Segment) -> bool {
    let (longer, shorter) = if first.length() >= second.length() { (first, second) } else { (second, first) };
    let ends = [longer.share_of(shorter.a), longer.share_of(shorter.b)].map(|share| share * longer.length());
    let gap = (-ends[0].max(ends[1])).max(ends[0].min(ends[1]) - longer.length());
    let offset = longer.offset_of(shorter.midpoint()).map_or(f64::INFINITY, f64::abs);
    longer.angle_to(shorter) <= ANGLE && offset <= OFFSET && gap <= GAP
}

/// Metres of a wall that lie under at least one of the surfaces.
fn covered(wall: Segment, surfaces: impl Iterator<Item = Segment>) -> f64 {
    let along = |point| wall.share_of(point).clamp(0.0, 1.0) * wall.length();
    let mut spans: Vec<(f64, f64)> =
        surfaces.map(|s| (along(s.a), along(s.b))).map(|(a, b)| (a.min(b), a.max(b))).collect();
    spans.sort_by(|a, b| a.0.total_cmp(&b.0));
    let (mut sum, mut until) = (0.0, 0.0);
    for (from, to) in spans {
        sum += (to - from.max(until)).max(0.0);
        until = to.max(until);
    }
    sum
}

#[cfg(test)]
mod tests {
    use cogmap_geometry::DVec2;

    use super::*;

    fn line(ax: f64, ay: f64, bx: f64, by: f64) -> Segment {
        Segment::new(DVec2::new(ax, ay), DVec2::new(bx, by))
    }

    /// Two walls; the first stands in the map in two pieces that go on from each other and once more
    /// 0.4 m beside them, the second once.
    #[test]
    fn a_wall_that_stands_twice_counts_twice_however_many_pieces_it_is_drawn_in() {
        let walls = [line(0.0, 0.0, 6.0, 0.0), line(6.0, 0.0, 6.0, 3.0), line(0.0, 0.0, 0.0, 0.5)];
        let mapped = |in_map, in_world, wall| Mapped { in_map, in_world, wall: Some(wall) };
        let surfaces = [
            mapped(line(0.0, 0.0, 2.0, 0.0), line(0.0, 0.0, 2.0, 0.0), 0),
            mapped(line(2.4, 0.1, 5.0, 0.1), line(2.4, 0.0, 5.0, 0.0), 0),
            mapped(line(1.0, 0.4, 4.0, 0.4), line(1.0, 0.0, 4.0, 0.0), 0),
            mapped(line(6.0, 0.0, 6.0, 3.0), line(6.0, 0.0, 6.0, 3.0), 1),
            mapped(line(6.1, 1.0, 6.1, 1.8), line(6.0, 1.0, 6.0, 1.8), 1),
            mapped(line(0.0, 0.0, 0.0, 1.5), line(0.0, 0.0, 0.0, 0.5), 2),
        ];
        let found = duplicates(&surfaces, &walls);
        assert_eq!((found.walls, found.pieces), (2, 3), "short surfaces and short walls do not count");
        assert!((found.mapped - (2.0 + 2.6 + 3.0 + 3.0)).abs() < 1e-12);
        assert!((found.shown - (5.0 + 3.0)).abs() < 1e-12);
    }

    #[test]
    fn pieces_join_across_a_gap_of_half_a_metre_and_no_more() {
        assert_eq!(pieces(&[line(0.0, 0.0, 2.0, 0.0), line(2.5, 0.0, 4.0, 0.0)]), 1);
        assert_eq!(pieces(&[line(0.0, 0.0, 2.0, 0.0), line(4.0, 0.0, 2.51, 0.0)]), 2);
        assert_eq!(pieces(&[line(0.0, 0.0, 2.0, 0.0), line(0.0, 0.0, 2.0, 0.15)]), 1);
        assert_eq!(pieces(&[line(0.0, 0.0, 2.0, 0.0), line(0.0, 0.0, 2.0, 0.4)]), 2);
        assert_eq!(pieces(&[]), 0);
    }
}
