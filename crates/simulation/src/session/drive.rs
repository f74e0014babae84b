use std::sync::Arc;

use cogmap_geometry::Pose;
use cogmap_mapping::perception::{Moment, Reading, Scan};
use rand_core::SeedableRng;
use rand_pcg::Pcg64Mcg;

use super::{
    SessionRecord, Source,
    feed::{Observation, Turn},
    people::{Sweep, Walker},
    stage::{Bodies, Stage},
};
use crate::{
    Body, BoxObstacle, Command, Disc, Laser, Noise, Odometer, Problem, Robot, Solids, Surroundings, TICK,
    TimedCommand, World, WorldChange, world::COORDINATE_MAX,
};

/// While a step is driven the laser records each so many metres …
const SCAN_DISTANCE: f64 = 0.1;
/// … or each so many radians.
const SCAN_TURN: f64 = 5.0 * cogmap_geometry::trig::PI / 180.0;
/// Under velocity driving it records each so many ticks: at 5 Hz.
const SCAN_TICKS: u64 = 10;

/// A robot in a world: the part of a session that moves. Cloning it is a checkpoint; what never
/// changes is shared.
#[derive(Clone)]
pub(super) struct Drive {
    stage: Arc<Stage>,
    walkers: Vec<Walker>,
    people: Vec<Disc>,
    tick: u64,
    next_command: usize,
    body: Body,
    odometer: Odometer,
    slip: Pcg64Mcg,
    noise: Pcg64Mcg,
    motion: Motion,
    last_look: Option<Look>,
}

/// What the laser saw last.
#[derive(Clone)]
struct Look {
    tick: u64,
    odom_from_robot: Pose,
    moment: Moment,
    scan: Arc<Scan>,
    beam_solids: Arc<[Option<u32>]>,
}

/// What is going on, as far as the laser's shutter is concerned.
#[derive(Clone, Copy, PartialEq)]
enum Motion {
    Resting,
    Stepping,
    Rolling,
}

impl Drive {
    pub(super) fn new(record: &SessionRecord) -> Result<Self, Vec<Problem>> {
        let Source::World { world, robot, .. } = &record.source else {
            return Err(vec![Problem {
                place: "source".to_owned(),
                message: "a recorded log cannot be driven through: replay it".to_owned(),
            }]);
        };
        let problems = world.problems();
        if !problems.is_empty() {
            return Err(problems);
        }
        let [mut manufacture, slip, noise] = [0, 1, 2].map(|stream| stream_of(record.seed, stream));
        let laser = Laser::new(&robot.laser, &mut manufacture);
        let [x, y] = world.start.position;
        let start = Pose::new(x, y, world.start.heading_deg.to_radians());
        let walkers: Vec<Walker> = world.people.iter().map(Walker::new).collect();
        Ok(Self {
            tick: 0,
            next_command: 0,
            body: Body::new(robot, start),
            odometer: Odometer::new(&robot.body),
            slip,
            noise,
            motion: Motion::Resting,
            last_look: None,
            people: walkers.iter().map(Walker::disc).collect(),
            walkers,
            stage: Arc::new(Stage::new(world, robot, laser)),
        })
    }

    /// One tick: move, count the wheels, look if it is time.
    pub(super) fn advance(&mut self) -> Turn {
        self.let_people_walk();
        let around = Surroundings { obstacles: self.stage.obstacles(), people: &self.people };
        let moved = self.body.tick(around, &mut self.slip);
        self.odometer.record(moved.turns);
        self.tick += 1;
        let observation = if moved.step_end.is_some() {
            self.motion = Motion::Resting;
            Some(self.scan(Moment::StepEnd))
        } else {
            self.moment_to_look().map(|moment| self.scan(moment))
        };
        Turn { observation, collision: moved.collision }
    }

    fn let_people_walk(&mut self) {
        let Disc { radius, .. } = self.footprint();
        let robot = Sweep::new(self.body.world_from_robot(), self.body.speed()[0], radius);
        for (walker, person) in self.walkers.iter_mut().zip(&mut self.people) {
            walker.walk(robot, self.stage.obstacles());
            *person = walker.disc();
        }
    }

    /// The next command whose time has come.
    pub(super) fn hear(&mut self, commands: &[TimedCommand]) -> Option<Command> {
        let timed = commands.get(self.next_command).filter(|timed| timed.tick <= self.tick)?;
        self.next_command += 1;
        Some(timed.command.clone())
    }

    /// Begins to do as it was told.
    pub(super) fn obey(&mut self, command: &Command) {
        self.body.command(command);
        self.motion = match command {
            Command::Step { .. } => Motion::Stepping,
            _ => Motion::Rolling,
        };
        if let Command::Kidnap { position: [x, y], heading_deg } = *command {
            let around = Surroundings { obstacles: self.stage.obstacles(), people: &self.people };
            self.body.kidnap(Pose::new(x, y, heading_deg.to_radians()), around);
        }
    }

