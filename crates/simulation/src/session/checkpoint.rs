use cogmap_mapping::Mapper;

use super::{Journal, feed::Feed, journal::Lengths};

/// More are thinned out to half as many, twice as far apart.
const MOST: usize = 64;

/// What the run looked like at some moments, so that going back need not begin at the beginning.
pub(super) struct Checkpoints {
    kept: Vec<Checkpoint>,
    interval: u64,
}

struct Checkpoint {
    feed: Feed,
    mappers: Vec<Mapper>,
    lengths: Lengths,
}

impl Checkpoints {
    pub(super) fn new(interval: u64) -> Self {
        Self { kept: Vec::new(), interval }
    }

    /// Keeps this moment if it is its turn and it is not kept yet.
    pub(super) fn keep(&mut self, feed: &Feed, mappers: &[Mapper], journal: &Journal) {
        let position = feed.position();
        let last = self.kept.last().map(|checkpoint| checkpoint.feed.position());
        if !position.is_multiple_of(self.interval) || last.is_some_and(|last| last >= position) {
            return;
        }
        let lengths = journal.lengths();
        self.kept.push(Checkpoint { feed: feed.clone(), mappers: mappers.to_vec(), lengths });
        if self.kept.len() > MOST {
            self.interval *= 2;
            let interval = self.interval;
            self.kept.retain(|checkpoint| checkpoint.feed.position().is_multiple_of(interval));
        }
    }

    /// The last moment at or before `position`; cuts the journal back to it.
    pub(super) fn restore(&self, position: u64, journal: &mut Journal) -> Option<(Feed, Vec<Mapper>)> {
        let kept = self.kept.iter().rev().find(|checkpoint| checkpoint.feed.position() <= position)?;
        journal.cut(&kept.lengths);
        Some((kept.feed.clone(), kept.mappers.clone()))
    }

    /// Drops what lies after `position`: it belongs to a run that will not be.
    pub(super) fn forget_after(&mut self, position: u64) {
        self.kept.retain(|checkpoint| checkpoint.feed.position() <= position);
    }
}
