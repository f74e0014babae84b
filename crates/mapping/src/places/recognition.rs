use std::collections::{BTreeMap, BTreeSet, VecDeque};

use serde::{Deserialize, Serialize};

use super::{AsrId, Network};
use crate::{StepReport, memory::SurfaceId};

/// When a space is recognised by what is seen in it (`recommended`, ours): surfaces that the mapper
/// recognised belong to a space already.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Familiarity {
    /// Behind a new exit this share of what is seen belongs to another space: the robot is back there.
    pub known: f64,
    /// This share belongs to the space that the robot comes from, and was not seen through the exit: the
    /// passage separates nothing.
    pub same: f64,
}

impl Default for Familiarity {
    fn default() -> Self {
        Self { known: 0.5, same: 0.5 }
    }
}

/// How many views are kept.
const VIEWS: usize = 100;

/// What was recognised in the last views: which surfaces, and how long they looked.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Sightings {
    views: VecDeque<(usize, Vec<(SurfaceId, f64)>)>,
}

impl Sightings {
    pub(super) fn note(&mut self, report: &StepReport) {
        let length = |seen: usize| report.view.surfaces.get(seen).map_or(0.0, |surface| surface.length());
        let matched = report.matches.iter().map(|m| (m.known, length(m.seen)));
        self.views.push_back((report.step, matched.collect()));
        if self.views.len() > VIEWS {
            self.views.pop_front();
        }
    }

    /// Of what was recognised since a view, metres that belong to each space; the surfaces of `new` belong
    /// to the space that is about to be made, `None`.
    pub(super) fn tally(
        &self,
        since: usize,
        network: &Network,
        new: &BTreeSet<SurfaceId>,
    ) -> BTreeMap<Option<AsrId>, f64> {
        let mut tally = BTreeMap::new();
        for (id, length) in self.views.iter().filter(|(step, _)| *step >= since).flat_map(|(_, seen)| seen) {
            let asr = if new.contains(id) { None } else { network.asr_of(*id) };
            *tally.entry(asr).or_insert(0.0) += length;
        }
        tally
    }
}
