use cogmap_geometry::{Pose, fit_motion};
use cogmap_simulation::{BoxObstacle, Door, Session};
use serde::{Deserialize, Serialize};

use crate::{
    Item, Role, Sample, Scene, Shape,
    world_scene::{robot_radius, walls},
};

/// What the world is laid over a memory by.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum TruthFit {
    /// Both agree about the first view: what went wrong since is seen where it is.
    #[default]
    FirstView,
    /// The path in memory lies as near to the true one as a rigid motion can lay it: what is wrong with the map's
    /// shape is seen, whichever way it has turned since the beginning.
    BestFit,
}

/// Lays the world over a memory.
pub(crate) fn draw(scene: &mut Scene, session: &Session, mapper: usize, fit: TruthFit) {
    let Some((map_from_world, world)) = map_from_world(session, mapper, fit).zip(session.world()) else {
        return;
    };
    let boxes = world.boxes.iter().flat_map(BoxObstacle::edges);
    let leaves = world.doors.iter().flat_map(Door::faces);
    let solids = walls(world).into_iter().chain(boxes).chain(leaves);
    let lines = solids.map(|solid| map_from_world * solid).collect();
    scene.still.push(Item::new(Role::Truth, Shape::Segments(lines)));
    if let Some(world_from_robot) = session.world_from_robot() {
        let robot = Shape::Robot(map_from_world * world_from_robot, robot_radius(session));
        scene.changing.push(Item::new(Role::Robot, robot));
        scene.explain(Sample::Robot(Role::Robot), "where it is");
    }
    scene.explain(
        Sample::Line(Role::Truth),
        match fit {
            TruthFit::FirstView => "the world",
            TruthFit::BestFit => "the world, as the whole path fits best",
        },
    );
}

/// Where the world lies in a mapper's map; `None` where it has no view yet, or there is no world.
fn map_from_world(session: &Session, mapper: usize, fit: TruthFit) -> Option<Pose> {
    let reports = &session.journal().mappers.get(mapper)?.reports;
    let truth = &session.journal().truth;
    let at =
        |t: f64| truth.get(truth.partition_point(|stamped| stamped.t < t)).filter(|stamped| stamped.t == t);
    let first = reports.first()?;
    let by_first_view = first.map_from_robot * at(first.t)?.pose.inverse();
    match fit {
        TruthFit::FirstView => Some(by_first_view),
        TruthFit::BestFit => {
            let mind = session.mappers().get(mapper)?;
            let believed = mind.path().iter().map(|point| mind.mfis().place_of(point).position);
            let pairs = reports.iter().zip(believed);
            let pairs = pairs.filter_map(|(report, believed)| Some([at(report.t)?.pose.position, believed]));
            fit_motion(&pairs.collect::<Vec<_>>(), by_first_view.heading)
        }
    }
}

#[cfg(test)]
mod tests {
    use cogmap_geometry::{DVec2, Segment};
    use cogmap_mapping::MapperSetup;
    use cogmap_simulation::{Command, Robot, SessionRecord, Source, World};

    use super::*;
    use crate::{MemoryOptions, memory_scene};

    /// A tour through a room, once round.
    fn session(robot: &str, mapper: &str) -> Session {
        let world: World = serde_json::from_str(
            r#"{"format": "cogmap-world/1", "name": "Cell", "start": {"position": [1, 2], "heading_deg": 30},
                "walls": [[[0, 0], [6, 0], [6, 4], [0, 4], [0, 0]]],
                "boxes": [{"center": [4.5, 3], "size": [0.6, 0.4]}]}"#,
        )
        .unwrap();
        let source = Source::world(world, Robot::named(robot).unwrap());
        let mapper = MapperSetup::named(mapper).unwrap();
        let mut session = Session::drive(SessionRecord::new(source, vec![mapper], 1)).unwrap();
        for turn in [-0.5, 0.2, 0.6, 1.2, 1.2, 0.9, 0.9] {
            session.command(Command::Step { turn, travel: 0.7 });
            while session.advance() && !session.at_rest() {}
        }
        session
    }

    /// Sum of the squared distances between the path in memory and the true one laid over it.
    fn misfit(session: &Session, fit: TruthFit) -> f64 {
        let map_from_world = map_from_world(session, 0, fit).unwrap();
        let mind = &session.mappers()[0];
        let reports = &session.journal().mappers[0].reports;
        let truth =
            |t: f64| session.journal().truth.iter().find(|stamped| stamped.t == t).unwrap().pose.position;
        let pairs = reports.iter().zip(mind.path());
        pairs
            .map(|(report, point)| {
                let believed: DVec2 = mind.mfis().place_of(point).position;
                (map_from_world * truth(report.t)).distance_squared(believed)
            })
            .sum()
    }

    #[test]
    fn the_truth_laid_over_agrees_with_what_was_seen_first() {
        let session = session("perfect", "perceptual");
        for truth_fit in [TruthFit::FirstView, TruthFit::BestFit] {
            let options = MemoryOptions { truth: true, truth_fit, ..MemoryOptions::default() };
            let scene = memory_scene(&session, 0, options);
            let truth: Vec<Segment> = scene
                .still
                .iter()
                .filter(|item| item.role == Role::Truth)
                .flat_map(
                    |item| if let Shape::Segments(lines) = &item.shape { lines.clone() } else { Vec::new() },
                )
                .collect();
            let first = session.mappers()[0].mfis().surfaces().iter().filter(|surface| surface.step == 0);
            for surface in first.filter(|surface| surface.segment.length() > 0.4) {
                let middle = surface.segment.midpoint();
                let nearest = truth.iter().map(|wall| wall.distance_to(middle)).fold(f64::INFINITY, f64::min);
                assert!(nearest < 0.03, "{surface:?} lies {nearest} m from every wall by {truth_fit:?}");
            }
        }
    }

    #[test]
    fn the_best_fit_leaves_less_between_the_paths_than_the_first_view_does() {
        let session = session("bad", "odometry");
        let (first, best) = (misfit(&session, TruthFit::FirstView), misfit(&session, TruthFit::BestFit));
        assert!(best < 0.5 * first, "{best} is not much less than {first}");
    }
}
