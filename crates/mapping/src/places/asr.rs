use cogmap_geometry::Pose;
use serde::{Deserialize, Serialize};

use super::ExitId;
use crate::memory::FrameId;

/// Names an ASR of one network, in the order of opening; the robot begins in ASR 0.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
pub struct AsrId(pub u32);

/// Absolute space representation (§2.2.1): one local space, with the exits in its boundary. Which
/// surfaces belong to it the [`Network`](super::Network) knows.
#[derive(Clone, Debug, PartialEq)]
pub struct Asr {
    /// Its name.
    pub id: AsrId,
    /// The local frame that its entrance is given in.
    pub frame: FrameId,
    /// Its own origin (§2.2.2): the middle of the exit through which it was first entered, x along
    /// the normal into the space; where the robot began, for the first.
    pub frame_from_entrance: Pose,
    /// The exits in its boundary, in the order of finding.
    pub exits: Vec<ExitId>,
    /// Spaces that turned out to be this one when a loop was closed.
    pub merged_from: Vec<AsrId>,
    /// The view in which it was opened.
    pub step: usize,
}
