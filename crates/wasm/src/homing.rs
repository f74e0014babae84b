//! How it goes with going home, in figures and for words.

use cogmap_mapping::MapperSetup;
use cogmap_navigation::{Atlas, Belief, Decision, HomingEvent, Mode};
use cogmap_simulation::{Command, Session, SessionEvent, WorldEvent};
use serde::Serialize;
use tsify::Tsify;

use crate::clause::{Clause, clauses};

/// A robot on its way home, or at the end of it.
#[derive(Clone, Debug, PartialEq, Serialize, Tsify)]
pub struct HomingStatus {
    /// How it finds the way.
    pub strategy: String,
    /// The mapper whose memory it goes by.
    pub by: String,
    /// What leads it, once it has decided something.
    pub lead: Option<Lead>,
    /// What it decided last and why.
    pub why: Option<Vec<Clause>>,
    /// How many decisions it has made.
    pub decisions: usize,
    /// Metres in a straight line to where it believes that home is; nothing where it does not know.
    pub believed: Option<f64>,
    /// Metres in a straight line to where the run began.
    pub distance: f64,
    /// How it ended; nothing while the robot is on its way.
    pub ended: Option<Ending>,
}

/// What leads a robot on its way home.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Tsify)]
#[serde(rename_all = "snake_case")]
pub enum Lead {
    /// The sense of direction.
    Direction,
    /// The remembered route.
    Route,
    /// A plan.
    Planning,
}

/// How a way home ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Tsify)]
#[serde(rename_all = "snake_case")]
pub enum Ending {
    /// The robot stopped by itself: it believes that it is home.
    Home,
    /// The robot gave up.
    Stuck,
    /// The user stopped it or took over.
    Stopped,
}

/// How it goes with going home, if that is what the robot does or did last: what it was told after the
/// order that ended its way is not about home any more.
pub(crate) fn homing(session: &Session) -> Option<HomingStatus> {
    let told = session.record().commands().iter().filter(|timed| timed.tick <= session.position());
    let to_the_robot = |command: &&Command| !matches!(command, Command::Change(_));
    let told: Vec<&Command> = told.map(|timed| &timed.command).filter(to_the_robot).collect();
    let (strategy, later) = told.iter().enumerate().rev().find_map(|(index, command)| match command {
        Command::GoHome { strategy } => Some((strategy, told.len() - 1 - index)),
        _ => None,
    })?;
    let ended = ending(session).filter(|_| session.homing().is_none());
    if later > usize::from(ended == Some(Ending::Stopped)) {
        return None;
    }
    let decisions = decisions(session);
    let last = decisions.last();
    Some(HomingStatus {
        strategy: strategy.name().to_owned(),
        by: guide(session)?.name().to_owned(),
        lead: last.map(|decision| lead(decision.mode)),
        why: last.map(|decision| clauses(&decision.why)),
        decisions: decisions.len(),
        believed: believed(session),
        distance: distance(session)?,
        ended,
    })
}

/// The mapper that led the robot home earlier in this run, before the way home that [`homing`] tells of.
pub(crate) fn led(session: &Session) -> Option<String> {
    let commands = session.record().commands().iter();
    let ways = commands.filter(|timed| matches!(timed.command, Command::GoHome { .. })).count();
    let guide = guide(session).filter(|_| ways > usize::from(homing(session).is_some()))?;
    Some(guide.name().to_owned())
}

/// What the robot has decided since it was told to go home, as far as it has decided anything yet.
fn decisions(session: &Session) -> &[Decision] {
    let journal = session.journal();
    let undecided = session.homing().is_some_and(|pilot| pilot.decisions() == 0);
    let begun = journal.homings.last().filter(|_| !undecided);
    begun.and_then(|begun| journal.decisions.get(begun.decisions..)).unwrap_or_default()
}

/// The mapper whose memory leads the robot.
fn guide(session: &Session) -> Option<&MapperSetup> {
    let record = session.record();
    record.navigator.as_ref().or(record.mappers.first())
}

/// How the latest way home ended.
fn ending(session: &Session) -> Option<Ending> {
    session.journal().mappers.first()?.events.iter().rev().find_map(|(_, event)| match event {
        SessionEvent::Homing(HomingEvent::Home { .. }) => Some(Ending::Home),
        SessionEvent::Homing(HomingEvent::Stuck { .. }) => Some(Ending::Stuck),
        SessionEvent::World(WorldEvent::Stopped) => Some(Ending::Stopped),
        _ => None,
    })
}

pub(crate) fn lead(mode: Mode) -> Lead {
    match mode {
        Mode::Direction => Lead::Direction,
        Mode::Route => Lead::Route,
        Mode::Planning => Lead::Planning,
    }
}

/// Metres to where the robot believes that home is; nothing where another mapper than those shown led it.
fn believed(session: &Session) -> Option<f64> {
    let mapper = session.mappers().first().filter(|_| session.record().navigator.is_none())?;
    Belief::of(mapper, &Atlas::of(mapper), session.odom_from_robot())?.distance_home()
}

/// Metres to where it truly is.
fn distance(session: &Session) -> Option<f64> {
    let began = session.journal().truth.first()?;
    Some(session.world_from_robot()?.position.distance(began.pose.position))
}
