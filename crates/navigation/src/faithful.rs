use cogmap_geometry::{DVec2, trig};
use cogmap_mapping::{Mapper, memory::SurfaceId, perception::Reading, say};
use serde::{Deserialize, Serialize};

use crate::{
    Atlas, Belief, FailsafeParams, ForgettingParams, HomingEvent, Mode, MovementOption, OptionsParams,
    Straightest,
    dead_ends::{Closed, DeadEnds},
    direction::{straightest, why},
    failsafe::{Following, Patience},
    options::Search,
    recent::Recent,
    strategy::{Proposal, Situation, Wish},
    surroundings::Surroundings,
    trial::Trial,
};

/// What [`StrategySetup::Faithful`](crate::StrategySetup::Faithful) goes by; the defaults are the thesis's
/// words as we read them.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct FaithfulParams {
    /// What counts as an option (§3.3.2).
    pub options: OptionsParams,
    /// Which of them is the most promising.
    pub straightest: Straightest,
    /// What is still trusted (§3.3.3).
    pub forgetting: ForgettingParams,
    /// Whether options that turned out closed are remembered; without it the robot can get caught in an
    /// endless loop (Fig. 3.31–3.32).
    pub dead_ends: bool,
    /// What helps where there is no option left (§3.3.4).
    pub failsafe: FailsafeParams,
    /// Where no option is left and home is believed to be no farther than this, that is rough proximity
    /// and counts as home (§3.3.5), metres.
    pub rough_home: f64,
    /// The robot turns by no more than this before it looks, radians: views that follow each other must
    /// overlap for anything to be recognised (§2.2.2).
    pub turn_max: f64,
}

impl Default for FaithfulParams {
    fn default() -> Self {
        Self {
            options: OptionsParams::default(),
            straightest: Straightest::default(),
            forgetting: ForgettingParams::default(),
            dead_ends: true,
            failsafe: FailsafeParams::default(),
            rough_home: 1.0,
            turn_max: 60.0 * trig::PI / 180.0,
        }
    }
}

/// The thesis to the letter (§3.3): the straightest option, optimism, forgetting, and the remembered route
/// where all else fails.
#[derive(Clone, Debug)]
pub(crate) struct Faithful {
    params: FaithfulParams,
    recent: Recent,
    dead_ends: DeadEnds,
    following: Option<Following>,
    patience: Patience,
    trial: Option<Trial>,
    /// Whether it has just turned to that option and has not moved since.
    turned: bool,
    dropped: usize,
}

/// What the robot sees of its situation before it decides.
struct Outlook {
    robot: DVec2,
    home: DVec2,
    options: Vec<MovementOption>,
    chosen: Option<usize>,
    /// Decisions in a row that have led nowhere.
    worn: usize,
}

impl Faithful {
    pub(crate) fn new(params: &FaithfulParams, mapper: &Mapper, atlas: &Atlas) -> Self {
        let recent = Recent::new(&params.forgetting, mapper, atlas);
        let dropped = mapper.mfis().remembered().count() - recent.len();
        Self {
            params: params.clone(),
            recent,
            dead_ends: DeadEnds::default(),
            following: None,
            patience: Patience::default(),
            trial: None,
            turned: false,
            dropped,
        }
    }

    pub(crate) fn observe(&mut self, reading: &Reading, mapper: &Mapper, atlas: &Atlas, belief: &Belief) {
        self.recent.observe(reading, mapper, atlas, belief);
    }

    /// Whether it still trusts a stored surface.
    pub(crate) fn trusts(&self, id: SurfaceId) -> bool {
        self.recent.trusts(id)
    }

    /// How many stored surfaces the command made it forget.
    pub(crate) fn dropped(&self) -> usize {
        self.dropped
    }

