use cogmap_geometry::Pose;

use super::{Asr, AsrId, Exit, ExitId};
use crate::memory::{FrameId, SurfaceId};

/// The network of local spaces (§2.2.1, Fig. 2.1): nodes are ASRs, edges are exits.
#[derive(Clone, Debug, PartialEq)]
pub struct Network {
    asrs: Vec<Asr>,
    exits: Vec<Exit>,
    current: AsrId,
    asr_of_surface: Vec<Option<AsrId>>,
    asr_of_step: Vec<AsrId>,
}

impl Default for Network {
    fn default() -> Self {
        let first = Asr {
            id: AsrId(0),
            frame: FrameId::default(),
            frame_from_entrance: Pose::IDENTITY,
            exits: Vec::new(),
            merged_from: Vec::new(),
            step: 0,
        };
        Self {
            asrs: vec![first],
            exits: Vec::new(),
            current: AsrId(0),
            asr_of_surface: Vec::new(),
            asr_of_step: Vec::new(),
        }
    }
}

impl Network {
    /// The spaces, oldest first; those that turned out to be another one are not among them.
    #[must_use]
    pub fn asrs(&self) -> &[Asr] {
        &self.asrs
    }

    /// The exits, in the order of finding.
    #[must_use]
    pub fn exits(&self) -> &[Exit] {
        &self.exits
    }

    /// The exit of that name.
    #[must_use]
    pub fn exit(&self, id: ExitId) -> Option<&Exit> {
        self.exits.get(id.0 as usize)
    }

    /// The space in which the robot believes to be.
    #[must_use]
    pub fn current(&self) -> AsrId {
        self.current
    }

    /// The space that a stored surface belongs to (§3.2.2: every surface belongs to one).
    #[must_use]
    pub fn asr_of(&self, surface: SurfaceId) -> Option<AsrId> {
        self.asr_of_surface.get(surface.0 as usize).copied().flatten()
    }

    /// The space in which a view was taken.
    #[must_use]
    pub fn asr_at(&self, step: usize) -> Option<AsrId> {
        self.asr_of_step.get(step).copied()
    }

    pub(super) fn assign(&mut self, surfaces: &[SurfaceId], asr: AsrId) {
        for surface in surfaces {
            let place = surface.0 as usize;
            if self.asr_of_surface.len() <= place {
                self.asr_of_surface.resize(place + 1, None);
            }
            self.asr_of_surface[place] = Some(asr);
        }
    }

    pub(super) fn note_step(&mut self, views: usize, asr: AsrId) {
        self.asr_of_step.resize(views, asr);
    }
}
