use std::collections::VecDeque;

use cogmap_geometry::{DVec2, Pose, normalize_angle, trig};

use super::{caution::Caution, planner::Planner};
use crate::{Command, Robot};

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

/// What is left of a route, for a planner that knows the building as it is now.
#[derive(Clone, Debug)]
pub(crate) struct Course {
    caution: Caution,
    legs: VecDeque<Leg>,
    /// Whether the last step was to end at the next point to pass.
    arriving: bool,
}

/// The way to one point of the route.
#[derive(Clone, Debug)]
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

impl Course {
    /// Plans a route. An error names the point that cannot be reached.
    pub(crate) fn new(
        planner: &mut Planner,
        robot: &Robot,
        mut from: DVec2,
        route: &[DVec2],
    ) -> Result<Self, String> {
        let mut legs = VecDeque::new();
        for (k, &to) in route.iter().enumerate() {
            let problem = |message| format!("point {} of the route, [{}, {}], {message}", k + 1, to.x, to.y);
            legs.push_back(Leg::new(planner.way(from, to).map_err(problem)?, from));
            from = to;
        }
        Ok(Self { caution: Caution::about(robot), legs, arriving: false })
    }

    /// The next step, from where the robot truly stands now; `None` at the end of the route, or
    /// where something stands so that the person gives up.
    pub(crate) fn next_command(&mut self, planner: &mut Planner, world_from_robot: Pose) -> Option<Command> {
        planner.rest();
        self.pass_points(world_from_robot.position);
        self.step(planner, world_from_robot).or_else(|| {
            self.plan_again(planner, world_from_robot.position)?;
            self.step(planner, world_from_robot)
        })
    }

    /// The points that are still to be passed, in order.
    pub(super) fn ahead(&self) -> impl Iterator<Item = DVec2> {
        self.legs.iter().flat_map(|leg| leg.points.iter().copied())
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
    fn plan_again(&mut self, planner: &mut Planner, position: DVec2) -> Option<()> {
        if self.legs.front()?.points.back()?.distance(position) < MISSED {
            self.legs.pop_front();
        }
        let leg = self.legs.front_mut()?;
        let way = planner.way(position, *leg.points.back()?);
        leg.points = way.ok()?.into();
        Some(())
    }

    /// A step toward the next point, as far as caution allows; `None` where it allows none.
    fn step(&mut self, planner: &mut Planner, pose: Pose) -> Option<Command> {
        let leg = self.legs.front_mut()?;
        let next = *leg.points.front()?;
        leg.steps = leg.steps.checked_sub(1)?;
        let ahead = next - pose.position;
        let turn = normalize_angle(trig::atan2(ahead.y, ahead.x) - pose.heading);
        let pieces = (ahead.length() / STEP_MAX - 0.05).ceil().max(1.0);
        let mut travel = ahead.length() / pieces;
        if self.caution.allows(pose, turn, travel, planner) {
            self.arriving = pieces < 1.5;
            return Some(Command::Step { turn, travel });
        }
        if !planner.leads_free(pose.position, next) {
            return None;
        }
        if turn.abs() > TURN_MIN {
            return Some(Command::Step { turn, travel: 0.0 });
        }
        while travel > STEP_MIN {
            travel /= 2.0;
            if self.caution.allows(pose, turn, travel, planner) {
                return Some(Command::Step { turn, travel });
            }
        }
        None
    }
}
