use cogmap_geometry::DVec2;
use cogmap_mapping::{Mapper, Sentence, perception::Reading, say};
use cogmap_navigation::{Act, Decision, Homing, HomingEvent, HomingParams, Mode};

use super::{
    drive::Drive,
    oracle::{self, Oracle},
};
use crate::{Command, Strategy};

/// A step that comes to rest and looks, and nothing else.
const LOOK: Command = Command::Step { turn: 0.0, travel: 0.0 };
/// A step that is smaller than this, in metres and radians, is none.
const NOTHING: f64 = 1e-3;
/// A robot that goes nowhere and turns by less than this, in radians, is held up: it waits …
const HELD_UP: f64 = 0.08;
/// … for so many ticks, half a second, before it looks again.
const WAIT: u64 = 25;
/// A run home has so many decisions …
const DECISIONS: usize = 200;
/// … and so many more for each metre of the way out, then it ends.
const DECISIONS_PER_METRE: f64 = 10.0;

/// Leads the robot home without the user (§3.3): asks the strategy whenever the robot has come to
/// rest, and has its acts carried out. What it orders is not written into the record, because the
/// same record leads to the same decisions.
#[derive(Clone, Debug)]
pub struct Pilot {
    strategy: Strategy,
    mind: Mind,
    decisions: usize,
    most: usize,
    /// The tick at which a robot that waits looks again.
    look_at: Option<u64>,
}

#[derive(Clone, Debug)]
#[allow(clippy::large_enum_variant, reason = "there is one a session")]
enum Mind {
    Robot(Homing),
    Oracle(Oracle),
}

impl Pilot {
    /// Takes over: the robot comes to rest and looks. `None` where the strategy needs a map and there is none.
    pub(super) fn begin(
        strategy: &Strategy,
        guide: Option<&Mapper>,
        way_out: f64,
        drive: &mut Drive,
    ) -> Option<Self> {
        let mind = match strategy {
            Strategy::Robot(setup) => Mind::Robot(Homing::begin(setup, &HomingParams::default(), guide?)),
            Strategy::Oracle => Mind::Oracle(Oracle::default()),
        };
        drive.obey(&LOOK);
        let most = DECISIONS + (way_out * DECISIONS_PER_METRE) as usize;
        Some(Self { strategy: strategy.clone(), mind, decisions: 0, most, look_at: None })
    }

    /// Takes in what the mapper has taken in; the robot brakes where something came into its way.
    pub(super) fn observe(&mut self, reading: &Reading, guide: Option<&Mapper>, drive: &mut Drive) {
        if let (Mind::Robot(homing), Some(guide)) = (&mut self.mind, guide)
            && !homing.observe(reading, guide)
            && drive.speed() > 0.0
        {
            drive.obey(&LOOK);
        }
    }

    /// What the robot does next, once it has come to rest; `None` where it is not time to decide.
    pub(super) fn lead(&mut self, guide: Option<&Mapper>, drive: &mut Drive) -> Option<Decision> {
        if matches!(self.mind, Mind::Oracle(_)) && oracle::has_to_brake(drive) {
            drive.obey(&LOOK);
        }
        if !drive.at_rest() || self.look_at.is_some_and(|tick| drive.tick() < tick) {
            return None;
        }
        if self.look_at.take().is_some() {
            drive.obey(&LOOK);
            return None;
        }
        let decision = self.decide(guide, drive);
        self.decisions += 1;
        if let Act::Step { turn, travel } = decision.act {
            if travel.abs() < NOTHING && turn.abs() < HELD_UP {
                self.look_at = Some(drive.tick() + WAIT);
            }
            if travel.abs() >= NOTHING || turn.abs() >= NOTHING {
                drive.obey(&Command::Step { turn, travel });
            }
        }
        Some(decision)
    }

    fn decide(&mut self, guide: Option<&Mapper>, drive: &Drive) -> Decision {
        let step = guide.map_or(0, |guide| guide.path().len().saturating_sub(1));
        if self.decisions >= self.most {
            return stuck(
                step,
                say("after {} decisions the robot is not home", &[(self.decisions as f64, 0)]),
            );
        }
        let nothing_known = || stuck(step, say("the robot has not seen anything yet", &[]));
        match &mut self.mind {
            Mind::Robot(homing) => {
                let decision = guide.and_then(|guide| homing.decide(guide, drive.odom_from_robot()));
                decision.unwrap_or_else(nothing_known)
            }
            Mind::Oracle(oracle) => oracle.decide(step, drive),
        }
    }

    /// Who finds the way.
    #[must_use]
    pub fn strategy(&self) -> &Strategy {
        &self.strategy
    }

    /// How many decisions were made since the robot was told to go home.
    #[must_use]
    pub fn decisions(&self) -> usize {
        self.decisions
    }

    /// What the robot's own program knows of the way; `None` for the oracle.
    #[must_use]
    pub fn homing(&self) -> Option<&Homing> {
        match &self.mind {
            Mind::Robot(homing) => Some(homing),
            Mind::Oracle(_) => None,
        }
    }
}

fn stuck(step: usize, why: Sentence) -> Decision {
    Decision { events: vec![HomingEvent::Stuck { why: why.clone() }], ..plain(step, Act::Stuck, why) }
}

/// A decision of which nothing can be shown on the map.
pub(super) fn plain(step: usize, act: Act, why: Sentence) -> Decision {
    Decision {
        step,
        act,
        mode: Mode::Planning,
        frame: cogmap_mapping::memory::FrameId::default(),
        home: None,
        options: Vec::new(),
        chosen: None,
        way: Vec::new(),
        waypoints: Vec::new(),
        why,
        events: Vec::new(),
    }
}

/// Metres along points.
pub(super) fn length(points: impl Iterator<Item = DVec2>) -> f64 {
    let mut last: Option<DVec2> = None;
    points.map(|point| last.replace(point).map_or(0.0, |last| last.distance(point))).sum()
}
