//! A run and everything that it depends on: the record that all else replays from.

mod checkpoint;
mod drive;
mod feed;
mod journal;
mod oracle;
mod otherwise;
mod people;
mod pilot;
mod record;
mod stage;
mod truth;
mod variation;
mod way_home;

use std::sync::Arc;

use cogmap_geometry::Pose;
use cogmap_mapping::{Mapper, MapperSetup, perception::Scan};
use cogmap_navigation::Act;

use checkpoint::Checkpoints;
pub use feed::Recording;
use feed::{Feed, Observation};
pub use journal::{Homeward, Journal, MapperJournal, Stamped, wall_of};
pub use pilot::Pilot;
pub use record::{SESSION_FORMAT, SessionRecord, Source};
pub use way_home::{Ending, WayHome};

use crate::{Command, Problem, SessionEvent, Strategy, WorldEvent};

/// A world, a robot, a seed and commands, or a recorded log; and the mappers that are fed from it.
/// The same record always gives the same journal, to the last bit, on every platform.
pub struct Session {
    record: SessionRecord,
    live: Live,
    journal: Journal,
    checkpoints: Checkpoints,
    /// Whether something was told at this very moment already.
    told: bool,
}

/// What changes as a run goes on; cloning it is a checkpoint.
#[derive(Clone)]
struct Live {
    feed: Feed,
    /// Those of the record, and the navigator behind them if it is another.
    mappers: Vec<Mapper>,
    pilot: Option<Pilot>,
}

/// The mapper whose belief leads the robot home.
fn guide<'a>(mappers: &'a [Mapper], record: &SessionRecord) -> Option<&'a Mapper> {
    if record.navigator.is_some() { mappers.last() } else { mappers.first() }
}

impl Session {
    /// A robot at the start of its world; commands in the record wait for their ticks.
    ///
    /// # Errors
    /// What is wrong with the world, and where.
    pub fn drive(record: SessionRecord) -> Result<Self, Vec<Problem>> {
        let feed = Feed::drive(&record)?;
        Ok(Self::begin(record, feed))
    }

    /// A recorded log before its first reading. The recording is already thinned and perturbed as
    /// the record says.
    #[must_use]
    pub fn replay(record: SessionRecord, recording: Recording) -> Self {
        Self::begin(record, Feed::Log { recording: Arc::new(recording), next: 0 })
    }

    fn begin(record: SessionRecord, feed: Feed) -> Self {
        let setups = record.mappers.iter().chain(&record.navigator);
        let mappers = setups.map(|setup| Mapper::new(setup, record.seed)).collect();
        let journal = Journal::for_mappers(record.mappers.len());
        let checkpoints = Checkpoints::new(feed.interval());
        let live = Live { feed, mappers, pilot: None };
        let mut session = Self { record, live, journal, checkpoints, told: false };
        session.first_look();
        session.checkpoints.keep(&session.live, &session.journal);
        session
    }

    /// A robot looks before it moves (§3.2.1, step 4).
    fn first_look(&mut self) {
        if let Feed::Drive(drive) = &mut self.live.feed {
            let observation = drive.look();
            self.take_in(&observation);
        }
    }

    /// The same run before its first reading, for other mappers: each will be fed the very readings that
    /// this session's were.
    ///
    /// # Errors
    /// None for a session that runs: its world has been judged already.
    pub fn remapped(&self, mappers: Vec<MapperSetup>) -> Result<Self, Vec<Problem>> {
        let record = self.record.with_mappers(mappers);
        let feed = self.live.feed.rewound(&record)?;
        Ok(Self::begin(record, feed))
    }

    /// The same run at this moment, to be continued otherwise. It remembers no earlier moment to go back to.
    #[must_use]
    pub fn forked(&self) -> Self {
        let mut checkpoints = Checkpoints::new(self.live.feed.interval());
        checkpoints.keep(&self.live, &self.journal);
        let (record, live, journal) = (self.record.clone(), self.live.clone(), self.journal.clone());
        Self { record, live, journal, checkpoints, told: self.told }
    }

    /// One turn of the world: a tick of a drive, a reading of a log. `false` where a log is at its end.
    pub fn advance(&mut self) -> bool {
        self.told = false;
        self.hear();
        self.lead();
        let Some(turn) = self.live.feed.advance() else { return false };
        if let Some(position) = turn.collision {
            let collision = WorldEvent::Collision { position: position.into() };
            self.journal.note(&SessionEvent::World(collision));
        }
        if let Some(observation) = turn.observation {
            self.take_in(&observation);
        }
        self.record.lasts_at_least(self.live.feed.position());
        self.checkpoints.keep(&self.live, &self.journal);
        true
    }

    /// What the user says goes: any order to the robot ends its way home.
    fn hear(&mut self) {
        while let Feed::Drive(drive) = &mut self.live.feed
            && let Some(command) = drive.hear(self.record.commands())
        {
            if let Command::Change(change) = command {
                if drive.change(&change) == Ok(true) {
                    self.journal.note(&SessionEvent::World(WorldEvent::WorldChanged(change)));
                }
                continue;
            }
            if drive.refusal(&command).is_some() {
                continue;
            }
            drive.obey(&command);
            if self.live.pilot.take().is_some() {
                self.journal.note(&SessionEvent::World(WorldEvent::Stopped));
            }
            if let Command::GoHome { strategy } = command {
                self.go_home(&strategy);
            }
        }
    }

