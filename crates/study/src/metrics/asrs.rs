use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};

/// A piece of what was mapped, with the room that it truly belongs to and the space that the robot gave
/// it to. Its size is metres for surfaces, and 1 for the cells that were visited.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Labelled {
    /// Which room; any numbering.
    pub room: u32,
    /// Which ASR.
    pub asr: u32,
    /// How much it counts.
    pub size: f64,
}

/// How well a division into spaces agrees with the rooms.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Division {
    /// The share that lies in the room that most of its space lies in.
    pub purity: f64,
    /// The mean over rooms of the largest share that one space holds of it (Bormann's recall).
    pub recall: f64,
    /// The mean over spaces of the largest share that one room holds of it (Bormann's precision).
    pub precision: f64,
    /// Rooms and spaces paired one to one where intersection over union is at least a half: F1 of the pairs.
    pub f1: f64,
    /// Adjusted Rand index over the pieces: 1 for the same division, about 0 for a random one.
    pub adjusted_rand: f64,
    /// Rooms among the pieces.
    pub rooms: usize,
    /// Spaces among the pieces.
    pub asrs: usize,
}

/// How much lies in which room and which space.
#[derive(Default)]
struct Table {
    both: BTreeMap<(u32, u32), f64>,
    rooms: BTreeMap<u32, f64>,
    asrs: BTreeMap<u32, f64>,
    total: f64,
}

/// Compares the division with the rooms; `None` of nothing.
#[must_use]
pub fn score_division(pieces: &[Labelled]) -> Option<Division> {
    let mut table = Table::default();
    for &Labelled { room, asr, size } in pieces {
        *table.both.entry((room, asr)).or_insert(0.0) += size;
        *table.rooms.entry(room).or_insert(0.0) += size;
        *table.asrs.entry(asr).or_insert(0.0) += size;
        table.total += size;
    }
    (table.total > 0.0).then(|| Division {
        purity: table.asrs.keys().map(|&asr| table.most_of_asr(asr)).sum::<f64>() / table.total,
        recall: mean(table.rooms.iter().map(|(&room, size)| table.most_of_room(room) / size)),
        precision: mean(table.asrs.iter().map(|(&asr, size)| table.most_of_asr(asr) / size)),
        f1: table.f1(),
        adjusted_rand: table.adjusted_rand(),
        rooms: table.rooms.len(),
        asrs: table.asrs.len(),
    })
}

impl Table {
    fn most_of_room(&self, room: u32) -> f64 {
        self.both.iter().filter(|((r, _), _)| *r == room).map(|(_, &size)| size).fold(0.0, f64::max)
    }

    fn most_of_asr(&self, asr: u32) -> f64 {
        self.both.iter().filter(|((_, a), _)| *a == asr).map(|(_, &size)| size).fold(0.0, f64::max)
    }

    /// More than half of a union cannot belong to two pairs, so no pairing has to be sought; exact halves
    /// are given to the first.
    #[allow(clippy::cast_precision_loss, reason = "a building has a few hundred rooms")]
    fn f1(&self) -> f64 {
        let (mut rooms, mut asrs) = (Vec::new(), Vec::new());
        for (&(room, asr), &size) in &self.both {
            let union = self.rooms[&room] + self.asrs[&asr] - size;
            if size >= 0.5 * union && !rooms.contains(&room) && !asrs.contains(&asr) {
                rooms.push(room);
                asrs.push(asr);
            }
        }
        2.0 * rooms.len() as f64 / (self.rooms.len() + self.asrs.len()) as f64
    }

    /// Hubert and Arabie's index, with sizes in the place of counts.
    fn adjusted_rand(&self) -> f64 {
        let pairs = |sizes: &mut dyn Iterator<Item = f64>| sizes.map(|n| n * (n - 1.0) / 2.0).sum::<f64>();
        let both = pairs(&mut self.both.values().copied());
        let rooms = pairs(&mut self.rooms.values().copied());
        let asrs = pairs(&mut self.asrs.values().copied());
        let all = self.total * (self.total - 1.0) / 2.0;
        let (expected, most) = (rooms * asrs / all, f64::midpoint(rooms, asrs));
        if (most - expected).abs() < 1e-12 { 1.0 } else { (both - expected) / (most - expected) }
    }
}

#[allow(clippy::cast_precision_loss, reason = "a building has a few hundred rooms")]
fn mean(values: impl ExactSizeIterator<Item = f64>) -> f64 {
    let count = values.len() as f64;
    values.sum::<f64>() / count
}

#[cfg(test)]
mod tests {
    use super::*;

    fn pieces(counts: &[(u32, u32, usize)]) -> Vec<Labelled> {
        let of = |&(room, asr, count): &(u32, u32, usize)| vec![Labelled { room, asr, size: 1.0 }; count];
        counts.iter().flat_map(of).collect()
    }

    #[test]
    fn the_same_division_under_other_names_is_perfect() {
        let score = score_division(&pieces(&[(0, 7, 4), (1, 3, 6)])).unwrap();
        assert_eq!((score.purity, score.recall, score.precision), (1.0, 1.0, 1.0));
        assert_eq!((score.f1, score.adjusted_rand), (1.0, 1.0));
    }

    #[test]
    fn a_room_split_in_two_loses_recall_and_not_precision() {
        // Room 0 of 10 cells is split 6 : 4; room 1 of 10 is whole.
        let score = score_division(&pieces(&[(0, 0, 6), (0, 1, 4), (1, 2, 10)])).unwrap();
        assert!((score.recall - 0.8).abs() < 1e-12);
        assert_eq!((score.precision, score.purity), (1.0, 1.0));
        // 6/10 and 10/10 pair up: 2 · 2 of 2 rooms and 3 spaces.
        assert!((score.f1 - 0.8).abs() < 1e-12);
        // Pairs: both 15 + 6 + 45 = 66, rooms 90, spaces 66, all 190.
        let expected = 90.0 * 66.0 / 190.0;
        assert!((score.adjusted_rand - (66.0 - expected) / (78.0 - expected)).abs() < 1e-12);
        assert_eq!((score.rooms, score.asrs), (2, 3));
    }

    #[test]
    fn two_rooms_in_one_space_lose_precision_and_purity() {
        let score = score_division(&pieces(&[(0, 0, 3), (1, 0, 1)])).unwrap();
        assert_eq!((score.recall, score.precision, score.purity), (1.0, 0.75, 0.75));
        assert!((score.f1 - 2.0 / 3.0).abs() < 1e-12);
    }

    #[test]
    fn purity_weighs_surfaces_by_their_length() {
        let wall = |room, size| Labelled { room, asr: 0, size };
        let score = score_division(&[wall(0, 9.0), wall(1, 0.5), wall(1, 0.5)]).unwrap();
        assert!((score.purity - 0.9).abs() < 1e-12);
    }

    #[test]
    fn nothing_has_no_score() {
        assert_eq!(score_division(&[]), None);
    }
}
