use cogmap_navigation::{Act, Decision, HomingEvent};

use super::{drive::Drive, pilot::plain};
use crate::{
    Command,
    driver::{Course, Planner},
};

/// The oracle is at home where it is no farther from it than this, metres.
const ARRIVED: f64 = 0.35;

/// The person at the controls takes the robot home (§3.1.4): the way of one who sees the building.
#[derive(Clone, Debug, Default)]
pub(super) struct Oracle {
    /// The plan, and how often the world had been changed when it was made.
    course: Option<(usize, Course)>,
    begun: bool,
}

impl Oracle {
    /// The next step to where the run began, at rest.
    pub(super) fn decide(&mut self, step: usize, drive: &Drive) -> Decision {
        let (world, robot) = (drive.world(), drive.robot());
        let (here, home) = (drive.world_from_robot(), world.start.position.into());
        let distance = here.position.distance(home);
        let mut planner = Planner::new(world, &[here.position, home], robot.body.radius);
        let begins = !std::mem::replace(&mut self.begun, true);
        let planned = match self.course.take() {
            Some((changes, course)) if changes == drive.changes() => Ok(course),
            _ => Course::new(&mut planner, robot, here.position, &[home]),
        };
        let command = planned.map(|mut course| {
            let command = course.next_command(&mut planner, here);
            self.course = Some((drive.changes(), course));
            command
        });
        let mut decision = match command {
            Ok(Some(Command::Step { turn, travel })) if distance > ARRIVED => {
                let why =
                    format!("one who sees the building leads the way: the start is {distance:.1} m off");
                plain(step, Act::Step { turn, travel }, why)
            }
            _ if distance <= ARRIVED => {
                plain(step, Act::Arrived, format!("the start is {distance:.2} m away"))
            }
            Err(problem) => plain(step, Act::Stuck, format!("no way leads back: {problem}")),
            Ok(_) => plain(step, Act::Stuck, "something stands in the way".to_owned()),
        };
        if begins {
            let strategy = "oracle".to_owned();
            decision.events.push(HomingEvent::GoHome { strategy, distance: Some(distance), dropped: 0 });
        }
        match decision.act {
            Act::Arrived => decision.events.push(HomingEvent::Home { distance }),
            Act::Stuck => decision.events.push(HomingEvent::Stuck { why: decision.why.clone() }),
            Act::Step { .. } => {}
        }
        decision
    }
}