    fn go_home(&mut self, strategy: &Strategy) {
        let way_out = pilot::length(self.journal.odometry.iter().map(|stamped| stamped.pose.position));
        let Live { feed, mappers, pilot } = &mut self.live;
        if let Feed::Drive(drive) = feed {
            *pilot = Pilot::begin(strategy, guide(mappers, &self.record), way_out, drive);
        }
    }

    /// A robot on its way home decides what to do next, once it has come to rest.
    fn lead(&mut self) {
        let Live { feed: Feed::Drive(drive), mappers, pilot: Some(pilot) } = &mut self.live else { return };
        let guide = guide(mappers, &self.record);
        let Some(decision) = pilot.lead(guide, drive) else { return };
        if pilot.decisions() == 1 {
            self.journal.turn_home(pilot.strategy().clone());
        }
        if matches!(decision.act, Act::Arrived | Act::Stuck) {
            self.live.pilot = None;
        }
        self.journal.decide(decision);
    }

    fn take_in(&mut self, observation: &Observation) {
        let Live { feed, mappers, pilot } = &mut self.live;
        let reports: Vec<_> = mappers.iter_mut().map(|mapper| mapper.observe(&observation.reading)).collect();
        self.journal.write(observation, mappers, reports);
        if let (Feed::Drive(drive), Some(pilot)) = (feed, pilot) {
            pilot.observe(&observation.reading, guide(mappers, &self.record), drive);
        }
    }

    /// Tells the robot something, from the next tick on. What had been recorded for later is dropped:
    /// going on from an earlier moment makes another run of it. A log takes no commands, and a robot on
    /// its way home need not be told again. What is refused is not written down.
    pub fn command(&mut self, command: Command) {
        if let (Some(pilot), Command::GoHome { strategy }) = (self.homing(), &command)
            && pilot.strategy() == strategy
        {
            return;
        }
        if self.refusal(&command).is_some() {
            return;
        }
        let tick = self.live.feed.position();
        if self.record.tell(tick, command, std::mem::replace(&mut self.told, true)) {
            self.checkpoints.forget_after(tick);
        }
    }

    /// What speaks against a command at this moment, in words for people; `None` where it will be obeyed.
    #[must_use]
    pub fn refusal(&self, command: &Command) -> Option<String> {
        match &self.live.feed {
            Feed::Drive(drive) => drive.refusal(command),
            Feed::Log { .. } => Some("a recorded log takes no commands".to_owned()),
        }
    }

    /// Goes to any moment, forwards or backwards: to the nearest checkpoint before it, and from
    /// there by replaying.
    pub fn jump(&mut self, position: u64) {
        if position < self.live.feed.position()
            && let Some(live) = self.checkpoints.restore(position, &mut self.journal)
        {
            self.live = live;
        }
        self.told = false;
        while self.live.feed.position() < position && self.advance() {}
    }

    /// Ticks or readings so far.
    #[must_use]
    pub fn position(&self) -> u64 {
        self.live.feed.position()
    }

    /// The furthest position known: the ticks of the record, or the readings of the log.
    #[must_use]
    pub fn end(&self) -> u64 {
        match (&self.live.feed, &self.record.source) {
            (Feed::Log { recording, .. }, _) => recording.readings.len() as u64,
            (_, Source::World { ticks, .. }) => *ticks,
            _ => self.position(),
        }
    }

    /// Seconds since the beginning.
    #[must_use]
    pub fn time(&self) -> f64 {
        self.live.feed.time()
    }

    /// Whether the robot stands still with nothing left to do; on its way home it has. A log always rests.
    #[must_use]
    pub fn at_rest(&self) -> bool {
        match &self.live.feed {
            Feed::Drive(drive) => drive.at_rest() && self.live.pilot.is_none(),
            Feed::Log { .. } => true,
        }
    }

    /// Everything that the run depends on.
    #[must_use]
    pub fn record(&self) -> &SessionRecord {
        &self.record
    }

    /// What has come to light so far.
    #[must_use]
    pub fn journal(&self) -> &Journal {
        &self.journal
    }

    /// The mappers, in the order of the record.
    #[must_use]
    pub fn mappers(&self) -> &[Mapper] {
        self.live.mappers.get(..self.record.mappers.len()).unwrap_or_default()
    }

    /// Who leads the robot home; `None` where nobody does.
    #[must_use]
    pub fn homing(&self) -> Option<&Pilot> {
        self.live.pilot.as_ref()
    }

    /// Where odometry believes the robot is.
    #[must_use]
    pub fn odom_from_robot(&self) -> Pose {
        match &self.live.feed {
            Feed::Drive(drive) => drive.odom_from_robot(),
            Feed::Log { .. } => self.journal.odometry.last().map_or(Pose::IDENTITY, |last| last.pose),
        }
    }

    /// What the laser saw last.
    #[must_use]
    pub fn last_scan(&self) -> Option<&Scan> {
        self.live.feed.last_scan()
    }
}

#[cfg(test)]
mod tests;
