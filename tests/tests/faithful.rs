//! Going home as the thesis's robot does (§3.3.5): its three experiments as they are told, and each flaw
//! that it reports. All with the bad robot and on development seeds.

mod trip;

use cogmap_geometry::DVec2;
use cogmap_navigation::{Act, HomingEvent, Mode};
use cogmap_simulation::Strategy;

use trip::{Moment, Trip, go, trip};

/// Three seeds; the counts on 1–99 stand at each test.
const SEEDS: std::ops::RangeInclusive<u64> = 1..=3;

fn trips(world: &'static str, mapper: &'static str) -> impl Iterator<Item = Trip> {
    SEEDS.map(move |seed| trip(world, mapper, seed, |_| {}))
}

/// E7 (Fig. 3.35): home round the corner, and not by the remembered route. 99 of 99.
#[test]
fn it_finds_home_around_a_corner_without_the_remembered_route() {
    for trip in trips("around-a-corner", "consensus") {
        assert!(trip.home_within(1.0), "{} m", trip.distance);
        assert_eq!((trip.route_steps().count(), trip.collisions), (0, 0));
        assert!(trip.way_home <= 1.5 * trip.shortest, "{} of {} m", trip.way_home, trip.shortest);
    }
}

/// E7 (Fig. 3.36–3.37): the side of the obstacle that was not seen makes a hole in memory, and the first
/// decision leads through it; a look shows the wall, before the robot has gone anywhere.
#[test]
fn its_first_step_heads_into_a_false_opening_until_it_looks() {
    for trip in trips("around-a-corner", "consensus") {
        let first = &trip.moments[0];
        assert_eq!(first.decision.mode, Mode::Direction);
        assert!(trip.blocked(&first.way()), "{:?}", first.way());
        let begun = trip.moments.iter().take_while(|moment| moment.here().distance(first.here()) < 0.5);
        let last = begun.last().unwrap();
        assert!(!trip.blocked(&last.way()), "{:?}", last.way());
    }
}

/// E7: "the robot will often drastically change its direction of travel".
#[test]
fn it_zigzags_where_a_straighter_way_would_do() {
    for seed in SEEDS {
        let oracle = go("around-a-corner", "consensus", seed, Strategy::named("oracle").unwrap());
        let trip = trip("around-a-corner", "consensus", seed, |_| {});
        let zigzag = trip.turned() / oracle.turned();
        assert!(zigzag > 1.05, "{zigzag}");
    }
}

/// E8 (Fig. 3.38): the shortcut through a door that it has never used, far shorter than the way out.
#[test]
fn it_takes_the_shortcut() {
    for mapper in ["consensus", "perceptual"] {
        for trip in trips("shortcut", mapper) {
            assert_eq!(trip.crossings([7.26, 2.4], [7.26, 3.6]), 1, "{mapper}");
            assert!(trip.way_home <= 0.4 * trip.way_out, "{mapper}: {} of {} m", trip.way_home, trip.way_out);
            assert!(trip.home_within(1.5), "{mapper}: {} m", trip.distance);
        }
    }
}

/// E8: where the map of the thesis's program is bent, home is displaced in it, and the robot stops there
/// in good faith. More than one metre in 11 of 99 seeds (seed 6 is the first).
#[test]
fn it_misses_home_by_a_metre_where_the_map_is_bent() {
    let trip = trip("shortcut", "perceptual", 6, |_| {});
    assert!(trip.home_offset() > 1.0, "{} m", trip.home_offset());
    assert_eq!(trip.moments.last().unwrap().decision.act, Act::Arrived);
    assert!(trip.distance > 0.5, "{} m", trip.distance);
}

/// Where the boxes of E9 stand.
fn among_the_boxes(moment: &Moment) -> bool {
    let DVec2 { x, .. } = moment.here();
    (10.7..=19.8).contains(&x)
}

