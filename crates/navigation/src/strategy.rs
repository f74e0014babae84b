use cogmap_geometry::DVec2;
use cogmap_mapping::{Mapper, Sentence, memory::SurfaceId, perception::Reading, say};
use serde::{Deserialize, Serialize};

use crate::{
    Atlas, Belief, FaithfulParams, HomingEvent, HomingParams, Mode, MovementOption, RecommendedParams,
    RetraceParams, TangentBugParams, Vigilance, faithful::Faithful, recommended::Recommended,
    retrace::Retrace, tangent_bug::TangentBug,
};

/// Which way of finding home, with every parameter that it uses.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(tag = "strategy", rename_all = "kebab-case")]
#[allow(clippy::large_enum_variant, reason = "there is one a way home")]
pub enum StrategySetup {
    /// The thesis to the letter (§3.3).
    Faithful(FaithfulParams),
    /// Ours: plans through remembered and assumed free space.
    Recommended(RecommendedParams),
    /// Kamon, Rimon and Rivlin's bug, which remembers nothing but two distances: a baseline.
    TangentBug(TangentBugParams),
    /// The way out, backward: a baseline.
    Retrace(RetraceParams),
}

impl StrategySetup {
    /// The names that [`StrategySetup::named`] knows.
    pub const NAMES: [&'static str; 4] = ["faithful", "recommended", "retrace", "tangent-bug"];

    /// The strategy of that name with its default parameters.
    #[must_use]
    pub fn named(name: &str) -> Option<Self> {
        match name {
            "faithful" => Some(Self::Faithful(FaithfulParams::default())),
            "recommended" => Some(Self::Recommended(RecommendedParams::default())),
            "retrace" => Some(Self::Retrace(RetraceParams::default())),
            "tangent-bug" => Some(Self::TangentBug(TangentBugParams::default())),
            _ => None,
        }
    }

    /// The name under which it is chosen.
    #[must_use]
    pub fn name(&self) -> &'static str {
        match self {
            Self::Faithful(_) => "faithful",
            Self::Recommended(_) => "recommended",
            Self::Retrace(_) => "retrace",
            Self::TangentBug(_) => "tangent-bug",
        }
    }
}

/// All that a strategy may go by when it decides.
#[derive(Clone, Copy)]
pub(crate) struct Situation<'a> {
    pub(crate) belief: &'a Belief,
    pub(crate) atlas: &'a Atlas,
    pub(crate) mapper: &'a Mapper,
    pub(crate) vigilance: &'a Vigilance,
    pub(crate) params: &'a HomingParams,
}

impl Situation<'_> {
    /// How far the robot may travel straight toward a point, metres, as far as the last scans go.
    pub(crate) fn free_toward(&self, point: DVec2) -> f64 {
        let ahead = self.belief.here_from_robot.inverse() * point;
        self.vigilance.free_way(self.turn_to(point), ahead.length())
    }

    /// By how much the robot must turn to face a point, radians.
    pub(crate) fn turn_to(&self, point: DVec2) -> f64 {
        let ahead = self.belief.here_from_robot.inverse() * point;
        cogmap_geometry::trig::atan2(ahead.y, ahead.x)
    }

    /// A point of the place where the robot is, in the map.
    pub(crate) fn in_map(&self, point: DVec2) -> DVec2 {
        self.mapper.mfis().map_from_frame(self.belief.here) * point
    }
}

/// What a strategy wants; points are in the coordinates of the place where the robot is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Wish {
    /// Go straight to a point.
    GoTo(DVec2),
    /// Turn to a bearing, radians, and look.
    Face(f64),
    /// Be done.
    Arrive,
    /// Wait for the user.
    GiveUp,
}

/// A strategy's answer; [`Decision`](crate::Decision) says what the parts are.
#[derive(Clone, Debug)]
pub(crate) struct Proposal {
    pub(crate) wish: Wish,
    pub(crate) mode: Mode,
    pub(crate) options: Vec<MovementOption>,
    pub(crate) chosen: Option<usize>,
    pub(crate) way: Vec<DVec2>,
    pub(crate) waypoints: Vec<DVec2>,
    pub(crate) why: Sentence,
    pub(crate) events: Vec<HomingEvent>,
}

impl Proposal {
    pub(crate) fn new(wish: Wish, mode: Mode, why: Sentence) -> Self {
        Self {
            wish,
            mode,
            options: Vec::new(),
            chosen: None,
            way: Vec::new(),
            waypoints: Vec::new(),
            why,
            events: Vec::new(),
        }
    }

    pub(crate) fn arrived(distance: f64) -> Self {
        let why = say("home is believed to be {} m away, which is near enough to stop", &[(distance, 2)]);
        Self::new(Wish::Arrive, Mode::Direction, why)
    }
}

/// A strategy at work.
#[derive(Clone, Debug)]
pub(crate) enum Mind {
    Faithful(Box<Faithful>),
    Recommended(Box<Recommended>),
    TangentBug(TangentBug),
    Retrace(Retrace),
}

impl Mind {
    pub(crate) fn new(setup: &StrategySetup, mapper: &Mapper, atlas: &Atlas) -> Self {
        match setup {
            StrategySetup::Faithful(params) => Self::Faithful(Box::new(Faithful::new(params, mapper, atlas))),
            StrategySetup::Recommended(params) => {
                Self::Recommended(Box::new(Recommended::new(params, mapper)))
            }
            StrategySetup::TangentBug(params) => Self::TangentBug(TangentBug::new(params)),
            StrategySetup::Retrace(params) => Self::Retrace(Retrace::new(params, mapper)),
        }
    }

    /// Takes a scan in, after the mapper did.
    pub(crate) fn observe(&mut self, reading: &Reading, mapper: &Mapper, atlas: &Atlas, belief: &Belief) {
        match self {
            Self::Faithful(faithful) => faithful.observe(reading, mapper, atlas, belief),
            Self::Recommended(recommended) => recommended.observe(reading, atlas, belief),
            Self::Retrace(_) | Self::TangentBug(_) => {}
        }
    }

    pub(crate) fn decide(&mut self, situation: &Situation) -> Proposal {
        match self {
            Self::Faithful(faithful) => faithful.decide(situation),
            Self::Recommended(recommended) => recommended.decide(situation),
            Self::Retrace(retrace) => retrace.decide(situation),
            Self::TangentBug(bug) => bug.decide(situation),
        }
    }

    /// Whether it goes by a stored surface; only the thesis's way forgets single surfaces (§3.3.3).
    pub(crate) fn trusts(&self, id: SurfaceId) -> bool {
        match self {
            Self::Faithful(faithful) => faithful.trusts(id),
            Self::Recommended(_) | Self::Retrace(_) | Self::TangentBug(_) => true,
        }
    }

    /// How many stored surfaces it has stopped to trust at the command (§3.3.5).
    pub(crate) fn dropped(&self) -> usize {
        match self {
            Self::Faithful(faithful) => faithful.dropped(),
            Self::Recommended(recommended) => recommended.dropped(),
            Self::Retrace(_) | Self::TangentBug(_) => 0,
        }
    }
}
