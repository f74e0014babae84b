//! Using the MFIS while travelling (§3.3.3).

use cogmap_geometry::{DVec2, Segment, trig};
use cogmap_mapping::memory::SurfaceId;
use cogmap_navigation::{FaithfulParams, ForgettingParams, HomingEvent, Mode};
use cogmap_scene::{Annotation, Item, Sample};
use cogmap_simulation::Session;

use super::{
    Drawing, Runs,
    draw::{ROBOT, arc, arrow, lines, role},
    mind::{FORGOTTEN, Frame, Show, mind_of, open, over_the_world, panel, source, world_from_belief},
    outings::{BAY, BENT_HALLS},
    runs::Run,
};

/// Beside the bay the robot is looked at where it has come so far to the right, metres …
const FROM: f64 = 9.0;
/// … and so far.
const TO: f64 = 15.0;

/// The middle of the bay, and half its width with its walls, metres.
const MIDDLE: f64 = 6.5;
const WIDE: f64 = 1.4;

fn trusted(session: &Session) -> Vec<SurfaceId> {
    let homing = session.homing().and_then(|pilot| pilot.homing());
    let (Some(homing), Some(mind)) = (homing, session.mappers().first()) else { return Vec::new() };
    mind.mfis().remembered().map(|surface| surface.id).filter(|&id| homing.trusts(id)).collect()
}

/// Fig. 3.29.
pub(super) fn on_the_way(runs: &mut Runs) -> Result<Drawing, String> {
    let out = runs.of(&BAY)?;
    let beside = |y: f64| (y - MIDDLE).abs() > WIDE;
    let beyond = |session: &Session, x: f64| {
        session.world_from_robot().is_some_and(|robot| robot.position.x > x && beside(robot.position.y))
    };
    let [before, after] =
        [FROM, TO].map(|x| out.homeward(FaithfulParams::default(), |session, _| beyond(session, x)));
    let (kept, known) = (trusted(&after.session), trusted(&before.session));
    let gone: Vec<SurfaceId> = known.into_iter().filter(|id| !kept.contains(id)).collect();
    let mfis = after.session.mappers().first().ok_or("there is no map")?.mfis();
    let gone_lines: Vec<Segment> =
        gone.iter().filter_map(|&id| Some(world_from_belief(&after) * mfis.in_map(mfis.get(id)?))).collect();
    let frame = Frame { rows: 2, ..Frame::of([-0.2, 3.1], [25.4, 13.5]) };
    let mut later = mind_of(&after, Show::Trust);
    later.still.push(lines(role(Annotation::Added), gone_lines));
    let scenes =
        [(mind_of(&before, Show::Trust), "Beside the bay"), (later, "Six metres farther to the right")];
    let more = [
        (Sample::Line(role(Annotation::Added)), "forgotten in between"),
        (Sample::Line(role(Annotation::Ring)), "5 m around the robot"),
    ];
    let limit = ForgettingParams::default().distance;
    let mut panels = Vec::new();
    for (run, (mut scene, heading)) in [&before, &after].into_iter().zip(scenes) {
        let robot = run.session.world_from_robot().ok_or("a log has no truth")?.position;
        let quarter = |k: f64| arc(robot, limit, k * trig::FRAC_PI_2, (k + 1.0) * trig::FRAC_PI_2);
        let ring = [0.0, 1.0, 2.0, 3.0].map(|k| Item::new(role(Annotation::Ring), quarter(k)));
        scene.still.extend(ring);
        panels.push(panel(heading, scene, frame, &more));
    }
    Ok(Drawing {
        panels,
        columns: 1,
        outcome: format!("Here {} surfaces go in between.", gone.len()),
        source: source(&after),
    })
}

/// How many seeds are tried for a run that gets stuck.
const SEEDS: u64 = 9;
/// A surface that lies farther than this from the wall that it was seen on is wrong, metres.
const WRONG: f64 = 0.15;

