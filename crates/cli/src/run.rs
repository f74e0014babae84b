use std::path::Path;
use std::time::Instant;

use cogmap_geometry::DVec2;
use cogmap_mapping::MapperSetup;
use cogmap_simulation::{Driver, Robot, Session, SessionRecord, Source, World, random_route};
use indicatif::ProgressBar;

use crate::arguments::{DEFAULT_MAPPER, RunArguments};
use crate::building;
use crate::conclusion::Conclusion;
use crate::failure::Failure;
use crate::homing;
use crate::input::Input;
use crate::output::Output;
use crate::progress;
use crate::records::Records;
use crate::timing::Timing;

/// Whoever drives counts as having arrived so near to the end of the route, metres.
const ARRIVED: f64 = 0.5;

/// Drives a robot along a route and leaves what its mappers made of it.
pub(crate) fn run(arguments: &RunArguments) -> Result<(), Failure> {
    let mut timing = Timing::start();
    let mappers = setups(&arguments.mappers.names)?;
    let world = building::read(&arguments.world, arguments.picture.resolution)?;
    let robot = robot(&arguments.robot)?;
    let (route_name, route) = route(arguments, &world, &robot)?;
    let driver = Driver::new(&world, &robot, &route).map_err(|problem| {
        Failure::input(format!("{}, {route_name}: {problem}", arguments.world.display()))
    })?;
    let title = format!("Drove the {} robot through \"{}\" along {route_name}", robot.name, world.name);
    let record = SessionRecord::new(Source::world(world, robot), mappers, arguments.seed);
    let mut session = Session::drive(record).map_err(|problems| problems_of(&arguments.world, &problems))?;
    let output = Output::of(&arguments.output)?;
    timing.done("read");
    let mut records = Records::of_drive(arguments.output.dense);
    drive(&mut session, driver, &mut records);
    timing.done("drive and map");
    let mut outcome = failure_of(&session, &route);
    if outcome.is_ok() && arguments.go_home {
        homing::go_home(&mut session, arguments.strategy.as_deref(), &mut records)?;
        outcome = homing::failure_of(&session);
        timing.done("go home");
    }
    let (session, records) = (&session, &records);
    Conclusion { session, title: &title, output: output.as_ref(), records, counts: None }.draw(timing)?;
    outcome
}

/// The mappers of these names with their default parameters.
pub(crate) fn setups(names: &[String]) -> Result<Vec<MapperSetup>, Failure> {
    let default = [DEFAULT_MAPPER.to_owned()];
    let names = if names.is_empty() { &default } else { names };
    for (index, name) in names.iter().enumerate() {
        if names[..index].contains(name) {
            return Err(Failure::input(format!("--mapper: `{name}` twice")).help("name each mapper once"));
        }
    }
    let unknown = |name: &str| {
        Failure::input(format!("--mapper {name}: there is no such mapper"))
            .help(format!("choose from {}", MapperSetup::NAMES.join(", ")))
    };
    names.iter().map(|name| MapperSetup::named(name).ok_or_else(|| unknown(name))).collect()
}

fn robot(wanted: &Path) -> Result<Robot, Failure> {
    if let Some(robot) = wanted.to_str().and_then(Robot::named) {
        return Ok(robot);
    }
    if !wanted.exists() {
        let message = format!("--robot {}: there is no such robot and no such file", wanted.display());
        let names = Robot::NAMES.join(", ");
        return Err(Failure::input(message).help(format!("choose from {names}, or name a robot file")));
    }
    let input = Input::read(wanted)?;
    let robot: Robot = serde_json::from_str(input.text()?).map_err(|error| {
        let problem = error.to_string();
        let what = problem.rsplit_once(" at line ").map_or(problem.as_str(), |(what, _)| what);
        Failure::input(format!("{}, line {}: {what}", input.name, error.line()))
            .help("a robot file is JSON, as session.json has it under \"source\", \"robot\"")
    })?;
    match robot.problems() {
        problems if problems.is_empty() => Ok(robot),
        problems => Err(problems_of(wanted, &problems)),
    }
}

/// What cannot be simulated, a line each.
pub(crate) fn problems_of(path: &Path, problems: &[cogmap_simulation::Problem]) -> Failure {
    let lines: Vec<String> = problems
        .iter()
        .map(|problem| format!("{}, `{}`: {}", path.display(), problem.place, problem.message))
        .collect();
    Failure::input(lines.join("\n       "))
}

