use std::collections::{BTreeMap, BTreeSet, VecDeque};

use serde::{Deserialize, Serialize};

use super::{AsrId, Network};
use crate::{StepReport, memory::SurfaceId, perception::Surface};

/// When a space is recognised by what is seen in it (`recommended`, ours): surfaces that the mapper
/// recognised belong to a space already.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Familiarity {
    /// Behind a new exit this share of what is recognised belongs to another space, and more of it than to any
    /// space but the new one: the robot is back there.
    pub known: f64,
    /// A space that overlaps with an old one in the map, but is so many times as large, is another.
    pub larger: f64,
    /// After the mapper recognised an old place, a newer space of whose outline at least this share lies on
    /// an older one's is that one (half of it, where what the robot sees lies on the older one) …
    pub shape: f64,
    /// … for so many metres of way.
    pub within: f64,
}

impl Default for Familiarity {
    fn default() -> Self {
        Self { known: 0.35, larger: 2.0, shape: 0.4, within: 5.0 }
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
        let length = |seen: usize| report.view.surfaces.get(seen).map_or(0.0, Surface::length);
        let matched = report.matches.iter().map(|m| (m.known, length(m.seen)));
        self.views.push_back((report.step, matched.collect()));
        if self.views.len() > VIEWS {
            self.views.pop_front();
        }
    }

    /// What was recognised since a view.
    pub(super) fn since(&self, view: usize) -> impl Iterator<Item = SurfaceId> {
        self.views.iter().filter(move |(step, _)| *step >= view).flat_map(|(_, seen)| seen).map(|(id, _)| *id)
    }

    /// Of what was recognised since a view, metres that belong to each space; the surfaces of `new` belong
    /// to the space that is about to be made, `None`.
    fn tally(
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

    /// The old space that most of what was recognised since a view belongs to, and its share: neither the space
    /// that the robot comes from nor the one that it may have just opened, and no less of it than of the first.
    pub(super) fn most(
        &self,
        since: usize,
        network: &Network,
        new: &BTreeSet<SurfaceId>,
        (left, opened): (AsrId, Option<AsrId>),
    ) -> Option<(AsrId, f64)> {
        let tally = self.tally(since, network, new);
        let total: f64 = tally.values().sum();
        let from_left = tally.get(&Some(left)).copied().unwrap_or(0.0);
        tally
            .iter()
            .filter_map(|(asr, &metres)| Some(((*asr)?, metres)))
            .filter(|&(asr, metres)| asr != left && Some(asr) != opened && metres >= from_left)
            .max_by(|a, b| a.1.total_cmp(&b.1))
            .map(|(asr, metres)| (asr, metres / total))
    }
}
