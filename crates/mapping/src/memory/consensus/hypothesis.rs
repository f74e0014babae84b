use cogmap_geometry::Pose;

use super::{
    Alignment, FreeSpace, Recognition,
    alignment::{Fit, align},
    candidates::Candidates,
    known::Known,
    line::Line,
    look::{Agreement, Look},
    surroundings::{Elsewhere, Surroundings},
};
use crate::memory::{FrameId, Mfis};

/// What surfaces of an old place must lie within of its origin, metres.
const OLD_RADIUS: f64 = 10.0;

/// What the robot sees: lines, and free space, in its own frame.
#[derive(Clone, Copy)]
pub(super) struct Sight<'a> {
    pub(super) lines: &'a [Line],
    pub(super) look: &'a Look,
}

/// What recognising goes by.
#[derive(Clone, Copy)]
pub(super) struct Rules<'a> {
    pub(super) recognition: &'a Recognition,
    pub(super) alignment: &'a Alignment,
    pub(super) free_space: &'a FreeSpace,
}

/// What is remembered.
#[derive(Clone, Copy)]
pub(super) struct Remembered<'a> {
    pub(super) mfis: &'a Mfis,
    pub(super) surroundings: &'a Surroundings,
}

impl Remembered<'_> {
    pub(super) fn around(self, frame: FrameId, rules: Rules<'_>) -> Elsewhere {
        self.surroundings.elsewhere(self.mfis, frame, rules.recognition.surroundings, OLD_RADIUS)
    }
}

/// An old place, and where the robot is in it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Place {
    pub(super) frame: FrameId,
    pub(super) frame_from_robot: Pose,
    /// Metres that the hypothesis was followed before it was believed.
    pub(super) way: f64,
}

/// The guess that the robot is in an old place, and how it has fared.
#[derive(Clone, Debug)]
pub(super) struct Hypothesis {
    pub(super) place: Place,
    pub(super) views: u32,
    fractions: f64,
    agreement: Agreement,
}

impl Hypothesis {
    pub(super) fn begin(frame: FrameId, fit: &Fit, agreement: Agreement) -> Self {
        let place = Place { frame, frame_from_robot: fit.pose, way: 0.0 };
        Self { place, views: 1, fractions: fit.fraction, agreement }
    }

    pub(super) fn mean(&self) -> f64 {
        self.fractions / f64::from(self.views)
    }

    /// The share of all beams so far that contradicted what was seen free there.
    pub(super) fn contradiction(&self) -> f64 {
        self.agreement.contradiction()
    }

    /// Takes in one more view; the fit, if it still can be.
    pub(super) fn follow(
        &mut self,
        sight: Sight<'_>,
        remembered: Remembered<'_>,
        rules: Rules<'_>,
    ) -> Option<Fit> {
        let old = remembered.around(self.place.frame, rules);
        let fit = fit_at(sight.lines, &old.lines, self.place.frame_from_robot, (0.0, rules.alignment))?;
        let agreement = old.agreement(&sight.look.seen_from(fit.pose), rules.free_space);
        self.place.frame_from_robot = fit.pose;
        self.views += 1;
        self.fractions += fit.fraction;
        self.agreement = [self.agreement, agreement].into_iter().sum();
        let Recognition { drop_below, believe_fraction, contradiction, .. } = *rules.recognition;
        let fits = fit.fraction >= drop_below && self.mean() >= believe_fraction - 0.05;
        (fits && self.contradiction() <= contradiction).then_some(fit)
    }
}

/// How a view fits there; `None` where less than `least` of it could.
pub(super) fn fit_at(
    view: &[Line],
    known: &Known,
    start: Pose,
    (least, alignment): (f64, &Alignment),
) -> Option<Fit> {
    let near = Candidates::around(view, known, start, 1.3 * alignment.gate, 1.2 * alignment.gate_angle);
    (near.possible_fraction() >= least).then(|| align(view, &near, start, 0.0, alignment))
}
