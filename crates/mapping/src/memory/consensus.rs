//! Our recommended mapper: all recognised surfaces together say where the robot is.
//!
//! It is not Yeap's model. It keeps two of its commitments: nothing stored is ever moved, and new
//! surfaces are placed from recognised ones. It borrows from SLAM a pose that all references
//! determine together, small local frames, and a jump when a place is recognised. Odometry says
//! where to begin looking, and decides only in directions that no reference determines; each such
//! use is an event.

mod ablation;
mod alignment;
mod candidates;
mod hypothesis;
mod information;
mod known;
mod line;
mod look;
mod lost;
mod novelty;
mod params;
mod recall;
mod recognition;
mod relocation;
mod search;
mod surroundings;

use std::collections::VecDeque;

use cogmap_geometry::{Metric, Pose};

pub use self::{
    alignment::Alignment, look::FreeSpace, lost::Loss, novelty::Novelty, params::ConsensusParams,
    recognition::Recognition, relocation::Relocation, search::Search, surroundings::Reach,
};
use self::{
    alignment::Fit,
    hypothesis::{Remembered, Rules, Sight},
    line::Line,
    look::{Agreement, Look},
    lost::{Doubt, Habit},
    recall::Recall,
    surroundings::Surroundings,
};
use super::{FrameId, Link, LinkKind, Memory, Sighting, SurfaceId};
use crate::{
    Placement, StepReport,
    perception::{Reading, View, extract},
    report::{Lost, Recalled},
};

/// So many looks back a view must bear out what was seen free.
const RECENT: usize = 5;

/// The consensus mapper; see the module for what it keeps of the theory and what it borrows.
#[derive(Clone, Debug)]
pub struct Consensus {
    params: ConsensusParams,
    memory: Memory,
    frame: FrameId,
    frame_from_robot: Pose,
    frame_from_last_placing: Pose,
    steps_lost: u32,
    doubt: Doubt,
    habit: Habit,
    /// What was seen free just before, in the robot's frame, oldest first.
    recent: VecDeque<Look>,
    surroundings: Surroundings,
    recall: Recall,
}

impl Consensus {
    /// A mapper with an empty memory.
    #[must_use]
    pub fn new(params: &ConsensusParams) -> Self {
        Self {
            params: *params,
            memory: Memory::default(),
            frame: FrameId::default(),
            frame_from_robot: Pose::IDENTITY,
            frame_from_last_placing: Pose::IDENTITY,
            steps_lost: 0,
            doubt: Doubt::default(),
            habit: Habit::default(),
            recent: VecDeque::new(),
            surroundings: Surroundings::default(),
            recall: Recall::default(),
        }
    }

    /// What it remembers.
    #[must_use]
    pub fn memory(&self) -> &Memory {
        &self.memory
    }

    /// Every reading counts: the robot locates itself in each, and places surfaces now and then.
    pub(crate) fn observe(&mut self, reading: &Reading) -> StepReport {
        let view = extract(&reading.scan, &self.params.extraction);
        let (lines, look) = (line::of_view(&view.surfaces), Look::of(&reading.scan));
        let sight = Sight { lines: &lines, look: &look };
        let moved = self.memory.moved_to(reading.odom_from_robot);
        let mut fit = moved.map(|moved| self.locate(sight, moved));
        let lost = self.notice_loss(sight, &mut fit);
        let (mut placed, mut recalled) = (Vec::new(), None);
        let stored = self.doubt.views == 0 && (fit.is_none() || self.time_to_place());
        if stored {
            placed = self.place(&view, sight);
            recalled = self.recognise(sight);
        }
        self.settle();
        let report = self.close(reading, view, fit);
        StepReport { stored, placed, recalled, lost, ..report }
    }

    /// Lays the view onto what is remembered around where odometry puts the robot.
    fn locate(&mut self, sight: Sight<'_>, moved: Pose) -> Fit {
        self.frame_from_robot = self.frame_from_robot * moved;
        self.recall.carry(moved);
        let known = self.surroundings.lines();
        let contradiction = |pose| self.agreement(sight.look, pose).contradiction();
        let start = (self.frame_from_robot, self.steps_lost);
        search::locate(sight.lines, known, start, contradiction, &self.params)
    }

