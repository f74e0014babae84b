use cogmap_scene::Stage;
use serde::{Deserialize, Serialize};
use tsify::Tsify;

use crate::{clause::Clause, homing::Lead, status::PlacementKind};

/// The latest step of one mapper taken apart: what it found out and why, in the order of §3.2.1.
#[derive(Clone, Debug, PartialEq, Serialize, Tsify)]
pub struct Explanation {
    /// The mapper.
    pub mapper: String,
    /// The number of the view.
    pub step: usize,
    /// When it was taken, seconds.
    pub t: f64,
    /// What happened, one after the other; what does not exist for the mapper is not among it.
    pub stages: Vec<StageReport>,
}

/// What one stage of a step came to; numbers of surfaces, spaces and exits are those of the files.
#[derive(Clone, Debug, PartialEq, Serialize, Tsify)]
#[serde(tag = "kind", rename_all = "snake_case")]
pub enum StageReport {
    /// The laser looked around.
    Scan {
        /// How many beams it has, unless it has looked again since.
        beams: Option<usize>,
    },
    /// What it saw became surfaces.
    Surfaces {
        /// How many.
        seen: usize,
        /// How many of their ends are true ends …
        true_ends: usize,
        /// … are hidden by something nearer …
        occluded: usize,
        /// … or lie where the laser's sight ends.
        at_limit: usize,
    },
    /// Some were recognised.
    Recognised {
        /// How many were seen.
        seen: usize,
        /// How many were compared with the map itself rather than with the last view.
        by_map: usize,
        /// Which, as which, and how well they fit.
        pairs: Vec<FittingPair>,
    },
    /// The measured movement was corrected until the views fitted (§3.1.3).
    Movement {
        /// Added to the turn and to the way, degrees and metres; nothing where it was taken as it was.
        corrected: Option<Corrected>,
    },
    /// A reference target was chosen.
    Reference(ReferenceReport),
    /// All recognised surfaces placed the view.
    Together {
        /// How many.
        surfaces: usize,
    },
    /// A direction was left open, where odometry decided.
    Open {
        /// The angle to the map's first axis, degrees; nothing where it is the heading, or several.
        along_deg: Option<f64>,
    },
    /// The robot noticed that it is not where it believed to be.
    Lost {
        /// The share of the view that fitted there.
        matched: f64,
        /// The share of the beams that contradicted what was seen just before.
        contradiction: f64,
    },
    /// The robot found itself in a place that it knew.
    Found {
        /// Metres that it followed the guess before it believed it.
        way: f64,
    },
    /// What was new entered the map.
    Placed {
        /// Under which numbers.
        surfaces: Vec<u32>,
        /// What placed the view.
        by: PlacementKind,
        /// The surface of the map that it was placed relative to, where it was one.
        reference: Option<u32>,
    },
    /// What did not enter the map.
    Ignored {
        /// How many were known already.
        known: usize,
        /// How many were not recognised and yet not taken in.
        others: usize,
    },
    /// How wide it was on the way since the last view (§3.2.2).
    Wideness {
        /// At its end, metres.
        here: f64,
        /// Where it was narrowest, metres.
        least: f64,
        /// How often it was measured.
        samples: usize,
    },
    /// An exit was gone through.
    Exit {
        /// Which.
        exit: u32,
        /// From jamb to jamb, metres.
        width: Option<f64>,
        /// The engine's reason.
        why: Vec<Clause>,
    },
    /// A local space was opened.
    NewAsr {
        /// Which.
        asr: u32,
        /// Behind which exit.
        exit: u32,
        /// How many surfaces were moved to it because they had been seen through the exit.
        moved: usize,
    },
    /// A loop was closed.
    LoopClosed {
        /// The space that the robot is back in.
        asr: u32,
        /// The newer space that is the same.
        instead_of: Option<u32>,
        /// The share of it that lies in the old one.
        overlap: f64,
        /// The engine's reason.
        why: Vec<Clause>,
    },
    /// The ways on were weighed.
    Options {
        /// Counter-clockwise.
        options: Vec<Weighed>,
    },
    /// One was taken.
    Choice {
        /// The view after which it was decided; the robot may have looked since, on its way.
        step: usize,
        /// What led the robot.
        lead: Lead,
        /// Which of the options, from 1; nothing where it was none of them.
        option: Option<usize>,
        /// The engine's reason.
        why: Vec<Clause>,
    },
    /// Something is not gone by any longer.
    Forgotten {
        /// How many surfaces the map let go (§2.2.2).
        by_map: usize,
        /// How many a robot on its way home does not trust at the moment (§3.3.3).
        by_navigation: usize,
    },
}

