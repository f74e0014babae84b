//! What `cargo bench` times: the laser's raycaster against parry's BVH and against brute force;
//! extraction and each mapper's step on a recorded log, how a step grows with the map, and decisions on the way home.
//!
//! The same code is timed in this process and, built for wasm32, in Node by `node.mjs`, through the few
//! functions of [`exports`]; [`race`] lets the two take turns, so that whatever else the machine does
//! slows both down.

mod contest;
pub mod exports;
mod gallery;
mod homing;
mod office;
#[cfg(not(target_arch = "wasm32"))]
pub mod race;
mod robot;
#[cfg(not(target_arch = "wasm32"))]
pub mod thinking;

use contest::Contest;
use homing::WayHome;
use robot::{Run, Walker};

/// Something to time.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Task {
    /// Extraction of the surfaces of each scan of the log.
    Extraction,
    /// The log through the mapper of that name; the time is that of a reading.
    Mapper(&'static str),
    /// Steps of the recommended mapper with a map of so many surfaces.
    Grown(usize),
    /// Decisions of the recommended strategy on a way home in the setting of that name; the time is that of a
    /// decision, the scan and the mapper's step before it included.
    WayHome(&'static str),
    /// Scans of a laser in an office of so many segments, by the method of that number in [`METHODS`].
    Cast(usize, usize),
}

/// Ways of casting rays: ours, parry's bounding volumes, each segment in turn.
pub const METHODS: [&str; 3] = ["ours", "parry", "brute"];

/// Everything that is timed. Maps grow from one to the next.
pub const TASKS: [Task; 21] = [
    Task::Extraction,
    Task::Mapper("perceptual"),
    Task::Mapper("consensus"),
    Task::Mapper("transform"),
    Task::Mapper("odometry"),
    Task::Grown(100),
    Task::Grown(1_000),
    Task::Grown(10_000),
    Task::Grown(100_000),
    Task::WayHome("furnished"),
    Task::WayHome("boxes-moved"),
    Task::WayHome("no-way"),
    Task::Cast(200, 0),
    Task::Cast(200, 1),
    Task::Cast(200, 2),
    Task::Cast(2_000, 0),
    Task::Cast(2_000, 1),
    Task::Cast(2_000, 2),
    Task::Cast(20_000, 0),
    Task::Cast(20_000, 1),
    Task::Cast(20_000, 2),
];

/// One after the other, tasks are made ready and run.
#[derive(Default)]
pub struct Bench {
    log: Vec<u8>,
    walker: Walker,
    ready: Option<Ready>,
}

/// Everything that a task needs, so that a run does nothing else.
enum Ready {
    Run(Box<Run>),
    WayHome(Box<WayHome>),
    Contest(Box<Contest>, usize),
}

impl Bench {
    /// With a log in CARMEN's format; empty where there is none.
    #[must_use]
    pub fn new(log: Vec<u8>) -> Self {
        Self { log, ..Self::default() }
    }

    /// Makes a task of [`TASKS`] ready; of how many units a run of it consists, 0 where it cannot be run.
    pub fn prepare(&mut self, task: usize) -> usize {
        let on_robot = |run| Ready::Run(Box::new(run));
        self.ready = match TASKS.get(task) {
            Some(Task::Extraction) => Run::on_log(&self.log, None).map(on_robot),
            Some(Task::Mapper(name)) => Run::on_log(&self.log, Some(name)).map(on_robot),
            Some(&Task::Grown(surfaces)) => Some(on_robot(self.walker.walk(surfaces))),
            Some(Task::WayHome(setting)) => {
                WayHome::in_setting(setting).map(|way| Ready::WayHome(Box::new(way)))
            }
            Some(&Task::Cast(segments, method)) => {
                Some(Ready::Contest(Box::new(Contest::new(segments)), method))
            }
            None => None,
        };
        match &self.ready {
            Some(Ready::Run(run)) => run.steps(),
            Some(Ready::WayHome(way)) => way.decisions(),
            Some(Ready::Contest(_, method)) => Contest::scans(*method),
            None => 0,
        }
    }

    /// Goes back to what a run begins with; not timed.
    pub fn rewind(&mut self) {
        match &mut self.ready {
            Some(Ready::Run(run)) => run.rewind(),
            Some(Ready::WayHome(way)) => way.rewind(),
            _ => {}
        }
    }

    /// Runs the task once; a number that is the same wherever it runs.
    pub fn run(&mut self) -> f64 {
        match &mut self.ready {
            Some(Ready::Run(run)) => run.run(),
            Some(Ready::WayHome(way)) => way.run(),
            Some(Ready::Contest(contest, method)) => contest.run(*method),
            None => 0.0,
        }
    }
}

/// How many beams of all scans of an office of so many segments the raycaster and parry see differently by
/// over a millimetre, and how many there are.
#[must_use]
pub fn differences(segments: usize) -> (usize, usize) {
    Contest::new(segments).differences([0, 1])
}
