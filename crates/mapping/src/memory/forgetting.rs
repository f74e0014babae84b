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
        let exists = |asr: AsrId| network.asrs().iter().any(|known| known.id == asr);
        if !self.enter(network.current(), exists, limit) {
            return Vec::new();
        }
        let old = memory.mfis().remembered().map(|stored| stored.id);
        let old: Vec<SurfaceId> =
            old.filter(|&id| network.asr_of(id).is_some_and(|asr| !self.spaces.contains(&asr))).collect();
        memory.forget(&old);
        old
    }

    /// Whether the robot has gone over to another space. One that turned out to be another one, and no
    /// longer exists, takes no place of its own.
    fn enter(&mut self, current: AsrId, exists: impl Fn(AsrId) -> bool, limit: usize) -> bool {
        if self.spaces.first() == Some(&current) {
            return false;
        }
        self.spaces.retain(|&asr| asr != current && exists(asr));
        self.spaces.insert(0, current);
        self.spaces.truncate(limit);
        true
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_last_few_spaces_are_kept_whatever_the_way_through_them() {
        let mut recent = RecentSpaces::default();
        let mut visit = |space: u32, gone: &[u32]| {
            let changed = recent.enter(AsrId(space), |asr| !gone.contains(&asr.0), 3);
            (changed, recent.spaces.iter().map(|asr| asr.0).collect::<Vec<u32>>())
        };
        assert_eq!(visit(0, &[]), (true, vec![0]));
        assert_eq!(visit(0, &[]), (false, vec![0]));
        visit(1, &[]);
        assert_eq!(visit(0, &[]), (true, vec![0, 1]));
        visit(2, &[]);
        assert_eq!(visit(3, &[]), (true, vec![3, 2, 0]));
        // Space 3 was space 1 all along.
        assert_eq!(visit(1, &[3]), (true, vec![1, 2, 0]));
    }
}
