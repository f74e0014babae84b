//! What §3.2.2 and §3.2.3 say of exits, spaces and loops, in both forms.

mod rooms;

use cogmap_geometry::{DVec2, Pose, Segment, trig};
use cogmap_mapping::{
    Event, MapperSetup, StepReport,
    memory::{Mfis, StoredSurface},
    places::{AsrId, Network, Overlap, PlacesParams, outline},
};
use rooms::{Drive, polyline, ring, setups, two_rooms};

fn network(drive: &Drive) -> &Network {
    let Some(network) = drive.mapper.network() else { unreachable!("both mappers keep a network") };
    network
}

fn places_events(report: &StepReport) -> &[Event] {
    report.place.as_ref().map_or(&[], |place| &place.events)
}

/// From one room into the other, in steps of so many metres.
fn across(setup: &MapperSetup, step: f64) -> Drive {
    let mut drive = Drive::begin(&two_rooms(), Pose::new(1.0, 2.0, 0.0), setup);
    drive.go_to([9.0, 2.0], step);
    drive
}

/// Where an exit lies in the world; the map's frame is where the robot began.
fn exit_in_world(drive: &Drive, index: usize) -> Segment {
    let exit = network(drive).exits()[index];
    drive.truth[0] * drive.mapper.mfis().map_from_frame(exit.frame) * exit.segment
}

#[test]
fn fig_3_13_a_narrow_passage_makes_two_spaces() {
    for setup in setups(None) {
        for step in [0.1, 0.2, 0.5, 1.0] {
            let drive = across(&setup, step);
            let network = network(&drive);
            assert_eq!(network.asrs().len(), 2, "{} in steps of {step} m", setup.name());
            assert_eq!(network.exits().len(), 1);
            assert_eq!(network.exits()[0].between, [AsrId(0), AsrId(1)]);
            let off = exit_in_world(&drive, 0).midpoint().distance(DVec2::new(5.05, 2.0));
            assert!(off < 0.2, "the exit is {off} m off with {} in steps of {step} m", setup.name());
        }
    }
}

#[test]
fn fig_3_13_without_a_narrow_passage_there_is_one_space() {
    let l_shape =
        polyline(&[[0.0, 0.0], [8.0, 0.0], [8.0, 7.0], [5.0, 7.0], [5.0, 4.0], [0.0, 4.0], [0.0, 0.0]]);
    let milder = polyline(&[
        [0.0, 0.0],
        [5.0, 0.0],
        [5.0, 0.6],
        [10.0, 0.6],
        [10.0, 4.0],
        [5.0, 4.0],
        [5.0, 4.4],
        [0.0, 4.4],
        [0.0, 0.0],
    ]);
    for setup in setups(None) {
        let mut drive = Drive::begin(&l_shape, Pose::new(1.0, 2.0, 0.0), &setup);
        drive.go_to([6.5, 2.0], 0.5);
        drive.go_to([6.5, 6.0], 0.5);
        assert_eq!(network(&drive).asrs().len(), 1, "{} in an L", setup.name());
        let mut drive = Drive::begin(&milder, Pose::new(1.0, 2.0, 0.0), &setup);
        drive.go_to([9.0, 2.2], 0.5);
        assert_eq!(network(&drive).asrs().len(), 1, "{} where the width changes mildly", setup.name());
    }
}

#[test]
fn fig_3_14_wide_narrow_wide_has_its_one_minimum_at_the_passage() {
    for setup in setups(None) {
        let drive = across(&setup, 0.5);
        let curve: Vec<_> =
            drive.reports.iter().flat_map(|report| report.place.as_ref().unwrap().wideness.clone()).collect();
        assert!(curve.len() > 70);
        let narrow: Vec<_> = curve.iter().filter(|wideness| wideness.width < 1.5).collect();
        assert!(!narrow.is_empty());
        for wideness in narrow {
            assert!((wideness.way - 4.05).abs() < 0.8, "{wideness:?} with {}", setup.name());
        }
        let least = curve.iter().map(|wideness| wideness.width).fold(f64::INFINITY, f64::min);
        assert!((least - 0.9).abs() < 0.1);
    }
}

