use std::collections::VecDeque;

use cogmap_geometry::{DVec2, Pose, normalize_angle, trig};

use crate::{Command, Robot, World};

mod caution;
mod lattice;
mod planner;
mod random;
mod search;

use caution::Caution;
pub(crate) use planner::Planner;
pub use random::random_route;
pub(crate) use random::{AMPLE, AWAY, Tour};

/// The longest step that the person orders, metres.
const STEP_MAX: f64 = 2.0;
/// The shortest, metres; shorter ones only end a leg.
const STEP_MIN: f64 = 0.08;
/// A point counts as reached from here, metres.
const REACHED: f64 = 0.04;
/// A step that was to end at a point may have missed it by so much, metres.
const MISSED: f64 = 0.4;
/// A turn that is worth a step of its own, radians.
const TURN_MIN: f64 = 0.05;
/// How many steps a leg may take besides one for every 10 cm.
const STEPS_SPARE: usize = 100;

/// The person at the controls (§3.1.4): follows a route through a building that it sees, in the
/// thesis's steps, without touching anything. Robot code never meets it.
///
/// A leg of at most 2 m whose straight line is free becomes exactly one step; other legs are split,
/// or led around what is in the way. Each step starts from where the robot truly is, and keeps 5 cm
/// from everything even if the robot's wheels err as much as they are known to.
pub struct Driver {
    planner: Planner,
    caution: Caution,
    legs: VecDeque<Leg>,
    /// Whether the last step was to end at the next point to pass.
    arriving: bool,
}

/// The way to one point of the route.
struct Leg {
    /// The points to pass, the last being the route's.
    points: VecDeque<DVec2>,
    /// How many more steps it may take.
    steps: usize,
}

impl Leg {
    fn new(points: Vec<DVec2>, from: DVec2) -> Self {
        let ends = std::iter::once(&from).chain(&points).zip(&points);
        let length: f64 = ends.map(|(a, b)| a.distance(*b)).sum();
        Self { points: points.into(), steps: STEPS_SPARE + (length / 0.1) as usize }
    }
}

impl Driver {
    /// Plans a route from the world's start. An error names the point that cannot be reached.
    pub fn new(world: &World, robot: &Robot, route: &[DVec2]) -> Result<Self, String> {
        let mut planner = Planner::new(world, route, robot.body.radius);
        let mut from = DVec2::from(world.start.position);
        let mut legs = VecDeque::new();
        for (k, &to) in route.iter().enumerate() {
            let problem = |message| format!("point {} of the route, [{}, {}], {message}", k + 1, to.x, to.y);
            legs.push_back(Leg::new(planner.way(from, to).map_err(problem)?, from));
            from = to;
        }
        Ok(Self { planner, caution: Caution::about(robot), legs, arriving: false })
    }

    /// The next step, from where the robot truly stands now; `None` at the end of the route, or
    /// where something stands so that the person gives up.
    pub fn next_command(&mut self, world_from_robot: Pose) -> Option<Command> {
        self.planner.rest();
        self.pass_points(world_from_robot.position);
        self.step(world_from_robot).or_else(|| {
            self.plan_again(world_from_robot.position)?;
            self.step(world_from_robot)
        })
    }

    /// Forgets the points that have been reached.
    fn pass_points(&mut self, position: DVec2) {
        while let Some(leg) = self.legs.front_mut() {
            let Some(next) = leg.points.front() else {
                self.legs.pop_front();
                continue;
            };
            let distance = position.distance(*next);
            let arrived = distance < REACHED || (self.arriving && distance < MISSED);
            self.arriving = false;
            if !arrived {
                return;
            }
            leg.points.pop_front();
        }
    }

    /// Plans the rest of the leg from where the robot is; the leg to a point that it has all but
    /// reached gives way to the next one.
    fn plan_again(&mut self, position: DVec2) -> Option<()> {
        if self.legs.front()?.points.back()?.distance(position) < MISSED {
            self.legs.pop_front();
        }
        let leg = self.legs.front_mut()?;
        let way = self.planner.way(position, *leg.points.back()?);
        leg.points = way.ok()?.into();
        Some(())
    }

    /// A step toward the next point, as far as caution allows; `None` where it allows none.
    fn step(&mut self, pose: Pose) -> Option<Command> {
        let leg = self.legs.front_mut()?;
        let next = *leg.points.front()?;
        leg.steps = leg.steps.checked_sub(1)?;
        let ahead = next - pose.position;
        let turn = normalize_angle(trig::atan2(ahead.y, ahead.x) - pose.heading);
        let pieces = (ahead.length() / STEP_MAX - 0.05).ceil().max(1.0);
        let mut travel = ahead.length() / pieces;
        if self.caution.allows(pose, turn, travel, &self.planner) {
            self.arriving = pieces < 1.5;
            return Some(Command::Step { turn, travel });
        }
        if !self.planner.leads_free(pose.position, next) {
            return None;
        }
        if turn.abs() > TURN_MIN {
            return Some(Command::Step { turn, travel: 0.0 });
        }
        while travel > STEP_MIN {
            travel /= 2.0;
            if self.caution.allows(pose, turn, travel, &self.planner) {
                return Some(Command::Step { turn, travel });
            }
        }
        None
    }
}

#[cfg(test)]
mod tests;
