//! Session files, `session.json`: everything that a run depends on, so that it can be run again.

mod limits;

use cogmap_mapping::MapperSetup;
use cogmap_simulation::{Robot, SESSION_FORMAT, SessionRecord, TimedCommand, World};
use serde::{Deserialize, de::DeserializeOwned};
use serde_json::value::RawValue;

use crate::{
    FormatError,
    json::{self, Piece},
};

/// A session as read, and what should be said before it is run.
#[derive(Clone, Debug, PartialEq)]
pub struct SessionFile {
    /// Everything that the run depends on.
    pub record: SessionRecord,
    /// What may make this run differ from the recorded one, each a sentence.
    pub warnings: Vec<String>,
}

/// Reads a session and makes sure that it can be run. `file` is the name for messages.
///
/// # Errors
/// [`FormatError`] with the place and the way out.
pub fn read(text: &str, file: &str) -> Result<SessionFile, FormatError> {
    let piece = Piece::whole(text, file);
    piece.expect_format(SESSION_FORMAT)?;
    let record: SessionRecord = piece.read().map_err(|error| closer(&piece).unwrap_or(error))?;
    limits::check(&piece, &record)?;
    let warnings = other_engine(&record).into_iter().collect();
    Ok(SessionFile { record, warnings })
}

/// The session as a file, each command on a line of its own.
#[must_use]
pub fn write(record: &SessionRecord) -> String {
    json::write_file(record, 3)
}

/// Another version may map differently: said, not refused.
fn other_engine(record: &SessionRecord) -> Option<String> {
    let here = env!("CARGO_PKG_VERSION");
    let there: String = record.engine.chars().take(32).collect();
    (there != here).then(|| {
        format!(
            "this session was made by version {there}, and this is version {here}: the run may differ in \
             detail; use version {there} for the same bytes"
        )
    })
}

/// The parts of a session that can be read one by one, to tell in which of them an error lies.
#[derive(Deserialize)]
struct Parts<'a> {
    #[serde(borrow)]
    source: Option<&'a RawValue>,
    #[serde(borrow)]
    mappers: Option<&'a RawValue>,
}

#[derive(Deserialize)]
struct SourceParts<'a> {
    #[serde(borrow)]
    world: Option<&'a RawValue>,
    #[serde(borrow)]
    robot: Option<&'a RawValue>,
    #[serde(borrow)]
    commands: Option<&'a RawValue>,
}

/// The error of the part that is broken: it knows its key and line, which the whole does not once
/// it has picked a source by its `from`.
fn closer(session: &Piece<'_>) -> Option<FormatError> {
    let parts: Parts<'_> = serde_json::from_str(session.text).ok()?;
    let source = parts.source.and_then(|source| {
        let piece = session.part(source.get(), "source");
        let parts: SourceParts<'_> = serde_json::from_str(source.get()).ok()?;
        part_error::<World>(&piece, parts.world, "world")
            .or_else(|| part_error::<Robot>(&piece, parts.robot, "robot"))
            .or_else(|| element_error::<TimedCommand>(&piece, parts.commands, "commands"))
    });
    source.or_else(|| element_error::<MapperSetup>(session, parts.mappers, "mappers"))
}

fn part_error<T: DeserializeOwned>(
    outer: &Piece<'_>,
    part: Option<&RawValue>,
    key: &str,
) -> Option<FormatError> {
    outer.part(part?.get(), key).read::<T>().err()
}

fn element_error<T: DeserializeOwned>(
    outer: &Piece<'_>,
    list: Option<&RawValue>,
    key: &str,
) -> Option<FormatError> {
    let list = outer.part(list?.get(), key);
    let elements: Vec<&RawValue> = serde_json::from_str(list.text).ok()?;
    let broken = |(index, element): (usize, &&RawValue)| {
        list.part(element.get(), &format!("[{index}]")).read::<T>().err()
    };
    elements.iter().enumerate().find_map(broken)
}

#[cfg(test)]
mod tests {
    use super::*;

    const CELL: &str = r#"{
  "format": "cogmap-session/1",
  "engine": "0.0.1",
  "source": {
    "from": "world",
    "world": {"format": "cogmap-world/1", "name": "Cell",
      "walls": [[[0,0],[5,0],[5,4],[0,4],[0,0]]], "start": {"position": [1,2]}},
    "robot": {"name": "mine"},
    "commands": [
      {"tick": 0, "do": "step", "turn": 0.3, "travel": 1.0},
      {"tick": 9, "do": "stop"}
    ],
    "ticks": 10
  },
  "mappers": [{"mapper": "perceptual"}],
  "seed": 18446744073709551615
}"#;

    fn error(from: &str, to: &str) -> String {
        assert!(CELL.contains(from), "{from}");
        read(&CELL.replace(from, to), "s.json").unwrap_err().to_string()
    }

    #[test]
    fn a_session_survives_its_file() {
        let first = read(CELL, "s.json").unwrap();
        let text = write(&first.record);
        let again = read(&text, "s.json").unwrap();
        assert_eq!(first, again);
        assert_eq!(text, write(&again.record));
        assert_eq!(first.record.seed, u64::MAX);
    }

    #[test]
    fn another_version_is_a_warning() {
        let warnings = read(CELL, "s.json").unwrap().warnings;
        assert!(warnings.len() == 1 && warnings[0].contains("version 0.0.1"), "{warnings:?}");
        let ours = CELL.replace("0.0.1", env!("CARGO_PKG_VERSION"));
        assert!(read(&ours, "s.json").unwrap().warnings.is_empty());
    }

    #[test]
    fn an_error_deep_inside_knows_its_place() {
        let message = error("[5,4],[0", "[5,\"4\"],[0");
        assert!(
            message.starts_with("s.json, line 7, column 35, at `source.world.walls[0][2][1]`"),
            "{message}"
        );
        let message = error("\"turn\"", "\"trun\"");
        assert!(message.starts_with("s.json, line 10, "), "{message}");
        assert!(message.contains("`source.commands[0]`"), "{message}");
        let message = error("\"name\": \"mine\"", "\"name\": \"mine\", \"lasr\": {}");
        assert!(
            message.contains("at `source.robot`: unknown key `lasr`; did you mean `laser`?"),
            "{message}"
        );
        let message = error("\"perceptual\"", "\"perceptul\"");
        assert!(
            message.contains("at `mappers[0]") && message.contains("did you mean `perceptual`?"),
            "{message}"
        );
    }

    #[test]
    fn a_number_that_would_never_end_is_refused_at_its_line() {
        let message = error("\"ticks\": 10", "\"ticks\": 1000000000000000000");
        assert!(message.starts_with("s.json, line 13, column 14, at `source.ticks`: "), "{message}");
    }
}
