//! Building a network of ASRs (§3.2.2): local spaces, and the exits that join them.
//!
//! [`Places`] follows the robot through the map that a mapper builds and shares it out among spaces. It
//! reads the memory and never writes to it: closing a loop changes the network, not the map.

mod asr;
mod closing;
mod discovery;
mod exit;
mod hypothesis;
mod nearby;
mod network;
mod outline;
mod overlap;
mod passage;
mod recognition;
mod shape;
mod sharing;
mod sight;
mod trail;
mod visits;
mod wideness;

use std::collections::BTreeMap;

use cogmap_geometry::{DVec2, Pose};
use serde::{Deserialize, Serialize};

pub use asr::{Asr, AsrId};
use closing::{Homecoming, Newcomer};
use discovery::Pending;
pub use exit::{Crossing, Exit, ExitId};
pub use hypothesis::{Gaps, Hypothesis};
use nearby::Nearby;
pub use network::Network;
pub use outline::outline;
pub use overlap::Overlap;
pub use passage::Narrowness;
pub use recognition::Familiarity;
use recognition::Sightings;
use trail::{Sample, Trail};
use wideness::Chord;
pub use wideness::{Looking, Wideness};

use crate::{Event, PathPoint, StepReport, memory::Memory};

/// How exits and loops are found.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Form {
    /// As the thesis programs it (§3.2.2, §3.2.3): left and right, a minimum, loops by overlap alone.
    #[default]
    Literal,
    /// Ours: the narrowest chord, walls beside it, loops by what is recognised.
    Recommended,
}

/// Every parameter of the network of ASRs.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct PlacesParams {
    /// How exits and loops are found.
    pub form: Form,
    /// How wideness is measured.
    pub looking: Looking,
    /// What makes a minimum of wideness an exit.
    pub narrowness: Narrowness,
    /// When a new space is an old one by where it lies (`literal`).
    pub overlap: Overlap,
    /// When a new space is an old one by what is seen in it (`recommended`).
    pub familiarity: Familiarity,
    /// Which gaps seen ahead may be exits (`recommended`).
    pub gaps: Gaps,
}

impl PlacesParams {
    /// The thesis's form, which is the default.
    #[must_use]
    pub fn literal() -> Self {
        Self::default()
    }

    /// Our form.
    #[must_use]
    pub fn recommended() -> Self {
        Self { form: Form::Recommended, narrowness: Narrowness::with_jambs(), ..Self::default() }
    }
}

/// What one view brought to the network.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct PlaceReport {
    /// The space in which the robot believes to be.
    pub asr: AsrId,
    /// How wide it was on the way since the last view, in order.
    pub wideness: Vec<Wideness>,
    /// What changed in the network, in order: [`Event::Exit`], [`Event::NewAsr`], [`Event::LoopClosed`].
    pub events: Vec<Event>,
}

/// The robot's sense of place: watches how wide it is along the way, and keeps the network.
#[derive(Clone, Debug, PartialEq)]
pub struct Places {
    params: PlacesParams,
    network: Network,
    trail: Trail,
    nearby: Nearby,
    sightings: Sightings,
    /// Exits are looked for on the way after this, metres.
    since: f64,
    pending: Option<Pending>,
    newcomer: Option<Newcomer>,
    homecoming: Option<Homecoming>,
    /// Metres of way when the robot was last in each space.
    last_in: BTreeMap<AsrId, f64>,
}

/// A view that is being taken in: where the robot is, and what the mapper made of it.
#[derive(Clone, Copy)]
struct Now<'a> {
    here: PathPoint,
    report: &'a StepReport,
    memory: &'a Memory,
}

impl Places {
    /// One space without exits, in which the robot begins.
    #[must_use]
    pub fn new(params: &PlacesParams) -> Self {
        Self {
            params: *params,
            network: Network::default(),
            trail: Trail::default(),
            nearby: Nearby::default(),
            sightings: Sightings::default(),
            since: 0.0,
            pending: None,
            newcomer: None,
            homecoming: None,
            last_in: BTreeMap::new(),
        }
    }

    /// The spaces and exits found so far.
    #[must_use]
    pub fn network(&self) -> &Network {
        &self.network
    }

    /// Takes in a view that the mapper has integrated.
    pub(crate) fn follow(&mut self, report: &StepReport, memory: &Memory) -> PlaceReport {
        let (mut wideness, mut events) = (Vec::new(), Vec::new());
        if let Some(&here) = memory.path().last() {
            let now = Now { here, report, memory };
            self.look_around(now);
            // §3.2.2: the robot keeps a measure of wideness as it travels …
            wideness = self.walk(now);
            // … every surface belongs to a space …
            self.share_out(now);
            if self.params.form == Form::Recommended {
                self.look_ahead(now);
            }
            // … and behind an exit begins another, unless it is one that the robot knows.
            events.extend(self.go_through_known(now));
            events.extend(self.go_through_new(now));
            events.extend(self.compare_newcomer(now));
            events.extend(self.compare_after_recognition(now));
            self.last_in.insert(self.network.current(), self.trail.way());
        }
        PlaceReport { asr: self.network.current(), wideness, events }
    }

    /// Brings the recent way and what is remembered around it into the robot's frame.
    fn look_around(&mut self, now: Now<'_>) {
        let Now { here, report, memory } = now;
        let left = self.trail.frame();
        let PlacesParams { looking, narrowness, gaps, .. } = &self.params;
        // As far as surfaces bound a space, known exits can be gone through, and gaps are looked at.
        let radius = looking.range.max(narrowness.memory()).max(gaps.range + gaps.same);
        let known = (memory.mfis(), &self.network);
        self.nearby.update(known, (here.frame, here.frame_from_robot.position), &report.placed, radius);
        if left != here.frame {
            self.trail.carry(here.frame, self.nearby.here_from(left));
            if let (Some(pending), Some(here_from_left)) = (&mut self.pending, self.nearby.here_from(left)) {
                pending.at = here_from_left * pending.at;
            }
        }
        self.sightings.note(report);
        self.network.note_view(memory.mfis().place_of(&here).position);
    }

    /// Measures the way since the last view.
    fn walk(&mut self, now: Now<'_>) -> Vec<Wideness> {
        let PlacesParams { form, looking, narrowness, .. } = self.params;
        let Now { here, memory, .. } = now;
        let map_from_here = memory.mfis().map_from_frame(here.frame);
        let view = here.step.saturating_sub(1);
        let mut wideness = Vec::new();
        for stride in self.trail.go_to(here.frame_from_robot.position) {
            let near = self.nearby.surfaces();
            let trail::Stride { way, at, direction } = stride;
            let mut chord = wideness::chord_at(at, direction, near, form, &looking);
            let mut jambs = 0;
            if chord.width <= 1.5 * narrowness.max_width {
                if form == Form::Recommended {
                    chord = Chord::between(passage::narrowest_near(chord.segment, at, near, looking.debris));
                }
                jambs = passage::jambs_of(chord.segment, near);
            }
            self.watch_known_exits(at - direction * trail::SPACING, at, view);
            self.trail.add(Sample { way, at, direction, view, chord, jambs }, narrowness.memory());
            wideness.push(Wideness { way, width: chord.width, chord: map_from_here * chord.segment });
        }
        wideness
    }

    /// Where the robot was when it took a view, in the frame that it is in now.
    fn here_from_robot_at(&self, memory: &Memory, view: usize) -> Option<Pose> {
        let point = memory.path().get(view)?;
        Some(self.nearby.here_from(point.frame)? * point.frame_from_robot)
    }

    fn robot(now: Now<'_>) -> DVec2 {
        now.here.frame_from_robot.position
    }
}
