//! Small things that many figures draw.

use cogmap_geometry::{DVec2, Pose, Segment, trig};
use cogmap_mapping::perception::{Scan, Surface};
use cogmap_scene::{Annotation, Item, LegendEntry, Panel, Role, Sample, Scene, Shape};

/// Radius of the robot's footprint, metres.
pub(super) const ROBOT: f64 = 0.25;

/// The role of an annotation.
pub(super) const fn role(annotation: Annotation) -> Role {
    Role::Annotation(annotation)
}

/// A word around a point.
pub(super) fn word(at: DVec2, text: impl Into<String>) -> Item {
    let shape = Shape::Label { at, text: text.into(), room: f64::INFINITY };
    Item::new(role(Annotation::Word), shape)
}

/// Lines that do not hang together.
pub(super) fn lines(role: Role, lines: impl IntoIterator<Item = Segment>) -> Item {
    Item::new(role, Shape::Segments(lines.into_iter().collect()))
}

/// The lines of surfaces, seen from another frame.
pub(super) fn surfaces<'a>(
    role: Role,
    other_from_robot: Pose,
    surfaces: impl IntoIterator<Item = &'a Surface>,
) -> Item {
    lines(role, surfaces.into_iter().map(|surface| other_from_robot * surface.segment))
}

/// A robot.
pub(super) fn robot(role: Role, pose: Pose) -> Item {
    Item::new(role, Shape::Robot(pose, ROBOT))
}

/// A ring around a place.
pub(super) fn ring(center: DVec2, radius: f64) -> Item {
    Item::new(role(Annotation::Ring), Shape::Disc(center, radius))
}

/// A line with an arrowhead at its end.
pub(super) fn arrow(annotation: Annotation, points: &[DVec2]) -> Item {
    Item::new(role(annotation), Shape::Arrow(points.to_vec()))
}

/// A line in dashes of that length, metres.
pub(super) fn dashed(line: Segment, dash: f64) -> Vec<Segment> {
    let pieces = (line.length() / dash).round().max(1.0);
    let at = |piece: f64| line.a.lerp(line.b, (piece / pieces).min(1.0));
    let mut dashes = Vec::new();
    let mut piece = 0.0;
    while piece < pieces {
        dashes.push(Segment::new(at(piece), at(piece + 1.0)));
        piece += 2.0;
    }
    dashes
}

/// A piece of a circle from one bearing to another.
pub(super) fn arc(center: DVec2, radius: f64, from: f64, to: f64) -> Shape {
    const PIECES: u32 = 24;
    let at = |piece: u32| {
        let bearing = from + (to - from) * f64::from(piece) / f64::from(PIECES);
        center + DVec2::new(trig::cos(bearing), trig::sin(bearing)) * radius
    };
    Shape::Polyline((0..=PIECES).map(at).collect())
}

/// The points that a scan hit, seen from another frame.
pub(super) fn hits(scan: &Scan, other_from_robot: Pose) -> Item {
    let other_from_laser = other_from_robot * scan.robot_from_laser;
    let points = (0..scan.ranges.len()).filter_map(|beam| scan.point(beam));
    Item::new(Role::LaserHit, Shape::Signs(points.map(|point| other_from_laser * point).collect()))
}

/// A panel with the items from the ground up, and what they mean.
pub(super) fn panel(heading: impl Into<String>, still: Vec<Item>, legend: &[(Sample, &str)]) -> Panel {
    let legend = legend.iter().map(|(sample, text)| LegendEntry::new(*sample, *text)).collect();
    Panel { heading: heading.into(), scene: Scene { still, legend, ..Scene::default() }, room: None }
}

/// An angle as people write it.
pub(super) fn degrees(radians: f64) -> String {
    format!("{:.1}°", radians.to_degrees())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn dashes_begin_and_end_with_the_line_and_leave_gaps() {
        let line = Segment::new(DVec2::ZERO, DVec2::new(0.9, 0.0));
        let dashes = dashed(line, 0.1);
        assert_eq!(dashes.len(), 5);
        assert_eq!((dashes[0].a, dashes[4].b), (line.a, line.b));
        assert!(dashes.iter().all(|dash| (dash.length() - 0.1).abs() < 1e-9));
    }

    #[test]
    fn an_arc_keeps_its_distance() {
        let Shape::Polyline(points) = arc(DVec2::ONE, 2.0, 0.3, -1.0) else { panic!() };
        assert!(points.iter().all(|point| (point.distance(DVec2::ONE) - 2.0).abs() < 1e-12));
    }
}
