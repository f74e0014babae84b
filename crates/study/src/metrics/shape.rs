use cogmap_geometry::{Pose, Segment, trig};

use super::{LONG, Mapped, Sample, alignment::by_whole_way};

/// A surface that was seen turned from its wall by more than this shows something else as well, radians.
const ASKEW: f64 = 5.0 * trig::PI / 180.0;

/// How far a map's shape is from the building's.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Shape {
    /// Root mean square distance of the way in the map from the true way, laid onto it as well as
    /// can be, metres.
    pub rms: f64,
    /// Length of the true way, metres.
    pub route: f64,
}

impl Shape {
    /// The distance as a share of the way.
    #[must_use]
    pub fn error(&self) -> f64 {
        self.rms / self.route
    }
}

/// The shape of the way, whatever its place and direction; `None` where the robot never moved.
#[must_use]
#[allow(clippy::cast_precision_loss, reason = "a run has a few thousand views")]
pub fn shape(samples: &[Sample]) -> Option<Shape> {
    let world_from_map = by_whole_way(samples)?;
    let off = |s: &Sample| (world_from_map * s.map_from_robot.position).distance(s.world_from_robot.position);
    let squares: f64 = samples.iter().map(off).map(|distance| distance * distance).sum();
    let route = length(samples);
    (route > 0.0).then(|| Shape { rms: (squares / samples.len() as f64).sqrt(), route })
}

/// Metres that the robot truly went.
#[must_use]
pub fn length(samples: &[Sample]) -> f64 {
    let step =
        |pair: &[Sample]| pair[0].world_from_robot.position.distance(pair[1].world_from_robot.position);
    samples.windows(2).map(step).sum()
}

/// How far the long walls of the map are turned from where they should be: root mean square over
/// the walls, radians; of a wall, the mean over its long surfaces by their lengths.
#[must_use]
#[allow(clippy::cast_precision_loss, reason = "a building has a few hundred walls")]
pub fn side_angles(surfaces: &[Mapped], walls: &[Segment], world_from_map: Pose) -> Option<f64> {
    let mut squares = Vec::new();
    for (number, wall) in walls.iter().enumerate().filter(|(_, wall)| wall.length() >= LONG) {
        let (mut sum, mut weight) = (0.0, 0.0);
        let shows = |s: &&Mapped| s.wall == Some(number) && s.is_long() && s.in_world.angle_to(*wall) < ASKEW;
        for surface in surfaces.iter().filter(shows) {
            let placed = world_from_map * surface.in_map;
            sum += turned(placed.heading() - wall.heading()) * placed.length();
            weight += placed.length();
        }
        if weight > 0.0 {
            squares.push((sum / weight) * (sum / weight));
        }
    }
    (!squares.is_empty()).then(|| (squares.iter().sum::<f64>() / squares.len() as f64).sqrt())
}

/// The angle between two undirected lines, `(-π/2, π/2]`.
fn turned(angle: f64) -> f64 {
    cogmap_geometry::normalize_angle(2.0 * angle.clamp(-trig::TAU, trig::TAU)) / 2.0
}

#[cfg(test)]
mod tests {
    use cogmap_geometry::DVec2;

    use super::*;

    /// The robot drives the sides of a square of 2 m; its map stretches them to 2.2 m.
    #[test]
    fn a_square_stretched_by_a_tenth_is_off_by_a_tenth_of_its_half_diagonal() {
        let corner = |x: f64, y: f64| Sample {
            world_from_robot: Pose::new(x, y, 0.0),
            map_from_robot: Pose::new(5.0 - 1.1 * y, 1.1 * x, 1.0),
        };
        let samples = [corner(-1.0, -1.0), corner(1.0, -1.0), corner(1.0, 1.0), corner(-1.0, 1.0)];
        let Shape { rms, route } = shape(&samples).unwrap();
        assert!((rms - 0.1 * 2.0_f64.sqrt()).abs() < 1e-12 && route == 6.0, "{rms} {route}");
        assert_eq!(shape(&samples[..1]), None);
    }

    #[test]
    fn a_wall_turned_by_2_degrees_and_one_that_is_not_make_the_root_of_2_degrees() {
        let line = |ax, ay, bx, by| Segment::new(DVec2::new(ax, ay), DVec2::new(bx, by));
        let walls = [line(0.0, 0.0, 4.0, 0.0), line(4.0, 0.0, 4.0, 4.0), line(0.0, 0.0, 0.9, 0.0)];
        let turn = Pose::new(0.0, 0.0, 2.0_f64.to_radians());
        let mapped = |in_map, wall| Mapped { in_map, in_world: walls[wall], wall: Some(wall) };
        let surfaces =
            [mapped(turn * walls[0].reversed(), 0), mapped(walls[1], 1), mapped(turn * walls[2], 2)];
        let angle = side_angles(&surfaces, &walls, Pose::IDENTITY).unwrap().to_degrees();
        assert!((angle - 2.0_f64.sqrt()).abs() < 1e-9, "{angle}");
        assert_eq!(side_angles(&surfaces[2..], &walls, Pose::IDENTITY), None);
    }
}
