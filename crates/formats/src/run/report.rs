use cogmap_mapping::{Event, FallbackRun, MapperSetup, Placement, fallback_runs};
use cogmap_simulation::{MapperJournal, Robot, Session, Source, Stamped};
use serde::Serialize;

use super::{
    Extras,
    homing::{HomingNote, homing_note},
    labels, trajectory,
};
use crate::{carmen::Counts, json};

/// `report.json`: how it went in numbers, and every parameter that mattered.
#[derive(Serialize)]
struct Report<'a> {
    format: &'static str,
    program: Program,
    seed: u64,
    source: SourceNote<'a>,
    run: Run,
    #[serde(skip_serializing_if = "Option::is_none")]
    homing: Option<HomingNote<'a>>,
    mappers: Vec<MapperNote<'a>>,
}

#[derive(Serialize)]
struct Program {
    name: &'static str,
    version: &'static str,
}

#[derive(Serialize)]
#[serde(tag = "from", rename_all = "snake_case")]
enum SourceNote<'a> {
    World {
        name: &'a str,
        robot: &'a Robot,
        commands: usize,
        ticks: u64,
    },
    Log {
        path: &'a str,
        sha256: &'a str,
        every: Option<f64>,
        odometry_noise: f64,
        #[serde(skip_serializing_if = "Option::is_none")]
        lines: Option<&'a Counts>,
    },
}

#[derive(Serialize)]
struct Run {
    scans: usize,
    /// Seconds from the first scan to the last.
    duration: f64,
    /// Metres, from scan to scan, as odometry has it.
    odometry_path_length: f64,
    /// Metres, from scan to scan.
    #[serde(skip_serializing_if = "Option::is_none")]
    path_length: Option<f64>,
    collisions: usize,
}

#[derive(Serialize)]
struct MapperNote<'a> {
    name: &'static str,
    #[serde(skip_serializing_if = "str::is_empty")]
    label: &'a str,
    views: usize,
    /// Of these, the views of which the map took in what was new.
    views_stored: usize,
    surfaces: usize,
    forgotten: usize,
    /// Metres of all stored surfaces together.
    surface_length: f64,
    matches: usize,
    references: usize,
    weak_placements: usize,
    partly_by_odometry: usize,
    fallbacks: usize,
    /// The stretches that these make up, and where each ended.
    fallback_runs: Vec<FallbackRun>,
    frames: usize,
    recognised: usize,
    /// Mappers that do not share their map out among local spaces have none of these three.
    asrs: Option<usize>,
    exits: Option<usize>,
    loops_closed: Option<usize>,
    /// Metres, from view to view, in the map.
    path_length: f64,
    parameters: &'a MapperSetup,
}

/// The report of the whole run as a file.
#[must_use]
pub fn report(session: &Session, extras: Extras<'_>) -> String {
    let record = session.record();
    let labels = labels(record);
    let mappers = (0..record.mappers.len()).zip(&labels);
    let report = Report {
        format: "cogmap-report/1",
        program: Program { name: "cogmap", version: env!("CARGO_PKG_VERSION") },
        seed: record.seed,
        source: source_note(&record.source, extras.log),
        run: run(session),
        homing: homing_note(session),
        mappers: mappers.filter_map(|(index, label)| mapper_note(session, index, label)).collect(),
    };
    json::write_file(&report, 8)
}

fn source_note<'a>(source: &'a Source, lines: Option<&'a Counts>) -> SourceNote<'a> {
    match source {
        Source::World { world, robot, commands, ticks } => {
            SourceNote::World { name: &world.name, robot, commands: commands.len(), ticks: *ticks }
        }
        Source::Log { path, sha256, every, odometry_noise } => {
            SourceNote::Log { path, sha256, every: *every, odometry_noise: *odometry_noise, lines }
        }
    }
}

fn run(session: &Session) -> Run {
    let odometry = trajectory::odometry(session, None);
    let truth = session.world_from_robot().map(|_| length(&trajectory::truth(session)));
    let duration = odometry.first().zip(odometry.last()).map_or(0.0, |(first, last)| last.t - first.t);
    Run {
        scans: session.journal().odometry.len(),
        duration,
        odometry_path_length: length(&odometry),
        path_length: truth,
        collisions: session.journal().mappers.first().map_or(0, |mapper| mapper.collisions().count()),
    }
}

fn loops_closed(journal: &MapperJournal) -> usize {
    journal.map_events().filter(|(_, event)| matches!(event, Event::LoopClosed { .. })).count()
}

fn length(poses: &[Stamped]) -> f64 {
    poses.windows(2).map(|pair| pair[0].pose.position.distance(pair[1].pose.position)).sum()
}

fn mapper_note<'a>(session: &'a Session, index: usize, label: &'a str) -> Option<MapperNote<'a>> {
    let parameters = session.record().mappers.get(index)?;
    let (mapper, journal) = (session.mappers().get(index)?, session.journal().mappers.get(index)?);
    let placed_by = |placement| journal.reports.iter().filter(|report| report.placement == placement).count();
    let path: Vec<Stamped> = mapper
        .path()
        .iter()
        .map(|point| Stamped { t: point.t, pose: mapper.mfis().place_of(point) })
        .collect();
    let (surfaces, network) = (mapper.mfis().surfaces(), mapper.network());
    Some(MapperNote {
        name: parameters.name(),
        label,
        views: journal.reports.len(),
        views_stored: journal.reports.iter().filter(|report| report.stored).count(),
        surfaces: surfaces.len(),
        forgotten: surfaces.len() - mapper.mfis().remembered().count(),
        surface_length: surfaces.iter().map(|surface| surface.segment.length()).sum(),
        matches: journal.reports.iter().map(|report| report.matches.len()).sum(),
        references: placed_by(Placement::Reference) + placed_by(Placement::WeakReference),
        weak_placements: placed_by(Placement::WeakReference),
        partly_by_odometry: placed_by(Placement::PartlyOdometry),
        fallbacks: placed_by(Placement::Odometry),
        fallback_runs: if mapper.is_odometry() { Vec::new() } else { fallback_runs(&journal.reports) },
        frames: mapper.mfis().frames().len(),
        recognised: journal.reports.iter().filter(|report| report.recalled.is_some()).count(),
        asrs: network.map(|network| network.asrs().len()),
        exits: network.map(|network| network.exits().len()),
        loops_closed: network.map(|_| loops_closed(journal)),
        path_length: length(&path),
        parameters,
    })
}
