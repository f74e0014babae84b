use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};

use super::Rate;

/// A space that the robot came into, in order of time: which room it truly was, which ASR the robot took it for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Visit {
    /// Which room.
    pub room: u32,
    /// Which ASR, as the network has it in the end.
    pub asr: u32,
}

/// How well the robot knew whether it was back.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct LoopScore {
    /// Of the visits to rooms that it had been to, those that it linked to the ASR it had for that room.
    pub recall: Rate,
    /// Of the visits to rooms that it had not been to, those that it took for a place it knew.
    pub false_closures: Rate,
}

/// Goes through the visits and compares each with those before it.
#[must_use]
pub fn score_loops(visits: &[Visit]) -> LoopScore {
    let mut score = LoopScore::default();
    for (at, visit) in visits.iter().enumerate() {
        let earlier = &visits[..at];
        let known_room = earlier.iter().any(|other| other.room == visit.room);
        let known_asr = earlier.iter().any(|other| other.asr == visit.asr);
        if known_room {
            score.recall.count(earlier.contains(visit));
        } else {
            score.false_closures.count(known_asr);
        }
    }
    score
}

/// A graph of places: for each pair of neighbours, smaller name first, how many passages join them.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct PlaceGraph {
    /// The places.
    pub nodes: Vec<u32>,
    /// The passages.
    pub edges: BTreeMap<(u32, u32), u32>,
}

impl PlaceGraph {
    /// A graph of places and the passages between them, in any order.
    #[must_use]
    pub fn new(nodes: &[u32], passages: &[(u32, u32)]) -> Self {
        let mut edges = BTreeMap::new();
        for &(a, b) in passages {
            *edges.entry((a.min(b), a.max(b))).or_insert(0) += 1;
        }
        let mut nodes = nodes.to_vec();
        nodes.sort_unstable();
        nodes.dedup();
        Self { nodes, edges }
    }
}

/// How many nodes and passages must be added or taken away to make one graph of the other, when each ASR
/// stands for the room that `room_of` gives it. Two ASRs of one room are one too many, and the passage
/// between them too.
#[must_use]
pub fn network_edits(truth: &PlaceGraph, network: &PlaceGraph, room_of: &BTreeMap<u32, u32>) -> usize {
    // Of several ASRs of a room the first keeps its place; the others are surplus.
    let mut room_taken = Vec::new();
    let mut surplus = 0;
    for asr in &network.nodes {
        match room_of.get(asr).filter(|room| truth.nodes.contains(room)) {
            Some(room) if !room_taken.contains(room) => room_taken.push(*room),
            _ => surplus += 1,
        }
    }
    let missing = truth.nodes.iter().filter(|room| !room_taken.contains(room)).count();
    let named = |asr: u32| room_of.get(&asr).copied();
    let mut edges: BTreeMap<(u32, u32), u32> = BTreeMap::new();
    let mut stray = 0;
    for (&(a, b), &count) in &network.edges {
        match (named(a), named(b)) {
            (Some(a), Some(b)) if a != b => *edges.entry((a.min(b), a.max(b))).or_insert(0) += count,
            _ => stray += count as usize,
        }
    }
    let mut pairs: Vec<(u32, u32)> = truth.edges.keys().chain(edges.keys()).copied().collect();
    pairs.sort_unstable();
    pairs.dedup();
    let count = |edges: &BTreeMap<(u32, u32), u32>, pair| edges.get(pair).copied().unwrap_or(0);
    let passages: u32 =
        pairs.iter().map(|pair| count(&truth.edges, pair).abs_diff(count(&edges, pair))).sum();
    surplus + missing + stray + passages as usize
}

#[cfg(test)]
mod tests {
    use super::*;

    fn visits(pairs: &[(u32, u32)]) -> Vec<Visit> {
        pairs.iter().map(|&(room, asr)| Visit { room, asr }).collect()
    }

    #[test]
    fn a_loop_that_comes_back_to_the_first_space_is_found() {
        let score = score_loops(&visits(&[(0, 0), (1, 1), (2, 2), (0, 0)]));
        assert_eq!(score.recall, Rate { hits: 1, runs: 1 });
        assert_eq!(score.false_closures, Rate { hits: 0, runs: 3 });
    }

    #[test]
    fn a_loop_that_ends_in_a_new_space_is_missed() {
        assert_eq!(score_loops(&visits(&[(0, 0), (1, 1), (0, 2)])).recall, Rate { hits: 0, runs: 1 });
    }

    #[test]
    fn a_look_alike_that_is_taken_for_home_is_a_false_closure() {
        let score = score_loops(&visits(&[(0, 0), (1, 1), (2, 0)]));
        assert_eq!(score.false_closures, Rate { hits: 1, runs: 3 });
    }

    #[test]
    fn the_right_network_needs_no_edits_whatever_its_names() {
        let truth = PlaceGraph::new(&[0, 1, 2], &[(0, 1), (1, 2), (2, 0)]);
        let network = PlaceGraph::new(&[5, 6, 7], &[(5, 6), (6, 7), (5, 7)]);
        let room_of = BTreeMap::from([(5, 1), (6, 2), (7, 0)]);
        assert_eq!(network_edits(&truth, &network, &room_of), 0);
    }

    #[test]
    fn an_open_loop_is_one_node_too_many() {
        // Room 0 has two ASRs, 0 and 3; the passages are as many as they should be.
        let truth = PlaceGraph::new(&[0, 1, 2], &[(0, 1), (1, 2), (2, 0)]);
        let network = PlaceGraph::new(&[0, 1, 2, 3], &[(0, 1), (1, 2), (2, 3)]);
        let room_of = BTreeMap::from([(0, 0), (1, 1), (2, 2), (3, 0)]);
        assert_eq!(network_edits(&truth, &network, &room_of), 1);
    }

    #[test]
    fn a_missed_room_and_a_split_one_are_four_edits() {
        // Room 2 and its door are missing; room 0 is split in two, with an exit between the halves.
        let truth = PlaceGraph::new(&[0, 1, 2], &[(0, 1), (1, 2)]);
        let network = PlaceGraph::new(&[0, 1, 4], &[(0, 1), (0, 4)]);
        let room_of = BTreeMap::from([(0, 0), (1, 1), (4, 0)]);
        assert_eq!(network_edits(&truth, &network, &room_of), 4);
    }
}
