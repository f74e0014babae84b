use cogmap_geometry::{DVec2, Pose, Segment};
use cogmap_mapping::{Mapper, MapperSetup, Placement, StepReport};
use cogmap_simulation::{Session, Source};
use serde::{Deserialize, Serialize};

use crate::{
    Colouring, HomingMark, Item, Role, Sample, Scene, Shape, homing_scene,
    label::plural,
    network_scene,
    surfaces::surfaces,
    truth_scene::{self, TruthFit},
    world_scene::robot_radius,
};

/// What of a robot's memory is shown.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct MemoryOptions {
    /// The world laid over it.
    pub truth: bool,
    /// What the world is laid by.
    pub truth_fit: TruthFit,
    /// Where the robot believes that it went, and how its views were placed.
    pub path: bool,
    /// The latest view, and the reference that it was placed by.
    pub view: bool,
    /// The exits, from jamb to jamb.
    pub exits: bool,
    /// The network: its local spaces by number, and the exits that join them.
    pub network: bool,
    /// The local frames and how they lie to each other.
    pub frames: bool,
    /// Where home is, also before the robot is told to go there.
    pub home: bool,
    /// What a robot on its way home has in mind.
    pub homing: bool,
    /// What the colours of the surfaces say.
    pub colouring: Colouring,
}

impl Default for MemoryOptions {
    fn default() -> Self {
        Self {
            truth: false,
            truth_fit: TruthFit::FirstView,
            path: true,
            view: true,
            exits: true,
            network: false,
            frames: false,
            home: false,
            homing: true,
            colouring: Colouring::View,
        }
    }
}

/// The colours of a short run are spread over this many views at least.
const FEW_VIEWS: usize = 8;

/// What a robot holds in memory: the MFIS of one mapper, and itself in it. Empty where the session
/// has no such mapper.
#[must_use]
pub fn memory_scene(session: &Session, mapper: usize, options: MemoryOptions) -> Scene {
    let (Some(journal), Some(mind)) = (session.journal().mappers.get(mapper), session.mappers().get(mapper))
    else {
        return Scene::default();
    };
    let name = session.record().mappers.get(mapper).map_or("", MapperSetup::name);
    let views = journal.reports.len();
    let mut scene = Scene { views: views.max(FEW_VIEWS), ..Scene::default() };
    (scene.title, scene.note) = words(session, name, mind, views);
    explain_colours(&mut scene, mind, options.colouring);
    scene.explain(Sample::Robot(Role::BelievedRobot), "robot, where it believes it is");
    if options.colouring == Colouring::Asr {
        network_scene::draw_floors(&mut scene, mind);
    }
    if options.truth {
        truth_scene::draw(&mut scene, session, mapper, options.truth_fit);
    }
    draw_surfaces(&mut scene, session, mapper, options);
    let robot = mind.map_from_robot(session.odom_from_robot());
    if options.path {
        draw_path(&mut scene, session, mapper, robot);
    }
    network_scene::draw(&mut scene, mind, journal, options);
    if let (true, Some(report)) = (options.view, journal.reports.last()) {
        draw_view(&mut scene, mind, report);
    }
    draw_homing(&mut scene, session, mapper, options);
    if let Some(robot) = robot {
        let shape = Shape::Robot(robot, robot_radius(session));
        scene.changing.push(Item::new(Role::BelievedRobot, shape));
    }
    scene
}

fn explain_colours(scene: &mut Scene, mind: &Mapper, colouring: Colouring) {
    match colouring {
        Colouring::Age => scene.explain(Sample::Age, "first seen just now … long ago"),
        Colouring::Asr if mind.network().is_some() => {
            scene.explain(Sample::Asrs, "a colour for each local space");
        }
        _ => scene.explain(Sample::Run, &format!("first seen in view 1–{}", scene.views)),
    }
}

fn words(session: &Session, name: &str, mind: &Mapper, views: usize) -> (String, String) {
    let surfaces = plural(mind.mfis().remembered().count(), "surface");
    let counts = format!("{surfaces} from {}", plural(views, "view"));
    let note = match &session.record().source {
        Source::World { world, robot, .. } => format!("{} · {} robot · {counts}", world.name, robot.name),
        Source::Log { path, .. } => {
            format!("{} · {counts}", path.rsplit(['/', '\\']).next().unwrap_or(path))
        }
    };
    (format!("The robot’s memory: {name}"), note)
}

fn draw_surfaces(scene: &mut Scene, session: &Session, mapper: usize, options: MemoryOptions) {
    let Some(mind) = session.mappers().get(mapper) else { return };
    let is_trusted = |stored: &_| !options.homing || homing_scene::is_trusted(session, mapper, stored);
    let surfaces = surfaces(mind, options.colouring, &is_trusted);
    let forgotten = Role::Homing(HomingMark::Forgotten);
    if surfaces.first().is_some_and(|item| item.role == forgotten) {
        scene.explain(Sample::Line(forgotten), "not trusted now");
    }
    scene.still.extend(surfaces);
}

fn draw_homing(scene: &mut Scene, session: &Session, mapper: usize, options: MemoryOptions) {
    let Some(mind) = session.mappers().get(mapper) else { return };
    let told = !homing_scene::times_home(session).is_empty();
    if options.homing {
        homing_scene::draw_decision(scene, session, mapper, mind);
    }
    if let (true, Some(home)) = (options.home || (told && options.homing), homing_scene::believed_home(mind))
    {
        homing_scene::draw_home(scene, home, "home, as it believes");
    }
}

