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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{memory::FrameId, places::Exit};
    use cogmap_geometry::{DVec2, Pose, Segment};

    fn exit(between: [AsrId; 2], middle: [f64; 2]) -> Exit {
        let middle = DVec2::from(middle);
        Exit {
            id: ExitId(0),
            frame: FrameId(0),
            segment: Segment::new(middle - DVec2::Y * 0.45, middle + DVec2::Y * 0.45),
            between,
            step: 0,
            crossed: 0,
            jambs: 2,
        }
    }

    /// A hall, 0, with exits to three rooms, 1 to 3; room 1 has a closet, 4.
    fn hall() -> (Network, Vec<ExitId>) {
        let mut network = Network::default();
        for step in 1..=4 {
            network.open((FrameId(0), Pose::IDENTITY), step);
        }
        let doors = [(0, 1, [0.0, 2.0]), (0, 2, [6.0, 2.0]), (0, 3, [3.0, 4.0]), (1, 4, [-4.0, 2.0])];
        let exits = doors.map(|(a, b, middle)| network.add_exit(exit([AsrId(a), AsrId(b)], middle)));
        (network, exits.to_vec())
    }

    #[test]
    fn a_route_through_a_room_with_three_exits_picks_the_correct_one() {
        let (network, exits) = hall();
        assert_eq!(network.route(AsrId(1), AsrId(3)), Some(vec![exits[0], exits[2]]));
        assert_eq!(network.route(AsrId(2), AsrId(4)), Some(vec![exits[1], exits[0], exits[3]]));
        let way_out = network.exit(exits[2]).unwrap().segment.midpoint();
        assert_eq!(way_out, DVec2::new(3.0, 4.0));
    }

    #[test]
    fn the_way_to_where_one_is_needs_no_exit() {
        assert_eq!(hall().0.route(AsrId(2), AsrId(2)), Some(Vec::new()));
    }

    #[test]
    fn there_is_no_way_to_an_unknown_space() {
        assert_eq!(hall().0.route(AsrId(0), AsrId(9)), None);
    }

    #[test]
    fn a_space_that_turned_out_to_be_another_is_found_under_both_names() {
        let (mut network, exits) = hall();
        network.merge(AsrId(4), AsrId(2));
        assert_eq!(network.route(AsrId(3), AsrId(4)), Some(vec![exits[2], exits[1]]));
        assert_eq!(network.asr(AsrId(4)).unwrap().merged_from, [AsrId(4)]);
        assert_eq!(network.exit(exits[3]).unwrap().between, [AsrId(1), AsrId(2)]);
    }
}
