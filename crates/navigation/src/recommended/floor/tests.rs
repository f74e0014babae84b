use super::*;

fn spot(floor: &Floor, x: f64, y: f64) -> Spot {
    floor.spot(Cell::at(DVec2::new(x, y)))
}

/// A wall across at 2 m, seen so often from the origin.
fn wall_seen(floor: &mut Floor, times: u16) {
    let points: Vec<DVec2> = (-20..=20).map(|k| DVec2::new(2.0, f64::from(k) * 0.05)).collect();
    (0..times).for_each(|_| floor.see(Pose::IDENTITY, &points, 1));
}

#[test]
fn what_beams_hit_is_occupied_and_what_they_pass_is_free() {
    let mut floor = Floor::default();
    wall_seen(&mut floor, 2);
    assert!(spot(&floor, 2.05, 0.05).is_found());
    assert!(spot(&floor, 1.0, 0.0).is_known_free() && !spot(&floor, 1.0, 0.0).is_occupied());
    assert!(!spot(&floor, 3.0, 0.0).is_known_free(), "nobody has seen behind the wall");
}

#[test]
fn a_remembered_wall_goes_when_beams_cross_it_but_not_when_they_graze_it() {
    let across = Segment::new(DVec2::new(1.0, -0.5), DVec2::new(1.0, 0.5));
    let along = Segment::new(DVec2::new(0.5, 0.02), DVec2::new(1.5, 0.02));
    for (wall, stays) in [(across, false), (along, true)] {
        let mut floor = Floor::default();
        floor.remember_wall(wall);
        wall_seen(&mut floor, 5);
        assert_eq!(spot(&floor, 1.0, 0.02).is_occupied(), stays, "{wall:?}");
    }
}

#[test]
fn the_count_of_what_is_around_ends_where_it_began() {
    let mut floor = Floor::default();
    floor.remember_wall(Segment::new(DVec2::new(1.0, -0.5), DVec2::new(1.0, 0.5)));
    assert!(spot(&floor, 0.8, 0.0).crowd() > 0);
    wall_seen(&mut floor, 5);
    assert_eq!(spot(&floor, 0.8, 0.0).crowd(), 0);
}

#[test]
fn where_the_robot_went_no_wall_of_the_map_stands() {
    let mut floor = Floor::default();
    floor.travel(Segment::new(DVec2::ZERO, DVec2::X));
    floor.remember_wall(Segment::new(DVec2::new(0.5, -1.0), DVec2::new(0.5, 1.0)));
    assert!(spot(&floor, 0.5, 0.0).is_travelled() && !spot(&floor, 0.5, 0.0).is_occupied());
    assert!(spot(&floor, 0.5, 0.5).is_occupied());
}

#[test]
fn where_the_robot_did_not_fit_through_beams_change_nothing_but_its_own_way_does() {
    let mut floor = Floor::default();
    floor.block(DVec2::new(1.0, 0.02), 1);
    wall_seen(&mut floor, 9);
    assert!(spot(&floor, 1.0, 0.02).is_occupied() && !spot(&floor, 1.0, 0.02).is_found());
    floor.travel(Segment::new(DVec2::new(0.5, 0.0), DVec2::new(1.5, 0.0)));
    assert!(!spot(&floor, 1.0, 0.02).is_occupied());
}
