//! Where a surface ends, and why (the kinds decide later what may serve as an anchor).

use cogmap_geometry::{DVec2, LineFit, Metric, Segment, line_angle_between, trig};

use super::{
    End, Extraction, Scan,
    extraction::{Piece, Point},
};

/// A neighbouring point this near to the line's continuation continues it, metres …
const ON_THE_LINE: f64 = 0.05;
/// … and this share of its range.
const ON_THE_LINE_PER_RANGE: f64 = 0.004;
/// Farther along the line than the next beam should hit it by this, something is open between, metres.
const OPENING: f64 = 0.3;
/// Beams that graze a surface more than this see too little of it to tell where it ends, radians.
const GRAZING: f64 = 70.0 * trig::PI / 180.0;

/// A piece as a segment on its line; which of its ends are corners, where it meets its neighbour.
#[derive(Clone, Copy)]
pub(super) struct Extent {
    pub(super) segment: Segment,
    corners: [bool; 2],
}

/// The pieces as segments on their lines, drawn out to the corner where two neighbours meet.
pub(super) fn extents(points: &[Point], lines: &[(Piece, LineFit)], params: &Extraction) -> Vec<Extent> {
    let on_line = |(piece, line): &(Piece, LineFit)| {
        let ends = [piece.from, piece.to].map(|end| line.project(points[end].at));
        Extent { segment: Segment::new(ends[0], ends[1]), corners: [false; 2] }
    };
    let mut extents: Vec<Extent> = lines.iter().map(on_line).collect();
    for next in 1..lines.len() {
        let (first, second) = (&lines[next - 1], &lines[next]);
        let touching = second.0.from <= first.0.to + 1;
        if let Some(corner) = corner_of(&first.1, &second.1, params)
            && touching
            && extents[next - 1].segment.b.distance_from(corner) <= params.corner_reach
            && extents[next].segment.a.distance_from(corner) <= params.corner_reach
        {
            extents[next - 1].segment.b = corner;
            extents[next - 1].corners[1] = true;
            extents[next].segment.a = corner;
            extents[next].corners[0] = true;
        }
    }
    extents
}

fn corner_of(first: &LineFit, second: &LineFit, params: &Extraction) -> Option<DVec2> {
    let angle = |d: DVec2| trig::atan2(d.y, d.x);
    if line_angle_between(angle(first.direction), angle(second.direction)) < params.corner_angle {
        return None;
    }
    let cross = first.direction.perp_dot(second.direction);
    let along = (second.centroid - first.centroid).perp_dot(second.direction) / cross;
    Some(first.centroid + first.direction * along)
}

/// Why the piece ends at its first and at its last point.
pub(super) fn kinds(
    scan: &Scan,
    points: &[Point],
    (piece, line): &(Piece, LineFit),
    extent: Extent,
) -> [End; 2] {
    let (first, last) = (&points[piece.from], &points[piece.to]);
    let before = piece.from.checked_sub(1).and_then(|i| points.get(i));
    let kind = |end: usize, at: &Point, neighbour: Option<&Point>, beside: Option<usize>| {
        if extent.corners[end] { End::True } else { open_kind(scan, line, at, neighbour, beside) }
    };
    [
        kind(0, first, before, first.beam.checked_sub(1)),
        kind(1, last, points.get(piece.to + 1), Some(last.beam + 1)),
    ]
}

/// Looks at the beam beside an end that is no corner: what would it have measured had the surface
/// gone on, and what did it measure?
fn open_kind(
    scan: &Scan,
    line: &LineFit,
    end: &Point,
    neighbour: Option<&Point>,
    beside: Option<usize>,
) -> End {
    let Some(beam) = beside.filter(|&beam| beam < scan.ranges.len()) else {
        return End::RangeLimit;
    };
    let Some(expected) = range_of_line(line, scan.bearing(beam)).filter(|&r| r < scan.range_max) else {
        return End::RangeLimit;
    };
    match neighbour.filter(|n| n.beam == beam) {
        Some(seen) if touches(seen, end, scan) => End::True,
        Some(seen) if goes_on(line, end, seen, expected) => End::RangeLimit,
        Some(seen) if seen.range < expected => End::Occlusion,
        Some(_) => End::True,
        None if grazing(line, end) => End::RangeLimit,
        None => End::True,
    }
}

/// Whether the next point stands where the end is, so that two surfaces meet there, however slightly
/// they are turned against each other.
fn touches(seen: &Point, end: &Point, scan: &Scan) -> bool {
    seen.at.distance_from(end.at) <= 0.10 + 3.0 * end.range * scan.angle_increment
}

/// Whether the surface goes on at the next beam, only bent a little or too thinly sampled to follow.
fn goes_on(line: &LineFit, end: &Point, seen: &Point, expected: f64) -> bool {
    let on_line = line.offset_of(seen.at).abs() <= ON_THE_LINE + ON_THE_LINE_PER_RANGE * seen.range;
    on_line && seen.at.distance_from(end.at) <= OPENING + 2.0 * (expected - end.range).abs()
}

fn grazing(line: &LineFit, end: &Point) -> bool {
    trig::asin(line.direction.dot(end.at.unit_or_zero()).abs()) > GRAZING
}

/// How far a beam flies until it meets the line; `None` where it never does.
fn range_of_line(line: &LineFit, bearing: f64) -> Option<f64> {
    let (sin, cos) = trig::sin_cos(bearing);
    let beam = DVec2::new(cos, sin);
    let cross = beam.perp_dot(line.direction);
    let range = line.centroid.perp_dot(line.direction) / cross;
    (range.is_finite() && range > 0.0).then_some(range)
}
