use cogmap_geometry::{Pose, Segment};

use super::Mapped;

/// How far a surface of the map lies from where its wall is, metres.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Displacement {
    /// From the wall's line to the middle of the surface.
    pub across: f64,
    /// By how much the surface reaches beyond the wall's ends.
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
    let placed = world_from_map * surface.in_map;
    let Some(along) = wall.direction() else {
        return Some(Displacement { across: placed.distance_to(wall.a), beyond: 0.0 });
    };
    let across = wall.offset_of(placed.midpoint())?.abs();
    let reach = |end| {
        let at = along.dot(end - wall.a);
        (-at).max(at - wall.length()).max(0.0)
    };
    Some(Displacement { across, beyond: reach(placed.a).max(reach(placed.b)) })
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
        let in_map = line(2.0, 0.3, 4.4, 0.3);
        let surface = Mapped { in_map, in_world: in_map, wall: Some(0) };
        let found = displacement(&surface, &[wall], Pose::IDENTITY).unwrap();
        assert!((found.across - 0.3).abs() < 1e-12 && (found.beyond - 0.4).abs() < 1e-12);
        assert!((found.total() - 0.5).abs() < 1e-12);
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
}
