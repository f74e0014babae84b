use cogmap_geometry::Segment;
use cogmap_scene::{MemoryOptions, Panel, Scene, WorldOptions, memory_scene, world_scene};

use super::{Drawing, runs::Run};

/// Surfaces at least so long are walls rather than debris, metres.
pub(super) const LONG: f64 = 0.6;

/// What a mapper remembers, in the world's directions.
pub(super) fn seen_in_the_world(run: &Run, mapper: &str, options: MemoryOptions) -> Scene {
    memory_scene(&run.session, run.index(mapper), options).seen_from(run.world_from_map())
}

/// What a mapper remembers, one colour a view, over the building as it is.
pub(super) fn map_of(run: &Run, mapper: &str) -> Scene {
    let options = MemoryOptions { truth: true, view: false, exits: false, ..MemoryOptions::default() };
    seen_in_the_world(run, mapper, options)
}

/// The building with the way through it.
pub(super) fn plan_of(run: &Run) -> Scene {
    world_scene(&run.session, WorldOptions { laser: false, path: true, labels: true, home: false })
}

/// A scene as a panel.
pub(super) fn panel_of(heading: impl Into<String>, scene: Scene) -> Panel {
    Panel { heading: heading.into(), scene, room: None }
}

/// A figure of one scene.
pub(super) fn one(scene: Scene, outcome: String, source: String) -> Drawing {
    Drawing { panels: vec![panel_of("", scene)], columns: 1, outcome, source }
}

/// How far the robot believes itself from where it is in the end, metres and radians.
pub(super) fn off_in_the_end(run: &Run, mapper: &str) -> Result<(f64, f64), String> {
    let (_, journal) = run.mind(mapper)?;
    let believed = journal.estimate.last().ok_or("the robot took no view")?.pose;
    let truth = run.session.world_from_robot().ok_or("a log has no truth")?;
    let error = truth.from_here(run.world_from_map() * believed);
    Ok((error.position.length(), error.heading.abs()))
}

/// The same in words.
pub(super) fn off_in_words(run: &Run, mapper: &str) -> Result<String, String> {
    let (metres, radians) = off_in_the_end(run, mapper)?;
    let distance =
        if metres < 0.995 { format!("{:.0} cm", 100.0 * metres) } else { format!("{metres:.1} m") };
    Ok(format!("{distance} and {:.0}°", radians.to_degrees()))
}

/// The long surfaces of a map that lie off the wall that they were seen on: where they lie in the world, and
/// how far off, metres; the farthest first.
pub(super) fn displaced(run: &Run, mapper: &str) -> Result<Vec<(Segment, f64)>, String> {
    let (mind, journal) = run.mind(mapper)?;
    let solids = run.session.solids().ok_or("a log has no truth")?;
    let with_walls = mind.mfis().surfaces().iter().zip(&journal.true_walls);
    let mut displaced: Vec<(Segment, f64)> = with_walls
        .filter_map(|(surface, wall)| {
            let line = run.world_from_map() * mind.mfis().in_map(surface);
            let wall = solids.segments.get((*wall)? as usize)?;
            Some((line, wall.distance_to(line.midpoint())))
        })
        .filter(|(line, _)| line.length() >= LONG)
        .collect();
    displaced.sort_by(|a, b| b.1.total_cmp(&a.1));
    Ok(displaced)
}