    pub(crate) fn decide(&mut self, situation: &Situation) -> Proposal {
        let robot = situation.belief.here_from_robot.position;
        let Some(home) = situation.belief.home.map(|home| home.position) else {
            let why =
                say("the robot has lost the thread: nothing that it knows links this place with home", &[]);
            return Proposal::new(Wish::GiveUp, Mode::Direction, why);
        };
        let trusted = self.surroundings(situation, 0);
        self.dead_ends.look_again(self.recent.view(), situation.belief.here_from_robot, situation.atlas);
        let closed =
            self.trial.and_then(|trial| trial.closed(home, &trusted, &self.params.options, situation));
        let options = self.options(&trusted, home, situation);
        let worn = self.patience.wear(robot, situation.atlas, self.params.failsafe.nowhere);
        let outlook = Outlook { robot, home, chosen: straightest(&options), options, worn };
        let mut events =
            Vec::from_iter(closed.and_then(|closed| self.learn(closed, &outlook, &trusted, situation)));
        events.extend(self.switch(&outlook, situation));
        let mut proposal = match (&self.following, outlook.chosen) {
            (Some(_), _) => self.follow(&outlook, situation),
            (None, Some(chosen)) => self.go(&outlook, chosen, situation),
            (None, None) => give_up_or_arrive(&outlook, self.params.rough_home),
        };
        events.append(&mut proposal.events);
        self.turned = turns_to(proposal.wish, situation);
        Proposal { events, options: outlook.options, ..proposal }
    }

    fn surroundings(&self, situation: &Situation, since: usize) -> Surroundings {
        self.recent.surroundings(since, situation.mapper, situation.atlas)
    }

    fn options(
        &self,
        surroundings: &Surroundings,
        target: DVec2,
        situation: &Situation,
    ) -> Vec<MovementOption> {
        let robot = situation.belief.here_from_robot.position;
        let step = situation.params.step_max;
        let search = Search {
            params: &self.params.options,
            straightest: self.params.straightest,
            surroundings,
            robot,
            facing: self.turned.then(|| situation.belief.here_from_robot.forward()),
            watch: &|direction| {
                let free = situation.free_toward(robot + direction * step);
                (free < step - 1e-9).then_some(free)
            },
            barred: &|way| self.dead_ends.bar(way, situation.atlas),
        };
        search.toward(target)
    }

    /// An option that turned out closed so that the robot has to turn away from it is a dead end: it is
    /// remembered as tried.
    fn learn(
        &mut self,
        closed: Closed,
        outlook: &Outlook,
        trusted: &Surroundings,
        situation: &Situation,
    ) -> Option<HomingEvent> {
        let tried = closed.at - outlook.robot;
        self.trial = None;
        let goes_on = |chosen: usize| (outlook.options[chosen].end - outlook.robot).dot(tried) > 0.0;
        if outlook.chosen.is_some_and(goes_on) {
            return None;
        }
        if self.params.dead_ends {
            self.dead_ends.remember(closed, trusted, situation.atlas);
        }
        let position = situation.in_map(closed.at).into();
        let why = say("the way that seemed to lead home is closed, now that the robot sees it", &[]);
        Some(HomingEvent::DeadEnd { position, why })
    }

    /// Hands over to the remembered route and back (§3.3.4).
    fn switch(&mut self, outlook: &Outlook, situation: &Situation) -> Option<HomingEvent> {
        let params = &self.params.failsafe;
        let chosen = outlook.chosen.map(|chosen| outlook.options[chosen]);
        if let Some(following) = &self.following {
            let come = following.come(outlook.robot, situation.atlas) >= params.leave;
            let option = chosen.filter(|_| params.shortcuts && come)?;
            let homeward = (option.end - outlook.robot).dot(outlook.home - outlook.robot) > 0.0;
            return homeward.then(|| {
                self.following = None;
                self.patience.renew();
                let why = say("there is a way on toward home again, so the remembered route is left", &[]);
                HomingEvent::FailsafeOff { why }
            });
        }
        let stalled = params.patience > 0 && outlook.worn > params.patience;
        let near = outlook.home.distance(outlook.robot) <= self.params.rough_home;
        if !params.on || (near && chosen.is_none()) || (chosen.is_some() && !stalled) {
            return None;
        }
        let why = match chosen {
            None => say("no free way leads on toward home", &[]),
            Some(_) => say("the last decisions led nowhere", &[]),
        };
        self.following = Some(Following::begin(situation, params.tolerance, self.recent.scan()));
        self.patience.renew();
        self.trial = None;
        Some(HomingEvent::FailsafeOn { why })
    }

