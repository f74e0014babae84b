use std::num::NonZeroU32;

use cogmap_geometry::{DVec2, Pose, Segment};
use cogmap_mapping::{Event, Mapper, MapperSetup, memory::PerceptualParams, places::AsrId};
use rand_core::SeedableRng;
use rand_pcg::Pcg64Mcg;

use crate::{
    sampled::{Laser, reading},
    walk::{along, bad_odometry},
};

/// Five rooms of 5 m by 5 m in a row, a door of 0.9 m from each to the next.
fn row_of_rooms() -> Vec<Segment> {
    let at = |x: f64, y: f64| DVec2::new(x, y);
    let mut walls = vec![
        Segment::new(at(0.0, 0.0), at(25.0, 0.0)),
        Segment::new(at(25.0, 0.0), at(25.0, 5.0)),
        Segment::new(at(25.0, 5.0), at(0.0, 5.0)),
        Segment::new(at(0.0, 5.0), at(0.0, 0.0)),
    ];
    for x in [5.0, 10.0, 15.0, 20.0] {
        for (y, end) in [(0.0, 2.0), (2.9, 5.0)] {
            walls.extend([
                Segment::new(at(x - 0.1, y), at(x - 0.1, end)),
                Segment::new(at(x + 0.1, y), at(x + 0.1, end)),
            ]);
        }
        walls.extend([2.0, 2.9].map(|y| Segment::new(at(x - 0.1, y), at(x + 0.1, y))));
    }
    walls
}

#[test]
fn only_the_last_few_spaces_are_remembered_and_no_name_is_given_twice() {
    let walls = row_of_rooms();
    let laser = Laser { walls: &walls, range_max: 8.0, noise: 0.003 };
    for limit in [1, 2, 3] {
        let mut rng = Pcg64Mcg::seed_from_u64(u64::from(limit));
        let poses: Vec<Pose> = along(&[[1.0, 2.45], [24.0, 2.45]], 0.7);
        let odometry = bad_odometry(&poses, 1.0, &mut rng);
        let spaces = NonZeroU32::new(limit);
        let setup = MapperSetup::Perceptual(PerceptualParams { spaces, ..PerceptualParams::default() });
        let mut mapper = Mapper::new(&setup, 1);
        let mut visited: Vec<AsrId> = Vec::new();
        for (&pose, &odom_from_robot) in poses.iter().zip(&odometry) {
            let before = mapper.mfis().clone();
            let report = mapper.observe(&reading(laser.scan(pose, &mut rng).0, odom_from_robot)).unwrap();
            let (mfis, network) = (mapper.mfis(), mapper.network().unwrap());
            assert!(report.matches.iter().all(|m| before.remembers(m.known)));
            assert!(report.forgot.iter().all(|&id| before.remembers(id) || report.placed.contains(&id)));
            assert_eq!(mfis.surfaces().len(), before.surfaces().len() + report.placed.len());
            if visited.last() != Some(&network.current()) {
                visited.push(network.current());
            }
            let recent = &visited[visited.len().saturating_sub(limit as usize)..];
            let belongs = |asr: Option<AsrId>| asr.is_none_or(|asr| recent.contains(&asr));
            assert!(mfis.remembered().all(|stored| belongs(network.asr_of(stored.id))));
            for &id in &report.forgot {
                assert!(!mfis.remembers(id) && mfis.forgotten_in(id) == Some(report.step));
            }
            let told =
                |event: &Event| matches!(event, Event::Forgot { surfaces } if *surfaces == report.forgot);
            assert_eq!(report.events().iter().any(told), !report.forgot.is_empty());
        }
        let forgotten = mapper.mfis().surfaces().len() - mapper.mfis().remembered().count();
        assert_eq!(forgotten > 0, visited.len() > limit as usize, "{visited:?}");
    }
}
