//! Taking a shortcut, and a narrow obstacle course (§3.3.5).

use cogmap_geometry::{DVec2, Segment};
use cogmap_navigation::{Act, Decision, FaithfulParams, Mode};
use cogmap_scene::{Annotation, Bounds, Sample};
use cogmap_simulation::Session;

use super::{
    Drawing, Runs,
    corner::go_home,
    draw::{dashed, lines, ring, robot, role, word},
    forgetting::stuck,
    mind::{Frame, Show, decided, mind_of, open, panel, source},
    outings::{BENT_SHORTCUT, BOXES},
    runs::Run,
};

/// Fig. 3.38.
pub(super) fn shortcut(runs: &mut Runs) -> Result<Drawing, String> {
    let run = runs.of(&BENT_SHORTCUT)?.homeward(FaithfulParams::default(), |_, _| false);
    let way = run.session.way_home().ok_or("the robot did not go home")?;
    let truth = run.session.world_from_robot().ok_or("a log has no truth")?;
    let off = Segment::new(run.world_from_map().position, truth.position);
    let mut scene = mind_of(&run, Show::Journey);
    scene.changing.push(lines(role(Annotation::Measure), dashed(off, 0.1)));
    scene.changing.push(robot(cogmap_scene::Role::Robot, truth));
    scene.changing.extend(go_home(&run, DVec2::new(0.0, 0.6)));
    let more = [(Sample::Line(role(Annotation::Measure)), "how far from where it began")];
    Ok(Drawing {
        panels: vec![panel("", scene, Frame::of([-0.5, -0.5], [16.5, 11.1]), &more)],
        columns: 1,
        outcome: format!(
            "Here {:.0} m out and {:.1} m home. The map is not quite straight: the robot believes itself at home {:.2} m \
             from where it began; the thesis’s robot was more than a metre off.",
            way.way_out, way.way_home, way.distance
        ),
        source: format!("the strategy faithful on the map of perceptual, {}", run.words()),
    })
}

/// The part of the world that the boxes fill.
fn neck(run: &Run) -> Result<Bounds, String> {
    let world = run.session.world().ok_or("a log has no truth")?;
    let room = world.rooms.iter().find(|room| room.name == "Neck").ok_or("there is no neck")?;
    let corners = room.outline.iter().copied().map(DVec2::from);
    corners.fold(None, Bounds::around).ok_or_else(|| "the neck has no corners".to_owned())
}

/// Fig. 3.39.
pub(super) fn around_the_boxes(runs: &mut Runs) -> Result<Drawing, String> {
    let out = runs.of(&BOXES)?;
    let run = out.homeward(FaithfulParams::default(), |_, _| false);
    let mut alone = FaithfulParams::default();
    alone.failsafe.on = false;
    let without = out.homeward(alone, |_, _| false);
    let without = without.session.way_home().ok_or("the robot did not go home")?;
    let way = run.session.way_home().ok_or("the robot did not go home")?;
    let by_route = way.decisions.iter().filter(|decision| decision.mode == Mode::Route).count();
    let neck = neck(&run)?;
    let mut scene = mind_of(&run, Show::Journey);
    scene.changing.extend(go_home(&run, DVec2::new(0.0, 0.7)));
    scene.changing.push(ring(neck.center(), 0.5 * (neck.max - neck.min).length()));
    let more = [(Sample::Line(role(Annotation::Ring)), "where the remembered route helps")];
    Ok(Drawing {
        panels: vec![panel("", scene, Frame::of([-0.5, -0.5], [22.8, 9.5]), &more)],
        columns: 1,
        outcome: format!(
            "Here {:.0} m out and {:.0} m home; {by_route} of {} decisions follow the remembered route. Without it the \
             robot stops after {} decisions, {:.0} m from home.",
            way.way_out,
            way.way_home,
            way.decisions.len(),
            without.decisions.len(),
            without.distance
        ),
        source: source(&run),
    })
}

/// Among the boxes the robot is looked at where it has come so far to the left, metres.
const AMONG: f64 = 15.6;

/// Fig. 3.40.
pub(super) fn among_the_boxes(runs: &mut Runs) -> Result<Drawing, String> {
    let out = runs.of(&BOXES)?;
    let first = || out.homeward(FaithfulParams::default(), |_, _| true);
    let (alone, heading) = match stuck(&out) {
        Some(alone) => (alone, "Told to go home: no option"),
        None => (first(), "Told to go home"),
    };
    let among = |session: &Session, decision: &Decision| {
        let here = session.world_from_robot().is_some_and(|robot| robot.position.x < AMONG);
        let goes = matches!(decision.act, Act::Step { travel, .. } if travel > 0.5);
        here && goes && decision.mode == Mode::Route && open(decision) == 0
    };
    let led = out.homeward(FaithfulParams::default(), among);
    let frame = Frame { columns: 2, ..Frame::of([11.9, 2.3], [20.8, 6.8]) };
    let headings = [heading, "Among the boxes: none either, but a remembered route"];
    let scenes = [mind_of(&alone, Show::Trust), mind_of(&led, Show::Decision)];
    let count = decided(&led)?.waypoints.len();
    let panels = headings.into_iter().zip(scenes).map(|(heading, scene)| {
        let mut panel = panel(heading, scene, frame, &[]);
        panel.scene.still.push(word(DVec2::new(12.35, 4.4), "← T"));
        panel
    });
    Ok(Drawing {
        panels: panels.collect(),
        columns: 2,
        outcome: format!("The remembered route has {count} waypoints left."),
        source: source(&led),
    })
}
