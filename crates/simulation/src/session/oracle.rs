use cogmap_geometry::{DVec2, Pose, Segment};
use cogmap_mapping::{Sentence, say};
use cogmap_navigation::{Act, Decision, HomingEvent};

use super::{drive::Drive, pilot::plain};
use crate::{
    Command, Post, World,
    driver::{Course, Planner},
};

/// The oracle is at home where it is no farther from it than this, metres.
const ARRIVED: f64 = 0.35;
/// Nobody is passed nearer than this, metres.
const ROOM: f64 = 0.1;
/// The person at the controls brakes so far before anybody, metres.
const RESPONSE: f64 = 0.2;
/// How often it is waited for somebody before a way round is looked for.
const PATIENCE: usize = 8;
/// A step that only looks.
const WAIT: Command = Command::Step { turn: 0.0, travel: 0.0 };

/// The person at the controls takes the robot home (§3.1.4): the way of one who sees the building, and
/// the people in it, whom it waits for.
#[derive(Clone, Debug, Default)]
pub(super) struct Oracle {
    /// The plan, and how often the world had been changed when it was made.
    course: Option<(usize, Course)>,
    begun: bool,
    /// How often in a row somebody stood in the way.
    waited: usize,
}

/// Whether somebody is so near ahead of a robot that drives that it has to brake.
pub(super) fn has_to_brake(drive: &Drive) -> bool {
    let speed = drive.speed();
    let braking = speed * speed / (2.0 * drive.robot().body.max_acceleration);
    speed > 0.0 && somebody_ahead(drive, 0.0, braking + RESPONSE)
}

/// Whether a step would lead the robot into somebody, or past somebody too near.
fn somebody_ahead(drive: &Drive, turn: f64, travel: f64) -> bool {
    let from = drive.world_from_robot();
    let ahead = (from * Pose::new(0.0, 0.0, turn)).forward();
    let way = Segment::new(from.position, from.position + ahead * travel);
    let keep = drive.robot().body.radius + ROOM;
    let in_the_way = |somebody: DVec2, radius: f64| {
        ahead.dot(somebody - from.position) > 0.0 && way.distance_to(somebody) < keep + radius
    };
    travel > 0.0 && drive.people().iter().any(|person| in_the_way(person.center, person.radius))
}

/// The building with the people in it as if they stood there for good.
fn with_people(drive: &Drive) -> World {
    let mut world = drive.world().clone();
    let posts = drive.people().iter();
    world.posts.extend(posts.map(|disc| Post { center: disc.center.into(), radius: disc.radius }));
    world
}

impl Oracle {
    /// The next step to where the run began, at rest.
    pub(super) fn decide(&mut self, step: usize, drive: &Drive) -> Decision {
        let distance = drive.world_from_robot().position.distance(drive.world().start.position.into());
        let begins = !std::mem::replace(&mut self.begun, true);
        let command = self.command(drive);
        let mut decision = match command {
            Ok(Some(Command::Step { turn, travel })) if distance > ARRIVED => {
                let off = (distance, 1);
                let why = say("one who sees the building leads the way: the start is {} m off", &[off]);
                plain(step, Act::Step { turn, travel }, why)
            }
            _ if distance <= ARRIVED => {
                plain(step, Act::Arrived, say("the start is {} m away", &[(distance, 2)]))
            }
            Err(problem) => {
                plain(step, Act::Stuck, say("no way leads back", &[]).then(Sentence::from(problem)))
            }
            Ok(_) => plain(step, Act::Stuck, say("something stands in the way", &[])),
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

    /// The next step, which is none while somebody is in the way; whoever stays there is gone round.
    fn command(&mut self, drive: &Drive) -> Result<Option<Command>, String> {
        let (here, home) = (drive.world_from_robot(), drive.world().start.position.into());
        let round = self.waited >= PATIENCE;
        let world = if round { with_people(drive) } else { drive.world().clone() };
        let mut planner = Planner::new(&world, &[here.position, home], drive.robot().body.radius);
        let known = self.course.clone().filter(|(changes, _)| !round && *changes == drive.changes());
        let planned = match known {
            Some((_, course)) => Ok(course),
            None => Course::new(&mut planner, drive.robot(), here.position, &[home]),
        };
        let command = planned.map(|mut course| (course.next_command(&mut planner, here), course));
        let blocked = match &command {
            Ok((Some(Command::Step { turn, travel }), _)) => somebody_ahead(drive, *turn, *travel),
            _ => round,
        };
        if blocked {
            self.waited += 1;
            return Ok(Some(WAIT));
        }
        self.waited = 0;
        let (command, course) = command?;
        self.course = Some((drive.changes(), course));
        Ok(command)
    }
}
