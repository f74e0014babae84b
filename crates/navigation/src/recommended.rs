//! Our way home, which is not the thesis's: it keeps the idea (trust what was seen lately, guess
//! optimistically beyond it, remember the way you came) but plans through remembered and assumed
//! free space, where the thesis looks to the next corner only (§3.3.2).

mod floor;
mod footing;
mod ground;
mod params;
mod rescue;
mod search;
mod sight;
mod survey;
mod tiles;

use cogmap_geometry::{DVec2, Pose, trig::FRAC_PI_4};
use cogmap_mapping::{Mapper, Sentence, perception::Reading, say};

use crate::{
    Anchored, Atlas, Belief, HomingEvent, steering,
    strategy::{Proposal, Situation, Wish},
};
use footing::Ease;
pub use footing::Footing;
use ground::Ground;
pub use params::RecommendedParams;
pub use rescue::RescueParams;
use rescue::{Lead, Rescue};
use search::{Search, Way};
use survey::Survey;
use tiles::Cell;

/// A way has become no worse while it costs no more than this above what was expected.
const RISE: f64 = 0.3;

/// So far aside of its way the robot goes where the way is tight, radians.
const ASIDE: f64 = FRAC_PI_4;

/// Where something too tight for the robot is noted, ahead of its middle, metres.
const TIGHT: f64 = 0.4;

/// Plans the way home anew at every decision, through what is remembered and what is assumed to be free.
#[derive(Clone, Debug)]
pub(crate) struct Recommended {
    params: RecommendedParams,
    ground: Ground,
    /// Decisions so far.
    moment: u16,
    /// The corners of the way that the robot has in mind, on the floor.
    way: Vec<DVec2>,
    /// What that way cost at the last decision, and for how many decisions it has cost no more.
    expected: f64,
    since_search: u32,
    rescue: Rescue,
    dropped: usize,
    /// Ways that the robot had in mind and that turned out closed.
    closed_ways: u32,
}

/// What a decision is about, on the floor.
struct Scene {
    floor_from_here: Pose,
    robot: DVec2,
    home: DVec2,
}

/// A way that was chosen, and what became of the one before.
struct Choice {
    way: Way,
    survey: Survey,
    /// What the way before would cost now; `None` where it is closed or there was none.
    before: Option<f64>,
    had_one: bool,
    switched: bool,
}

impl Recommended {
    pub(crate) fn new(params: &RecommendedParams, mapper: &Mapper) -> Self {
        let atlas = Atlas::of(mapper);
        let mut ground = Ground::new(atlas.here());
        ground.follow(mapper, &atlas);
        let dropped = far_surfaces(mapper, &atlas, params.footing.near);
        let rescue = Rescue::new(&params.rescue, way_out(mapper, &atlas));
        Self {
            params: params.clone(),
            ground,
            moment: 0,
            way: Vec::new(),
            expected: 0.0,
            since_search: 0,
            rescue,
            dropped,
            closed_ways: 0,
        }
    }

    /// Surfaces that are too far to be trusted at the command (§3.3.5).
    pub(crate) fn dropped(&self) -> usize {
        self.dropped
    }

    pub(crate) fn observe(&mut self, reading: &Reading, atlas: &Atlas, belief: &Belief) {
        self.ground.observe(reading, atlas, belief, self.moment);
    }

    pub(crate) fn decide(&mut self, situation: &Situation) -> Proposal {
        self.moment = self.moment.wrapping_add(1);
        if self.ground.follow(situation.mapper, situation.atlas) {
            self.way.clear();
        }
        let Some(scene) = self.scene(situation) else {
            let why = say("the robot has lost its way: nothing that it sees tells it where home is", &[]);
            return Proposal::new(Wish::GiveUp, Lead::Planning.mode(), why);
        };
        let mut events = Vec::new();
        let lead = self.rescue.lead(scene.robot, &mut events);
        if events.iter().any(|event| matches!(event, HomingEvent::FailsafeOn { .. })) {
            self.block(&scene);
        }
        if let Some(why) = self.rescue.is_spent() {
            return Proposal::new(Wish::GiveUp, lead.mode(), why);
        }
        let proposal = match self.choose(&scene) {
            Some(choice) => self.go(situation, &scene, (lead, choice), &mut events),
            None => self.rescue.no_way(situation, &mut events),
        };
        Proposal { events, ..proposal }
    }

    fn scene(&self, situation: &Situation) -> Option<Scene> {
        let floor_from_here = self.ground.floor_from_here(situation.atlas)?;
        let robot = floor_from_here * situation.belief.here_from_robot.position;
        let home = floor_from_here * situation.belief.home?.position;
        Some(Scene { floor_from_here, robot, home })
    }

