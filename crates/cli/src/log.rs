use std::path::{Path, PathBuf};

use cogmap_formats::carmen::{self, CarmenLog};
use cogmap_formats::sha256_hex;
use cogmap_simulation::{SessionRecord, Source};

use crate::failure::Failure;
use crate::input::Input;
use crate::terminal;
use cogmap_formats::Kind;

/// Reads a log, and says what it left out.
pub(crate) fn read(input: &Input, strict: bool) -> Result<CarmenLog, Failure> {
    let log = carmen::read(&input.plain, &input.name, strict)?;
    for warning in &log.warnings {
        terminal::remark(&format!("{}: {warning}", input.name));
    }
    if let Some(first) = log.skipped.first() {
        let lines = counted(log.counts.broken, "broken line", "broken lines");
        let first = format!("line {}: {}", first.line, first.reason);
        terminal::remark(&format!(
            "{}: skipped {lines}, first {first} (`--strict` stops there, `cogmap check` lists them)",
            input.name
        ));
    }
    Ok(log)
}

/// Finds the log that a session was made from, and makes sure that it is that one: by the path as
/// it was given, from the session's directory, or beside the session.
pub(crate) fn find(record: &SessionRecord, session_file: &Path) -> Result<Input, Failure> {
    let Source::Log { path, sha256, .. } = &record.source else {
        return Err(Failure::input(format!("{}: a drive has no log", session_file.display())));
    };
    let mut other = None;
    for candidate in candidates(path, session_file) {
        if candidate.is_file() {
            let input = Input::read(&candidate)?;
            if sha256_hex(&input.bytes) == *sha256 {
                return Ok(input);
            }
            other = Some(input.name);
        }
    }
    let session = session_file.display();
    Err(match other {
        Some(found) => Failure::input(format!("{found}: this is not the log that {session} was made from"))
            .help(format!(
                "put the log with the SHA-256 {sha256} in its place, or map this one: cogmap replay {found}"
            )),
        None => Failure::input(format!("{session}: its log is missing: {path}"))
            .help("run it where it was run first, or put the log beside the session file"),
    })
}

fn candidates(path: &str, session_file: &Path) -> Vec<PathBuf> {
    let beside = session_file.parent().unwrap_or(Path::new(""));
    let given = Path::new(path);
    // A session from another system may spell its path in that system's way.
    let name = path.rsplit(['/', '\\']).next().unwrap_or(path);
    vec![given.to_owned(), beside.join(given), beside.join(name)]
}

/// The source of a run on this log.
pub(crate) fn source(input: &Input, every: Option<f64>, odometry_noise: f64) -> Source {
    Source::Log { path: input.name.clone(), sha256: sha256_hex(&input.bytes), every, odometry_noise }
}

/// A log, or the reason why this is none.
pub(crate) fn not_a_log(input: &Input, kind: Kind) -> Failure {
    let name = &input.name;
    let nothing_to_replay = |what: &str| {
        Failure::input(format!("{name}: this is {what}, not a log"))
            .help("give a CARMEN log (.log, .clf; gzipped or not) or the session.json of an earlier run")
    };
    match kind {
        Kind::World => {
            Failure::input(format!("{name}: this is a world, and a world has to be driven through"))
                .help(format!("cogmap run {name}"))
        }
        Kind::Picture => nothing_to_replay("a picture"),
        Kind::MapServer => nothing_to_replay("a ROS map_server file"),
        Kind::Other(what) => nothing_to_replay(what),
        Kind::Log | Kind::Session => Failure::input(format!("{name}: cannot be replayed")),
    }
}

/// A number and what it counts.
pub(crate) fn counted(number: usize, one: &str, many: &str) -> String {
    format!("{number} {}", if number == 1 { one } else { many })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_log_is_looked_for_as_given_then_from_the_session_and_then_beside_it() {
        let paths = candidates("logs/a.log", Path::new("runs/one/session.json"));
        let paths: Vec<_> = paths.iter().map(|path| path.to_string_lossy()).collect();
        assert_eq!(paths, ["logs/a.log", "runs/one/logs/a.log", "runs/one/a.log"]);
        let foreign = candidates(r"C:\logs\a.log", Path::new("session.json"));
        assert_eq!(foreign.last(), Some(&PathBuf::from("a.log")));
    }
}
