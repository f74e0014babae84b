use std::collections::BTreeMap;

use cogmap_geometry::{DVec2, Pose};

use super::{Asr, AsrId, Crossing, Exit, ExitId, Hypothesis, visits::Visits};
use crate::memory::{FrameId, Index, SurfaceId};

mod merge;
mod route;

/// The network of local spaces (§2.2.1, Fig. 2.1): nodes are ASRs, edges are exits.
#[derive(Clone, Debug, PartialEq)]
pub struct Network {
    asrs: Vec<Asr>,
    exits: Vec<Exit>,
    crossings: Vec<Crossing>,
    current: AsrId,
    opened: u32,
    asr_of_surface: Vec<Option<AsrId>>,
    surfaces_of: BTreeMap<AsrId, Vec<SurfaceId>>,
    visits: Visits,
    /// For spaces that turned out to be another one: which.
    lasting: BTreeMap<AsrId, AsrId>,
    /// For exits that turned out to be another one: which.
    same_exit: BTreeMap<ExitId, ExitId>,
    hypotheses: Vec<Hypothesis>,
    /// Where exits were found; those that turned out to be another one still lead to that.
    exits_at: Index<ExitId>,
    hypotheses_at: Index<usize>,
}

impl Default for Network {
    fn default() -> Self {
        let mut network = Self {
            asrs: Vec::new(),
            exits: Vec::new(),
            crossings: Vec::new(),
            current: AsrId(0),
            opened: 0,
            asr_of_surface: Vec::new(),
            surfaces_of: BTreeMap::new(),
            visits: Visits::default(),
            lasting: BTreeMap::new(),
            same_exit: BTreeMap::new(),
            hypotheses: Vec::new(),
            exits_at: Index::default(),
            hypotheses_at: Index::default(),
        };
        network.open((FrameId::default(), Pose::IDENTITY), 0);
        network
    }
}

impl Network {
    /// The spaces, oldest first; those that turned out to be another one are not among them.
    #[must_use]
    pub fn asrs(&self) -> &[Asr] {
        &self.asrs
    }

    /// The space of that name, or the one that it turned out to be.
    #[must_use]
    pub fn asr(&self, id: AsrId) -> Option<&Asr> {
        let id = self.lasting(id);
        self.asrs.binary_search_by_key(&id, |asr| asr.id).ok().map(|at| &self.asrs[at])
    }

    /// The space that one turned out to be; mostly itself.
    #[must_use]
    pub fn lasting(&self, id: AsrId) -> AsrId {
        self.lasting.get(&id).copied().unwrap_or(id)
    }

    /// The exits, in the order of finding; those that turned out to be another one are not among them.
    #[must_use]
    pub fn exits(&self) -> &[Exit] {
        &self.exits
    }

    /// The exit of that name, or the one that it turned out to be.
    #[must_use]
    pub fn exit(&self, id: ExitId) -> Option<&Exit> {
        let id = self.same_exit.get(&id).copied().unwrap_or(id);
        self.exits.binary_search_by_key(&id, |exit| exit.id).ok().map(|at| &self.exits[at])
    }

    /// Each time that the robot went through an exit, in order.
    #[must_use]
    pub fn crossings(&self) -> &[Crossing] {
        &self.crossings
    }

    /// The exits that were seen ahead, or beside the way, in the order of seeing.
    #[must_use]
    pub fn hypotheses(&self) -> &[Hypothesis] {
        &self.hypotheses
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

    /// The surfaces of a space, oldest first.
    #[must_use]
    pub fn surfaces_of(&self, asr: AsrId) -> &[SurfaceId] {
        self.surfaces_of.get(&self.lasting(asr)).map_or(&[], Vec::as_slice)
    }

    /// The space in which a view was taken.
    #[must_use]
    pub fn asr_at(&self, step: usize) -> Option<AsrId> {
        self.visits.asr_at(step)
    }

    /// Opens a space with its entrance there.
    pub(super) fn open(&mut self, (frame, frame_from_entrance): (FrameId, Pose), step: usize) -> AsrId {
        let id = AsrId(self.opened);
        self.opened += 1;
        let (exits, merged_from) = (Vec::new(), Vec::new());
        self.asrs.push(Asr { id, frame, frame_from_entrance, exits, merged_from, step });
        id
    }

    /// Adds an exit; its name is given here.
    pub(super) fn add_exit(&mut self, exit: Exit) -> ExitId {
        let id = self.next_exit();
        let exit = Exit { id, ..exit };
        for asr in &mut self.asrs {
            if exit.between.contains(&asr.id) {
                asr.exits.push(id);
            }
        }
        self.exits.push(exit);
        self.exits_at.insert(exit.frame, exit.segment, id);
        id
    }

    /// The exits of a frame that may come within `radius` metres of a point, in the order of finding.
    pub(super) fn exits_around(&self, frame: FrameId, at: DVec2, radius: f64) -> Vec<ExitId> {
        self.exits_at.around(frame, at, radius)
    }

    /// The numbers of the hypotheses of a frame that may come within `radius` metres of a point, in order.
    pub(super) fn hypotheses_around(&self, frame: FrameId, at: DVec2, radius: f64) -> Vec<usize> {
        self.hypotheses_at.around(frame, at, radius)
    }

    /// The name of the next exit.
    pub(super) fn next_exit(&self) -> ExitId {
        let kept = self.exits.last().map_or(0, |exit| exit.id.0 + 1);
        ExitId(self.same_exit.last_key_value().map_or(kept, |(gone, _)| kept.max(gone.0 + 1)))
    }

    /// The robot has gone through an exit: it is in another space since the view after the crossing.
    pub(super) fn cross(&mut self, crossing: Crossing) {
        self.crossings.push(crossing);
        self.enter(crossing.into, crossing.view + 1);
    }

    /// The robot is in a space since a view.
    pub(super) fn enter(&mut self, asr: AsrId, since: usize) {
        self.current = asr;
        self.visits.enter(asr, since);
    }

    /// Gives a surface to a space; it leaves the one that it belonged to.
    pub(super) fn assign(&mut self, surface: SurfaceId, asr: AsrId) {
        let place = surface.0 as usize;
        if self.asr_of_surface.len() <= place {
            self.asr_of_surface.resize(place + 1, None);
        }
        let before = self.asr_of_surface[place].replace(asr);
        if before == Some(asr) {
            return;
        }
        if let Some(members) = before.and_then(|before| self.surfaces_of.get_mut(&before))
            && let Ok(at) = members.binary_search(&surface)
        {
            members.remove(at);
        }
        let members = self.surfaces_of.entry(asr).or_default();
        if let Err(at) = members.binary_search(&surface) {
            members.insert(at, surface);
        }
    }

    /// A view was taken there in the map.
    pub(super) fn note_view(&mut self, at: DVec2) {
        self.visits.add(self.current, at);
    }

    pub(super) fn visits(&self) -> &Visits {
        &self.visits
    }

    pub(super) fn suppose(&mut self, hypothesis: Hypothesis) -> usize {
        let number = self.hypotheses.len();
        self.hypotheses_at.insert(hypothesis.frame, hypothesis.segment, number);
        self.hypotheses.push(hypothesis);
        number
    }

    pub(super) fn see_again(&mut self, hypothesis: usize) {
        if let Some(hypothesis) = self.hypotheses.get_mut(hypothesis) {
            hypothesis.views += 1;
        }
    }

    pub(super) fn confirm(&mut self, hypothesis: usize, exit: ExitId) {
        if let Some(hypothesis) = self.hypotheses.get_mut(hypothesis) {
            hypothesis.confirmed = Some(exit);
        }
    }
}
