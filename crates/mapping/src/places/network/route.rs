use std::collections::{BTreeMap, VecDeque};

use super::{AsrId, ExitId, Network};

impl Network {
    /// The exits to go through from one space to another, the fewest that lead there (Fig. 2.2, 2.3);
    /// empty where both are one, `None` where no way is known.
    #[must_use]
    pub fn route(&self, from: AsrId, to: AsrId) -> Option<Vec<ExitId>> {
        let (from, to) = (self.asr(from)?.id, self.asr(to)?.id);
        let mut reached: BTreeMap<AsrId, Option<(AsrId, ExitId)>> = BTreeMap::from([(from, None)]);
        let mut open = VecDeque::from([from]);
        while let Some(asr) = open.pop_front().filter(|asr| *asr != to) {
            for exit in self.asr(asr).iter().flat_map(|asr| &asr.exits).filter_map(|&id| self.exit(id)) {
                let Some(next) = exit.leads_from(asr) else { continue };
                reached.entry(next).or_insert_with(|| {
                    open.push_back(next);
                    Some((asr, exit.id))
                });
            }
        }
        let mut exits = Vec::new();
        let mut at = to;
        while let Some((before, exit)) = *reached.get(&at)? {
            exits.push(exit);
            at = before;
        }
        exits.reverse();
        Some(exits)
    }
}