/// E9 (Fig. 3.39–3.40): among the boxes the sense of direction finds no way on, the remembered route leads
/// out, and outside the sense of direction leads again, over the longer part of the way.
#[test]
fn the_remembered_route_rescues_it_from_the_boxes_and_is_left_behind_them() {
    for trip in trips("box-course", "consensus") {
        assert!(trip.home_within(1.0), "{} m", trip.distance);
        assert_eq!(trip.collisions, 0);
        let on = |event: &HomingEvent| matches!(event, HomingEvent::FailsafeOn { .. });
        let off = |event: &HomingEvent| matches!(event, HomingEvent::FailsafeOff { .. });
        assert!(trip.moments.iter().any(|moment| moment.told(on) && among_the_boxes(moment)));
        let left = trip.moments.iter().rposition(|moment| moment.told(off)).unwrap();
        assert!(trip.moments[left].here().x > 12.7 - 3.0, "{}", trip.moments[left].here());
        assert!(trip.moments[left..].iter().all(|moment| moment.decision.mode == Mode::Direction));
        let (all, there) = (trip.route_steps().count(), trip.route_steps().filter(|m| among_the_boxes(m)));
        assert!(there.count() * 10 >= all * 8);
    }
}

/// E9 without the fail-safe: it stays where it is.
#[test]
fn without_the_fail_safe_the_boxes_are_a_trap() {
    for seed in SEEDS {
        let trip = trip("box-course", "consensus", seed, |params| params.failsafe.on = false);
        assert_eq!(trip.moments.last().unwrap().decision.act, Act::Stuck);
        assert!(trip.distance > 10.0, "{} m", trip.distance);
    }
}

/// How often it went into the bay of the U-trap.
fn entries(trip: &Trip) -> usize {
    trip.crossings([8.3, 7.8], [8.3, 5.2])
}

/// Fig. 3.31–3.32 avoided: once the robot has turned away from a dead end it remembers it.
#[test]
fn it_does_not_go_into_a_dead_end_again_that_it_remembers() {
    for trip in trips("u-trap", "consensus") {
        assert!((1..=2).contains(&entries(&trip)), "{} entries", entries(&trip));
        assert!(trip.home_within(1.5), "{} m", trip.distance);
    }
}

/// Fig. 3.31–3.32: without that memory it forgets the end of the bay on the way out and turns back, over and over.
#[test]
fn without_memory_of_dead_ends_it_is_caught_in_an_endless_loop() {
    let trip = trip("u-trap", "consensus", 1, |params| params.dead_ends = false);
    assert!(entries(&trip) > 5, "{} entries", entries(&trip));
    assert_eq!(trip.moments.last().unwrap().decision.act, Act::Stuck);
}

/// Fig. 3.34: two doorways that the way out passed by are two shortcuts on the way home.
#[test]
fn it_takes_two_shortcuts_on_one_route() {
    for trip in trips("two-shortcuts", "consensus") {
        assert!(trip.crossings([6.8, 7.76], [5.4, 7.76]) >= 1);
        assert!(trip.crossings([10.0, 3.76], [8.6, 3.76]) >= 1);
        assert!(trip.way_home <= 0.5 * trip.way_out, "{} of {} m", trip.way_home, trip.way_out);
        assert!(trip.home_within(1.0), "{} m", trip.distance);
    }
}

/// §3.3.2: in narrow places there are one to three options, in wide ones many more.
#[test]
fn there_are_more_options_where_there_is_more_room() {
    let mean = |trip: &Trip, here: fn(&Moment) -> bool| {
        let counts = trip.moments.iter().filter(|moment| here(moment));
        let counts: Vec<f64> = counts.map(|moment| moment.decision.options.len() as f64).collect();
        counts.iter().sum::<f64>() / counts.len() as f64
    };
    let narrow = mean(&trip("box-course", "consensus", 1, |_| {}), among_the_boxes);
    let wide = mean(&trip("u-trap", "consensus", 1, |_| {}), |moment| moment.here().x < 7.9);
    assert!(narrow < 2.0 && wide > 2.0 * narrow, "{narrow} and {wide}");
}
