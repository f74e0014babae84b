//! Times each decision of whole ways home.

use std::{fs, path::Path, time::Instant};

use cogmap_geometry::DVec2;
use cogmap_simulation::{Building, Episode, Session, Setting, World};

use crate::homing::{TICKS, at_the_command};

/// All ways home are gone so often, and of each decision the fastest time counts: what else the machine does only
/// adds, and one that is slow for a while is so in one round.
const ROUNDS: usize = 3;

/// How long decisions took, the scan and the mapper's step before each included.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Thinking {
    /// How many decisions.
    pub decisions: usize,
    /// Milliseconds of all of them.
    pub total: f64,
    /// Milliseconds of the slowest.
    pub slowest: f64,
}

impl Thinking {
    /// Lets the robots go home.
    #[must_use]
    pub fn of(starts: &[Session]) -> Self {
        let round = || -> Vec<f64> { starts.iter().flat_map(|start| times(start.forked())).collect() };
        let fastest =
            (1..ROUNDS).fold(round(), |best, _| best.iter().zip(round()).map(|(a, b)| a.min(b)).collect());
        Self {
            decisions: fastest.len(),
            total: fastest.iter().sum(),
            slowest: fastest.iter().copied().fold(0.0, f64::max),
        }
    }

    /// Adds the decisions of another way home.
    pub fn add(&mut self, other: Self) {
        self.decisions += other.decisions;
        self.total += other.total;
        self.slowest = self.slowest.max(other.slowest);
    }

    /// Milliseconds for a decision.
    #[must_use]
    pub fn mean(&self) -> f64 {
        #[allow(clippy::cast_precision_loss, reason = "a few thousand decisions")]
        let decisions = self.decisions as f64;
        self.total / decisions.max(1.0)
    }
}

/// A robot that has just been told to go home on the generated floor of that seed; `None` where it has no place for
/// that setting.
#[must_use]
pub fn on_a_generated_floor(setting: Setting, seed: u64) -> Option<Session> {
    told_to_go_home(&Building::generate(seed), 1.0, setting, seed)
}

/// A robot that has just been told to go home in a building from a world file, after a share of its first route.
///
/// # Errors
/// What is wrong with the file, or that there is no way home in it.
pub fn in_a_designed_building(file: &Path, share: f64, seed: u64) -> Result<Session, String> {
    let name = file.display();
    let text = fs::read_to_string(file).map_err(|why| format!("{name}: {why}"))?;
    let world = cogmap_formats::world::read(&text, &name.to_string()).map_err(|why| why.to_string())?;
    told_to_go_home(&world, share, Setting::Furnished, seed)
        .ok_or_else(|| format!("{name}: it has no route to drive"))
}

fn told_to_go_home(world: &World, share: f64, setting: Setting, seed: u64) -> Option<Session> {
    let route: Vec<DVec2> = world.routes.values().next()?.iter().map(|&point| point.into()).collect();
    #[allow(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        clippy::cast_precision_loss,
        reason = "a share"
    )]
    let points = (share * route.len() as f64).ceil() as usize;
    at_the_command(&Episode::new(world, route.get(..points)?, setting, seed)?)
}

/// The milliseconds of each decision until the robot rests.
fn times(mut session: Session) -> Vec<f64> {
    let mut times = Vec::new();
    let end = session.position() + TICKS;
    while session.position() < end && (times.is_empty() || !session.at_rest()) {
        let decided = session.journal().decisions.len();
        let start = Instant::now();
        session.advance();
        if session.journal().decisions.len() > decided {
            times.push(start.elapsed().as_secs_f64() * 1e3);
        }
    }
    times
}
