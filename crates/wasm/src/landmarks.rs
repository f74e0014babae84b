//! What stands on the timeline: moments that are worth going back to.

use cogmap_mapping::Placement;
use cogmap_simulation::{Command, Session, SessionEvent, TICK};
use serde::Serialize;
use tsify::Tsify;

use crate::{memories::happening, status::Happening};

/// A moment of the run that is worth a mark on the timeline.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Tsify)]
pub struct Landmark {
    /// In ticks or readings.
    pub position: u64,
    /// Seconds since the beginning.
    pub t: f64,
    /// What happened then.
    pub what: Happening,
}

/// What happened in the first mapper's mind, as far as the run has ever come: the journal forgets what lies
/// ahead when the run goes back.
#[derive(Clone, Debug, Default)]
pub(crate) struct Landmarks {
    in_mind: Vec<Landmark>,
    /// Up to this position everything is noted.
    noted: u64,
    /// Whether a view in which nothing was known was the last.
    unseen: bool,
}

impl Landmarks {
    /// Notes what is new since the last time.
    pub(crate) fn note(&mut self, session: &Session, position_at: impl Fn(f64) -> u64) {
        let (Some(mind), Some(journal)) = (session.mappers().first(), session.journal().mappers.first())
        else {
            return;
        };
        let known = journal.reports.partition_point(|report| position_at(report.t) <= self.noted);
        let from = if self.noted == 0 { 0 } else { known };
        let begun = journal.reports.first().map_or(0.0, |first| first.t);
        if !mind.is_odometry() {
            let first = journal.events.partition_point(|(step, _)| *step < from);
            for (step, event) in &journal.events[first..] {
                let (Some(report), SessionEvent::Map(event)) = (journal.reports.get(*step), event) else {
                    continue;
                };
                let Some(what) = happening(event, report) else { continue };
                // Of views in a row in which nothing was known the first has a mark.
                let again = what == Happening::Unseen && self.unseen;
                self.unseen = report.placement == Placement::Odometry;
                if !again {
                    let position = position_at(report.t);
                    self.in_mind.push(Landmark { position, t: report.t - begun, what });
                }
            }
        }
        self.noted = self.noted.max(session.position());
    }

    /// Drops what lies after a position: it belongs to a run that will not be.
    pub(crate) fn forget_after(&mut self, position: u64) {
        self.in_mind.retain(|mark| mark.position <= position);
        self.noted = self.noted.min(position);
    }

    /// All of them in order, with what the user did: an order is marked where it was given, a change where it has
    /// just happened.
    #[allow(clippy::cast_precision_loss, reason = "no run lasts 2^53 ticks")]
    pub(crate) fn all(&self, session: &Session) -> Vec<Landmark> {
        let told = session.record().commands().iter().filter_map(|timed| {
            let happened = (timed.tick + 1).min(session.end());
            let (position, what) = match &timed.command {
                Command::GoHome { .. } => (timed.tick, Happening::ToldHome),
                Command::Kidnap { .. } => (happened, Happening::Kidnapped),
                Command::Change(change) => (happened, Happening::WorldChanged { change: change.into() }),
                _ => return None,
            };
            Some(Landmark { position, t: position as f64 * TICK, what })
        });
        let mut all: Vec<Landmark> = told.chain(self.in_mind.iter().copied()).collect();
        all.sort_by_key(|mark| mark.position);
        all
    }
}