/// The robot where the sense of direction finds no way on, before the remembered route helps.
pub(super) fn stuck(out: &Run) -> Option<Run> {
    let gives_up = |event: &HomingEvent| matches!(event, HomingEvent::FailsafeOn { .. });
    let run = out.homeward(FaithfulParams::default(), |_, decision| {
        open(decision) == 0 && decision.events.iter().any(gives_up)
    });
    let last = run.session.journal().decisions.last()?;
    (last.mode == Mode::Route && open(last) == 0).then_some(run)
}

/// Fig. 3.30.
pub(super) fn by_a_wrong_surface(runs: &mut Runs) -> Result<Drawing, String> {
    let seeds = (0..SEEDS).map(|more| runs.seed().wrapping_add(more));
    for seed in seeds {
        let out = Runs::new(seed).of(&BENT_HALLS)?;
        let drawing = stuck(&out).and_then(|run| Trap::of(&run)?.drawn(&run, runs.seed()));
        if let Some(drawing) = drawing {
            return Ok(drawing);
        }
    }
    let run = runs.of(&BENT_HALLS)?.homeward(FaithfulParams::default(), |_, _| false);
    Ok(Drawing {
        panels: vec![panel("", mind_of(&run, Show::Journey), HALLS, &[])],
        columns: 1,
        outcome: format!("In this run and with {} more seeds it does not happen.", SEEDS - 1),
        source: bent_source(&run),
    })
}

/// The three halls, and what the map of the thesis's program shows around them.
const HALLS: Frame = Frame::of([-0.5, -0.5], [14.5, 12.2]);

fn bent_source(run: &Run) -> String {
    format!("the strategy faithful on the map of perceptual, {}", run.words())
}

/// What the robot goes by where it finds no way on, as it lies in the world.
struct Trap {
    robot: DVec2,
    home: DVec2,
    right: Vec<Segment>,
    /// What lies off the wall that it was seen on.
    wrong: Vec<Segment>,
    /// The world's walls.
    walls: Vec<Segment>,
    /// By how much at most, metres.
    off: f64,
}

impl Trap {
    fn of(run: &Run) -> Option<Self> {
        let session = &run.session;
        let (mfis, journal) = (session.mappers().first()?.mfis(), session.journal().mappers.first()?);
        let (solids, trusted, world_from_map) = (session.solids()?, trusted(session), world_from_belief(run));
        let robot = session.world_from_robot()?.position;
        let home = world_from_map * mfis.place_of(session.mappers().first()?.path().first()?).position;
        let mut trap = Self {
            robot,
            home,
            right: Vec::new(),
            wrong: Vec::new(),
            walls: solids.segments.clone(),
            off: 0.0,
        };
        for (surface, wall) in mfis.surfaces().iter().zip(&journal.true_walls) {
            let line = world_from_map * mfis.in_map(surface);
            let wall = wall.and_then(|wall| solids.segments.get(wall as usize));
            let off = wall.map_or(0.0, |wall| wall.distance_to(line.midpoint()));
            if !trusted.contains(&surface.id) {
                continue;
            }
            if off > WRONG {
                trap.wrong.push(line);
                trap.off = trap.off.max(off);
            } else {
                trap.right.push(line);
            }
        }
        Some(trap)
    }

    /// Where the shortest way home over one bend bends that is free in the world and that the wrong surfaces
    /// alone close; `None` where it would be a detour.
    fn closed(&self) -> Option<DVec2> {
        let bends = (0..BEARINGS).flat_map(|k| {
            let (sin, cos) = trig::sin_cos(f64::from(k) * trig::TAU / f64::from(BEARINGS));
            (1..=REACH).map(move |s| self.robot + DVec2::new(cos, sin) * (0.5 * f64::from(s)))
        });
        let way = |bend: DVec2| {
            let ahead = (bend - self.robot).normalize_or_zero() * ROBOT;
            [Segment::new(self.robot + ahead, bend), Segment::new(bend, self.home)]
        };
        let free = |bend: DVec2, surfaces: &[Segment]| {
            way(bend).into_iter().all(|leg| surfaces.iter().all(|surface| between(leg, *surface) > ROBOT))
        };
        let length = |bend: &DVec2| self.robot.distance(*bend) + bend.distance(self.home);
        let closed = bends
            .filter(|bend| length(bend) < DETOUR * self.robot.distance(self.home))
            .filter(|&bend| free(bend, &self.walls) && free(bend, &self.right) && !free(bend, &self.wrong));
        closed.min_by(|one, other| length(one).total_cmp(&length(other)))
    }

