use cogmap_simulation::{Command, Problem, SessionRecord, Source, TICK, TimedCommand};
use serde_json::Value;

use crate::{FormatError, json::Piece, world::complain};

/// The longest run, seconds: a day.
const LONGEST: f64 = 86_400.0;
/// The most commands that a session may hold.
const COMMANDS_MAX: usize = 1_000_000;
/// The most changes of the world: each makes it be arranged anew.
const CHANGES_MAX: usize = 2_000;
/// The most mappers that may watch one run.
const MAPPERS_MAX: usize = 16;
/// No command asks for more metres, radians or either a second.
const COMMAND_MAX: f64 = 1000.0;
/// No parameter of a mapper is farther from zero.
const PARAMETER_MAX: f64 = 1e6;
/// How many wrong values are told one by one.
const TOLD_MAX: usize = 20;

/// Refuses what would never end, fill the memory or make no sense.
pub(super) fn check(piece: &Piece<'_>, record: &SessionRecord) -> Result<(), FormatError> {
    let mut problems = match &record.source {
        Source::World { world, robot, commands, ticks } => {
            let mut problems = under("source.world", world.problems());
            problems.extend(under("source.robot", robot.problems()));
            problems.extend(duration(*ticks));
            problems.extend(these_commands(commands, *ticks));
            problems
        }
        Source::Log { path, sha256, every, odometry_noise } => {
            let mut problems = log(path, sha256);
            problems.extend(bounded("source.every", every.unwrap_or(1.0), [0.001, 1000.0]));
            problems.extend(bounded("source.odometry_noise", *odometry_noise, [0.0, 1000.0]));
            problems
        }
    };
    problems.extend(mappers(record));
    problems.truncate(TOLD_MAX);
    complain(piece, problems)
}

fn under(key: &str, problems: Vec<Problem>) -> Vec<Problem> {
    problems.into_iter().map(|it| Problem { place: format!("{key}.{}", it.place), ..it }).collect()
}

fn problem(place: impl Into<String>, message: impl Into<String>) -> Problem {
    Problem { place: place.into(), message: message.into() }
}

fn bounded(place: &str, value: f64, [low, high]: [f64; 2]) -> Option<Problem> {
    let wrong = !(low..=high).contains(&value);
    wrong.then(|| problem(place, format!("is {value}; choose a number from {low} to {high}")))
}

fn duration(ticks: u64) -> Option<Problem> {
    let most = (LONGEST / TICK) as u64;
    (ticks > most).then(|| {
        problem("source.ticks", format!("is {ticks}; at most {most} ticks of {TICK} s (a day) can be run"))
    })
}

fn these_commands(commands: &[TimedCommand], ticks: u64) -> Vec<Problem> {
    if commands.len() > COMMANDS_MAX {
        let message = format!("there are {}; at most {COMMANDS_MAX} can be run", commands.len());
        return vec![problem("source.commands", message)];
    }
    let changes = commands.iter().filter(|timed| matches!(timed.command, Command::Change(_))).count();
    if changes > CHANGES_MAX {
        let message = format!("there are {changes} changes of the world; at most {CHANGES_MAX} can be run");
        return vec![problem("source.commands", message)];
    }
    let mut problems = Vec::new();
    let mut last = 0;
    for (index, timed) in commands.iter().enumerate() {
        let place = format!("source.commands[{index}]");
        if timed.tick < last || timed.tick > ticks {
            let message = format!(
                "is {}; put commands in order, from {last} to the session's {ticks} ticks",
                timed.tick
            );
            problems.push(problem(format!("{place}.tick"), message));
        }
        last = last.max(timed.tick);
        let most = match timed.command {
            // What makes no sense is refused when its time has come.
            Command::Change(_) => continue,
            Command::GoHome { .. } => PARAMETER_MAX,
            _ => COMMAND_MAX,
        };
        let value = serde_json::to_value(&timed.command).unwrap_or_default();
        problems.extend(wild_numbers(&value, &place, most));
    }
    problems.truncate(TOLD_MAX);
    problems
}

fn log(path: &str, sha256: &str) -> Vec<Problem> {
    let mut problems = Vec::new();
    if path.is_empty() {
        problems.push(problem("source.path", "is empty; name the log's file"));
    }
    if sha256.len() != 64 || !sha256.bytes().all(|byte| byte.is_ascii_hexdigit()) {
        problems.push(problem("source.sha256", "is not 64 hexadecimal digits; write the log file's SHA-256"));
    }
    problems
}

fn mappers(record: &SessionRecord) -> Vec<Problem> {
    let count = record.mappers.len();
    if count == 0 || count > MAPPERS_MAX {
        return vec![problem("mappers", format!("there are {count}; name from 1 to {MAPPERS_MAX} mappers"))];
    }
    let setups = record.mappers.iter().enumerate();
    let problems = setups.flat_map(|(index, setup)| {
        let value = serde_json::to_value(setup).unwrap_or_default();
        wild_numbers(&value, &format!("mappers[{index}]"), PARAMETER_MAX)
    });
    problems.collect()
}

/// Numbers anywhere in a value that are farther from zero than `most`.
fn wild_numbers(value: &Value, place: &str, most: f64) -> Vec<Problem> {
    match value {
        Value::Number(number) => {
            bounded(place, number.as_f64().unwrap_or(f64::NAN), [-most, most]).into_iter().collect()
        }
        Value::Array(elements) => {
            let elements = elements.iter().enumerate();
            elements.flat_map(|(i, element)| wild_numbers(element, &format!("{place}[{i}]"), most)).collect()
        }
        Value::Object(members) => {
            let members = members.iter();
            members.flat_map(|(key, member)| wild_numbers(member, &format!("{place}.{key}"), most)).collect()
        }
        _ => Vec::new(),
    }
}