    /// How far a look bears out what was seen free just before.
    fn agreement(&self, look: &Look, pose: Pose) -> Agreement {
        let look = look.seen_from(pose);
        self.recent.iter().map(|recent| recent.agreement(&look, &self.params.free_space)).sum()
    }

    /// How far a view bears out the last one, at best, from where the robot can be: where it fits, or
    /// where odometry puts it, or beside that.
    fn overlap(&self, sight: Sight<'_>, fit: &Fit) -> Agreement {
        let (loss, predicted) = (&self.params.loss, self.frame_from_robot);
        let Some(last) = self.recent.back() else { return Agreement::default() };
        let beside = || {
            let known = self.surroundings.lines();
            search::align_from(sight.lines, known, predicted, 0.0, &self.params.alignment).pose
        };
        let places = [fit.pose, predicted].into_iter().chain(std::iter::once_with(beside));
        let can_be = |at: &Pose| self.habit.allows(predicted.from_here(*at), self.doubt.views + 1, loss);
        let mut least: Option<Agreement> = None;
        for place in places.filter(can_be) {
            let agreement = last.agreement(&sight.look.seen_from(place), &loss.free_space);
            if least.is_none_or(|least| agreement.contradiction() < least.contradiction()) {
                least = Some(agreement);
            }
            if !loss.doubts(agreement, self.doubt) {
                return agreement;
            }
        }
        least.unwrap_or_default()
    }

    /// Successive views overlap (§2.2.2). One that contradicts the last, wherever odometry can have
    /// carried the robot meanwhile, was not taken near it: it places nothing, the robot included. After
    /// some of them the robot knows that it was moved unseen, and begins a map that has no link to the
    /// first.
    fn notice_loss(&mut self, sight: Sight<'_>, fit: &mut Option<Fit>) -> Option<Lost> {
        let found = fit.as_ref()?;
        let loss = &self.params.loss;
        let agreement = if loss.on { self.overlap(sight, found) } else { Agreement::default() };
        let by = self.frame_from_robot.from_here(found.pose);
        if !(loss.on && loss.doubts(agreement, self.doubt)) {
            self.doubt = Doubt::default();
            if self.params.search.believes(found) {
                self.habit.learn(by, loss);
                (self.frame_from_robot, self.steps_lost) = (found.pose, 0);
            } else {
                self.steps_lost += 1;
            }
            return None;
        }
        self.doubt.grow(agreement, loss);
        if !loss.is_lost(self.doubt) {
            return None;
        }
        let matched = found.fraction;
        let map_from_robot = self.memory.mfis().map_from_frame(self.frame) * self.frame_from_robot;
        let left = self.frame;
        let opened = self.memory.open_frame(map_from_robot);
        self.recent.clear();
        self.enter(opened, self.frame_from_robot);
        self.recall.lose(opened);
        (self.doubt, self.steps_lost, *fit) = (Doubt::default(), 0, None);
        Some(Lost { left, matched, contradiction: agreement.contradiction() })
    }

    fn time_to_place(&self) -> bool {
        let since = self.frame_from_last_placing.from_here(self.frame_from_robot);
        self.memory.path().is_empty()
            || since.position.norm() >= self.params.place_distance
            || since.heading.abs() >= self.params.place_turn
    }

    /// Freezes what is new, in the frame of the place where the robot is.
    fn place(&mut self, view: &View, sight: Sight<'_>) -> Vec<SurfaceId> {
        let (frame, step) = (self.frame, self.memory.path().len());
        let mut placed = Vec::new();
        for line in sight.lines {
            let in_frame = line.seen_from(self.frame_from_robot);
            if !novelty::is_new(&in_frame, self.surroundings.lines(), &self.params.novelty) {
                continue;
            }
            let index_in_view = line.tag as usize;
            let sighting = Sighting { frame, step, index_in_view };
            let surface = &view.surfaces[index_in_view];
            let id = self.memory.store(surface, self.frame_from_robot, sighting);
            self.surroundings.remember(frame, Line { tag: id.0, ..in_frame });
            placed.push(id);
        }
        self.frame_from_last_placing = self.frame_from_robot;
        let look = sight.look.seen_from(self.frame_from_robot);
        self.surroundings.keep(frame, &look);
        if self.recent.len() == RECENT {
            self.recent.pop_front();
        }
        self.recent.push_back(look);
        placed
    }

