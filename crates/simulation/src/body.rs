use cogmap_geometry::{DVec2, Pose};
use rand_pcg::Pcg64Mcg;

use crate::{BodyParams, Command, OdometryErrors, Robot, Surroundings, TICK, WheelTurns, odometer::arc};

mod contact;
mod profile;
mod wheels;

/// The longest step that is carried out, metres; a longer one is cut.
const TRAVEL_MAX: f64 = 100.0;
/// The widest turn of a step that is carried out, radians; a wider one is cut.
const TURN_MAX: f64 = 4.0 * cogmap_geometry::trig::PI;
/// How many ticks a step presses against something that does not give way before it ends: 0.5 s.
const PATIENCE: u32 = 25;
/// A contact has ended when the gap is wider than this, metres.
const CONTACT_GAP: f64 = 0.002;

/// A differential drive on the floor: where it is, how fast, and what it is doing.
///
/// Its motors follow the wheel encoders, so a step is as long as *they* say. What the floor sees
/// differs by the wheels' true radii, the true axle and slip; a wall holds the wheels, so that the
/// encoders do not count what it prevents, but sliding along it they do not notice.
#[derive(Clone, Debug, PartialEq)]
pub struct Body {
    params: BodyParams,
    errors: OdometryErrors,
    world_from_robot: Pose,
    /// Metres and radians per second, as the encoders say.
    speed: [f64; 2],
    task: Task,
    /// From the middle to what it touched last, while the contact lasts.
    touching: Option<DVec2>,
    patience: u32,
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum Task {
    /// Come to rest and stay.
    Rest,
    /// Keep a velocity: metres and radians per second.
    Drive([f64; 2]),
    /// Come to rest first, then do a step: metres and radians.
    Prepare([f64; 2]),
    /// Turn, then travel; metres and radians still to go.
    Step([f64; 2]),
}

/// What happened to a body in one tick.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Tick {
    /// What the encoders counted.
    pub turns: WheelTurns,
    /// Where a new contact began, in the world, metres.
    pub collision: Option<DVec2>,
    /// Whether a step ended, and how.
    pub step_end: Option<StepEnd>,
}

/// How a step ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum StepEnd {
    /// The encoders count what was ordered.
    Done,
    /// Something in the way held the robot for half a second.
    Stalled,
}

impl Body {
    /// A robot at rest.
    #[must_use]
    pub fn new(robot: &Robot, world_from_robot: Pose) -> Self {
        let (params, errors) = (robot.body.clone(), robot.odometry.clone());
        let (speed, task) = ([0.0; 2], Task::Rest);
        Self { params, errors, world_from_robot, speed, task, touching: None, patience: PATIENCE }
    }

    /// Takes an order; numbers that are not finite count as 0, the others are cut to what it can do.
    pub fn command(&mut self, command: &Command) {
        let bounded = |value: f64, most: f64| if value.is_finite() { value.clamp(-most, most) } else { 0.0 };
        self.task = match *command {
            Command::Stop | Command::Kidnap { .. } | Command::GoHome { .. } => Task::Rest,
            Command::Change(_) => return,
            Command::Drive { linear, angular } => {
                let angular = bounded(angular, self.params.max_turn_rate);
                Task::Drive([bounded(linear, self.params.max_speed), angular])
            }
            Command::Step { turn, travel } => {
                Task::Prepare([bounded(travel, TRAVEL_MAX), bounded(turn, TURN_MAX)])
            }
        };
        self.patience = PATIENCE;
    }

    /// Its wheels lie otherwise from now on.
    pub(crate) fn wear(&mut self, errors: OdometryErrors) {
        self.errors = errors;
    }

