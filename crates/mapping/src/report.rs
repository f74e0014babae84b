//! What one step found out and why: everything the Why? panel, the event log and the figures need.

use cogmap_geometry::{DVec2, Pose};
use serde::{Deserialize, Serialize};

use crate::{
    Sentence,
    memory::{Along, FrameId, Match, Reference, SurfaceId},
    perception::View,
    places::{AsrId, ExitId, PlaceReport},
    traditional::Correction,
};

/// What a mapper did with one reading, in the order of §3.2.1's steps.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct StepReport {
    /// Number of the view, from 0.
    pub step: usize,
    /// When the scan was taken, seconds.
    pub t: f64,
    /// The surfaces seen, in the robot's frame.
    pub view: View,
    /// Which of them were recognised, and as what.
    pub matches: Vec<Match>,
    /// The reference target, and every other candidate behind it, best first.
    pub references: Vec<Reference>,
    /// Whether the map took in what was new; in the thesis's program it always does (§3.2.1).
    pub stored: bool,
    /// The surfaces that were new and are now in the map.
    pub placed: Vec<SurfaceId>,
    /// What placed them.
    pub placement: Placement,
    /// The direction in the map, a unit vector, in which odometry decided because no recognised surface did.
    #[serde(default)]
    pub open: Option<DVec2>,
    /// That the robot is not where it believed to be; the view is the first of a map of its own.
    #[serde(default)]
    pub lost: Option<Lost>,
    /// The place that the robot found itself back in.
    pub recalled: Option<Recalled>,
    /// How the traditional mapper corrected the measured movement.
    pub correction: Option<Correction>,
    /// What it means for the network of local spaces; `None` for the traditional mappers.
    pub place: Option<PlaceReport>,
    /// What was forgotten because the robot has moved on (§2.2.2).
    pub forgot: Vec<SurfaceId>,
    /// Where the robot is in its map.
    pub map_from_robot: Pose,
}

/// What a view was placed by.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Placement {
    /// The first view, or the first after the robot was lost: it defines a frame.
    First,
    /// A reference target; no odometry value entered the map.
    Reference,
    /// A reference whose place along its own line no true end determined (the flaw of Fig. 3.17).
    WeakReference,
    /// All recognised surfaces together.
    Consensus,
    /// The same, and odometry along directions that none of them determined.
    PartlyOdometry,
    /// The measured movement, corrected until the views fitted (§3.1.3).
    Transform,
    /// Odometry, because nothing was recognised (§3.2.3, the corridor), or because the mapper knows no better.
    Odometry,
}

/// A place known before that was found again: the robot goes on in its coordinates.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Recalled {
    /// The old place.
    pub frame: FrameId,
    /// The place whose coordinates the robot leaves.
    pub left: FrameId,
    /// Metres that the robot followed the guess before it believed it.
    pub way: f64,
}

/// The robot noticed that it was moved unseen (or lost its way altogether).
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Lost {
    /// The place where it believed to be.
    pub left: FrameId,
    /// The share of the view that fitted there.
    pub matched: f64,
    /// The share of the beams that contradicted what was seen free there just before.
    pub contradiction: f64,
}

impl Lost {
    fn why(&self) -> String {
        format!(
            "{:.0} % of what the robot sees contradicts what it had just seen, and only {:.0} % fits: it was moved unseen; what it maps from now on has no link to what was before",
            100.0 * self.contradiction,
            100.0 * self.matched
        )
    }
}

