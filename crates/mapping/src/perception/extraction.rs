use cogmap_geometry::{DVec2, LineFit, Metric, Segment, fit_line, trig};
use serde::{Deserialize, Serialize};

use super::{
    Scan, Surface, View,
    ends::{self, Extent},
};

/// How points become surfaces (§3.1.1 names no method): cut at gaps, split at corners, merge what
/// was split in vain, fit by total least squares.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Extraction {
    /// Neighbouring points farther apart than this belong to two objects, metres …
    pub gap: f64,
    /// … plus this many beam spacings at their range.
    pub gap_beams: f64,
    /// A point farther from the chord than this splits it, metres …
    pub split: f64,
    /// … plus this share of its range.
    pub split_per_range: f64,
    /// Neighbouring pieces become one where the common line leaves no point farther off, metres.
    pub merge: f64,
    /// Fewer points make no surface.
    pub min_points: usize,
    /// Shorter pieces make no surface, metres.
    pub min_length: f64,
    /// Two lines meet in a corner where their ends are this near to it, metres …
    pub corner_reach: f64,
    /// … and they are turned at least this far against each other, radians.
    pub corner_angle: f64,
}

impl Default for Extraction {
    fn default() -> Self {
        Self {
            gap: 0.10,
            gap_beams: 4.8,
            split: 0.07,
            split_per_range: 0.004,
            merge: 0.056,
            min_points: 3,
            min_length: 0.15,
            corner_reach: 0.25,
            corner_angle: 30.0 * trig::PI / 180.0,
        }
    }
}

impl Extraction {
    /// Tells apart two walls that stand a hand's breadth behind each other, as a wall and the niche of its
    /// window do: one line through both lies askew, and whoever goes by many lines is turned by it.
    #[must_use]
    pub fn fine() -> Self {
        Self { split: 0.025, split_per_range: 0.0, merge: 0.025, ..Self::default() }
    }
}

/// A point that a beam hit, in the laser's frame.
#[derive(Clone, Copy, Debug)]
pub(super) struct Point {
    pub(super) beam: usize,
    pub(super) range: f64,
    pub(super) at: DVec2,
}

/// A run of points taken as one straight line; `from..=to` index the scan's points.
#[derive(Clone, Copy, Debug)]
pub(super) struct Piece {
    pub(super) from: usize,
    pub(super) to: usize,
}

/// Finds the straight surfaces of a scan, in the robot's frame, in the order of the beams.
#[must_use]
pub fn extract(scan: &Scan, params: &Extraction) -> View {
    let points = points_of(scan);
    let mut pieces: Vec<Piece> = cut_at_gaps(&points, scan.angle_increment, params)
        .into_iter()
        .flat_map(|run| split_at_corners(&points, run, params))
        .collect();
    settle_borders(&points, &mut pieces);
    let mut pieces = merge_neighbours(&points, pieces, params);
    settle_borders(&points, &mut pieces);
    let lines: Vec<(Piece, LineFit)> =
        pieces.into_iter().filter_map(|piece| Some((piece, fit(&points, piece)?))).collect();
    let extents = ends::extents(&points, &lines, params);
    let surfaces = lines
        .iter()
        .zip(extents)
        .filter(|((piece, _), extent)| {
            piece.to - piece.from + 1 >= params.min_points && extent.segment.length() >= params.min_length
        })
        .map(|(line, extent)| surface(scan, &points, line, extent))
        .collect();
    View { surfaces }
}

fn points_of(scan: &Scan) -> Vec<Point> {
    (0..scan.ranges.len())
        .filter_map(|beam| Some(Point { beam, range: scan.range(beam)?, at: scan.point(beam)? }))
        .collect()
}

fn cut_at_gaps(points: &[Point], spacing: f64, params: &Extraction) -> Vec<Piece> {
    let mut runs = Vec::new();
    let mut from = 0;
    for (index, pair) in points.windows(2).enumerate() {
        let nearer = pair[0].range.min(pair[1].range);
        let allowed = params.gap + params.gap_beams * nearer * spacing;
        if pair[0].at.distance_from(pair[1].at) > allowed {
            runs.push(Piece { from, to: index });
            from = index + 1;
        }
    }
    if from < points.len() {
        runs.push(Piece { from, to: points.len() - 1 });
    }
    runs
}

