//! A run and everything that it depends on: the record that all else replays from.

mod checkpoint;
mod drive;
mod feed;
mod journal;
mod record;
mod variation;

use std::sync::Arc;

use cogmap_geometry::Pose;
use cogmap_mapping::{
    Event, Mapper, MapperSetup,
    perception::{Moment, Scan},
};

use checkpoint::Checkpoints;
pub use feed::Recording;
use feed::{Feed, Observation};
pub use journal::{Journal, MapperJournal, Stamped, wall_of};
pub use record::{SESSION_FORMAT, SessionRecord, Source};

use crate::{Command, Problem, Solids};

/// A world, a robot, a seed and commands, or a recorded log; and the mappers that are fed from it.
/// The same record always gives the same journal, to the last bit, on every platform.
pub struct Session {
    record: SessionRecord,
    feed: Feed,
    mappers: Vec<Mapper>,
    journal: Journal,
    checkpoints: Checkpoints,
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
        let mappers: Vec<Mapper> =
            record.mappers.iter().map(|setup| Mapper::new(setup, record.seed)).collect();
        let journal = Journal::for_mappers(mappers.len());
        let checkpoints = Checkpoints::new(feed.interval());
        let mut session = Self { record, feed, mappers, journal, checkpoints };
        session.first_look();
        session.checkpoints.keep(&session.feed, &session.mappers, &session.journal);
        session
    }

    /// A robot looks before it moves (§3.2.1, step 4).
    fn first_look(&mut self) {
        if let Feed::Drive(drive) = &mut self.feed {
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
        let record = SessionRecord { mappers, ..self.record.clone() };
        let feed = self.feed.rewound(&record)?;
        Ok(Self::begin(record, feed))
    }

    /// One turn of the world: a tick of a drive, a reading of a log. `false` where a log is at its end.
    pub fn advance(&mut self) -> bool {
        let Some(turn) = self.feed.advance(self.record.commands()) else { return false };
        if let Some(position) = turn.collision {
            self.journal.note(&Event::Collision { position: position.into() });
        }
        if let Some(observation) = turn.observation {
            self.take_in(&observation);
        }
        self.record.lasts_at_least(self.feed.position());
        self.checkpoints.keep(&self.feed, &self.mappers, &self.journal);
        true
    }

    fn take_in(&mut self, observation: &Observation) {
        let reports: Vec<_> =
            self.mappers.iter_mut().map(|mapper| mapper.observe(&observation.reading)).collect();
        self.journal.write(observation, &self.mappers, reports);
    }

    /// Tells the robot something, from the next tick on. What had been recorded for later is dropped:
    /// going on from an earlier moment makes another run of it. A log takes no commands.
    pub fn command(&mut self, command: Command) {
        let tick = self.feed.position();
        if self.record.tell(tick, command) {
            self.checkpoints.forget_after(tick);
        }
    }

    /// Goes to any moment, forwards or backwards: to the nearest checkpoint before it, and from
    /// there by replaying.
    pub fn jump(&mut self, position: u64) {
        if position < self.feed.position()
            && let Some((feed, mappers)) = self.checkpoints.restore(position, &mut self.journal)
        {
            self.feed = feed;
            self.mappers = mappers;
        }
        while self.feed.position() < position && self.advance() {}
    }

    /// Ticks or readings so far.
    #[must_use]
    pub fn position(&self) -> u64 {
        self.feed.position()
    }

    /// The furthest position known: the ticks of the record, or the readings of the log.
    #[must_use]
    pub fn end(&self) -> u64 {
        match (&self.feed, &self.record.source) {
            (Feed::Log { recording, .. }, _) => recording.readings.len() as u64,
            (_, Source::World { ticks, .. }) => *ticks,
            _ => self.position(),
        }
    }

    /// Seconds since the beginning.
    #[must_use]
    pub fn time(&self) -> f64 {
        self.feed.time()
    }

    /// Whether the robot stands still with nothing left to do; a log always rests.
    #[must_use]
    pub fn at_rest(&self) -> bool {
        match &self.feed {
            Feed::Drive(drive) => drive.at_rest(),
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
        &self.mappers
    }

    /// Where the robot truly is; `None` for logs.
    #[must_use]
    pub fn world_from_robot(&self) -> Option<Pose> {
        match &self.feed {
            Feed::Drive(drive) => Some(drive.world_from_robot()),
            Feed::Log { .. } => None,
        }
    }

    /// Where odometry believes the robot is.
    #[must_use]
    pub fn odom_from_robot(&self) -> Pose {
        match &self.feed {
            Feed::Drive(drive) => drive.odom_from_robot(),
            Feed::Log { .. } => self.journal.odometry.last().map_or(Pose::IDENTITY, |last| last.pose),
        }
    }

    /// What the laser saw last.
    #[must_use]
    pub fn last_scan(&self) -> Option<&Scan> {
        self.feed.last_scan()
    }

    /// How the robot was moving when the laser saw it; `None` for logs.
    #[must_use]
    pub fn last_moment(&self) -> Option<Moment> {
        match &self.feed {
            Feed::Drive(drive) => drive.last_moment(),
            Feed::Log { .. } => None,
        }
    }

    /// Which solid each beam of it truly measured; `None` for logs.
    #[must_use]
    pub fn last_beam_solids(&self) -> Option<&[Option<u32>]> {
        match &self.feed {
            Feed::Drive(drive) => drive.last_beam_solids(),
            Feed::Log { .. } => None,
        }
    }

    /// The building as the laser and the body meet it; `None` for logs.
    #[must_use]
    pub fn solids(&self) -> Option<&Solids> {
        match &self.feed {
            Feed::Drive(drive) => Some(drive.solids()),
            Feed::Log { .. } => None,
        }
    }
}

#[cfg(test)]
mod tests;
