//! Integrating surfaces into the MFIS (§3.2.1).
//!
//! [`perceptual`](Perceptual) joins the steps; each has its own file: `matching` finds common
//! surfaces and `scope` says where, `tracking` hands their names on, `reference` chooses the reference target,
//! `update` says when a view is needed, `mfis` keeps what is placed for good until `forgetting` lets it go.

mod consensus;
mod forgetting;
mod frames;
mod index;
mod matching;
mod mfis;
mod perceptual;
mod reference;
mod scope;
mod tracking;
mod update;

pub use consensus::{
    Alignment, Consensus, ConsensusParams, FreeSpace, Loss, Novelty, Reach, Recognition, Relocation, Search,
};
pub use frames::{Frame, FrameId, Link, LinkKind, Way};
pub(crate) use index::Index;
pub use matching::{Match, Matching, PairError, match_views, pair_error};
pub(crate) use mfis::Sighting;
pub use mfis::{Mfis, StoredSurface, SurfaceId};
pub use perceptual::{Perceptual, PerceptualParams};
pub use reference::{Along, Reference, ReferenceQuality, ReferenceRule, rank_references};
pub use scope::MatchScope;
pub use tracking::{Memory, Tracked};
pub use update::{Update, UpdatePolicy};
