//! What a run leaves: its session, trajectories, maps, events and report, written from the session
//! alone, so that the same session gives the same bytes.

mod events;
mod homing;
mod map;
mod network;
mod report;
mod table;
mod trajectory;

use cogmap_simulation::{Session, SessionRecord, Stamped};

use crate::{carmen::Counts, session, tum};

pub use events::events;
pub use map::map;
pub use network::network;
pub use report::report;
pub use table::table;

/// What the session does not hold but its files can tell.
#[derive(Clone, Copy, Debug, Default)]
pub struct Extras<'a> {
    /// Odometry records between the scans, to write trajectories more densely.
    pub dense: Option<&'a [Stamped]>,
    /// What the lines of the log were, for the report.
    pub log: Option<&'a Counts>,
}

/// A file that a run leaves.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct RunFile {
    /// Its name within the run's directory.
    pub name: String,
    /// Its content.
    pub text: String,
}

/// Every text file of a run but its picture and its timing.
#[must_use]
pub fn files(session: &Session, extras: Extras<'_>) -> Vec<RunFile> {
    let mut files = vec![RunFile { name: "session.json".to_owned(), text: session::write(session.record()) }];
    if session.world_from_robot().is_some() {
        files.push(RunFile { name: "truth.tum".to_owned(), text: tum::write(&trajectory::truth(session)) });
    }
    let odometry = trajectory::odometry(session, extras.dense);
    files.push(RunFile { name: "odometry.tum".to_owned(), text: tum::write(&odometry) });
    for (index, label) in labels(session.record()).iter().enumerate() {
        let estimate = trajectory::estimate(session, index, extras.dense);
        let named = |stem, extension, text| RunFile { name: file_name(stem, label, extension), text };
        files.push(named("estimate", "tum", tum::write(&estimate)));
        files.push(named("map", "json", map(session, index)));
        files.push(named("network", "g2o", network(session, index)));
        files.push(named("events", "jsonl", events(session, index)));
    }
    files.push(RunFile { name: "report.json".to_owned(), text: report(session, extras) });
    files
}

/// What tells the files of one mapper from those of the others: nothing where there is one mapper,
/// else its name, with a number where a name comes twice.
#[must_use]
pub fn labels(record: &SessionRecord) -> Vec<String> {
    let names: Vec<&str> = record.mappers.iter().map(cogmap_mapping::MapperSetup::name).collect();
    if names.len() == 1 {
        return vec![String::new()];
    }
    let label = |(index, name): (usize, &&str)| {
        let earlier = names.iter().take(index).filter(|other| *other == name).count();
        if earlier == 0 { (*name).to_owned() } else { format!("{name}-{}", earlier + 1) }
    };
    names.iter().enumerate().map(label).collect()
}

/// The name of a mapper's file: `map.json`, or `map.LABEL.json`.
///
/// ```
/// assert_eq!(cogmap_formats::run::file_name("map", "", "json"), "map.json");
/// assert_eq!(cogmap_formats::run::file_name("map", "odometry", "svg"), "map.odometry.svg");
/// ```
#[must_use]
pub fn file_name(stem: &str, label: &str, extension: &str) -> String {
    if label.is_empty() { format!("{stem}.{extension}") } else { format!("{stem}.{label}.{extension}") }
}

#[cfg(test)]
mod tests;