/// A path: the way out, and the way home where there is one.
fn draw_path(scene: &mut Scene, session: &Session, mapper: usize, robot: Option<Pose>) {
    let (Some(mind), Some(journal)) = (session.mappers().get(mapper), session.journal().mappers.get(mapper))
    else {
        return;
    };
    let points: Vec<_> = mind.path().iter().map(|point| mind.mfis().place_of(point).position).collect();
    let timed: Vec<_> = journal.reports.iter().map(|report| report.t).zip(points.iter().copied()).collect();
    let tail = timed.last().zip(robot).map(|((_, last), robot)| vec![*last, robot.position]);
    homing_scene::draw_path(scene, session, &timed, tail, Role::Path);
    scene.still.push(Item::new(Role::PathStep, Shape::Signs(points)));
    scene.explain(Sample::Sign(Role::PathStep), "a view");
    if mind.is_odometry() {
        return; // every view is placed by odometry, so marking them would say nothing
    }
    let marks = [
        (Placement::WeakReference, Role::WeakPlacement, "placed with a guess"),
        (Placement::Odometry, Role::FallbackPlacement, "placed by odometry"),
    ];
    for (placement, role, text) in marks {
        let placed = journal.reports.iter().filter(|report| report.placement == placement);
        let places: Vec<DVec2> = placed.map(|report| report.map_from_robot.position).collect();
        if !places.is_empty() {
            scene.still.push(Item::new(role, Shape::Signs(places)));
            scene.explain(Sample::Sign(role), text);
        }
    }
}

fn draw_view(scene: &mut Scene, mind: &Mapper, report: &StepReport) {
    let segments: Vec<Segment> =
        report.view.surfaces.iter().map(|surface| report.map_from_robot * surface.segment).collect();
    let pair = report
        .reference_target()
        .and_then(|best| Some((mind.mfis().get(best.known)?, *segments.get(best.seen)?)));
    scene.changing.push(Item::new(Role::SeenNow, Shape::Segments(segments)));
    scene.explain(Sample::Line(Role::SeenNow), "seen now");
    if let Some((known, seen)) = pair {
        scene.changing.extend([
            Item::new(Role::ReferenceKnown, Shape::Segments(vec![mind.mfis().in_map(known)])),
            Item::new(Role::ReferenceSeen, Shape::Segments(vec![seen])),
            Item::new(Role::ReferenceSeen, Shape::Signs(vec![seen.a, seen.b])),
        ]);
        scene.explain(Sample::Line(Role::ReferenceKnown), "reference, known");
        scene.explain(Sample::Line(Role::ReferenceSeen), "reference, seen");
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use cogmap_simulation::{Command, Robot, SessionRecord, World};

    fn session() -> Session {
        let world: World = serde_json::from_str(
            r#"{"format": "cogmap-world/1", "name": "Cell", "start": {"position": [1, 2], "heading_deg": 30},
                "walls": [[[0, 0], [6, 0], [6, 4], [0, 4], [0, 0]]],
                "boxes": [{"center": [4.5, 3], "size": [0.6, 0.4]}]}"#,
        )
        .unwrap();
        let source = Source::world(world, Robot::named("perfect").unwrap());
        let mapper = MapperSetup::named("perceptual").unwrap();
        let mut session = Session::drive(SessionRecord::new(source, vec![mapper], 1)).unwrap();
        for turn in [-0.5, 0.2, 0.6] {
            session.command(Command::Step { turn, travel: 0.7 });
            while session.advance() && !session.at_rest() {}
        }
        session
    }

    fn of(scene: &Scene, role: Role) -> Vec<Segment> {
        let items = scene.still.iter().chain(&scene.changing).filter(|item| item.role == role);
        let segments = items.filter_map(|item| match &item.shape {
            Shape::Segments(segments) => Some(segments.clone()),
            _ => None,
        });
        segments.flatten().collect()
    }

    #[test]
    fn every_stored_surface_is_drawn_once_in_the_colour_of_its_view() {
        let session = session();
        let scene = memory_scene(&session, 0, MemoryOptions::default());
        let stored = session.mappers()[0].mfis().surfaces();
        assert!(stored.len() > 4);
        for surface in stored {
            let roles = [Role::SurfaceOfView(surface.step), Role::DebrisOfView(surface.step)];
            let drawn = roles.map(|role| of(&scene, role)).concat();
            assert_eq!(drawn.iter().filter(|drawn| **drawn == surface.segment).count(), 1);
        }
    }

    #[test]
    fn a_mapper_that_is_not_there_has_nothing_in_mind() {
        assert_eq!(memory_scene(&session(), 1, MemoryOptions::default()), Scene::default());
    }

    #[test]
    fn the_reference_is_drawn_as_known_and_as_seen() {
        let session = session();
        let report = session.journal().mappers[0].reports.last().unwrap();
        assert_eq!(report.placement, Placement::Reference);
        let scene = memory_scene(&session, 0, MemoryOptions::default());
        let known = session.mappers()[0].mfis().get(report.references[0].known).unwrap();
        assert_eq!(of(&scene, Role::ReferenceKnown), [known.segment]);
        let seen = of(&scene, Role::ReferenceSeen)[0];
        assert!(known.segment.distance_to(seen.midpoint()) < 0.05);
    }
}