    /// `None` where it is not the wrong surfaces that close the way.
    fn drawn(&self, run: &Run, first: u64) -> Option<Drawing> {
        let mut scene = over_the_world(run, mind_of(run, Show::Trust));
        scene.still.retain(|item| item.role != FORGOTTEN);
        scene.still.push(lines(role(Annotation::Flaw), self.wrong.iter().copied()));
        let bend = self.closed()?;
        let end = self.home - (self.home - bend).normalize_or_zero() * HOUSE;
        scene.changing.insert(0, arrow(Annotation::Movement, &[self.robot, bend, end]));
        let more = [
            (Sample::Line(role(Annotation::Flaw)), "remembered in the wrong place"),
            (Sample::Arrow(role(Annotation::Movement)), "the way that they close"),
        ];
        Some(Drawing {
            panels: vec![panel("", scene, HALLS, &more)],
            columns: 1,
            outcome: format!(
                "In this run, of the seeds from {first} on the first that shows it, surfaces up to {:.1} m off their \
                 walls close a way that is open in the world, and no option is left.",
                self.off
            ),
            source: bent_source(run),
        })
    }
}

/// A way is a detour where it is so much longer than the straight line.
const DETOUR: f64 = 1.2;
/// The way ends so far before the middle of the house that its head can be seen, metres.
const HOUSE: f64 = 0.45;
/// Directions in which a way is looked for.
const BEARINGS: u32 = 90;
/// Half metres to the farthest bend.
const REACH: u32 = 16;

/// Metres between two lines.
fn between(a: Segment, b: Segment) -> f64 {
    if a.crossing(b).is_some() {
        return 0.0;
    }
    let ends = [a.distance_to(b.a), a.distance_to(b.b), b.distance_to(a.a), b.distance_to(a.b)];
    ends.into_iter().fold(f64::INFINITY, f64::min)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn wall(a: [f64; 2], b: [f64; 2]) -> Segment {
        Segment::new(a.into(), b.into())
    }

    #[test]
    fn a_way_is_closed_by_the_wrong_surface_only() {
        let (low, high) = (wall([3.0, -9.0], [3.0, -0.5]), wall([3.0, 0.5], [3.0, 9.0]));
        let across = wall([3.1, -0.6], [3.1, 0.6]);
        let (robot, home) = (DVec2::ZERO, DVec2::new(6.0, 0.0));
        let trap = |right: &[Segment], wrong: &[Segment], walls: &[Segment]| Trap {
            robot,
            home,
            right: right.to_vec(),
            wrong: wrong.to_vec(),
            walls: walls.to_vec(),
            off: 0.0,
        };
        let sides = [low, high];
        let bend = trap(&sides, &[across], &sides).closed().unwrap();
        assert!(bend.y.abs() < 0.1, "straight through the gap, not over {bend}");
        assert_eq!(trap(&sides, &[], &sides).closed(), None, "nothing is wrong");
        assert_eq!(trap(&sides, &[across], &[low, high, across]).closed(), None, "it is closed in the world");
    }

    #[test]
    fn lines_that_cross_touch() {
        let level = wall([0.0, 0.0], [4.0, 0.0]);
        assert_eq!(between(level, wall([1.0, -1.0], [1.0, 1.0])), 0.0);
        assert_eq!(between(level, wall([1.0, 0.5], [1.0, 1.0])), 0.5);
        assert_eq!(between(level, wall([7.0, 4.0], [9.0, 9.0])), 5.0);
    }
}
