use std::path::Path;

use cogmap_formats::carmen::CarmenLog;
use cogmap_mapping::MapperSetup;
use cogmap_simulation::{Session, SessionRecord, Source};

use crate::arguments::ReplayArguments;
use crate::conclusion::Conclusion;
use crate::failure::Failure;
use crate::input::Input;
use crate::log;
use crate::output::Output;
use crate::progress;
use crate::records::Records;
use crate::run::{problems_of, setups};
use crate::terminal;
use crate::timing::Timing;
use cogmap_formats::Kind;

/// The seed of a log's noise where none is given.
const DEFAULT_SEED: u64 = 1;

/// Maps a log, or runs a session again, and leaves what the mappers made of it.
pub(crate) fn replay(arguments: &ReplayArguments) -> Result<(), Failure> {
    let mut timing = Timing::start();
    let input = Input::read(&arguments.input)?;
    let (record, log) = prepare(arguments, &input)?;
    let title = title(&record);
    let counts = log.as_ref().map(|log| log.counts.clone());
    let (mut session, mut records) = open(record, log, arguments)?;
    let output = Output::of(&arguments.output)?;
    timing.done("read");
    play(&mut session, &mut records);
    timing.done("map");
    let (session, records) = (&session, &records);
    let (output, counts) = (output.as_ref(), counts.as_ref());
    Conclusion { session, title: &title, output, records, counts }.draw(timing)
}

/// What is to be run, and the log that it needs.
fn prepare(
    arguments: &ReplayArguments,
    input: &Input,
) -> Result<(SessionRecord, Option<CarmenLog>), Failure> {
    let mappers = setups(&arguments.mappers.names)?;
    match input.kind() {
        Kind::Log => {
            let log = log::read(input, arguments.strict)?;
            let source = log::source(input, arguments.every, arguments.odometry_noise.unwrap_or(0.0));
            let seed = arguments.seed.unwrap_or(DEFAULT_SEED);
            Ok((SessionRecord::new(source, mappers, seed), Some(log)))
        }
        Kind::Session => {
            let record = session(arguments, input, mappers)?;
            let log = match record.source {
                Source::World { .. } => None,
                Source::Log { .. } => {
                    Some(log::read(&log::find(&record, &arguments.input)?, arguments.strict)?)
                }
            };
            Ok((record, log))
        }
        kind => Err(log::not_a_log(input, kind)),
    }
}

/// A session as its file has it, but for what the arguments say otherwise.
fn session(
    arguments: &ReplayArguments,
    input: &Input,
    mappers: Vec<MapperSetup>,
) -> Result<SessionRecord, Failure> {
    let file = cogmap_formats::session::read(input.text()?, &input.name)?;
    for warning in &file.warnings {
        terminal::remark(&format!("{}: {warning}", input.name));
    }
    let mut record = file.record;
    if !arguments.mappers.names.is_empty() {
        record = record.with_mappers(mappers);
    }
    match &mut record.source {
        Source::World { .. } => refuse_options_of_logs(arguments)?,
        Source::Log { every, odometry_noise, .. } => {
            *every = arguments.every.or(*every);
            *odometry_noise = arguments.odometry_noise.unwrap_or(*odometry_noise);
            record.seed = arguments.seed.unwrap_or(record.seed);
        }
    }
    Ok(record)
}

fn refuse_options_of_logs(arguments: &ReplayArguments) -> Result<(), Failure> {
    let given = [
        ("--every", arguments.every.is_some()),
        ("--odometry-noise", arguments.odometry_noise.is_some()),
        ("--seed", arguments.seed.is_some()),
        ("--strict", arguments.strict),
    ];
    match given.iter().find(|(_, given)| *given) {
        None => Ok(()),
        Some((option, _)) => {
            let session = arguments.input.display();
            Err(Failure::input(format!("{option}: {session} is a drive through a world, not a log"))
                .help(format!("leave {option} out, or drive anew with `cogmap run`")))
        }
    }
}

fn open(
    record: SessionRecord,
    log: Option<CarmenLog>,
    arguments: &ReplayArguments,
) -> Result<(Session, Records), Failure> {
    let dense = arguments.output.dense;
    match log {
        Some(log) => {
            let recording = log.recording.varied(&record);
            let records = Records::of_log(&recording, dense);
            Ok((Session::replay(record, recording), records))
        }
        None => {
            let session =
                Session::drive(record).map_err(|problems| problems_of(&arguments.input, &problems))?;
            Ok((session, Records::of_drive(dense)))
        }
    }
}

/// Runs a session to its end.
fn play(session: &mut Session, records: &mut Records) {
    let unit = if session.world_from_robot().is_some() { "ticks" } else { "scans" };
    let end = session.end();
    let bar = progress::bar(end, unit);
    records.note(session);
    while session.position() < end && session.advance() {
        records.note(session);
        bar.inc(1);
    }
    bar.finish_and_clear();
}

fn title(record: &SessionRecord) -> String {
    match &record.source {
        Source::World { world, robot, .. } => {
            format!("Drove the {} robot through \"{}\" again", robot.name, world.name)
        }
        Source::Log { path, every, odometry_noise, .. } => {
            let file = Path::new(path).file_name().unwrap_or_default().to_string_lossy();
            let every = every.map(|every| format!(", a scan each {every} m or rad")).unwrap_or_default();
            let noise = Some(odometry_noise).filter(|noise| **noise > 0.0);
            let noise = noise.map(|noise| format!(", odometry noise {noise} times")).unwrap_or_default();
            format!("Mapped {file}{every}{noise}")
        }
    }
}
