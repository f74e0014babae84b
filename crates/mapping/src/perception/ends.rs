//! Where a surface ends, and why (the kinds decide later what may serve as an anchor).

use cogmap_geometry::{DVec2, LineFit, Segment, line_angle_between, trig};

use super::{
    End, Extraction, Scan,
    extraction::{Piece, Point},
};

/// A neighbouring point this near to the line's continuation continues it, share of its range.
const ON_THE_LINE: f64 = 0.03;
/// Beams that graze a surface more than this see too little of it to tell where it ends, radians.
const GRAZING: f64 = 82.0 * trig::PI / 180.0;

/// The pieces as segments on their lines, drawn out to the corner where two neighbours meet.
pub(super) fn with_corners(
    points: &[Point],
    lines: &[(Piece, LineFit)],
    params: &Extraction,
) -> Vec<Segment> {
    let mut segments: Vec<Segment> = lines
        .iter()
        .map(|(piece, line)| {
            Segment::new(line.project(points[piece.from].at), line.project(points[piece.to].at))
        })
        .collect();
    for next in 1..lines.len() {
        let (first, second) = (&lines[next - 1], &lines[next]);
        let touching = second.0.from <= first.0.to + 1;
        if let Some(corner) = corner_of(&first.1, &second.1, params)
            && touching
            && segments[next - 1].b.distance(corner) <= params.corner_reach
            && segments[next].a.distance(corner) <= params.corner_reach
        {
            segments[next - 1].b = corner;
            segments[next].a = corner;
        }
    }
    segments
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
pub(super) fn kinds(scan: &Scan, points: &[Point], piece: Piece, line: &LineFit) -> [End; 2] {
    let before = piece.from.checked_sub(1).and_then(|i| points.get(i));
    let after = points.get(piece.to + 1);
    [
        kind(scan, line, &points[piece.from], before, points[piece.from].beam.checked_sub(1)),
        kind(scan, line, &points[piece.to], after, Some(points[piece.to].beam + 1)),
    ]
}

/// Looks at the beam beside the end: what would it have measured had the surface gone on?
fn kind(scan: &Scan, line: &LineFit, end: &Point, neighbour: Option<&Point>, beside: Option<usize>) -> End {
    let Some(beam) = beside.filter(|&beam| beam < scan.ranges.len()) else {
        return End::RangeLimit;
    };
    let Some(expected) = range_of_line(line, scan.bearing(beam)).filter(|&r| r < scan.range_max) else {
        return End::RangeLimit;
    };
    match neighbour.filter(|n| n.beam == beam) {
        Some(seen) if touches(seen, end, scan) => End::True,
        // The surface goes on, only too thinly sampled to be followed.
        Some(seen) if (seen.range - expected).abs() < expected * ON_THE_LINE => End::RangeLimit,
        Some(seen) if seen.range < expected => End::Occlusion,
        Some(_) => End::True,
        None if grazing(line, end) => End::RangeLimit,
        None => End::True,
    }
}

/// Whether the next point stands where the end is, so that the two meet in a corner.
fn touches(seen: &Point, end: &Point, scan: &Scan) -> bool {
    seen.at.distance(end.at) <= 0.10 + 3.0 * end.range * scan.angle_increment
}

fn grazing(line: &LineFit, end: &Point) -> bool {
    trig::asin(line.direction.dot(end.at.normalize_or_zero()).abs()) > GRAZING
}

/// How far a beam flies until it meets the line; `None` where it never does.
fn range_of_line(line: &LineFit, bearing: f64) -> Option<f64> {
    let (sin, cos) = trig::sin_cos(bearing);
    let beam = DVec2::new(cos, sin);
    let cross = beam.perp_dot(line.direction);
    let range = line.centroid.perp_dot(line.direction) / cross;
    (range.is_finite() && range > 0.0).then_some(range)
}