/// Splits at the point farthest from the chord until no point is far; neighbours share that point.
fn split_at_corners(points: &[Point], run: Piece, params: &Extraction) -> Vec<Piece> {
    let mut waiting = vec![run];
    let mut done = Vec::new();
    while let Some(piece) = waiting.pop() {
        match farthest_from_chord(points, piece) {
            Some((index, distance))
                if distance > params.split + params.split_per_range * points[index].range =>
            {
                waiting.push(Piece { from: index, to: piece.to });
                waiting.push(Piece { from: piece.from, to: index });
            }
            _ => done.push(piece),
        }
    }
    done
}

fn farthest_from_chord(points: &[Point], piece: Piece) -> Option<(usize, f64)> {
    let chord = Segment::new(points[piece.from].at, points[piece.to].at);
    let mut farthest: Option<(usize, f64)> = None;
    for (index, point) in points.iter().enumerate().take(piece.to).skip(piece.from + 1) {
        let distance = chord.distance_to(point.at);
        if farthest.is_none_or(|(_, best)| distance > best) {
            farthest = Some((index, distance));
        }
    }
    farthest
}

/// Joins neighbouring pieces of one run that lie on one line after all.
fn merge_neighbours(points: &[Point], pieces: Vec<Piece>, params: &Extraction) -> Vec<Piece> {
    let mut merged: Vec<Piece> = Vec::with_capacity(pieces.len());
    for piece in pieces {
        match merged.last_mut() {
            Some(last) if last.to == piece.from && on_one_line(points, *last, piece, params) => {
                last.to = piece.to;
            }
            _ => merged.push(piece),
        }
    }
    merged
}

fn on_one_line(points: &[Point], first: Piece, second: Piece, params: &Extraction) -> bool {
    let union = Piece { from: first.from, to: second.to };
    let Some(line) = fit(points, union) else { return false };
    inner(points, union).iter().all(|p| line.offset_of(p.at).abs() <= params.merge)
}

/// Moves the border between two neighbouring pieces to where their lines meet: a chord may take in
/// a few points of the next wall before it notices the corner.
fn settle_borders(points: &[Point], pieces: &mut [Piece]) {
    for next in 1..pieces.len() {
        let (first, second) = (pieces[next - 1], pieces[next]);
        if first.to != second.from {
            continue;
        }
        let (Some(before), Some(after)) = (fit(points, first), fit(points, second)) else { continue };
        let belongs_after =
            |i: usize| after.offset_of(points[i].at).abs() < before.offset_of(points[i].at).abs();
        let mut border = first.to;
        while border > first.from + 2 && belongs_after(border - 1) {
            border -= 1;
        }
        while border + 2 < second.to && !belongs_after(border + 1) {
            border += 1;
        }
        pieces[next - 1].to = border;
        pieces[next].from = border;
    }
}

/// The points that certainly belong to a piece: those at its ends lie on a corner, where they may be
/// the neighbour's, and are left out where enough others remain.
fn inner(points: &[Point], piece: Piece) -> &[Point] {
    let trim = usize::from(piece.to - piece.from >= 4);
    &points[piece.from + trim..=piece.to - trim]
}

fn fit(points: &[Point], piece: Piece) -> Option<LineFit> {
    let inner: Vec<DVec2> = inner(points, piece).iter().map(|p| p.at).collect();
    fit_line(&inner)
}

fn surface(scan: &Scan, points: &[Point], line: &(Piece, LineFit), extent: Extent) -> Surface {
    let (piece, fit) = line;
    let own = &points[piece.from..=piece.to];
    #[allow(clippy::cast_precision_loss, reason = "a scan has a few hundred points")]
    let range = own.iter().map(|p| p.range).sum::<f64>() / own.len() as f64;
    let towards = extent.segment.midpoint().unit_or_zero();
    Surface {
        segment: scan.robot_from_laser * extent.segment,
        ends: ends::kinds(scan, points, line, extent),
        beams: [own[0].beam, own[own.len() - 1].beam],
        points: own.len(),
        residual: fit.residual,
        range,
        incidence: trig::asin(fit.direction.dot(towards).abs()),
        label: label_of(scan, own),
    }
}

/// The label that more than half of the points carry.
fn label_of(scan: &Scan, own: &[Point]) -> Option<u32> {
    let mut labels: Vec<u32> = own.iter().filter_map(|p| scan.labels.get(p.beam).copied()?).collect();
    labels.sort_unstable();
    let most = labels.chunk_by(|a, b| a == b).max_by_key(|run| run.len())?;
    (2 * most.len() > own.len()).then_some(most[0])
}

#[cfg(test)]
mod tests;