    /// Changes the building; `Ok(false)` where it is so already, and an error that says what speaks against it.
    pub(super) fn change(&mut self, change: &WorldChange) -> Result<bool, String> {
        let next = self.stage.after(change, self.bodies())?;
        let changed = next.is_some();
        self.stage = next.map_or_else(|| Arc::clone(&self.stage), Arc::new);
        let came = self.stage.world().people.iter().skip(self.walkers.len()).map(Walker::new);
        self.walkers.extend(came);
        self.people = self.walkers.iter().map(Walker::disc).collect();
        self.body.wear(self.robot().odometry.times(self.noise().odometry));
        Ok(changed)
    }

    /// What speaks against a command.
    pub(super) fn refusal(&self, command: &Command) -> Option<String> {
        match command {
            Command::Change(change) => self.stage.after(change, self.bodies()).err(),
            Command::Kidnap { position: [x, y], heading_deg } => {
                let set_down = Pose::new(*x, *y, heading_deg.to_radians());
                let around = Surroundings { obstacles: self.stage.obstacles(), people: &self.people };
                let in_a_box = self.world().boxes.iter().any(|carton| carton.contains(set_down.position));
                if set_down.position.abs().max_element() > COORDINATE_MAX {
                    return Some(format!("that is more than {COORDINATE_MAX} m from the origin"));
                }
                let free = !in_a_box && self.body.fits(set_down, around);
                (!free).then(|| "something stands there".to_owned())
            }
            _ => None,
        }
    }

    fn footprint(&self) -> Disc {
        let radius = self.stage.robot().body.radius;
        Disc { center: self.body.world_from_robot().position, radius }
    }

    fn bodies(&self) -> Bodies<'_> {
        Bodies { robot: self.footprint(), people: &self.people }
    }

    /// Whether the laser records now, between the ends of steps.
    fn moment_to_look(&self) -> Option<Moment> {
        let last = self.last_look.as_ref()?;
        let moved = last.odom_from_robot.from_here(self.odom_from_robot());
        match self.motion {
            Motion::Resting => None,
            Motion::Stepping => {
                let far = moved.position.length() >= SCAN_DISTANCE || moved.heading.abs() >= SCAN_TURN;
                far.then_some(Moment::WithinStep)
            }
            Motion::Rolling => {
                let due = self.tick >= last.tick + SCAN_TICKS && moved != Pose::IDENTITY;
                due.then_some(Moment::Rolling)
            }
        }
    }

    /// The view before the first movement.
    pub(super) fn look(&mut self) -> Observation {
        self.scan(Moment::StepEnd)
    }

    fn scan(&mut self, moment: Moment) -> Observation {
        let world_from_robot = self.body.world_from_robot();
        let (scan, beam_solids) = self.stage.scan(world_from_robot, &self.people, &mut self.noise);
        let odom_from_robot = self.odom_from_robot();
        let (tick, solids) = (self.tick, Arc::from(beam_solids.as_slice()));
        let look = Look { tick, odom_from_robot, moment, scan: Arc::new(scan.clone()), beam_solids: solids };
        self.last_look = Some(look);
        let reading = Reading { t: self.time(), odom_from_robot, moment, scan };
        Observation { reading, world_from_robot: Some(world_from_robot), beam_solids }
    }

    pub(super) fn tick(&self) -> u64 {
        self.tick
    }

    #[allow(clippy::cast_precision_loss, reason = "no run lasts 2^53 ticks")]
    pub(super) fn time(&self) -> f64 {
        self.tick as f64 * TICK
    }

    pub(super) fn at_rest(&self) -> bool {
        self.body.at_rest()
    }

    /// Metres per second straight ahead.
    pub(super) fn speed(&self) -> f64 {
        self.body.speed()[0]
    }

    /// The building as it is now.
    pub(super) fn world(&self) -> &World {
        self.stage.world()
    }

    pub(super) fn robot(&self) -> &Robot {
        self.stage.robot()
    }

    /// The boxes by their numbers; `None` where one was taken away.
    pub(super) fn boxes(&self) -> &[Option<BoxObstacle>] {
        self.stage.boxes()
    }

    /// How large the robot's errors are now, in multiples of its own.
    pub(super) fn noise(&self) -> Noise {
        self.stage.noise()
    }

    /// How often the building was changed.
    pub(super) fn changes(&self) -> usize {
        self.stage.changes()
    }

    /// The people, where they are now.
    pub(super) fn people(&self) -> &[Disc] {
        &self.people
    }

    pub(super) fn world_from_robot(&self) -> Pose {
        self.body.world_from_robot()
    }

    pub(super) fn odom_from_robot(&self) -> Pose {
        self.odometer.odom_from_robot()
    }

    pub(super) fn last_scan(&self) -> Option<&Scan> {
        self.last_look.as_ref().map(|look| look.scan.as_ref())
    }

    pub(super) fn last_moment(&self) -> Option<Moment> {
        self.last_look.as_ref().map(|look| look.moment)
    }

    pub(super) fn last_beam_solids(&self) -> Option<&[Option<u32>]> {
        self.last_look.as_ref().map(|look| look.beam_solids.as_ref())
    }

    pub(super) fn solids(&self) -> &Solids {
        self.stage.solids()
    }
}

/// Independent random numbers for each of the things that chance decides.
fn stream_of(seed: u64, stream: u64) -> Pcg64Mcg {
    Pcg64Mcg::seed_from_u64(seed.wrapping_mul(4).wrapping_add(stream))
}
