use super::{AsrId, ExitId, Network};

impl Network {
    /// Makes one space of two: the surfaces, exits and views of the newer one go over to the older.
    pub(in crate::places) fn merge(&mut self, newer: AsrId, older: AsrId) {
        let Some(place) = self.asrs.iter().position(|asr| asr.id == newer) else { return };
        if newer == older {
            return;
        }
        let gone = self.asrs.remove(place);
        for surface in self.surfaces_of.remove(&newer).unwrap_or_default() {
            self.assign(surface, older);
        }
        self.visits.merge(newer, older);
        let sides = self.exits.iter_mut().flat_map(|exit| &mut exit.between);
        let crossed = self.crossings.iter_mut().map(|crossing| &mut crossing.into);
        for side in sides.chain(crossed).filter(|side| **side == newer) {
            *side = older;
        }
        if let Some(asr) = self.asrs.iter_mut().find(|asr| asr.id == older) {
            asr.merged_from.push(newer);
            asr.merged_from.extend(gone.merged_from);
            asr.exits.extend(gone.exits);
            asr.exits.sort_unstable();
            asr.exits.dedup();
        }
        for lasting in self.lasting.values_mut().filter(|lasting| **lasting == newer) {
            *lasting = older;
        }
        self.lasting.insert(newer, older);
        if self.current == newer {
            self.current = older;
        }
    }

    /// Makes one exit of two: the newer one turned out to be the older.
    pub(in crate::places) fn merge_exits(&mut self, newer: ExitId, older: ExitId) {
        if newer == older {
            return;
        }
        self.exits.retain(|exit| exit.id != newer);
        for asr in &mut self.asrs {
            asr.exits.retain(|exit| *exit != newer);
        }
        for crossing in self.crossings.iter_mut().filter(|crossing| crossing.exit == newer) {
            crossing.exit = older;
        }
        for confirmed in self.hypotheses.iter_mut().filter_map(|h| h.confirmed.as_mut()) {
            if *confirmed == newer {
                *confirmed = older;
            }
        }
        for same in self.same_exit.values_mut().filter(|same| **same == newer) {
            *same = older;
        }
        self.same_exit.insert(newer, older);
    }
}
