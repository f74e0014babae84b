//! Finding home around a corner (§3.3.5).

use cogmap_geometry::{DVec2, Pose, Segment};
use cogmap_navigation::{Act, FaithfulParams, Mode};
use cogmap_scene::{Annotation, HomingMark, Item, Role, Sample, Shape};
use cogmap_simulation::World;

use super::{
    Drawing, Runs,
    draw::{lines, role, word},
    mind::{FORGOTTEN, Frame, Show, TRUSTED, mind_of, over_the_world, panel, source},
    outings::CORNER,
    runs::Run,
};

const OFFICE: Frame = Frame::of([-0.2, -0.2], [8.2, 7.6]);

/// Where the robot was told to go home, in the map laid over the world at the beginning.
pub(super) fn turning_point(run: &Run) -> Option<DVec2> {
    let scans = run.session.journal().homings.first()?.scans;
    let believed = run.session.journal().mappers.first()?.estimate.get(scans.checked_sub(1)?)?;
    Some(run.world_from_map() * believed.pose.position)
}

/// The sign and the words where the robot was told to go home.
pub(super) fn go_home(run: &Run, aside: DVec2) -> Vec<Item> {
    let Some(at) = turning_point(run) else { return Vec::new() };
    vec![Item::new(role(Annotation::Mark), Shape::Signs(vec![at])), word(at + aside, "Go Home")]
}

/// Fig. 3.35.
pub(super) fn there_and_back(runs: &mut Runs) -> Result<Drawing, String> {
    let run = runs.of(&CORNER)?.homeward(FaithfulParams::default(), |_, _| false);
    let way = run.session.way_home().ok_or("the robot did not go home")?;
    let by_route = way.decisions.iter().filter(|decision| decision.mode == Mode::Route).count();
    let turned: f64 = way.decisions.iter().map(|decision| turn(decision.act)).sum();
    let mut scene = mind_of(&run, Show::Journey);
    scene.changing.extend(go_home(&run, DVec2::new(0.0, 0.45)));
    Ok(Drawing {
        panels: vec![panel("", scene, OFFICE, &[])],
        columns: 1,
        outcome: format!(
            "Here {:.1} m out and {:.1} m home; {} of {} decisions follow the known route. The thesis’s robot zigzags \
             at the start; ours looks before it moves, so that it turns to and fro instead, by {:.0}° in all.",
            way.way_out,
            way.way_home,
            if by_route == 0 { "none".to_owned() } else { by_route.to_string() },
            way.decisions.len(),
            turned.to_degrees(),
        ),
        source: source(&run),
    })
}

fn turn(act: Act) -> f64 {
    match act {
        Act::Step { turn, .. } => turn.abs(),
        Act::Arrived | Act::Stuck => 0.0,
    }
}

/// Walls are looked at in pieces of this length, metres.
const PIECE: f64 = 0.05;
/// What the laser sees ahead: half a circle of this radius, metres.
const RANGE: f64 = 8.0;

/// The pieces of the world's walls that stand free and that no view of the robot shows.
fn unseen(run: &Run) -> Result<Vec<Segment>, String> {
    let world = run.session.world().ok_or("a log has no truth")?;
    let solids = &run.session.solids().ok_or("a log has no truth")?.segments;
    let (_, journal) = run.mind(CORNER.mappers[0])?;
    let places: Vec<Pose> = journal.reports.iter().step_by(3).map(|report| run.truth_of(report)).collect();
    let pieces = solids.iter().flat_map(|solid| {
        let pieces = (solid.length() / PIECE).ceil().max(1.0);
        (0..pieces as u32).map(move |k| {
            let at = |k: f64| solid.a.lerp(solid.b, k / pieces);
            Segment::new(at(f64::from(k)), at(f64::from(k) + 1.0))
        })
    });
    let hidden = |piece: &Segment| {
        stands_free(world, *piece) && !places.iter().any(|place| sees(*place, piece.midpoint(), solids))
    };
    Ok(pieces.filter(hidden).collect())
}