    /// Tracks whether the robot may be back in an old place, and goes over to it when sure.
    fn recognise(&mut self, sight: Sight<'_>) -> Option<Recalled> {
        let ConsensusParams { recognition, alignment, free_space, .. } = &self.params;
        let remembered = Remembered { mfis: self.memory.mfis(), surroundings: &self.surroundings };
        let rules = Rules { recognition, alignment, free_space };
        let place = self.recall.consider(sight, (self.frame, self.frame_from_robot), remembered, rules)?;
        let recalled = Recalled { frame: place.frame, left: self.frame, way: place.way };
        let old_from_current = place.frame_from_robot * self.frame_from_robot.inverse();
        self.link(place.frame, self.frame, old_from_current, LinkKind::Recognised);
        self.enter(place.frame, old_from_current.inverse());
        Some(recalled)
    }

    /// Goes over to a nearer frame, or opens one where there is none.
    fn settle(&mut self) {
        if self.frame_from_robot.position.norm() <= self.params.frame_size {
            return;
        }
        let nearest = self.surroundings.nearest_frame(self.frame, self.frame_from_robot);
        match nearest {
            Some((frame, current_from_frame, distance)) if distance < self.params.frame_size * 0.8 => {
                self.enter(frame, current_from_frame);
            }
            _ => {
                let (current, pose) = (self.frame, self.frame_from_robot);
                let map_from_robot = self.memory.mfis().map_from_frame(current) * pose;
                let opened = self.memory.open_frame(map_from_robot);
                self.link(current, opened, pose, LinkKind::Passage);
                self.enter(opened, pose);
            }
        }
    }

    fn link(&mut self, from: FrameId, to: FrameId, from_from_to: Pose, kind: LinkKind) {
        let step = self.memory.path().len();
        self.memory.link(Link { from, to, from_from_to, step, kind });
    }

    fn enter(&mut self, frame: FrameId, current_from_frame: Pose) {
        let frame_from_current = current_from_frame.inverse();
        self.frame_from_robot = frame_from_current * self.frame_from_robot;
        self.frame_from_last_placing = frame_from_current * self.frame_from_last_placing;
        for look in &mut self.recent {
            *look = look.seen_from(frame_from_current);
        }
        self.frame = frame;
        self.surroundings.centre_on(self.memory.mfis(), frame, &self.params.reach);
    }

    /// Closes the step: where the robot was, and what told it.
    fn close(&mut self, reading: &Reading, view: View, fit: Option<Fit>) -> StepReport {
        let placement = match &fit {
            None => Placement::First,
            Some(fit) if !self.params.search.believes(fit) => Placement::Odometry,
            Some(_) if self.doubt.views > 0 => Placement::Odometry,
            Some(fit) if fit.rank < 3 => Placement::PartlyOdometry,
            Some(_) => Placement::Consensus,
        };
        let map_from_frame = self.memory.mfis().map_from_frame(self.frame);
        let open = fit.as_ref().and_then(|fit| fit.open).map(|open| map_from_frame.rotate(open));
        let map_from_robot = map_from_frame * self.frame_from_robot;
        let here = (self.frame, self.frame_from_robot);
        let step = self.memory.remember(reading.t, here, reading.odom_from_robot);
        let report = StepReport::new((step, reading.t), view, placement, map_from_robot);
        let open = open.filter(|_| placement == Placement::PartlyOdometry);
        let fit = fit.filter(|_| self.doubt.views == 0);
        StepReport { open, matches: fit.map_or(Vec::new(), |fit| fit.matches), ..report }
    }
}
