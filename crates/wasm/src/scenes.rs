use cogmap_geometry::Pose;
use cogmap_scene::{MemoryOptions, Scene, WorldOptions, memory_scene, world_scene};
use cogmap_simulation::Session;

use crate::views::View;

/// What a view shows of a session, in the coordinates that both views share.
pub(crate) fn scene(session: &Session, view: View, options: MemoryOptions) -> Scene {
    let rival = usize::from(session.mappers().len() > 1);
    match (view, shared_from_map(session)) {
        (View::Left, Some(_)) => world_scene(session, WorldOptions::default()),
        (View::Left, None) => memory_scene(session, rival, options),
        (View::Right, shared) => {
            memory_scene(session, 0, options).seen_from(shared.unwrap_or(Pose::IDENTITY))
        }
    }
}

/// Where the memory's frame lies in the world so that both agree about the first view; `None`
/// where there is no truth.
pub(crate) fn shared_from_map(session: &Session) -> Option<Pose> {
    let truth = session.journal().truth.first()?;
    let mapper = session.mappers().first()?;
    let first = mapper.mfis().place_of(mapper.path().first()?);
    Some(truth.pose * first.inverse())
}
