//! Integrating surfaces into the MFIS (§3.2.1).
//!
//! [`perceptual`](Perceptual) joins the steps; each has its own file: `matching` finds common
//! surfaces, `tracking` hands their names on, `reference` chooses the reference target, `mfis` keeps what is placed for good.

mod consensus;
mod frames;
mod index;
mod matching;
mod mfis;
mod perceptual;
mod reference;
mod tracking;

pub use consensus::{Alignment, Consensus, ConsensusParams, Novelty, Reach, Recognition, Search};
pub use frames::{Frame, FrameId, Link, LinkKind, Way};
pub use matching::{Match, Matching, PairError, match_views, pair_error};
pub(crate) use mfis::Sighting;
pub use mfis::{Mfis, StoredSurface, SurfaceId};
pub use perceptual::{Perceptual, PerceptualParams};
pub use reference::{Along, Reference, ReferenceQuality, rank_references};
pub use tracking::{Memory, Tracked};