#[test]
fn an_exit_is_known_only_after_it_has_been_crossed() {
    for setup in setups(None) {
        for step in [0.2, 0.5, 1.0] {
            let drive = across(&setup, step);
            let exit = network(&drive).exits()[0];
            assert!(exit.step > exit.crossed);
            assert!(drive.truth[exit.crossed].position.x < 5.3);
            let told = drive.truth[exit.step].position.x;
            assert!(told > 5.1 && told <= 5.05 + 3.0, "told at {told} in steps of {step} m");
            for report in &drive.reports[..exit.step] {
                assert!(places_events(report).is_empty());
            }
        }
    }
}

#[test]
fn every_surface_belongs_to_exactly_one_asr() {
    for setup in setups(None) {
        let drive = around(&setup);
        let (network, mfis) = (network(&drive), drive.mapper.mfis());
        for surface in mfis.surfaces() {
            let asr = network.asr_of(surface.id).expect("every surface belongs to a space");
            let holders =
                network.asrs().iter().filter(|asr| network.surfaces_of(asr.id).contains(&surface.id));
            assert_eq!(holders.map(|asr| asr.id).collect::<Vec<_>>(), [asr]);
        }
        let held: usize = network.asrs().iter().map(|asr| network.surfaces_of(asr.id).len()).sum();
        assert_eq!(held, mfis.surfaces().len());
    }
}

#[test]
fn surfaces_seen_through_the_exit_go_to_the_space_behind_it() {
    for setup in setups(None) {
        let drive = across(&setup, 0.5);
        for surface in drive.mapper.mfis().surfaces() {
            let in_world = drive.truth[0] * drive.mapper.mfis().in_map(surface);
            let behind = in_world.a.x.min(in_world.b.x) > 5.3;
            if behind {
                assert_eq!(network(&drive).asr_of(surface.id), Some(AsrId(1)), "{in_world:?}");
            }
        }
    }
}

#[test]
fn a_known_exit_leads_back_into_the_known_space() {
    for setup in setups(None) {
        let mut drive = across(&setup, 0.5);
        drive.go_to([1.0, 2.0], 0.5);
        assert_eq!(network(&drive).current(), AsrId(0), "{}", setup.name());
        drive.go_to([9.0, 2.0], 0.5);
        assert_eq!(network(&drive).current(), AsrId(1));
        assert_eq!((network(&drive).asrs().len(), network(&drive).exits().len()), (2, 1));
        let crossed: Vec<AsrId> = network(&drive).crossings().iter().map(|crossing| crossing.into).collect();
        assert_eq!(crossed, [AsrId(1), AsrId(0), AsrId(1)]);
    }
}

/// Round the ring and a little on.
fn around(setup: &MapperSetup) -> Drive {
    let mut drive = Drive::begin(&ring(), Pose::new(-4.0, -2.0, 0.0), setup);
    for point in [[2.0, -2.0], [2.0, 2.0], [-2.0, 2.0], [-2.0, -2.0], [-3.4, -3.0]] {
        drive.go_to(point, 0.5);
    }
    drive
}

#[test]
fn a_loop_ends_in_the_space_that_it_began_in() {
    let [_, consensus] = setups(None);
    let drive = around(&consensus);
    let network = network(&drive);
    assert_eq!((network.current(), network.asrs().len()), (AsrId(0), 4));
    assert!(drive.reports.iter().flat_map(places_events).any(|e| matches!(e, Event::LoopClosed { .. })));
    assert_eq!(network.asr_at(0), network.asr_at(drive.reports.len() - 1));
    assert_eq!(network.route(AsrId(0), AsrId(3)).unwrap().len(), 1);
}

#[test]
fn closing_a_loop_leaves_the_mfis_bit_identical() {
    for form in [PlacesParams::literal(), PlacesParams::recommended()] {
        let mut never = form;
        never.overlap = Overlap { share: 2.0, ..Overlap::default() };
        never.familiarity.known = 2.0;
        for (closing, open) in setups(Some(form)).iter().zip(&setups(Some(never))) {
            let (closed, left_open) = (around(closing), around(open));
            assert!(network(&closed).asrs().len() < network(&left_open).asrs().len());
            assert_eq!(bits(closed.mapper.mfis()), bits(left_open.mapper.mfis()));
        }
    }
}

