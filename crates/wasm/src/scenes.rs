use cogmap_geometry::{DVec2, Pose};
use cogmap_scene::{
    HomingMark, Item, LegendEntry, MemoryOptions, Role, Sample, Scene, Shape, Stage, Thing, WorldOptions,
    memory_scene, point_out, set_off, world_scene,
};
use cogmap_simulation::Session;

use crate::views::View;

/// What is shown of the world.
const IN_THE_WORLD: WorldOptions = WorldOptions { laser: true, path: true, labels: true, home: true };

/// What a view shows of a session, in the coordinates that all views share.
pub(crate) fn scene(session: &Session, view: View, options: MemoryOptions) -> Scene {
    let Some(mapper) = view.mapper() else { return world_scene(session, IN_THE_WORLD) };
    let shared_from_map = shared_from_map(session, mapper).unwrap_or(Pose::IDENTITY);
    memory_scene(session, mapper, options).seen_from(shared_from_map)
}

/// The world, with the ways that the robot went in futures that were left.
pub(crate) fn with_left_ways<'a>(mut scene: Scene, ways: impl Iterator<Item = &'a [DVec2]>) -> Scene {
    let before = scene.changing.len();
    scene.changing.extend(ways.map(|way| Item::new(Role::Path, Shape::Polyline(way.to_vec()))));
    if scene.changing.len() > before {
        scene.legend.push(LegendEntry::new(Sample::Line(Role::Path), "its way on another branch"));
    }
    scene
}

/// The world, with what is left of a way that somebody drew.
pub(crate) fn with_drawn_way(mut scene: Scene, ahead: &[DVec2]) -> Scene {
    if ahead.len() < 2 {
        return scene;
    }
    let line = || Shape::Polyline(ahead.to_vec());
    let marks = [(HomingMark::Rim, line()), (HomingMark::InMind, line())];
    scene.changing.extend(marks.map(|(mark, shape)| Item::new(Role::Homing(mark), shape)));
    scene.legend.push(LegendEntry::new(Sample::Line(Role::Homing(HomingMark::InMind)), "the way you drew"));
    scene
}

/// The memory of a mapper in its own frame, with what a stage of its latest step is about pointed out.
pub(crate) fn explained(
    session: &Session,
    mapper: usize,
    stage: Option<Stage>,
    options: MemoryOptions,
) -> Scene {
    let Some(stage) = stage else { return memory_scene(session, mapper, options) };
    let mut scene = memory_scene(session, mapper, MemoryOptions { view: false, ..options });
    point_out(&mut scene, session, mapper, stage);
    scene
}

/// Sets a thing of a mapper's memory off, above everything that changes in a picture of it.
pub(crate) fn accentuate(
    scene: &mut Scene,
    session: &Session,
    mapper: usize,
    thing: Thing,
    view_from_map: Pose,
) {
    let mut accents = Scene::default();
    set_off(&mut accents, session, mapper, thing);
    scene.changing.extend(accents.seen_from(view_from_map).changing);
}

/// Where the frame of a mapper's memory lies in the world, or in the odometry's frame where there is
/// no truth, so that both agree about the first view; `None` before that.
pub(crate) fn shared_from_map(session: &Session, mapper: usize) -> Option<Pose> {
    let journal = session.journal();
    let first_scan = journal.truth.first().or(journal.odometry.first())?;
    let mapper = session.mappers().get(mapper)?;
    let first = mapper.mfis().place_of(mapper.path().first()?);
    Some(first_scan.pose * first.inverse())
}
