use super::{Journal, Live, journal::Lengths};

/// More are thinned out to half as many, twice as far apart.
const MOST: usize = 64;

/// What the run looked like at some moments, so that going back need not begin at the beginning.
pub(super) struct Checkpoints {
    kept: Vec<Checkpoint>,
    interval: u64,
}

struct Checkpoint {
    live: Live,
    lengths: Lengths,
}

impl Checkpoints {
    pub(super) fn new(interval: u64) -> Self {
        Self { kept: Vec::new(), interval }
    }

    /// Keeps this moment if it is its turn and it is not kept yet.
    pub(super) fn keep(&mut self, live: &Live, journal: &Journal) {
        let position = live.feed.position();
        let last = self.kept.last().map(|checkpoint| checkpoint.live.feed.position());
        if !position.is_multiple_of(self.interval) || last.is_some_and(|last| last >= position) {
            return;
        }
        self.kept.push(Checkpoint { live: live.clone(), lengths: journal.lengths() });
        if self.kept.len() > MOST {
            self.interval *= 2;
            let interval = self.interval;
            self.kept.retain(|checkpoint| checkpoint.live.feed.position().is_multiple_of(interval));
        }
    }

    /// The last moment at or before `position`; cuts the journal back to it.
    pub(super) fn restore(&self, position: u64, journal: &mut Journal) -> Option<Live> {
        let kept = self.kept.iter().rev().find(|checkpoint| checkpoint.live.feed.position() <= position)?;
        journal.cut(&kept.lengths);
        Some(kept.live.clone())
    }

    /// Drops what lies after `position`: it belongs to a run that will not be.
    pub(super) fn forget_after(&mut self, position: u64) {
        self.kept.retain(|checkpoint| checkpoint.live.feed.position() <= position);
    }
}
