use std::time::{Duration, Instant};

use cogmap_geometry::{DVec2, normalize_angle};
use cogmap_mapping::MapperSetup;
use cogmap_navigation::{Act, Atlas, Belief, HomingEvent};
use cogmap_simulation::{
    Command, Driver, Ending, Episode, Robot, Session, SessionRecord, Source, Strategy, WorldChange,
};

use super::row::{Ended, Trial};

/// The way out was driven if it ends so near to the route's end, metres.
const ARRIVED: f64 = 0.5;
/// A robot that has not decided anything for so long has lost its way, ticks: half an hour.
const TICKS_MAX: u64 = 90_000;
/// Two dead ends this near to each other are one, metres.
const SAME_DEAD_END: f64 = 1.0;
/// A turn that counts toward zigzags, radians.
const ZIG: f64 = 30.0 * std::f64::consts::PI / 180.0;

/// The robot at the end of its way out, with all that it remembers; `None` where it did not get there
/// without touching anything.
pub(super) fn way_out(
    episode: &Episode,
    (robot, mapper): (&Robot, &MapperSetup),
    seed: u64,
) -> Option<Session> {
    let mut driver = Driver::new(&episode.world, robot, &episode.route).ok()?;
    let source = Source::world(episode.world.clone(), robot.clone());
    let mut session = Session::drive(SessionRecord::new(source, vec![mapper.clone()], seed)).ok()?;
    driver.drive(&mut session);
    let end = session.world_from_robot()?.position;
    let arrived = episode.route.last()?.distance(end) < ARRIVED;
    (arrived && collisions(&session) == 0).then_some(session)
}

/// Changes the world and sends the robot home; with how long its decisions took on this machine.
pub(super) fn way_home(
    from: &Session,
    changes: &[WorldChange],
    strategy: &Strategy,
) -> Option<(Trial, Vec<Duration>)> {
    let mut session = from.forked();
    for change in changes {
        let change = Command::Change(change.clone());
        if session.refusal(&change).is_some() {
            return None;
        }
        session.command(change);
        session.advance();
    }
    session.command(Command::GoHome { strategy: strategy.clone() });
    let (begin, mut times) = (session.position(), Vec::new());
    loop {
        let (decided, began) = (session.journal().decisions.len(), Instant::now());
        session.advance();
        if session.journal().decisions.len() > decided {
            times.push(began.elapsed());
        }
        if session.at_rest() || session.position() > begin + TICKS_MAX {
            break;
        }
    }
    Some((trial(&session, collisions(from))?, times))
}

fn collisions(session: &Session) -> usize {
    session.journal().mappers.first().map_or(0, |mapper| mapper.collisions().count())
}

fn trial(session: &Session, before: usize) -> Option<Trial> {
    let way = session.way_home()?;
    let path = way.way_home;
    let events = || way.decisions.iter().flat_map(|decision| &decision.events);
    let dead_ends = events().filter_map(|event| match event {
        HomingEvent::DeadEnd { position, .. } => Some(DVec2::from(*position)),
        _ => None,
    });
    let dead_ends: Vec<DVec2> = dead_ends.collect();
    let again = |k: &usize| dead_ends[..*k].iter().any(|other| other.distance(dead_ends[*k]) < SAME_DEAD_END);
    let scans = session.journal().homings.last()?.scans;
    let headings: Vec<f64> =
        session.journal().truth.get(scans..)?.iter().map(|scan| scan.pose.heading).collect();
    let turned: f64 = headings.windows(2).map(|pair| normalize_angle(pair[1] - pair[0]).abs()).sum();
    let why = way.decisions.last().map_or(String::new(), |decision| decision.why.to_string());
    Some(Trial {
        ended: match way.ending {
            Some(Ending::Home) => Ended::Home,
            Some(Ending::Stuck(_)) => Ended::Stuck,
            _ => Ended::Lost,
        },
        distance: rounded(way.distance),
        home_offset: home_offset(session).map(rounded),
        out: rounded(way.way_out),
        shortest: way.shortest.map(rounded),
        path: rounded(path),
        collisions: (collisions(session) - before) as f64,
        decisions: way.decisions.len() as f64,
        failsafe_steps: failsafe_steps(way.decisions) as f64,
        dead_ends: dead_ends.len() as f64,
        reentries: (0..dead_ends.len()).filter(again).count() as f64,
        turning: rounded(turned / path.max(0.1)),
        zigzag: rounded(zigzags(way.decisions) as f64 / path.max(0.1) * 10.0),
        why: why.replace([',', '\n', '"'], ";"),
    })
}

/// How far from its true place the robot believes home to be, whatever it did about it.
fn home_offset(session: &Session) -> Option<f64> {
    let mapper = session.mappers().first()?;
    let belief = Belief::of(mapper, &Atlas::of(mapper), session.odom_from_robot())?;
    let believed = belief.here_from_robot.inverse() * belief.home?.position;
    let start = DVec2::from(session.world()?.start.position);
    let truly = session.world_from_robot()?.inverse() * start;
    Some(believed.distance(truly))
}

fn failsafe_steps(decisions: &[cogmap_navigation::Decision]) -> usize {
    let (mut on, mut steps) = (false, 0);
    for decision in decisions {
        for event in &decision.events {
            match event {
                HomingEvent::FailsafeOn { .. } => on = true,
                HomingEvent::FailsafeOff { .. } => on = false,
                _ => {}
            }
        }
        steps += usize::from(on);
    }
    steps
}

/// How often the robot turned sharply one way after it had turned sharply the other way.
fn zigzags(decisions: &[cogmap_navigation::Decision]) -> usize {
    let turns = decisions.iter().filter_map(|decision| match decision.act {
        Act::Step { turn, .. } if turn.abs() > ZIG => Some(turn > 0.0),
        _ => None,
    });
    let turns: Vec<bool> = turns.collect();
    turns.windows(2).filter(|pair| pair[0] != pair[1]).count()
}

fn rounded(metres: f64) -> f64 {
    // Adding nothing makes −0 of an empty sum 0.
    (metres * 1e4).round() / 1e4 + 0.0
}