/// A surface that was seen and the one that it was recognised as (Fig. 3.4).
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Tsify)]
pub struct FittingPair {
    /// Its number in the view.
    pub seen: usize,
    /// Its number in the map.
    pub known: u32,
    /// Distance of their first ends, metres.
    pub d1: f64,
    /// Distance of their second ends, metres.
    pub d2: f64,
    /// Difference of orientation, degrees.
    pub phi_deg: f64,
    /// What the three amount to, m² rad.
    pub error: f64,
}

/// How the measured movement was corrected.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Tsify)]
pub struct Corrected {
    /// Added to the turn, degrees.
    pub turn_deg: f64,
    /// Added to the way, metres.
    pub travel: f64,
    /// The mean error before, m² rad.
    pub before: f64,
    /// And after.
    pub after: f64,
    /// How many changes were kept.
    pub changes: usize,
}

/// The pair that a view was placed by, and why it.
#[derive(Clone, Debug, PartialEq, Serialize, Tsify)]
pub struct ReferenceReport {
    /// Its number in the view.
    pub seen: usize,
    /// Its number in the map.
    pub known: u32,
    /// Metres that were seen of it.
    pub length: f64,
    /// Mean range of its points, metres.
    pub range: f64,
    /// Angle between the beams and its normal, degrees.
    pub incidence_deg: f64,
    /// What fixes the place along its line.
    pub along: AlongKind,
    /// The surface that does, where one does.
    pub crossing: Option<u32>,
    /// Every candidate, best first, the reference among them.
    pub candidates: Vec<Candidate>,
}

/// What fixes a place along a reference's line.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Tsify)]
#[serde(rename_all = "snake_case")]
pub enum AlongKind {
    /// A true end.
    End,
    /// Another surface that crosses it.
    Crossing,
    /// Nothing: it is a guess.
    Guess,
}

/// A pair that could have been the reference.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Tsify)]
pub struct Candidate {
    /// Its number in the view.
    pub seen: usize,
    /// Its number in the map.
    pub known: u32,
    /// What the choice goes by; higher is better.
    pub quality: f64,
}

/// A way on and what speaks for it.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Tsify)]
pub struct Weighed {
    /// Metres that it would be longer than the straight line.
    pub detour: f64,
    /// What the choice goes by; lower is better.
    pub score: f64,
    /// Whether it is not for choice.
    pub barred: bool,
    /// Whether it was taken.
    pub chosen: bool,
}

/// Names a stage of a step.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, Tsify)]
#[serde(rename_all = "snake_case")]
#[allow(missing_docs, reason = "each is the stage report of the same name")]
pub enum StageKind {
    Scan,
    Surfaces,
    Recognised,
    Movement,
    Reference,
    Together,
    Open,
    Lost,
    Found,
    Placed,
    Ignored,
    Wideness,
    Exit,
    NewAsr,
    LoopClosed,
    Options,
    Choice,
    Forgotten,
}

impl StageKind {
    /// What the picture points out.
    pub(crate) fn stage(self) -> Stage {
        match self {
            Self::Scan => Stage::Scan,
            Self::Surfaces => Stage::Surfaces,
            Self::Recognised | Self::Lost | Self::Found => Stage::Recognised,
            Self::Movement => Stage::Movement,
            Self::Reference => Stage::Reference,
            Self::Together => Stage::Together,
            Self::Open => Stage::Open,
            Self::Placed => Stage::Placed,
            Self::Ignored => Stage::Ignored,
            Self::Wideness => Stage::Wideness,
            Self::Exit => Stage::Exit,
            Self::NewAsr => Stage::NewAsr,
            Self::LoopClosed => Stage::LoopClosed,
            Self::Options => Stage::Options,
            Self::Choice => Stage::Choice,
            Self::Forgotten => Stage::Forgotten,
        }
    }
}