/// Something worth a line in `events.jsonl` and a mark on the timeline.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(tag = "kind", rename_all = "snake_case")]
pub enum Event {
    /// A pair became the reference target.
    Reference {
        /// Which surface of the view.
        seen: usize,
        /// Which surface of the map it was recognised as.
        known: SurfaceId,
        /// What the choice went by; higher is better.
        quality: f64,
        /// The runner-up's quality.
        next_quality: Option<f64>,
        /// Whether the place along the reference's line was a guess.
        weak: bool,
        /// One sentence for people.
        why: String,
    },
    /// New surfaces entered the map.
    Placed {
        /// Their names.
        surfaces: Vec<SurfaceId>,
    },
    /// The robot has moved on to other spaces and no longer remembers these surfaces (§2.2.2).
    Forgot {
        /// Their names, which are never given to others.
        surfaces: Vec<SurfaceId>,
    },
    /// No reference was found: this one view was placed by odometry (§3.2.3).
    Fallback {
        /// How many surfaces were recognised all the same.
        matches: usize,
        /// One sentence for people.
        why: String,
    },
    /// Odometry decided along a direction that no recognised surface determined.
    OdometryUsed {
        /// How many surfaces were recognised.
        matches: usize,
        /// The direction in the map, a unit vector; none where it is the heading, or several.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        along: Option<[f64; 2]>,
        /// One sentence for people.
        why: String,
    },
    /// The robot noticed that it is not where it believed to be.
    Lost {
        /// The place where it believed to be.
        left: FrameId,
        /// One sentence for people.
        why: String,
    },
    /// The robot found itself back in a place that it knew.
    Recognised(Recalled),
    /// An exit was crossed (§3.2.2); it is recognised only now that it lies behind the robot.
    Exit {
        /// Which.
        exit: ExitId,
        /// One sentence for people.
        why: Sentence,
    },
    /// A new local space was opened behind an exit.
    NewAsr {
        /// Which.
        asr: AsrId,
        /// The exit that led to it.
        exit: ExitId,
        /// How many surfaces were moved to it because they had been seen through the exit.
        moved: usize,
    },
    /// The robot is back in a local space that it knew; the network says so, the map stays (§3.2.3).
    LoopClosed {
        /// The space that it is back in.
        asr: AsrId,
        /// The newer space that turned out to be the same.
        #[serde(skip_serializing_if = "Option::is_none")]
        instead_of: Option<AsrId>,
        /// The exit that now leads to the known space.
        exit: ExitId,
        /// The share of the new space that lies in the old one.
        overlap: f64,
        /// One sentence for people.
        why: Sentence,
    },
}

impl StepReport {
    /// A report of a view in which nothing was recognised and nothing placed.
    #[must_use]
    pub fn new((step, t): (usize, f64), view: View, placement: Placement, map_from_robot: Pose) -> Self {
        Self {
            step,
            t,
            view,
            matches: Vec::new(),
            references: Vec::new(),
            stored: true,
            placed: Vec::new(),
            placement,
            open: None,
            lost: None,
            recalled: None,
            correction: None,
            place: None,
            forgot: Vec::new(),
            map_from_robot,
        }
    }

    /// The pair that placed the view; `None` where something else did.
    #[must_use]
    pub fn reference_target(&self) -> Option<&Reference> {
        let by_reference = matches!(self.placement, Placement::Reference | Placement::WeakReference);
        self.references.first().filter(|_| by_reference)
    }

    /// What the step amounts to in the event log, in the order of §3.2.1's steps.
    #[must_use]
    pub fn events(&self) -> Vec<Event> {
        let mut events = Vec::new();
        match (self.placement, self.references.first()) {
            (Placement::Reference | Placement::WeakReference, Some(best)) => {
                events.push(self.reference_event(best));
            }
            (Placement::Odometry, _) => {
                events.push(Event::Fallback { matches: self.matches.len(), why: self.why_fallback() });
            }
            (Placement::PartlyOdometry, _) => events.push(Event::OdometryUsed {
                matches: self.matches.len(),
                along: self.open.map(Into::into),
                why: "the recognised surfaces leave a direction open, as in a corridor".to_owned(),
            }),
            _ => {}
        }
        events.extend(self.lost.map(|lost| Event::Lost { left: lost.left, why: lost.why() }));
        if !self.placed.is_empty() {
            events.push(Event::Placed { surfaces: self.placed.clone() });
        }
        events.extend(self.recalled.map(Event::Recognised));
        events.extend(self.place.iter().flat_map(|place| place.events.clone()));
        if !self.forgot.is_empty() {
            events.push(Event::Forgot { surfaces: self.forgot.clone() });
        }
        events
    }

    fn reference_event(&self, best: &Reference) -> Event {
        let next_quality = self.references.get(1).map(|next| next.quality);
        Event::Reference {
            seen: best.seen,
            known: best.known,
            quality: best.quality,
            next_quality,
            weak: self.placement == Placement::WeakReference,
            why: self.why_reference(best),
        }
    }

    fn why_reference(&self, best: &Reference) -> String {
        let Reference { seen, known, along, .. } = best;
        let (length, range) = self.view.surfaces.get(*seen).map_or((0.0, 0.0), |s| (s.length(), s.range));
        let along = match along {
            Along::FirstEnd | Along::SecondEnd => "one of its true ends fixes the place along it".to_owned(),
            Along::Crossing(other) => format!("surface {} fixes the place along it", other.0),
            Along::GuessedEnd => "no true end fixes the place along it, so that place is a guess".to_owned(),
        };
        format!(
            "surface {}, seen {length:.2} m long at {range:.1} m, is the best of {} candidates; {along}",
            known.0,
            self.references.len()
        )
    }

    fn why_fallback(&self) -> String {
        match self.matches.len() {
            0 => "no surface of the previous view was recognised".to_owned(),
            n => format!("{n} surfaces were recognised, but none fixes where the robot is"),
        }
    }
}
