use cogmap_navigation::{HomingEvent, Mode};
use cogmap_simulation::{Command, Ending, Session, Strategy, WayHome};

use crate::arguments::DEFAULT_STRATEGY;
use crate::failure::Failure;
use crate::progress;
use crate::records::Records;
use crate::run::{at, collision, come_to_rest};

/// A robot that stops no farther from its start has come home, metres in truth (§3.3.5 counts more than
/// one metre as home).
const HOME: f64 = 1.5;

/// Tells the robot to go home and waits until it has stopped by itself.
pub(crate) fn go_home(
    session: &mut Session,
    strategy: Option<&str>,
    records: &mut Records,
) -> Result<(), Failure> {
    let name = strategy.unwrap_or(DEFAULT_STRATEGY);
    let strategy = Strategy::named(name).ok_or_else(|| {
        Failure::input(format!("--strategy {name}: there is no such strategy"))
            .help(format!("choose from {}", Strategy::names().join(", ")))
    })?;
    let sign = progress::spinner();
    session.command(Command::GoHome { strategy });
    come_to_rest(session, records, &sign);
    sign.finish_and_clear();
    Ok(())
}

/// A robot that hit something, gave up, or stopped too far from its start has failed.
pub(crate) fn failure_of(session: &Session) -> Result<(), Failure> {
    const WAY_OUT: &str = "events.jsonl (--out DIR) tells what it decided and why; try another --strategy";
    if let Some(failure) = collision(session) {
        return Err(failure.help(WAY_OUT));
    }
    let (Some(way), Some(pose)) = (session.way_home(), session.world_from_robot()) else { return Ok(()) };
    let off = format!("{:.1} m from its start", way.distance);
    let message = match way.ending {
        Some(Ending::Stuck(why)) => format!("the robot gave up {off}, at {}: {why}", at(pose.position)),
        _ if way.distance > HOME => format!("the robot took {} for home, {off}", at(pose.position)),
        _ => return Ok(()),
    };
    Err(Failure::run(message).help(WAY_OUT))
}

/// How the way home went, for people; nothing where the robot was never told to go home.
pub(crate) fn summary(session: &Session) -> String {
    let Some(way) = session.way_home() else { return String::new() };
    let believed = way.believed.map_or_else(
        || "it knows no way back".to_owned(),
        |metres| format!("it believes to be {metres:.2} m from it"),
    );
    let shortest = way.shortest.map_or_else(
        || "no way leads home".to_owned(),
        |metres| format!("{metres:.1} m would do for one who sees the building"),
    );
    format!(
        "\nWent home by `{}`\n  {}\n  it stands {:.2} m from its start, and {believed}\n  \
         {:.1} m home after {:.1} m out; {shortest}\n  {}\n",
        way.strategy.name(),
        ending(&way),
        way.distance,
        way.way_home,
        way.way_out,
        decisions(&way)
    )
}

fn ending(way: &WayHome) -> String {
    match way.ending {
        Some(Ending::Home) => {
            let why =
                way.decisions.last().map_or("home is here".to_owned(), |decision| decision.why.to_string());
            format!("stopped by itself: {why}")
        }
        Some(Ending::Stuck(why)) => format!("gave up: {why}"),
        Some(Ending::Stopped) => "was stopped by its user".to_owned(),
        None => "is still on its way".to_owned(),
    }
}

fn decisions(way: &WayHome) -> String {
    let led_by = |mode: Mode| way.decisions.iter().filter(|decision| decision.mode == mode).count();
    let modes = [
        (Mode::Direction, "by its sense of direction"),
        (Mode::Route, "along the remembered route"),
        (Mode::Planning, "by a plan"),
    ];
    let led = modes.map(|(mode, how)| (led_by(mode), how)).into_iter().filter(|(count, _)| *count > 0);
    let led: Vec<String> = led.map(|(count, how)| format!("{count} {how}")).collect();
    let events = || way.decisions.iter().flat_map(|decision| &decision.events);
    let dead_ends = events().filter(|event| matches!(event, HomingEvent::DeadEnd { .. })).count();
    let failsafes = events().filter(|event| matches!(event, HomingEvent::FailsafeOn { .. })).count();
    format!(
        "{} decisions, {}; {dead_ends} dead ends, fail-safe {failsafes} times",
        way.decisions.len(),
        led.join(", ")
    )
}
