use cogmap_geometry::{DVec2, Pose};
use cogmap_scene::{Item, MemoryOptions, Scene, Shape, WorldOptions, memory_scene, world_scene};
use cogmap_simulation::Session;

use crate::views::View;

/// What a view shows of a session, in the coordinates that both views share.
pub(crate) fn scene(session: &Session, view: View) -> Scene {
    let rival = usize::from(session.mappers().len() > 1);
    match (view, shared_from_map(session)) {
        (View::Left, Some(_)) => world_scene(session, WorldOptions::default()),
        (View::Left, None) => memory_scene(session, rival, MemoryOptions::default()),
        (View::Right, shared) => {
            placed(memory_scene(session, 0, MemoryOptions::default()), shared.unwrap_or(Pose::IDENTITY))
        }
    }
}

/// Where the memory's frame lies in the world so that both agree about the first view; `None`
/// where there is no truth.
pub(crate) fn shared_from_map(session: &Session) -> Option<Pose> {
    let truth = session.journal().truth.first()?;
    let first = session.mappers().first()?.path().first()?;
    Some(truth.pose * first.map_from_robot.inverse())
}

/// The same picture in another place.
fn placed(scene: Scene, pose: Pose) -> Scene {
    let place = |items: Vec<Item>| items.into_iter().map(|item| placed_item(item, pose)).collect();
    Scene { still: place(scene.still), changing: place(scene.changing), ..scene }
}

fn placed_item(item: Item, pose: Pose) -> Item {
    let points = |points: Vec<DVec2>| points.into_iter().map(|point| pose * point).collect();
    let shape = match item.shape {
        Shape::Segments(segments) => {
            Shape::Segments(segments.into_iter().map(|segment| pose * segment).collect())
        }
        Shape::Polyline(line) => Shape::Polyline(points(line)),
        Shape::Polygon(outline) => Shape::Polygon(points(outline)),
        Shape::Signs(places) => Shape::Signs(points(places)),
        Shape::Disc(center, radius) => Shape::Disc(pose * center, radius),
        Shape::Robot(robot, radius) => Shape::Robot(pose * robot, radius),
        Shape::Label { at, text, room } => Shape::Label { at: pose * at, text, room },
    };
    Item { shape, ..item }
}
