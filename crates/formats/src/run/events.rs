use cogmap_simulation::{Session, SessionEvent};
use serde::Serialize;

use crate::json;

/// A line of `events.jsonl`.
#[derive(Serialize)]
struct Line<'a> {
    step: usize,
    #[serde(flatten)]
    event: &'a SessionEvent,
}

/// What happened to the mapper at `index`, one line of JSON an event, in order.
#[must_use]
pub fn events(session: &Session, index: usize) -> String {
    let Some(journal) = session.journal().mappers.get(index) else {
        return String::new();
    };
    let lines =
        journal.events.iter().map(|(step, event)| json::write(&Line { step: *step, event }, 0) + "\n");
    lines.collect()
}