    /// The cheapest way home, or the one that the robot has in mind where that is hardly dearer.
    fn choose(&mut self, scene: &Scene) -> Option<Choice> {
        let footing = self.params.footing_after(self.closed_ways);
        let ease = Ease {
            floor: self.ground.floor(),
            footing: &footing,
            trust: self.rescue.trust(),
            robot: Cell::at(scene.robot),
            moment: self.moment,
        };
        let mut search = Search::new(ease, scene.home);
        let had_one = !self.way.is_empty();
        let kept = search.pull_tight(scene.robot, &self.way);
        let before = if had_one { search.cost(scene.robot, &kept) } else { None };
        if had_one && before.is_none() {
            self.rescue.closed();
            self.closed_ways = self.closed_ways.saturating_add(1);
        }
        let as_good = before.is_some_and(|cost| cost <= self.expected + RISE);
        self.since_search = if as_good { self.since_search + 1 } else { 0 };
        let content = as_good && !self.since_search.is_multiple_of(self.params.look_for_better);
        let found = if content { None } else { found(&mut search, scene.robot, before.is_none()) };
        let worth = |cost: f64| cost + self.params.hysteresis + self.params.hysteresis_share * cost;
        let (way, switched) = match (found, before) {
            (Some(found), Some(before)) if worth(found.cost) < before => (found, true),
            (_, Some(before)) => (Way { corners: kept, cost: before }, false),
            (Some(found), None) => (found, had_one),
            (None, None) => return None,
        };
        let survey = Survey::of(&ease, scene.robot, &way.corners);
        self.way.clone_from(&way.corners);
        self.expected = way.cost;
        if survey.barrier > self.params.closed {
            self.way.clear();
            return None;
        }
        Some(Choice { way, survey, before, had_one, switched })
    }

    /// Goes along the chosen way.
    fn go(
        &mut self,
        situation: &Situation,
        scene: &Scene,
        (lead, choice): (Lead, Choice),
        events: &mut Vec<HomingEvent>,
    ) -> Proposal {
        let here_from_floor = scene.floor_from_here.inverse();
        let corners: Vec<DVec2> = choice.way.corners.iter().map(|&corner| here_from_floor * corner).collect();
        let why = why(&choice, lead);
        if choice.switched {
            let robot = situation.belief.here_from_robot.position;
            let position = situation.in_map(robot).into();
            if choice.before.is_none() {
                events.push(HomingEvent::DeadEnd { position, why: why.clone() });
            }
            let end = situation.in_map(corners.last().copied().unwrap_or(robot)).into();
            let options = 1 + usize::from(choice.before.is_some());
            events.push(HomingEvent::OptionChosen { end, options, why: why.clone() });
        }
        self.rescue.settle(choice.survey.barrier > 0);
        let mode = lead.mode();
        let near = choice.way.corners.last().is_none_or(|last| last.distance(scene.robot) < 0.15);
        if near && scene.robot.distance(scene.home) <= search::NEAR_HOME {
            let distance = scene.robot.distance(scene.home);
            let why =
                say("home itself cannot be reached: {} m is as near as the robot gets", &[(distance, 2)]);
            return Proposal::new(Wish::Arrive, mode, why);
        }
        let wish = steering::toward(situation, &corners, ASIDE).unwrap_or_else(|| {
            self.block(scene);
            Wish::GoTo(corners.first().copied().unwrap_or_default())
        });
        Proposal { way: corners, ..Proposal::new(wish, mode, why) }
    }

    /// Remembers that the robot does not fit through although it looks as if it did.
    fn block(&mut self, scene: &Scene) {
        let Some(toward) = self.way.first().and_then(|&corner| (corner - scene.robot).try_normalize()) else {
            return;
        };
        self.ground.block(scene.robot + toward * TIGHT, self.moment);
        self.way.clear();
    }
}

/// Why the robot goes along a way.
fn why(choice: &Choice, lead: Lead) -> Sentence {
    let Survey { length, unseen, barrier, .. } = choice.survey;
    let reason = match (choice.switched, choice.before) {
        (true, None) if choice.had_one => say("the way that the robot had in mind is closed", &[]),
        (true, Some(_)) => say("a shorter way has come to light", &[]),
        _ => Sentence::default(),
    };
    let (long, unseen_long) = ((length, 1), (unseen, 1));
    reason.then(match lead {
        Lead::OwnWay => say(
            "plans have got the robot nowhere, so it goes by its eyes and the way that it came alone: {} m home",
            &[long],
        ),
        Lead::Planning if barrier > 0 => say(
            "the best way home that the robot can think of is {} m long, {} m of it through places that it has not \
             seen free, and through where it saw a wall long ago, which it hopes is gone",
            &[long, unseen_long],
        ),
        Lead::Planning if unseen > 0.5 => say(
            "the best way home that the robot can think of is {} m long, {} m of it through places that it has not \
             seen but hopes to be free",
            &[long, unseen_long],
        ),
        Lead::Planning => say(
            "the best way home that the robot can think of is {} m long, all of it through places that it has seen \
             free",
            &[long],
        ),
    })
}

/// The way that a search finds, pulled tight.
fn found(search: &mut Search, robot: DVec2, wide: bool) -> Option<Way> {
    let mut points: Vec<DVec2> = search.way(wide)?.into_iter().skip(1).map(Cell::middle).collect();
    if points.is_empty() {
        points.push(robot);
    }
    let corners = search.pull_tight(robot, &points);
    Some(Way { cost: search.cost(robot, &corners)?, corners })
}

/// Metres that the robot has come since it began, as far as links lead there.
fn way_out(mapper: &Mapper, atlas: &Atlas) -> f64 {
    let keep =
        |point: &cogmap_mapping::PathPoint| Anchored { frame: point.frame, value: point.frame_from_robot };
    let places: Vec<DVec2> =
        mapper.path().iter().filter_map(|point| Some(atlas.pose(keep(point))?.position)).collect();
    places.windows(2).map(|pair| pair[0].distance(pair[1])).sum()
}

fn far_surfaces(mapper: &Mapper, atlas: &Atlas, near: f64) -> usize {
    let Some(last) = mapper.path().last() else { return 0 };
    let here = last.frame_from_robot.position;
    let far = |wall: cogmap_geometry::Segment| wall.distance_to(here) > near;
    mapper.mfis().remembered().filter(|stored| atlas.surface(stored).is_some_and(far)).count()
}