/// Whether there is floor on one side of a piece of wall.
fn stands_free(world: &World, piece: Segment) -> bool {
    let aside = piece.direction().unwrap_or(DVec2::X).perp() * PIECE;
    let inside = |point: DVec2, outline: &[[f64; 2]]| {
        let edges = outline.iter().zip(outline.iter().cycle().skip(1));
        edges
            .map(|(a, b)| Segment::new((*a).into(), (*b).into()))
            .all(|edge| edge.offset_of(point) >= Some(0.0))
    };
    [aside, -aside].into_iter().any(|aside| {
        let point = piece.midpoint() + aside;
        let in_room = world.rooms.iter().any(|room| inside(point, &room.outline));
        in_room && !world.boxes.iter().any(|carton| carton.contains(point))
    })
}

/// Whether a robot sees a point of a wall: it lies ahead, and nothing stands between.
fn sees(world_from_robot: Pose, point: DVec2, solids: &[Segment]) -> bool {
    let ahead = world_from_robot.inverse() * point;
    let sight = Segment::new(world_from_robot.position, world_from_robot.position.lerp(point, 0.99));
    ahead.x > 0.0 && ahead.length() < RANGE && solids.iter().all(|solid| solid.crossing(sight).is_none())
}

const WAY_HOME: Role = Role::Homing(HomingMark::WayHome);
const UNSEEN: Sample = Sample::Line(role(Annotation::Flaw));

/// Fig. 3.36.
pub(super) fn what_was_seen(runs: &mut Runs) -> Result<Drawing, String> {
    let run = runs.of(&CORNER)?.homeward(FaithfulParams::default(), |_, _| true);
    let unseen = unseen(&run)?;
    let length: f64 = unseen.iter().map(|piece| piece.length()).sum();
    let mut scene = mind_of(&run, Show::Journey);
    scene.still.retain(|item| item.role != WAY_HOME);
    scene.changing.retain(|item| item.role != WAY_HOME);
    scene.changing.extend(go_home(&run, DVec2::new(0.0, 0.45)));
    scene.still.iter_mut().filter(|item| item.role == FORGOTTEN).for_each(|item| item.role = TRUSTED);
    scene.still.push(lines(role(Annotation::Flaw), unseen));
    Ok(Drawing {
        panels: vec![panel("", scene, OFFICE, &[(UNSEEN, "never seen")])],
        columns: 1,
        outcome: format!("Here it has not seen {length:.0} m of what stands there."),
        source: source(&run),
    })
}

/// Fig. 3.37.
pub(super) fn false_opening(runs: &mut Runs) -> Result<Drawing, String> {
    let out = runs.of(&CORNER)?;
    let first = out.homeward(FaithfulParams::default(), |_, _| true);
    let moves = |act: Act| matches!(act, Act::Step { travel, .. } if travel > 0.0);
    let then = out.homeward(FaithfulParams::default(), |_, decision| moves(decision.act));
    let unseen = unseen(&first)?;
    let mut panels = Vec::new();
    for (run, heading) in [(&first, "The first decision"), (&then, "Once it has turned and looked")] {
        let mut scene = over_the_world(run, mind_of(run, Show::Decision));
        if std::ptr::eq(run, &first) {
            scene.still.push(lines(role(Annotation::Flaw), unseen.iter().copied()));
        }
        let frame = Frame { columns: 2, ..OFFICE };
        panels.push(panel(heading, scene, frame, &[(UNSEEN, "never seen until then")]));
    }
    let looks = then.session.journal().decisions.len() - 1;
    Ok(Drawing {
        panels,
        columns: 2,
        outcome: format!(
            "Here it turned and looked {looks} times before it moved; the thesis’s robot turns and travels in one \
             and takes a step toward the wall first."
        ),
        source: source(&then),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_robot_sees_what_lies_ahead_and_is_hidden_by_nothing() {
        let screen = [Segment::new(DVec2::new(2.0, -1.0), DVec2::new(2.0, 1.0))];
        let sees = |x: f64, y: f64| sees(Pose::IDENTITY, DVec2::new(x, y), &screen);
        assert!(sees(1.0, 0.0) && sees(3.0, 4.0) && sees(2.0, 0.5), "the screen itself too");
        assert!(!sees(3.0, 0.5), "behind the screen");
        assert!(!sees(-1.0, 0.0), "behind the robot");
        assert!(!sees(7.0, 6.0), "too far");
    }
}
