use std::path::{Path, PathBuf};

use cogmap_formats::{carmen, plan::Plan, session, world};
use cogmap_geometry::DVec2;
use cogmap_simulation::{Problem, SessionRecord, Source, TICK, World};

use crate::building;
use crate::failure::Failure;
use crate::input::Input;
use crate::log::{self, counted};
use crate::terminal;
use cogmap_formats::Kind;

/// How many broken lines are told one by one.
const TOLD: usize = 10;

/// Less floor than this that a plan loses is not told, square metres.
const WORTH_TELLING: f64 = 0.05;

/// Says of each file what it is, what is in it, and what is wrong with it.
pub(crate) fn check(files: &[PathBuf], resolution: Option<f64>) -> Result<(), Failure> {
    let mut bad = 0;
    for path in files {
        match describe(path, resolution) {
            Ok(description) => terminal::say(&format!("{}: {description}\n", path.display()))?,
            Err(failure) => {
                terminal::complain(&failure);
                bad += 1;
            }
        }
    }
    match (bad, files.len()) {
        (0, _) => Ok(()),
        (_, 1) => Err(Failure::input("this file cannot be used as it is")),
        (bad, all) => Err(Failure::input(format!("{bad} of {all} files cannot be used as they are"))),
    }
}

fn describe(path: &Path, resolution: Option<f64>) -> Result<String, Failure> {
    let input = Input::read(path)?;
    match input.kind() {
        Kind::World => {
            let world = world::read(input.text()?, &input.name)?;
            for Problem { place, message } in world.remarks() {
                terminal::remark(&format!("{}, at `{place}`: {message}", input.name));
            }
            Ok(of_world(&world))
        }
        Kind::Picture => Ok(of_plan(&building::of_picture(&input, path, resolution)?)),
        Kind::MapServer => Ok(of_plan(&building::of_map_server(&input, path)?)),
        Kind::Session => of_session(&input, path),
        Kind::Log => of_log(&input),
        Kind::Other(what) => Err(Failure::input(format!("{}: this is {what}", input.name))
            .help("a world, a floor plan, a CARMEN log or a session can be checked")),
    }
}

fn of_world(world: &World) -> String {
    let length = |wall: &Vec<[f64; 2]>| -> f64 {
        wall.windows(2).map(|ends| DVec2::from(ends[0]).distance(DVec2::from(ends[1]))).sum()
    };
    let walls: f64 = world.walls.iter().map(length).sum();
    let furniture = [
        counted(world.boxes.len(), "box", "boxes"),
        counted(world.posts.len(), "post", "posts"),
        counted(world.doors.len(), "door", "doors"),
        counted(world.people.len(), "person", "people"),
        counted(world.rooms.len(), "room", "rooms"),
    ];
    let routes: Vec<String> = world
        .routes
        .iter()
        .map(|(name, route)| format!("{name} ({})", counted(route.len(), "point", "points")))
        .collect();
    let routes = match routes.len() {
        0 => "no routes".to_owned(),
        1 => format!("route: {}; it can be driven", routes.join("")),
        _ => format!("routes: {}; all can be driven", routes.join(", ")),
    };
    format!("a world, \"{}\"\n  {walls:.1} m of wall, {}\n  {routes}", world.name, furniture.join(", "))
}

fn of_plan(plan: &Plan) -> String {
    let ([width, height], [x, y]) = (plan.size, plan.world.start.position);
    let left_out = match plan.left_out {
        area if area < WORTH_TELLING => String::new(),
        area => format!("\n  left out: {area:.1} m² of floor that the robot cannot get to"),
    };
    format!(
        "a floor plan of {width:.1} m by {height:.1} m, {} m a pixel\n  {:.1} m² of floor within {} of wall; \
         the robot starts at [{x:.2}, {y:.2}]{left_out}",
        plan.resolution,
        plan.kept,
        counted(plan.pieces, "piece", "pieces"),
    )
}

fn of_log(input: &Input) -> Result<String, Failure> {
    let log = carmen::read(&input.plain, &input.name, false)?;
    let (counts, readings) = (&log.counts, &log.recording.readings);
    if counts.broken > 0 {
        let lines =
            log.skipped.iter().take(TOLD).map(|line| format!("\n  line {}: {}", line.line, line.reason));
        let message = format!("{}: {}", input.name, counted(counts.broken, "broken line", "broken lines"));
        return Err(Failure::input(message + &lines.collect::<String>())
            .help("`cogmap replay` skips them, and stops there with --strict"));
    }
    let beams = readings.first().map_or(0, |reading| reading.scan.ranges.len());
    let seconds = readings.first().zip(readings.last()).map_or(0.0, |(first, last)| last.t - first.t);
    let way: f64 = readings
        .windows(2)
        .map(|pair| pair[0].odom_from_robot.position.distance(pair[1].odom_from_robot.position))
        .sum();
    let unknown: Vec<String> =
        counts.unknown.iter().map(|(word, number)| format!("{word} ({number})")).collect();
    let unknown =
        if unknown.is_empty() { String::new() } else { format!("\n  passed over: {}", unknown.join(", ")) };
    let warnings: String = log.warnings.iter().map(|warning| format!("\n  note: {warning}")).collect();
    Ok(format!(
        "a CARMEN log\n  {} of {beams} beams in {seconds:.0} s, {way:.1} m by their odometry\n  \
         {} between them, {}{unknown}{warnings}",
        counted(counts.scans, "scan", "scans"),
        counted(counts.odometry, "odometry record", "odometry records"),
        counted(counts.comments, "comment", "comments"),
    ))
}

fn of_session(input: &Input, path: &Path) -> Result<String, Failure> {
    let file = session::read(input.text()?, &input.name)?;
    let SessionRecord { source, mappers, seed, engine, .. } = &file.record;
    let what = match source {
        Source::World { world, robot, commands, ticks } => format!(
            "the {} robot in \"{}\": {} in {:.0} s",
            robot.name,
            world.name,
            counted(commands.len(), "command", "commands"),
            *ticks as f64 * TICK
        ),
        Source::Log { .. } => {
            format!("the log {}, unchanged since then", log::find(&file.record, path)?.name)
        }
    };
    let names: Vec<&str> = mappers.iter().map(cogmap_mapping::MapperSetup::name).collect();
    let warnings: String = file.warnings.iter().map(|warning| format!("\n  note: {warning}")).collect();
    Ok(format!(
        "a session\n  {what}\n  mapped by {}, seed {seed}, made by version {engine}{warnings}",
        names.join(", ")
    ))
}
