//! Ideal views: the exact visible parts of walls, without beams and without noise.

use cogmap_geometry::{DVec2, Pose, Segment, trig};
use cogmap_mapping::perception::{End, Surface, View};

/// How far the ideal eye sees, metres.
const RANGE: f64 = 30.0;

/// Everything of the walls that can be seen from a pose within the half circle ahead.
pub(crate) fn view(walls: &[Segment], world_from_robot: Pose) -> View {
    let robot_from_world = world_from_robot.inverse();
    let walls: Vec<Segment> = walls.iter().map(|&wall| robot_from_world * wall).collect();
    let mut surfaces: Vec<Surface> = Vec::new();
    let mut last: Option<usize> = None;
    let bearings = critical_bearings(&walls);
    for pair in bearings.windows(2) {
        let wall = first_wall(&walls, f64::midpoint(pair[0], pair[1]));
        match (wall, surfaces.last_mut()) {
            (Some(wall), Some(surface)) if last == Some(wall) => extend(surface, walls[wall], pair[1]),
            (Some(wall), _) => surfaces.push(piece(walls[wall], pair[0], pair[1], surfaces.len())),
            (None, _) => {}
        }
        last = wall;
    }
    surfaces.retain(|surface| surface.segment.length() > 0.2);
    View { surfaces }
}

/// Between two of these the nearest wall stays the same.
fn critical_bearings(walls: &[Segment]) -> Vec<f64> {
    let mut bearings = vec![-trig::FRAC_PI_2, trig::FRAC_PI_2];
    bearings.extend(walls.iter().flat_map(|wall| [wall.a, wall.b]).map(bearing));
    bearings.retain(|bearing| bearing.abs() <= trig::FRAC_PI_2);
    bearings.sort_by(f64::total_cmp);
    bearings.dedup_by(|a, b| (*a - *b).abs() < 1e-12);
    bearings
}

fn bearing(point: DVec2) -> f64 {
    trig::atan2(point.y, point.x)
}

fn first_wall(walls: &[Segment], bearing: f64) -> Option<usize> {
    let (sin, cos) = trig::sin_cos(bearing);
    let ray = Segment::new(DVec2::ZERO, DVec2::new(cos, sin) * RANGE);
    let distance = |wall: &Segment| ray.crossing(*wall).map_or(f64::INFINITY, DVec2::length);
    (0..walls.len())
        .filter(|&wall| distance(&walls[wall]).is_finite())
        .min_by(|&a, &b| distance(&walls[a]).total_cmp(&distance(&walls[b])))
}

fn piece(wall: Segment, from: f64, to: f64, index: usize) -> Surface {
    let ((a, first), (b, second)) = (end_at(wall, from), end_at(wall, to));
    Surface {
        segment: Segment::new(a, b),
        ends: [first, second],
        beams: [index, index],
        points: 100,
        residual: 0.0,
        range: f64::midpoint(a.length(), b.length()),
        incidence: 0.5,
        label: None,
    }
}

fn extend(surface: &mut Surface, wall: Segment, to: f64) {
    let (b, end) = end_at(wall, to);
    surface.segment.b = b;
    surface.ends[1] = end;
    surface.range = f64::midpoint(surface.segment.a.length(), b.length());
}

/// Where the ray at that bearing meets the wall: exactly its own end, if that is what lies there.
fn end_at(wall: Segment, at: f64) -> (DVec2, End) {
    if let Some(own) = [wall.a, wall.b].into_iter().find(|&end| (bearing(end) - at).abs() < 1e-12) {
        return (own, End::True);
    }
    let (sin, cos) = trig::sin_cos(at);
    let (ray, along) = (DVec2::new(cos, sin), wall.b - wall.a);
    let range = wall.a.perp_dot(along) / ray.perp_dot(along);
    let kind = if at.abs() < trig::FRAC_PI_2 { End::Occlusion } else { End::RangeLimit };
    (ray * range, kind)
}

/// A rectangular hall with boxes standing in it, far enough from each other that no gate confuses them.
pub(crate) fn hall(width: f64, depth: f64, boxes: &[(f64, f64, f64)]) -> Vec<Segment> {
    let mut walls = ring(Pose::new(width / 2.0, depth / 2.0, 0.0), width, depth);
    for (&(x, y, turn), place) in boxes.iter().zip([3.0, 7.0, 11.0]) {
        let center = DVec2::new(place + x, depth - 2.5 + y);
        walls.extend(ring(Pose::new(center.x, center.y, turn), 1.4, 1.2));
    }
    walls
}

fn ring(world_from_center: Pose, width: f64, depth: f64) -> Vec<Segment> {
    let corner = |x: f64, y: f64| world_from_center * DVec2::new(x * width / 2.0, y * depth / 2.0);
    let corners = [corner(-1.0, -1.0), corner(1.0, -1.0), corner(1.0, 1.0), corner(-1.0, 1.0)];
    (0..4).map(|i| Segment::new(corners[i], corners[(i + 1) % 4])).collect()
}