    /// Someone sets it down elsewhere, at rest; refused where it does not fit.
    pub fn kidnap<'a>(&mut self, world_from_robot: Pose, around: impl Into<Surroundings<'a>>) {
        if self.fits(world_from_robot, around) {
            self.world_from_robot = world_from_robot;
            (self.speed, self.task, self.touching) = ([0.0; 2], Task::Rest, None);
        }
    }

    /// Whether it could stand there.
    #[must_use]
    pub fn fits<'a>(&self, world_from_robot: Pose, around: impl Into<Surroundings<'a>>) -> bool {
        let Pose { position, heading } = world_from_robot;
        let real = position.is_finite() && heading.is_finite();
        real && around.into().nearest(position, self.params.radius).is_none()
    }

    /// Where it truly is.
    #[must_use]
    pub fn world_from_robot(&self) -> Pose {
        self.world_from_robot
    }

    /// Metres per second forward and radians per second counter-clockwise, as the encoders say.
    #[must_use]
    pub fn speed(&self) -> [f64; 2] {
        self.speed
    }

    /// Whether it stands still and has nothing left to do.
    #[must_use]
    pub fn at_rest(&self) -> bool {
        let idle = matches!(self.task, Task::Rest | Task::Drive([0.0, 0.0]));
        idle && self.speed == [0.0; 2]
    }

    /// Lives through [`TICK`] seconds.
    pub fn tick<'a>(&mut self, around: impl Into<Surroundings<'a>>, rng: &mut Pcg64Mcg) -> Tick {
        self.speed = self.next_speed();
        let [linear, angular] = self.speed;
        if self.speed == [0.0; 2] {
            return Tick { step_end: self.progress([0.0; 2]), ..Tick::default() };
        }
        let ordered = WheelTurns::ordered([linear * TICK, angular * TICK], &self.params);
        let rolled = wheels::roll(ordered, &self.params, &self.errors, rng);
        let (freed, collision) = self.roll(rolled, around.into());
        self.hold_against(freed);
        let counted = [linear * TICK * freed, angular * TICK];
        let turns = WheelTurns::ordered(counted, &self.params);
        let step_end = self.progress(counted).or_else(|| self.lose_patience(freed));
        Tick { turns, collision, step_end }
    }

    fn next_speed(&self) -> [f64; 2] {
        let BodyParams { max_speed, max_turn_rate, max_acceleration, max_turn_acceleration, .. } =
            self.params;
        let gain = [max_acceleration * TICK, max_turn_acceleration * TICK];
        let [linear, angular] = self.speed;
        match self.task {
            Task::Rest | Task::Prepare(_) => profile::approach(self.speed, [0.0; 2], gain),
            Task::Drive(wanted) => profile::approach(self.speed, wanted, gain),
            Task::Step([_, turn]) if turn != 0.0 => {
                [0.0, profile::toward(turn, angular, max_turn_rate, max_turn_acceleration)]
            }
            Task::Step([travel, _]) => [profile::toward(travel, linear, max_speed, max_acceleration), 0.0],
        }
    }

    /// Moves on the floor; the share of the way forward that nothing prevented, and a new contact.
    fn roll(&mut self, rolled: [f64; 2], around: Surroundings<'_>) -> (f64, Option<DVec2>) {
        let from = self.world_from_robot;
        let wanted = from * arc(rolled);
        let movement = wanted.position - from.position;
        let slide = contact::slide(from.position, movement, self.params.radius, around);
        self.world_from_robot = Pose { position: slide.position, ..wanted };
        let length = movement.length();
        let freed = if slide.touched.is_some() && length > 1e-9 {
            ((slide.position - from.position).dot(movement) / (length * length)).clamp(0.0, 1.0)
        } else {
            1.0
        };
        (freed, self.feel(slide.touched, around))
    }

    /// A contact is new where nothing was touched before, or something on another side.
    fn feel(&mut self, touched: Option<DVec2>, around: Surroundings<'_>) -> Option<DVec2> {
        let position = self.world_from_robot.position;
        let Some(point) = touched else {
            if around.nearest(position, self.params.radius + CONTACT_GAP).is_none() {
                self.touching = None;
            }
            return None;
        };
        let side = (point - position).normalize_or_zero();
        let known = self.touching.replace(side).is_some_and(|before| before.dot(side) > 0.5);
        (!known).then_some(point)
    }

    /// Takes the speed that a head-on contact leaves: none.
    fn hold_against(&mut self, freed: f64) {
        if freed < 0.05 {
            self.speed[0] = 0.0;
        }
    }

    fn progress(&mut self, counted: [f64; 2]) -> Option<StepEnd> {
        match &mut self.task {
            Task::Prepare(step) if self.speed == [0.0; 2] => {
                self.task = Task::Step(*step);
                None
            }
            Task::Step(left) => {
                for (left, done) in left.iter_mut().zip(counted) {
                    *left = if (*left - done).abs() < 1e-9 { 0.0 } else { *left - done };
                }
                (*left == [0.0; 2]).then(|| self.end_step(StepEnd::Done))
            }
            _ => None,
        }
    }

    fn lose_patience(&mut self, freed: f64) -> Option<StepEnd> {
        if !matches!(self.task, Task::Step(_)) {
            return None;
        }
        self.patience =
            if freed < 0.25 { self.patience.saturating_sub(1) } else { PATIENCE.min(self.patience + 1) };
        (self.patience == 0).then(|| self.end_step(StepEnd::Stalled))
    }

    fn end_step(&mut self, end: StepEnd) -> StepEnd {
        self.task = Task::Rest;
        self.speed = [0.0; 2];
        end
    }
}

#[cfg(test)]
mod tests;