fn bits(mfis: &Mfis) -> Vec<[u64; 4]> {
    let of = |s: &StoredSurface| {
        let Segment { a, b } = s.segment;
        [a.x, a.y, b.x, b.y].map(f64::to_bits)
    };
    mfis.surfaces().iter().map(of).collect()
}

#[test]
fn turning_on_the_spot_is_no_way() {
    for setup in setups(None) {
        let mut drive = Drive::begin(&two_rooms(), Pose::new(5.05, 2.0, 0.0), &setup);
        for _ in 0..12 {
            drive.turn(trig::PI / 6.0);
        }
        assert_eq!(network(&drive).asrs().len(), 1);
        assert!(drive.reports.iter().all(|report| report.place.as_ref().unwrap().wideness.is_empty()));
    }
}

#[test]
fn who_turns_back_in_the_doorway_has_left_no_room() {
    for setup in setups(None) {
        let mut drive = Drive::begin(&two_rooms(), Pose::new(1.0, 2.0, 0.0), &setup);
        for _ in 0..4 {
            drive.go_to([5.2, 2.0], 0.2);
            drive.go_to([4.2, 2.0], 0.2);
        }
        assert_eq!(network(&drive).current(), AsrId(0), "{}", setup.name());
        assert!(network(&drive).exits().is_empty());
        drive.go_to([8.0, 2.0], 0.2);
        assert_eq!((network(&drive).asrs().len(), network(&drive).current()), (2, AsrId(1)));
    }
}

#[test]
fn driving_to_and_fro_through_a_door_finds_it_once() {
    for setup in setups(None) {
        let mut drive = Drive::begin(&two_rooms(), Pose::new(1.0, 2.0, 0.0), &setup);
        for _ in 0..3 {
            drive.go_to([6.5, 2.0], 0.2);
            drive.go_to([3.5, 2.0], 0.2);
        }
        assert_eq!((network(&drive).asrs().len(), network(&drive).exits().len()), (2, 1), "{}", setup.name());
        assert_eq!(network(&drive).current(), AsrId(0));
    }
}

#[test]
fn where_nothing_is_seen_there_is_one_space_and_no_exit() {
    for setup in setups(None) {
        let mut drive = Drive::begin(&[], Pose::IDENTITY, &setup);
        drive.go_to([6.0, 0.0], 0.5);
        assert_eq!(network(&drive).asrs().len(), 1);
        assert!(network(&drive).surfaces_of(AsrId(0)).is_empty());
        for wideness in drive.reports.iter().flat_map(|report| &report.place.as_ref().unwrap().wideness) {
            assert!((wideness.width - 16.0).abs() < 1e-9, "as far as the laser sees");
        }
    }
}

#[test]
fn a_door_is_seen_ahead_and_confirmed_by_crossing() {
    let [literal, recommended] = setups(None);
    assert!(network(&across(&literal, 0.5)).hypotheses().is_empty());
    let drive = across(&recommended, 0.5);
    let exit = network(&drive).exits()[0];
    let door = network(&drive).hypotheses().iter().find(|seen| seen.confirmed == Some(exit.id));
    assert!(door.is_some_and(|seen| seen.step < exit.crossed));
}

#[test]
fn an_entrance_lies_in_its_exit_and_looks_into_the_space() {
    for setup in setups(None) {
        let drive = across(&setup, 0.5);
        let entered = network(&drive).asr(AsrId(1)).unwrap();
        let map_from_entrance =
            drive.mapper.mfis().map_from_frame(entered.frame) * entered.frame_from_entrance;
        let in_world = drive.truth[0] * map_from_entrance;
        assert!(in_world.position.distance(DVec2::new(5.05, 2.0)) < 0.2);
        assert!(in_world.forward().dot(DVec2::X) > 0.98);
        let outline = outline(entered, network(&drive), drive.mapper.memory());
        assert!(outline.len() >= 3);
    }
}
