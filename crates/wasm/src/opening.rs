//! How runs begin: from the page's own worlds, and from files that somebody brought.

use cogmap_formats::{Kind, carmen, gzip, session, sha256_hex, world};
use cogmap_geometry::DVec2;
use cogmap_mapping::MapperSetup;
use cogmap_simulation::{Building, Driver, Robot, Session, SessionRecord, Source, Strategy, World};

use crate::{
    failure::Failure,
    plans,
    run::{Label, Run},
    setup::{Opening, Setup},
};

/// How a building is asked for that no file holds, here and on the command line.
pub(crate) const GENERATED: &str = "generated:";

/// A run in one of the page's worlds, or in a building made from a seed.
pub(crate) fn start(setup: &Setup) -> Result<Run, Failure> {
    let world = match setup.world.strip_prefix(GENERATED) {
        Some(seed) => generated(seed)?,
        None => world::read(&setup.world, &setup.file)?,
    };
    let (robot, mappers) = (robot(&setup.robot)?, mappers(&setup.mappers)?);
    let building = if setup.world.starts_with(GENERATED) { &setup.world } else { &setup.file };
    drive(world, robot, mappers, setup.seed, page_label(building))
}

/// An office floor made from the seed that stands in the text.
pub(crate) fn generated(seed: &str) -> Result<World, Failure> {
    let unknown = |_| Failure::new(&format!("there is no building `{seed}`: a whole number makes one"));
    seed.parse().map(Building::generate).map_err(unknown)
}

/// A run of what somebody brought, by its content. `other` may be the log that a session needs, or the other half of
/// a floor plan.
pub(crate) fn open(opening: &Opening, bytes: &[u8], other: Option<&[u8]>) -> Result<Run, Failure> {
    let plain = gzip::unpack(bytes, &opening.name)?;
    let kind = Kind::of(&plain);
    if let (Kind::Log | Kind::World, Some(_)) = (&kind, other) {
        let beside = opening.beside.as_deref().unwrap_or("the other file");
        return Err(Failure::new(&format!(
            "{} and {beside} do not belong together; bring one of them, or a session with the log that it was made \
             from, or a floor plan's picture with its YAML",
            opening.name
        )));
    }
    match kind {
        Kind::Log => map_log(opening, bytes),
        Kind::World => drive_in(world::read(text(&plain, &opening.name)?, &opening.name)?, opening),
        Kind::Picture | Kind::MapServer => drive_in(plans::building(opening, &plain, other)?, opening),
        Kind::Session => reopen(text(&plain, &opening.name)?, &opening.name, other),
        Kind::Other(what) => Err(Failure::new(&format!(
            "{}: this is {what}; bring a CARMEN log, a session, a world, or a floor plan as PNG or PGM",
            opening.name
        ))),
    }
}

/// A run in a building that somebody brought.
fn drive_in(world: World, opening: &Opening) -> Result<Run, Failure> {
    let (robot, mappers) = (robot(&opening.robot)?, mappers(&opening.mappers)?);
    drive(world, robot, mappers, opening.seed, label(&opening.name, true))
}

/// A robot at the start of a world, about to be driven along the world's first route.
fn drive(
    world: World,
    robot: Robot,
    mappers: Vec<MapperSetup>,
    seed: u64,
    label: Label,
) -> Result<Run, Failure> {
    let driver = driver(&world, &robot);
    let label = Label { name: world.name.clone(), ..label };
    let record = SessionRecord::new(Source::world(world, robot), mappers, seed);
    Ok(Run::new(Session::drive(record)?, label, driver))
}

/// The person at the controls, about to follow the world's first route. A route that cannot be driven is no
/// reason to keep the world from whoever wants to drive in it.
pub(crate) fn driver(world: &World, robot: &Robot) -> Option<Driver> {
    let route = world.routes.values().next()?;
    let route: Vec<_> = route.iter().copied().map(DVec2::from).collect();
    Driver::new(world, robot, &route).ok()
}

fn map_log(opening: &Opening, bytes: &[u8]) -> Result<Run, Failure> {
    let mappers = mappers(&opening.mappers)?;
    let source = Source::Log {
        path: opening.name.clone(),
        sha256: sha256_hex(bytes),
        every: None,
        odometry_noise: 0.0,
    };
    let record = SessionRecord::new(source, mappers, opening.seed);
    replay(record, bytes, label(&opening.name, true))
}

