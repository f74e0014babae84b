use std::collections::BTreeMap;

use cogmap_geometry::DVec2;

use super::AsrId;

/// In which space each view was taken, and where in the map. What is asked about one space costs no more
/// for the way through all others.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Visits {
    views: Vec<(AsrId, DVec2)>,
    of: BTreeMap<AsrId, Visited>,
}

/// The views taken in one space, oldest first, and a box around where that was.
#[derive(Clone, Debug, PartialEq)]
struct Visited {
    views: Vec<usize>,
    low: DVec2,
    high: DVec2,
}

impl Default for Visited {
    fn default() -> Self {
        Self { views: Vec::new(), low: DVec2::INFINITY, high: DVec2::NEG_INFINITY }
    }
}

impl Visits {
    pub(super) fn asr_at(&self, view: usize) -> Option<AsrId> {
        self.views.get(view).map(|(asr, _)| *asr)
    }

    /// Where the robot was in a space, oldest first, in the map.
    pub(super) fn places_in(&self, asr: AsrId) -> impl Iterator<Item = DVec2> {
        let views = self.of.get(&asr).map_or(&[][..], |visited| visited.views.as_slice());
        views.iter().map(|&view| self.views[view].1)
    }

    /// `false` only where the robot never was within so many metres of a point while it was in a space, nor
    /// anywhere around that point.
    pub(super) fn may_reach(&self, asr: AsrId, point: DVec2, metres: f64) -> bool {
        self.of.get(&asr).is_some_and(|Visited { low, high, .. }| {
            (*low - metres).cmple(point).all() && (*high + metres).cmpge(point).all()
        })
    }

    /// A view was taken in a space.
    pub(super) fn add(&mut self, asr: AsrId, at: DVec2) {
        self.views.push((asr, at));
        self.of.entry(asr).or_default().take_in(self.views.len() - 1, at);
    }

    /// The views since one were taken in a space.
    pub(super) fn enter(&mut self, asr: AsrId, since: usize) {
        for (before, _) in self.views.iter().skip(since).rev() {
            self.of.entry(*before).or_default().views.pop();
        }
        let visited = self.of.entry(asr).or_default();
        for (view, (before, at)) in self.views.iter_mut().enumerate().skip(since) {
            *before = asr;
            visited.take_in(view, *at);
        }
    }

    /// The newer of two spaces turned out to be the older.
    pub(super) fn merge(&mut self, newer: AsrId, older: AsrId) {
        let gone = self.of.remove(&newer).unwrap_or_default();
        let visited = self.of.entry(older).or_default();
        for view in gone.views {
            self.views[view].0 = older;
            visited.take_in(view, self.views[view].1);
        }
        visited.views.sort_unstable();
    }
}

impl Visited {
    fn take_in(&mut self, view: usize, at: DVec2) {
        self.views.push(view);
        (self.low, self.high) = (self.low.min(at), self.high.max(at));
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    proptest! {
        #[test]
        fn every_view_belongs_to_the_space_that_lists_it(
            turns in prop::collection::vec((0u32..5, 0usize..9, -9.0f64..9.0, prop::bool::ANY), 1..40),
        ) {
            let (mut visits, mut current) = (Visits::default(), AsrId(0));
            for (asr, back, x, merges) in turns {
                visits.add(current, DVec2::new(x, 0.0));
                if merges && AsrId(asr) < current {
                    visits.merge(current, AsrId(asr));
                } else {
                    visits.enter(AsrId(asr), visits.views.len().saturating_sub(back));
                }
                current = AsrId(asr);
                for asr in (0..5).map(AsrId) {
                    let views = visits.views.iter().filter(|(of, _)| *of == asr).map(|(_, at)| *at);
                    prop_assert!(views.clone().all(|at| visits.may_reach(asr, at, 0.0)));
                    prop_assert_eq!(views.collect::<Vec<_>>(), visits.places_in(asr).collect::<Vec<_>>());
                }
            }
        }
    }
}
