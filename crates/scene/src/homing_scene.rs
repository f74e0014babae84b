//! Go Home (§3.3): where home is, the ways on that the robot sees, the one that it takes, and both paths.

use cogmap_geometry::DVec2;
use cogmap_mapping::{Mapper, memory::StoredSurface};
use cogmap_navigation::{Anchored, Atlas, Decision, HomingEvent, MovementOption};
use cogmap_simulation::{Pilot, Session, SessionEvent, WorldEvent};

use crate::{HomingMark, Item, Role, Sample, Scene, Shape};

/// From when to when the robot was on its way home, seconds, each time that it was told to; without end
/// where it still is.
pub(crate) fn times_home(session: &Session) -> Vec<[f64; 2]> {
    let mut times: Vec<[f64; 2]> = Vec::new();
    let Some(journal) = session.journal().mappers.first() else { return times };
    for (step, event) in &journal.events {
        let now = journal.reports.get(*step).map_or(0.0, |report| report.t);
        match event {
            SessionEvent::Homing(HomingEvent::GoHome { .. }) => times.push([now, f64::INFINITY]),
            SessionEvent::Homing(HomingEvent::Home { .. } | HomingEvent::Stuck { .. })
            | SessionEvent::World(WorldEvent::Stopped) => {
                times.iter_mut().for_each(|[_, end]| *end = end.min(now));
            }
            _ => {}
        }
    }
    times
}

/// Draws a path of times and places, and its last stretch up to the robot. Where the robot was told to go
/// home, the way out and the way home each have their colour; before, it is a path of that role. Where the
/// robot was carried, its true path has a gap.
pub(crate) fn draw_path(
    scene: &mut Scene,
    session: &Session,
    path: &[(f64, DVec2)],
    tail: Option<Vec<DVec2>>,
    role: Role,
) {
    let times_home = times_home(session);
    let roles =
        [if times_home.is_empty() { role } else { HomingMark::WayOut.into() }, HomingMark::WayHome.into()];
    let goes_home = session.homing().is_some() && !times_home.is_empty();
    let carried: Vec<f64> =
        if role == Role::TruePath { session.times_carried().collect() } else { Vec::new() };
    let tail = tail.filter(|_| !is_carried(&carried, path.last(), f64::INFINITY));
    let tail = tail.map(|tail| Item::new(roles[usize::from(goes_home)], Shape::Polyline(tail)));
    scene.changing.extend(tail);
    for (homeward, points) in pieces(path, &times_home, &carried) {
        scene.still.push(Item::new(roles[usize::from(homeward)], Shape::Polyline(points)));
    }
    if !times_home.is_empty() {
        scene.explain(Sample::Line(roles[0]), "way out");
        scene.explain(Sample::Line(roles[1]), "way home");
    } else if role == Role::TruePath {
        scene.explain(Sample::Line(role), "its way");
    }
}

/// Whether the robot was carried between two looks, of which the later may be still to come.
fn is_carried(carried: &[f64], last: Option<&(f64, DVec2)>, to: f64) -> bool {
    last.is_some_and(|(from, _)| carried.iter().any(|t| (*from..to).contains(t)))
}

/// Cuts a path of times and places into pieces; `true` marks those on which the robot went home.
fn pieces(path: &[(f64, DVec2)], times_home: &[[f64; 2]], carried: &[f64]) -> Vec<(bool, Vec<DVec2>)> {
    let mut pieces: Vec<(bool, Vec<DVec2>)> = Vec::new();
    let mut gap = false;
    for pair in path.windows(2) {
        let [(from, start), (to, end)] = [pair[0], pair[1]];
        if is_carried(carried, pair.first(), to) {
            gap = true;
            continue;
        }
        let homeward = times_home.iter().any(|&[begin, done]| begin <= from && to <= done);
        let joined = !std::mem::take(&mut gap);
        match pieces.last_mut() {
            Some((same, points)) if joined && *same == homeward => points.push(end),
            _ => pieces.push((homeward, vec![start, end])),
        }
    }
    pieces
}

/// Whether the belief of this mapper leads the robot home.
fn leads(session: &Session, mapper: usize) -> bool {
    mapper == 0 && session.record().navigator.is_none()
}

