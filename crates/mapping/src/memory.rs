//! Integrating surfaces into the MFIS (§3.2.1).
//!
//! [`perceptual`](Perceptual) joins the steps; each has its own file: `matching` finds common
//! surfaces, `tracking` hands their names on, `reference` chooses the reference target, `mfis` keeps what is placed for good.

mod consensus;
mod matching;
mod mfis;
mod perceptual;
mod reference;
mod tracking;

pub use consensus::{Alignment, Consensus, ConsensusParams, Novelty, Reach, Recognition, Search};
pub use matching::{Match, Matching, PairError, match_views, pair_error};
pub(crate) use mfis::Sighting;
pub use mfis::{Frame, FrameId, Link, LinkKind, Mfis, StoredSurface, SurfaceId};
pub use perceptual::{Perceptual, PerceptualParams};
pub use reference::{Along, Reference, ReferenceQuality, rank_references};
pub use tracking::{Memory, Tracked};
