use cogmap_geometry::{DVec2, Pose};

use crate::{Command, Robot, Session, World};

mod caution;
mod course;
mod lattice;
mod planner;
mod random;
mod search;
mod shortest;

pub(crate) use course::Course;
pub(crate) use planner::Planner;
pub use random::random_route;
pub(crate) use random::{AMPLE, AWAY, Tour};
pub use shortest::shortest_way;

/// The person at the controls (§3.1.4): follows a route through a building that it sees, in the
/// thesis's steps, without touching anything. Robot code never meets it.
///
/// A leg of at most 2 m whose straight line is free becomes exactly one step; other legs are split,
/// or led around what is in the way. Each step starts from where the robot truly is, and keeps 5 cm
/// from everything even if the robot's wheels err as much as they are known to.
#[derive(Clone)]
pub struct Driver {
    planner: Planner,
    course: Course,
}

impl Driver {
    /// Plans a route from the world's start. An error names the point that cannot be reached.
    pub fn new(world: &World, robot: &Robot, route: &[DVec2]) -> Result<Self, String> {
        let mut planner = Planner::new(world, route, robot.body.radius);
        let course = Course::new(&mut planner, robot, world.start.position.into(), route)?;
        Ok(Self { planner, course })
    }

    /// Plans a way that somebody drew, from where the robot is: points that leave it no room are left out, and what is
    /// in the way is driven around. `None` where no point is left; an error names the point that cannot be reached.
    pub fn along(world: &World, robot: &Robot, from: DVec2, line: &[DVec2]) -> Result<Option<Self>, String> {
        let mut planner = Planner::new(world, &[from], robot.body.radius);
        let line: Vec<_> = line.iter().copied().filter(|point| planner.has_place(*point)).collect();
        if line.is_empty() {
            return Ok(None);
        }
        let course = Course::new(&mut planner, robot, from, &line)?;
        Ok(Some(Self { planner, course }))
    }

    /// The points that are still to be passed, in order.
    pub fn ahead(&self) -> impl Iterator<Item = DVec2> {
        self.course.ahead()
    }

    /// The next step, from where the robot truly stands now; `None` at the end of the route, or
    /// where something stands so that the person gives up.
    pub fn next_command(&mut self, world_from_robot: Pose) -> Option<Command> {
        self.course.next_command(&mut self.planner, world_from_robot)
    }

    /// Sees what the building is like now that something in it was changed: the next step goes by that.
    pub fn see(&mut self, world: &World) {
        self.planner = self.planner.within(world);
    }

    /// Drives the robot of a session until the person has nothing more to say.
    pub fn drive(&mut self, session: &mut Session) {
        while let Some(command) = session.world_from_robot().and_then(|pose| self.next_command(pose)) {
            session.command(command);
            while session.advance() && !session.at_rest() {}
        }
    }
}

#[cfg(test)]
mod tests;
