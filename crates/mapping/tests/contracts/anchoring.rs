use cogmap_geometry::{Pose, Segment};
use cogmap_mapping::memory::{FrameId, StoredSurface, SurfaceId};
use proptest::prelude::*;

use crate::walk::any_walk;

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    /// §2.2.2: the preferred origin is the entrance of the space in which the robot is.
    #[test]
    fn seen_from_an_entrance_the_map_keeps_its_shape_and_stays_where_it_is(
        walk in any_walk(), x in -9.0f64..9.0, y in -9.0f64..9.0, heading in -3.1f64..3.1,
    ) {
        let mapper = walk.map(0.5).0;
        let mfis = mapper.memory().mfis();
        let before = mfis.surfaces().to_vec();
        let map_from_entrance = Pose::new(x, y, heading);
        let from_entrance: Vec<(SurfaceId, Segment)> = mfis.seen_from(FrameId(0), map_from_entrance).collect();
        prop_assert_eq!(from_entrance.len(), before.len());
        let origin = map_from_entrance.inverse() * map_from_entrance.position;
        prop_assert!(origin.length() < 1e-9);
        for ((id, here), stored) in from_entrance.iter().zip(&before) {
            prop_assert_eq!(*id, stored.id);
            prop_assert!((here.length() - stored.segment.length()).abs() < 1e-9);
        }
        for (first, second) in from_entrance.iter().zip(from_entrance.iter().skip(1)) {
            let (a, b) = (first.0.0 as usize, second.0.0 as usize);
            let apart = before[a].segment.a.distance(before[b].segment.b);
            prop_assert!((first.1.a.distance(second.1.b) - apart).abs() < 1e-9);
        }
        // Back in the map's own frame every coordinate is there again, bit by bit.
        prop_assert_eq!(bits(mfis.seen_from(FrameId(0), Pose::IDENTITY).map(|(_, segment)| segment)),
            bits(before.iter().map(|stored: &StoredSurface| stored.segment)));
        prop_assert_eq!(mfis.surfaces(), before.as_slice());
    }
}

fn bits(segments: impl Iterator<Item = Segment>) -> Vec<[u64; 4]> {
    segments.map(|Segment { a, b }| [a.x, a.y, b.x, b.y].map(f64::to_bits)).collect()
}