/// The route's name for people, and its points.
fn route(arguments: &RunArguments, world: &World, robot: &Robot) -> Result<(String, Vec<DVec2>), Failure> {
    let file = arguments.world.display();
    let points = |route: &[[f64; 2]]| route.iter().copied().map(DVec2::from).collect();
    let Some(wanted) = &arguments.route else {
        let first = world.routes.first_key_value().ok_or_else(|| {
            Failure::input(format!("{file}: this world has no route"))
                .help("let one be drawn with --route random, or give a file with --route FILE")
        })?;
        return Ok((format!("`{}`", first.0), points(first.1)));
    };
    if wanted == Path::new("random") {
        let route = random_route(world, robot, arguments.seed).map_err(|problem| {
            Failure::input(format!("{file}: {problem}")).help("name a route with --route")
        })?;
        return Ok(("a random route".into(), route));
    }
    if let Some((name, route)) = wanted.to_str().and_then(|name| world.routes.get_key_value(name)) {
        return Ok((format!("`{name}`"), points(route)));
    }
    if wanted.exists() {
        return Ok((format!("the route in {}", wanted.display()), read_route(wanted)?));
    }
    let names: Vec<&str> = world.routes.keys().map(String::as_str).collect();
    let known = if names.is_empty() { String::new() } else { format!("{}, ", names.join(", ")) };
    Err(Failure::input(format!(
        "--route: {file} has no route `{}`, and no such file exists",
        wanted.display()
    ))
    .help(format!("choose from {known}random, or name a file")))
}

fn read_route(path: &Path) -> Result<Vec<DVec2>, Failure> {
    const FORM: &str = "a route is a JSON list of points in metres: [[x, y], …]";
    if path.is_dir() {
        return Err(Failure::input(format!("--route {}: this is a directory", path.display())).help(FORM));
    }
    let input = Input::read(path)?;
    let points: Vec<[f64; 2]> = serde_json::from_str(input.text()?)
        .map_err(|error| Failure::input(format!("{}: {error}", input.name)).help(FORM))?;
    if points.is_empty() {
        return Err(Failure::input(format!("{}: at least one point is needed", input.name)).help(FORM));
    }
    Ok(points.into_iter().map(DVec2::from).collect())
}

/// Asks the person at the controls whenever the robot has come to rest, until they have nothing
/// more to say.
fn drive(session: &mut Session, mut driver: Driver, records: &mut Records) {
    let sign = progress::spinner();
    records.note(session);
    while let Some(command) = session.world_from_robot().and_then(|pose| driver.next_command(pose)) {
        session.command(command);
        come_to_rest(session, records, &sign);
    }
    sign.finish_and_clear();
}

/// Lets the robot do what it was told.
pub(crate) fn come_to_rest(session: &mut Session, records: &mut Records, sign: &ProgressBar) {
    let mut shown = Instant::now();
    loop {
        session.advance();
        records.note(session);
        if session.at_rest() {
            return;
        }
        if shown.elapsed() >= progress::MESSAGE_EVERY {
            let scans = session.journal().odometry.len();
            sign.set_message(format!("{:.0} s driven, {scans} scans", session.time()));
            sign.tick();
            shown = Instant::now();
        }
    }
}

/// A robot that hit something, or did not arrive, has failed.
fn failure_of(session: &Session, route: &[DVec2]) -> Result<(), Failure> {
    let (Some(pose), Some(goal)) = (session.world_from_robot(), route.last()) else { return Ok(()) };
    let way_out = "the files show how it came there; move the route, or what stands in its way";
    collision(session).map_or(Ok(()), |failure| Err(failure.help(way_out)))?;
    let distance = pose.position.distance(*goal);
    if distance > ARRIVED {
        let message = format!("the robot got stuck at {}, {distance:.1} m before the end", at(pose.position));
        return Err(Failure::run(message).help(way_out));
    }
    Ok(())
}

/// The first thing that the robot hit.
pub(crate) fn collision(session: &Session) -> Option<Failure> {
    let place = session.journal().mappers.first()?.collisions().next()?;
    Some(Failure::run(format!("the robot drove into something at {}", at(place.into()))))
}

pub(crate) fn at(point: DVec2) -> String {
    format!("[{:.2}, {:.2}]", point.x, point.y)
}

#[cfg(test)]
mod tests {
    use std::process::ExitCode;

    use super::*;

    #[test]
    fn a_robot_that_does_not_arrive_has_failed() {
        let world = r#"{"format": "cogmap-world/1", "name": "Cell", "start": {"position": [1, 2]},
            "walls": [[[0,0],[5,0],[5,4],[0,4],[0,0]]]}"#;
        let world = cogmap_formats::world::read(world, "cell.world.json").unwrap();
        let source = Source::world(world, Robot::named("perfect").unwrap());
        let record = SessionRecord::new(source, setups(&[]).unwrap(), 1);
        let session = Session::drive(record).unwrap();
        assert!(failure_of(&session, &[DVec2::new(1.1, 2.1)]).is_ok());
        let failure = failure_of(&session, &[DVec2::new(4.0, 2.0)]).unwrap_err();
        assert!(failure.to_string().contains("stuck at [1.00, 2.00], 3.0 m before the end"), "{failure}");
        assert_eq!(failure.exit_code(), ExitCode::from(1));
    }
}
