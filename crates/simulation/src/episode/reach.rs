use cogmap_geometry::{DVec2, Segment};

use super::planner;
use crate::{Door, World};

/// What the planner keeps from everything besides the radius that it is given, metres.
const PLANNER_KEEPS: f64 = 0.07;

/// How much room a way must leave, metres around its middle.
pub(super) struct Reach(f64);

impl Reach {
    /// The robot and 10 cm: a way that any careful robot can go.
    pub(super) const AMPLE: Self = Self(0.35);
    /// Little more than the robot: where not even this leads through, nothing does.
    pub(super) const SCANT: Self = Self(0.255);

    /// Whether a way leads from one spot to another.
    pub(super) fn leads(&self, world: &World, from: DVec2, to: DVec2) -> bool {
        planner(world, self.0 - PLANNER_KEEPS).way(from, to).is_ok()
    }
}

/// Whether a way from `start` passes between a door's hinge and its latch.
pub(super) fn leads_through(start: DVec2, route: &[DVec2], door: &Door) -> bool {
    let sill = Segment::new(door.hinge.into(), door.latch.into());
    legs(start, route).any(|leg| leg.crossing(sill).is_some())
}

/// The straight pieces of a way.
pub(super) fn legs(start: DVec2, route: &[DVec2]) -> impl Iterator<Item = Segment> + '_ {
    std::iter::once(start).chain(route.iter().copied()).zip(route).map(|(a, &b)| Segment::new(a, b))
}
