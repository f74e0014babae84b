use std::num::NonZeroU32;

use cogmap_geometry::Pose;
use serde::{Deserialize, Serialize};

use super::{
    Along, Match, MatchScope, Matching, Memory, Reference, ReferenceQuality, SurfaceId, Update,
    forgetting::RecentSpaces, rank_references, scope::match_remembered,
};
use crate::{
    Cadence, Placement, StepReport,
    perception::{Extraction, Reading, View, extract},
    places::{Network, PlacesParams},
};

/// Every parameter of the perceptual mapper; the defaults are the thesis's program.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct PerceptualParams {
    /// When a scan is a view.
    pub cadence: Cadence,
    /// How points become surfaces.
    pub extraction: Extraction,
    /// When two sightings are one surface.
    pub matching: Matching,
    /// What a view is compared with.
    pub scope: MatchScope,
    /// Which recognised surface becomes the reference target.
    pub reference: ReferenceQuality,
    /// When the map takes in what is new.
    pub update: Update,
    /// How many local spaces are remembered, the current one included: the theory's memory reaches a few
    /// (§2.2.2; ours would be 3). `None` forgets nothing, as the thesis's program while it maps.
    pub spaces: Option<NonZeroU32>,
    /// How the map is shared out among local spaces.
    pub places: PlacesParams,
}

/// Yeap's perceptual mapping as the thesis programs it (§3.2.1): new surfaces are placed relative to
/// one recognised surface; what is stored never changes.
#[derive(Clone, Debug, PartialEq)]
pub struct Perceptual {
    params: PerceptualParams,
    memory: Memory,
    recent: RecentSpaces,
}

impl Perceptual {
    /// A mapper with an empty memory.
    #[must_use]
    pub fn new(params: &PerceptualParams) -> Self {
        Self { params: *params, memory: Memory::default(), recent: RecentSpaces::default() }
    }

    /// What it remembers.
    #[must_use]
    pub fn memory(&self) -> &Memory {
        &self.memory
    }

    pub(crate) fn observe(&mut self, reading: &Reading) -> Option<StepReport> {
        self.params.cadence.takes(reading, self.memory.odom_from_last()).then(|| {
            let view = extract(&reading.scan, &self.params.extraction);
            self.integrate(view, reading.t, reading.odom_from_robot)
        })
    }

    /// §3.2.1, steps 4 to 7, on the surfaces seen when odometry stood at `odom_from_robot`.
    pub fn integrate(&mut self, view: View, t: f64, odom_from_robot: Pose) -> StepReport {
        // Steps 1 to 3 and 5: the robot has turned and moved, by roughly this much, and has looked.
        let moved = self.memory.moved_to(odom_from_robot);
        // Step 6: the surfaces that the current and the previous view have in common, one of which
        // becomes the reference target. The movement is forgotten from here on.
        let (matches, references) = self.compare(&view, moved);
        let (placement, map_from_robot) = self.place(references.first(), moved);
        // Step 4, the whole first view, and step 7, later whatever is new.
        let stored = self.params.update.needs(&view, &matches);
        let placed = if stored {
            self.memory.store_new(&view, &matches, map_from_robot)
        } else {
            self.memory.track(&view, &matches);
            Vec::new()
        };
        let step = self.memory.remember_view(t, map_from_robot, odom_from_robot);
        let report = StepReport::new((step, t), view, placement, map_from_robot);
        StepReport { matches, references, stored, placed, ..report }
    }

    /// The common surfaces, and those of them that can be the reference target, best first.
    fn compare(&self, view: &View, moved: Option<Pose>) -> (Vec<Match>, Vec<Reference>) {
        let (mfis, params) = (self.memory.mfis(), &self.params);
        let mut matches = self.memory.recognise(view, moved, &params.matching);
        let references = rank_references(&view.surfaces, &matches, mfis, &params.reference);
        if params.scope == MatchScope::PreviousView {
            return (matches, references);
        }
        let (_, roughly_here) = self.place(references.first(), moved);
        matches.extend(match_remembered(view, &matches, (mfis, roughly_here), &params.matching));
        matches.sort_by_key(|m| m.seen);
        let references = rank_references(&view.surfaces, &matches, mfis, &params.reference);
        (matches, references)
    }

    /// Forgets what lies beyond the last few local spaces, if the memory is limited to them (§2.2.2).
    pub(crate) fn forget(&mut self, network: &Network) -> Vec<SurfaceId> {
        let Some(limit) = self.params.spaces else { return Vec::new() };
        self.recent.limit(&mut self.memory, network, limit.get() as usize)
    }

    /// Where the view lies in the map: by its reference target; by odometry where there is none
    /// (§3.2.3, the corridor), for this one view.
    fn place(&self, reference: Option<&Reference>, moved: Option<Pose>) -> (Placement, Pose) {
        match (reference, moved, self.memory.path().last()) {
            (Some(reference), _, _) if reference.along == Along::GuessedEnd => {
                (Placement::WeakReference, reference.map_from_robot)
            }
            (Some(reference), _, _) => (Placement::Reference, reference.map_from_robot),
            (None, Some(moved), Some(last)) => (Placement::Odometry, last.frame_from_robot * moved),
            _ => (Placement::First, Pose::IDENTITY),
        }
    }
}

#[cfg(test)]
mod tests {
    use cogmap_geometry::{DVec2, Segment};

    use super::*;
    use crate::perception::{End, Surface};

    #[test]
    fn what_is_forgotten_is_no_candidate_and_comes_back_under_a_new_name() {
        let wall = |x: f64| {
            let segment = Segment::new(DVec2::new(x, -1.0), DVec2::new(x, 1.0));
            let (ends, beams) = ([End::True; 2], [0, 9]);
            Surface { segment, ends, beams, points: 10, residual: 0.0, range: x, incidence: 0.3, label: None }
        };
        for scope in [MatchScope::PreviousView, MatchScope::PreviousViewThenMfis] {
            let mut mapper = Perceptual::new(&PerceptualParams { scope, ..PerceptualParams::default() });
            let view = View { surfaces: vec![wall(2.0), wall(4.0)] };
            mapper.integrate(view.clone(), 0.0, Pose::IDENTITY);
            mapper.memory.forget(&[SurfaceId(0)]);
            let report = mapper.integrate(view, 1.0, Pose::IDENTITY);
            assert_eq!(report.matches.iter().map(|m| m.known).collect::<Vec<_>>(), [SurfaceId(1)]);
            assert_eq!(report.placed, [SurfaceId(2)]);
            let mfis = mapper.memory().mfis();
            assert!(!mfis.remembers(SurfaceId(0)) && mfis.forgotten_in(SurfaceId(0)) == Some(0));
            assert_eq!(mfis.surfaces().len(), 3);
        }
    }
}
