use super::{Memory, SurfaceId};
use crate::places::{AsrId, Network};

/// The local spaces that the robot was in last, the current one first: the memory for one's immediate
/// surroundings reaches no farther (§2.2.2).
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct RecentSpaces {
    spaces: Vec<AsrId>,
}

impl RecentSpaces {
    /// Forgets what belongs to none of the last `limit` spaces; gives the names of what was forgotten.
    pub(super) fn limit(&mut self, memory: &mut Memory, network: &Network, limit: usize) -> Vec<SurfaceId> {
        let current = network.current();
        if self.spaces.first() == Some(&current) {
            return Vec::new();
        }
        // A space that turned out to be another one takes no place of its own.
        let exists = |asr: AsrId| network.asrs().iter().any(|known| known.id == asr);
        self.spaces.retain(|&asr| asr != current && exists(asr));
        self.spaces.insert(0, current);
        self.spaces.truncate(limit);
        let is_recent = |asr: Option<AsrId>| asr.is_none_or(|asr| self.spaces.contains(&asr));
        let old = memory.mfis().remembered().map(|stored| stored.id);
        let old: Vec<SurfaceId> = old.filter(|&id| !is_recent(network.asr_of(id))).collect();
        memory.forget(&old);
        old
    }
}