fn replay(record: SessionRecord, bytes: &[u8], label: Label) -> Result<Run, Failure> {
    Ok(Run::new(log_session(record, bytes, &label.name)?, label, None))
}

/// A log's session before its first reading. `name` is the log's, for messages.
pub(crate) fn log_session(record: SessionRecord, bytes: &[u8], name: &str) -> Result<Session, Failure> {
    let recording = carmen::read(bytes, name, false)?.recording.varied(&record);
    Ok(Session::replay(record, recording))
}

fn reopen(written: &str, name: &str, other: Option<&[u8]>) -> Result<Run, Failure> {
    let record = session::read(written, name)?.record;
    let Source::Log { path, sha256, .. } = &record.source else {
        let label = Label { name: world_name(&record), settled: true, ..label(name, true) };
        return Ok(Run::new(Session::drive(record)?, label, None));
    };
    match other {
        Some(log) if sha256_hex(log) == *sha256 => {
            let label = Label { settled: true, ..label(path, true) };
            replay(record, log, label)
        }
        Some(_) => {
            Err(Failure::new(&format!("{name}: made from another log than the one beside it; bring {path}")))
        }
        None => Err(Failure::new(&format!("{name}: made from the log {path}; bring both files at once"))),
    }
}

pub(crate) fn world_name(record: &SessionRecord) -> String {
    match &record.source {
        Source::World { world, .. } => world.name.clone(),
        Source::Log { path, .. } => path.clone(),
    }
}

pub(crate) fn text<'a>(plain: &'a [u8], name: &str) -> Result<&'a str, Failure> {
    std::str::from_utf8(plain)
        .map_err(|error| Failure::new(&format!("{name}: byte {} is not UTF-8 text", error.valid_up_to() + 1)))
}

fn robot(name: &str) -> Result<Robot, Failure> {
    Robot::named(name).ok_or_else(|| unknown("robot", name, &Robot::NAMES))
}

/// The strategy of that name.
pub(crate) fn strategy(name: &str) -> Result<Strategy, Failure> {
    Strategy::named(name).ok_or_else(|| unknown("strategy", name, &Strategy::names()))
}

/// The mappers of these names: at least one, each once.
pub(crate) fn mappers(names: &[String]) -> Result<Vec<MapperSetup>, Failure> {
    let twice = names.iter().enumerate().find(|(index, name)| names[..*index].contains(name));
    if let Some((_, name)) = twice {
        return Err(Failure::new(&format!("the mapper `{name}` is chosen twice")));
    }
    if names.is_empty() {
        return Err(Failure::new(&"no mapper is chosen"));
    }
    let known =
        |name: &String| MapperSetup::named(name).ok_or_else(|| unknown("mapper", name, &MapperSetup::NAMES));
    names.iter().map(known).collect()
}

fn unknown(what: &str, name: &str, known: &[&str]) -> Failure {
    Failure::new(&format!("there is no {what} `{name}`, only {}", known.join(", ")))
}

/// What a run in one of the page's buildings is called.
pub(crate) fn page_label(building: &str) -> Label {
    let building = building.trim_end_matches(".world.json");
    Label { building: Some(building.to_owned()), ..label(&building.replace(':', "-"), false) }
}

/// What a file's run is called: the file without folder and extensions.
pub(crate) fn label(file: &str, foreign: bool) -> Label {
    let name = file.rsplit(['/', '\\']).next().unwrap_or(file);
    let stem = name.split('.').find(|part| !part.is_empty()).unwrap_or("run");
    Label {
        name: name.to_owned(),
        stem: stem.to_owned(),
        foreign,
        settled: false,
        building: None,
        warnings: Vec::new(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn saved_files_are_called_after_what_they_came_from() {
        for (file, stem) in [
            ("intel.log.gz", "intel"),
            ("folder/office.world.json", "office"),
            ("C:\\logs\\.hidden.log", "hidden"),
            ("", "run"),
        ] {
            assert_eq!(label(file, true).stem, stem);
        }
    }

    #[test]
    fn files_that_do_not_belong_together_are_not_opened_in_part() {
        let opening = Opening {
            name: "one.log".into(),
            robot: "bad".into(),
            mappers: vec!["odometry".into()],
            seed: 1,
            resolution: None,
            beside: Some("two.log".into()),
        };
        let log = b"# CARMEN\n";
        let told = open(&opening, log, Some(log)).err().map(|failure| failure.to_string());
        assert!(told.is_some_and(|told| told.contains("one.log and two.log do not belong together")));
    }
}