/// Whether the robot goes by this surface at the moment.
pub(crate) fn is_trusted(session: &Session, mapper: usize, stored: &StoredSurface) -> bool {
    let homing = session.homing().and_then(Pilot::homing).filter(|_| leads(session, mapper));
    homing.is_none_or(|homing| homing.trusts(stored.id))
}

/// The sign of a home.
pub(crate) fn draw_home(scene: &mut Scene, home: DVec2, text: &str) {
    scene.changing.push(item(HomingMark::Home, Shape::Signs(vec![home])));
    scene.explain(Sample::Sign(HomingMark::Home.into()), text);
}

/// Where a robot believes its home to be, in its map.
#[must_use]
pub fn believed_home(mind: &Mapper) -> Option<DVec2> {
    let first = mind.path().first()?;
    let atlas = Atlas::of(mind);
    let here_from_home = atlas.pose(Anchored { frame: first.frame, value: first.frame_from_robot })?;
    Some((mind.mfis().map_from_frame(atlas.here()) * here_from_home).position)
}

/// What the robot decided last, for as long as it stands by it, if the belief of this mapper leads it.
#[must_use]
pub fn decision_in_force(session: &Session, mapper: usize) -> Option<&Decision> {
    let decision = session.journal().decisions.last().filter(|_| leads(session, mapper))?;
    let stands = match session.homing() {
        Some(pilot) => pilot.decisions() > 0,
        None => decision.step + 1 >= session.mappers().get(mapper)?.path().len(),
    };
    stands.then_some(decision)
}

pub(crate) fn draw_decision(scene: &mut Scene, session: &Session, mapper: usize, mind: &Mapper) {
    if let Some(decision) = decision_in_force(session, mapper) {
        let begun = scene.changing.len();
        draw_options(scene, decision);
        draw_way(scene, decision);
        let map_from_here = mind.mfis().map_from_frame(decision.frame);
        scene.changing.iter_mut().skip(begun).for_each(|item| item.shape.carry(map_from_here));
    }
}

/// The options that were not taken (Fig. 3.25).
fn draw_options(scene: &mut Scene, decision: &Decision) {
    let (Some(&robot), Some(home)) = (decision.way.first(), decision.home) else { return };
    let others = decision.options.iter().enumerate().filter(|(k, _)| Some(*k) != decision.chosen);
    let (barred, open): (Vec<&MovementOption>, Vec<_>) =
        others.map(|(_, option)| option).partition(|it| it.barred);
    for option in &barred {
        scene.changing.push(item(HomingMark::Barred, Shape::Polyline(vec![robot, option.end])));
    }
    for option in &open {
        scene.changing.push(item(HomingMark::Assumed, Shape::Polyline(vec![option.end, home])));
        scene.changing.push(item(HomingMark::Seen, Shape::Polyline(vec![robot, option.end])));
    }
    if !open.is_empty() {
        scene.explain(Sample::Line(HomingMark::Seen.into()), "other ways on");
    }
    if !barred.is_empty() {
        scene.explain(Sample::Line(HomingMark::Barred.into()), "leads nowhere");
    }
}

/// What the robot decided for (Fig. 3.28), and the remembered route where it follows one (Fig. 3.33).
fn draw_way(scene: &mut Scene, decision: &Decision) {
    if let [robot, next, ..] = decision.way[..] {
        let behind = decision.way[1..].to_vec();
        scene.changing.push(item(HomingMark::Rim, Shape::Polyline(decision.way.clone())));
        if behind.len() > 1 {
            scene.changing.push(item(HomingMark::InMind, Shape::Polyline(behind)));
        }
        scene.changing.push(item(HomingMark::Chosen, Shape::Arrow(vec![robot, next])));
        scene.explain(Sample::Arrow(HomingMark::Chosen.into()), "goes there now");
        scene.explain(Sample::Line(HomingMark::InMind.into()), "and on from there");
    }
    if !decision.waypoints.is_empty() {
        let signs = decision.waypoints.iter().map(|&at| item(HomingMark::Waypoint, Shape::Signs(vec![at])));
        scene.changing.extend(signs);
        scene.explain(Sample::Sign(HomingMark::Waypoint.into()), "remembered waypoint");
    }
}

fn item(mark: HomingMark, shape: Shape) -> Item {
    Item::new(Role::Homing(mark), shape)
}

#[cfg(test)]
mod tests;
