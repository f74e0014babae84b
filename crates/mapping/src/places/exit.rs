use cogmap_geometry::Segment;
use serde::{Deserialize, Serialize};

use super::AsrId;
use crate::memory::FrameId;

/// Names an exit of one network, in the order of finding.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
pub struct ExitId(pub u32);

/// A passage between two local spaces (§2.2.1), narrower than both.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Exit {
    /// Its name.
    pub id: ExitId,
    /// The local frame that it is given in.
    pub frame: FrameId,
    /// From the jamb on the left to the one on the right of the robot that first crossed it, metres.
    pub segment: Segment,
    /// The space that the robot left when it first crossed it, and the one that it entered.
    pub between: [AsrId; 2],
    /// The view in which it was found, after it had been crossed.
    pub step: usize,
    /// The last view that was taken before it was crossed.
    pub crossed: usize,
    /// On how many of its sides, 0 to 2, a wall goes on outward along its line.
    pub jambs: u8,
}

impl Exit {
    /// The space on its other side; `None` for a space that it does not bound.
    #[must_use]
    pub fn leads_from(&self, asr: AsrId) -> Option<AsrId> {
        match self.between {
            [one, other] if one == asr => Some(other),
            [other, one] if one == asr => Some(other),
            _ => None,
        }
    }
}

/// The robot has gone through an exit, the first time or again.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Crossing {
    /// The exit.
    pub exit: ExitId,
    /// The space that it led to.
    pub into: AsrId,
    /// The last view that was taken before the robot was in it.
    pub view: usize,
    /// The view in which the robot noticed.
    pub step: usize,
    /// Where it lay seen from the robot in [`view`](Self::view), metres.
    pub robot_from_exit: Segment,
}
