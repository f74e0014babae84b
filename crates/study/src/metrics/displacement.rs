use cogmap_geometry::{Pose, Segment};

use super::Mapped;

/// How far a surface of the map lies from where it should, metres. What the laser mistook (two
/// walls for one, a corner cut) is no displacement: it is compared with the surface as it was seen.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Displacement {
    /// Across the wall's line, of the middle of the surface.
    pub across: f64,
    /// By how much it reaches beyond the wall's ends, and beyond what was seen of it.
    pub beyond: f64,
}

impl Displacement {
    /// Both together.
    #[must_use]
    pub fn total(&self) -> f64 {
        (self.across * self.across + self.beyond * self.beyond).sqrt()
    }
}

/// How far the surface lies from its wall when the map is laid so onto the world; `None` where no
/// wall can be named.
#[must_use]
pub fn displacement(surface: &Mapped, walls: &[Segment], world_from_map: Pose) -> Option<Displacement> {
    let wall = *walls.get(surface.wall?)?;
    let (placed, seen) = (world_from_map * surface.in_map, surface.in_world);
    let moved = placed.midpoint() - seen.midpoint();
    let Some(along) = wall.direction() else {
        return Some(Displacement { across: moved.length(), beyond: 0.0 });
    };
    let at = |end| along.dot(end - wall.a);
    let span = |s: Segment| (at(s.a).min(at(s.b)), at(s.a).max(at(s.b)));
    let (seen, placed) = (span(seen), span(placed));
    let before = seen.0.min(0.0) - placed.0;
    let after = placed.1 - seen.1.max(wall.length());
    Some(Displacement { across: along.perp_dot(moved).abs(), beyond: before.max(after).max(0.0) })
}

#[cfg(test)]
mod tests {
    use cogmap_geometry::DVec2;

    use super::*;

    fn line(ax: f64, ay: f64, bx: f64, by: f64) -> Segment {
        Segment::new(DVec2::new(ax, ay), DVec2::new(bx, by))
    }

    #[test]
    fn a_surface_0_3_off_its_wall_and_0_4_beyond_its_end_is_displaced_by_0_5() {
        let wall = line(0.0, 0.0, 4.0, 0.0);
        let (in_map, in_world) = (line(2.0, 0.3, 4.4, 0.3), line(1.6, 0.0, 4.0, 0.0));
        let surface = Mapped { in_map, in_world, wall: Some(0) };
        let found = displacement(&surface, &[wall], Pose::IDENTITY).unwrap();
        assert!((found.across - 0.3).abs() < 1e-12 && (found.beyond - 0.4).abs() < 1e-12);
        assert!((found.total() - 0.5).abs() < 1e-12);
    }

    #[test]
    fn a_surface_that_was_seen_across_a_doorway_is_not_displaced() {
        let wall = line(0.0, 0.0, 2.0, 0.0);
        let seen = line(1.0, 0.05, 3.5, 0.05);
        let surface = Mapped { in_map: seen, in_world: seen, wall: Some(0) };
        assert_eq!(displacement(&surface, &[wall], Pose::IDENTITY).unwrap().total(), 0.0);
    }

    #[test]
    fn it_is_measured_where_the_map_is_laid() {
        let wall = line(0.0, 0.0, 0.0, 4.0);
        let surface = Mapped { in_map: line(1.0, 0.0, 3.0, 0.0), in_world: wall, wall: Some(0) };
        let laid = Pose::new(0.25, 0.0, cogmap_geometry::trig::FRAC_PI_2);
        let found = displacement(&surface, &[wall], laid).unwrap();
        assert!((found.across - 0.25).abs() < 1e-12 && found.beyond == 0.0);
        assert_eq!(displacement(&Mapped { wall: None, ..surface }, &[wall], laid), None);
    }

    #[test]
    fn a_post_is_displaced_by_however_far_it_lies_from_where_it_was_seen() {
        let post = line(1.0, 1.0, 1.0, 1.0);
        let (in_map, in_world) = (line(1.3, 1.4, 1.4, 1.4), line(1.0, 1.0, 1.1, 1.0));
        let found = displacement(&Mapped { in_map, in_world, wall: Some(0) }, &[post], Pose::IDENTITY);
        assert!((found.unwrap().total() - 0.5).abs() < 1e-12);
    }
}
