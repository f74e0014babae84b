//! Is home found again (§3.3)? Every strategy on the same [`Episode`]s: a building, a way out, and what
//! happens behind the robot's back. Native only.
//!
//! A [`Plan`] says what is tried; [`run`] drives each way out once and hands a copy of the robot, with
//! all that it remembers, to every strategy; each way home becomes a [`HomeRow`]. [`HomeSummary`] puts
//! the rows together. All measures are ours (the thesis judges by eye).
//!
//! [`Episode`]: cogmap_simulation::Episode

mod figures;
mod plan;
mod row;
mod runner;
mod trial;

use cogmap_mapping::MapperSetup;
use cogmap_simulation::{Episode, Robot, Setting, Strategy};

use crate::Outing;

pub use figures::{HomeFigures, HomeSummary, SplPair};
pub use plan::{Place, Plan, Task};
pub use row::{Ended, HomeRow, Trial};
pub use runner::{DecisionTimes, Thinking, run};

/// How the study is called.
pub const NAME: &str = "home";
/// One line for people.
pub const LINE: &str = "is home found again, by every strategy, in buildings that change behind the robot?";
/// How many buildings unless told otherwise.
pub const SEEDS: u64 = 1000;
/// What is run and measured.
pub const ABOUT: &str = "\
A robot is driven 10 to 60 m through an office floor made from the seed, or through other worlds with --worlds, and is \
told to go home; it knows only its map, made by `consensus`. Settings: empty, furnished, cartons dropped on its way, a \
door closed behind it (another way exists, or, in no-way, none does), furniture moved, a course of cartons 0.75 to \
0.9 m wide, people. All strategies start from the same map. Success is an own stop within 1 m of the true start \
without a collision; SPL is the shortest true way over the way driven, 0 without success. Choose with --robot, \
--setting and --strategy. A run that was cut off goes on from the rows in --out DIR.";

/// What the robot remembers by, whoever finds the way.
fn mapper() -> MapperSetup {
    MapperSetup::Consensus(Box::default())
}

/// A way out that is made from the seed, or is always the same, in a building that stays as it is.
///
/// # Errors
/// The building has no place for a way.
pub(crate) fn episode(outing: &Outing, seed: u64) -> Result<Episode, String> {
    let (world, route) = match outing {
        Outing::Course(course) => (course.world.as_ref().clone(), course.route.clone()),
        Outing::Floors => plan::floor(seed)?,
    };
    let episode = Episode::new(&world, &route, Setting::Furnished, seed);
    episode.ok_or_else(|| "nothing can be tried here".to_owned())
}

/// Out with a mapper, and home by what it remembers; `None` where the way out could not be driven.
pub(crate) fn trial(
    episode: &Episode,
    (robot, mapper): (&Robot, &MapperSetup),
    strategy: &Strategy,
    seed: u64,
) -> Option<Trial> {
    let out = trial::way_out(episode, (robot, mapper), seed)?;
    trial::way_home(&out, &episode.changes, strategy).map(|(trial, _)| trial)
}