    /// Follows its sense of direction (§3.3.2).
    fn go(&mut self, outlook: &Outlook, chosen: usize, situation: &Situation) -> Proposal {
        let option = outlook.options[chosen];
        let before = self.trial.replace(Trial::of(option.end, situation));
        let choice = outlook.options.iter().filter(|option| !option.barred).count();
        let why = why(&option, choice, outlook.robot, outlook.home);
        let other = before
            .and_then(|before| before.end(situation))
            .is_none_or(|before| before.distance(option.end) > self.params.options.apart);
        let event = HomingEvent::OptionChosen {
            end: situation.in_map(option.end).into(),
            options: outlook.options.len(),
            why: why.clone(),
        };
        let mut proposal = Proposal::new(self.toward(option.end, situation), Mode::Direction, why);
        proposal.chosen = Some(chosen);
        proposal.way = vec![option.end, outlook.home];
        proposal.events.extend(other.then_some(event));
        proposal
    }

    /// Follows the remembered route, with the sense of direction from waypoint to waypoint and on a fresh
    /// scan (§3.3.4).
    fn follow(&mut self, outlook: &Outlook, situation: &Situation) -> Proposal {
        let params = &self.params.failsafe;
        let most = params.patience.max(10);
        let worn_out = outlook.worn > 2 * most;
        let Some(following) = &mut self.following else { return lost_route() };
        if outlook.worn.is_multiple_of(most / 2 + 1) {
            following.since = self.recent.scan();
        }
        let waypoints = following.waypoints(outlook.robot, situation.atlas, params.passed);
        let Some(&next) = waypoints.last() else { return lost_route() };
        let since = following.since;
        let fresh = self.surroundings(situation, since);
        let mut options = self.options(&fresh, next, situation);
        options.iter_mut().for_each(|option| option.barred = false);
        let end = straightest(&options).map_or(next, |best| options[best].end);
        let (wish, why) = if worn_out {
            (Wish::GiveUp, say("no way on, and the way that the robot came is blocked too", &[]))
        } else {
            let why = say(
                "back along the way that the robot came, until a way on toward home comes into sight: the next of \
                 {} waypoints is {} m away",
                &[(waypoints.len() as f64, 0), (outlook.robot.distance(next), 1)],
            );
            (self.toward(end, situation), why)
        };
        let way = std::iter::once(end).chain(waypoints.iter().rev().copied()).collect();
        Proposal { way, waypoints, ..Proposal::new(wish, Mode::Route, why) }
    }

    /// Goes to a point, or first looks part of the way round to it.
    fn toward(&self, point: DVec2, situation: &Situation) -> Wish {
        let turn = situation.turn_to(point);
        if turn.abs() <= self.params.turn_max {
            return Wish::GoTo(point);
        }
        Wish::Face(situation.belief.here_from_robot.heading + self.params.turn_max.copysign(turn))
    }
}

/// Whether a wish makes the robot turn to a point and look, before it goes there.
fn turns_to(wish: Wish, situation: &Situation) -> bool {
    let Wish::GoTo(point) = wish else { return false };
    situation.turn_to(point).abs() > situation.params.look
}

fn lost_route() -> Proposal {
    let why = say("no way on, and no remembered route leads home", &[]);
    Proposal::new(Wish::GiveUp, Mode::Route, why)
}

fn give_up_or_arrive(outlook: &Outlook, rough_home: f64) -> Proposal {
    let distance = outlook.home.distance(outlook.robot);
    if distance <= rough_home {
        let why = say("home is believed to be {} m away and no way leads nearer", &[(distance, 1)]);
        return Proposal::new(Wish::Arrive, Mode::Direction, why);
    }
    let why = say("no free way leads on toward home", &[]);
    Proposal::new(Wish::GiveUp, Mode::Direction, why)
}
