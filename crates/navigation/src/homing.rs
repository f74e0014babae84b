use cogmap_geometry::{DVec2, Pose, normalize_angle, trig};
use cogmap_mapping::{Mapper, Sentence, memory::SurfaceId, perception::Reading, say};
use serde::{Deserialize, Serialize};

use crate::{
    Act, Atlas, Belief, Decision, HomingEvent, StrategySetup, Vigilance, VigilanceParams,
    deed::deed,
    strategy::{Mind, Proposal, Situation, Wish},
};

/// What every strategy shares.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct HomingParams {
    /// Home counts as reached where it is believed to be no farther than this, metres.
    pub arrived: f64,
    /// The longest stretch that is driven before the robot decides again (§3.3.2: it need not travel the
    /// whole option), metres.
    pub step_max: f64,
    /// A shorter stretch is not worth driving, metres.
    pub step_min: f64,
    /// A turn by more than this is made first, and looked at, before the robot moves on, radians.
    pub look: f64,
    /// What keeps the robot from running into what it sees.
    pub vigilance: VigilanceParams,
}

impl Default for HomingParams {
    fn default() -> Self {
        Self {
            arrived: 0.35,
            step_max: 0.8,
            step_min: 0.05,
            look: 4.0_f64.to_radians(),
            vigilance: VigilanceParams::default(),
        }
    }
}

/// Finds the way home: fed after the mapper, asked whenever the robot has come to rest.
#[derive(Clone, Debug)]
pub struct Homing {
    params: HomingParams,
    atlas: Atlas,
    vigilance: Vigilance,
    mind: Mind,
    name: &'static str,
    started: bool,
    events: Vec<HomingEvent>,
}

impl Homing {
    /// One that begins now: what the mapper remembers is the way out (§3.3.5).
    #[must_use]
    pub fn begin(setup: &StrategySetup, params: &HomingParams, mapper: &Mapper) -> Self {
        let atlas = Atlas::of(mapper);
        Self {
            params: params.clone(),
            vigilance: Vigilance::new(&params.vigilance),
            mind: Mind::new(setup, mapper, &atlas),
            atlas,
            name: setup.name(),
            started: false,
            events: Vec::new(),
        }
    }

    /// Takes in a scan that the mapper has taken in; `false` where the robot should come to a stop
    /// because something has come into its way.
    pub fn observe(&mut self, reading: &Reading, mapper: &Mapper) -> bool {
        self.vigilance.observe(reading);
        self.atlas.refresh(mapper);
        if let Some(belief) = Belief::of(mapper, &self.atlas, reading.odom_from_robot) {
            self.mind.observe(reading, mapper, &self.atlas, &belief);
        }
        self.vigilance.is_clear()
    }

    /// What to do next, at rest, when odometry stands there; `None` before the mapper's first view.
    pub fn decide(&mut self, mapper: &Mapper, odom_from_robot: Pose) -> Option<Decision> {
        self.atlas.refresh(mapper);
        let belief = Belief::of(mapper, &self.atlas, odom_from_robot)?;
        self.announce(&belief);
        let situation = Situation {
            belief: &belief,
            atlas: &self.atlas,
            mapper,
            vigilance: &self.vigilance,
            params: &self.params,
        };
        let proposal = match belief.distance_home() {
            Some(distance) if distance <= self.params.arrived => Proposal::arrived(distance),
            _ => self.mind.decide(&situation),
        };
        let (act, deed) = self.act(&belief, proposal.wish);
        if let Act::Step { travel, .. } = act {
            self.vigilance.expect(travel);
        }
        let decision = self.decision(mapper, &belief, proposal, act);
        Some(Decision { why: news(&decision).then(decision.why.clone()).then(deed), ..decision })
    }

    /// The places as they lie to the one where the robot is.
    #[must_use]
    pub fn atlas(&self) -> &Atlas {
        &self.atlas
    }

    /// Whether the robot goes by a stored surface at the moment (§3.3.3); what it does not trust stays in
    /// the map.
    #[must_use]
    pub fn trusts(&self, id: SurfaceId) -> bool {
        self.mind.trusts(id)
    }

    /// The strategy's name.
    #[must_use]
    pub fn name(&self) -> &'static str {
        self.name
    }

    fn announce(&mut self, belief: &Belief) {
        if !self.started {
            self.started = true;
            let (strategy, dropped) = (self.name.to_owned(), self.mind.dropped());
            self.events.push(HomingEvent::GoHome { strategy, distance: belief.distance_home(), dropped });
        }
    }

    /// What a wish comes to, and how that is said. A turn that is not small comes alone: what it brings
    /// into view may change the robot's mind.
    fn act(&self, belief: &Belief, wish: Wish) -> (Act, Sentence) {
        let said = |act, wanted| (act, deed(act, wanted));
        let toward = match wish {
            Wish::Arrive => return said(Act::Arrived, 0.0),
            Wish::GiveUp => return said(Act::Stuck, 0.0),
            Wish::Face(bearing) => {
                let turn = normalize_angle(bearing - belief.here_from_robot.heading);
                return said(Act::Step { turn, travel: 0.0 }, 0.0);
            }
            Wish::GoTo(point) => point,
        };
        let ahead = toward - belief.here_from_robot.position;
        let turn = normalize_angle(trig::atan2(ahead.y, ahead.x) - belief.here_from_robot.heading);
        if turn.abs() > self.params.look {
            return said(Act::Step { turn, travel: 0.0 }, 0.0);
        }
        if self.vigilance.somebody_passes() {
            return (Act::Step { turn: 0.0, travel: 0.0 }, say("somebody is walking by, so it waits", &[]));
        }
        let wanted = ahead.length().min(self.params.step_max);
        said(Act::Step { turn, travel: self.vigilance.free_way(turn, wanted) }, wanted)
    }

    fn decision(&mut self, mapper: &Mapper, belief: &Belief, proposal: Proposal, act: Act) -> Decision {
        let mut events = std::mem::take(&mut self.events);
        events.extend(proposal.events);
        match act {
            Act::Arrived => {
                events.push(HomingEvent::Home { distance: belief.distance_home().unwrap_or(0.0) });
            }
            Act::Stuck => events.push(HomingEvent::Stuck { why: proposal.why.clone() }),
            Act::Step { .. } => {}
        }
        let home = belief.home.map(|home| home.position);
        let way =
            std::iter::once(belief.here_from_robot.position).chain(proposal.way).collect::<Vec<DVec2>>();
        Decision {
            step: mapper.path().len().saturating_sub(1),
            act,
            mode: proposal.mode,
            frame: belief.here,
            home,
            options: proposal.options,
            chosen: proposal.chosen,
            way,
            waypoints: proposal.waypoints,
            why: proposal.why,
            events,
        }
    }
}

/// What has just come about and is behind a decision, as the beginning of its sentence.
fn news(decision: &Decision) -> Sentence {
    let whys = decision.events.iter().filter_map(|event| match event {
        HomingEvent::DeadEnd { why, .. }
        | HomingEvent::FailsafeOn { why }
        | HomingEvent::FailsafeOff { why } => Some(why),
        _ => None,
    });
    whys.filter(|why| !decision.why.says(why)).fold(Sentence::default(), |news, why| news.then(why.clone()))
}
