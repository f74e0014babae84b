use cogmap_geometry::Segment;

use super::{
    super::{
        floor::Floor,
        footing::{Footing, Trust},
    },
    *,
};

/// A wall from y = -3 to 3 at x = 3, with a gap of a width around y = 2.
fn floor(gap: f64) -> Floor {
    let mut floor = Floor::default();
    let wall = |from: f64, to: f64| Segment::new(DVec2::new(3.0, from), DVec2::new(3.0, to));
    floor.remember_wall(wall(-3.0, 2.0 - gap / 2.0));
    floor.remember_wall(wall(2.0 + gap / 2.0, 3.0));
    floor
}

fn ease<'a>(floor: &'a Floor, footing: &'a Footing) -> Ease<'a> {
    Ease { floor, footing, trust: Trust::Memory, robot: Cell::at(DVec2::ZERO), moment: 1 }
}

fn way(floor: &Floor, home: DVec2) -> (f64, Vec<DVec2>) {
    let footing = Footing { near: 20.0, ..Footing::default() };
    let mut search = Search::new(ease(floor, &footing), home);
    let cells = search.way(true).unwrap();
    let points: Vec<DVec2> = cells.into_iter().skip(1).map(Cell::middle).collect();
    let corners = search.pull_tight(DVec2::ZERO, &points);
    (search.cost(DVec2::ZERO, &corners).unwrap(), corners)
}

#[test]
fn the_way_leads_through_a_gap_that_the_robot_fits_through_and_round_one_that_it_does_not() {
    let home = DVec2::new(6.0, 0.0);
    let through = |corners: &[DVec2]| corners.iter().any(|corner| (corner.y - 2.0).abs() < 0.3);
    assert!(through(&way(&floor(0.9), home).1));
    let (_, corners) = way(&floor(0.4), home);
    assert!(corners.iter().any(|corner| corner.y.abs() > 3.0), "{corners:?}");
}

#[test]
fn in_the_open_the_way_is_straight_and_costs_what_was_never_seen_costs() {
    let (cost, corners) = way(&Floor::default(), DVec2::new(5.0, 1.3));
    assert_eq!(corners.len(), 1, "{corners:?}");
    assert!((cost - Footing::default().unknown * 5.0).abs() < 0.6, "{cost}");
}

#[test]
fn a_way_far_longer_than_the_lines_that_it_is_pulled_tight_by_has_no_corner_too_many() {
    let mut floor = Floor::default();
    floor.travel(Segment::new(DVec2::ZERO, DVec2::new(40.0, 13.0)));
    let (_, corners) = way(&floor, DVec2::new(40.0, 13.0));
    assert_eq!(corners.len(), 1, "{corners:?}");
}

#[test]
fn a_wall_that_is_far_leaves_a_barrier_and_one_that_is_near_is_closed() {
    let floor = floor(0.0);
    let [near, far] = [20.0, 1.0].map(|near| {
        let footing = Footing { near, ..Footing::default() };
        let mut search = Search::new(ease(&floor, &footing), DVec2::new(6.0, 0.0));
        search.line(DVec2::ZERO, DVec2::new(6.0, 0.0))
    });
    assert_eq!(near, None);
    assert!(far.unwrap() > 50.0);
}

#[test]
fn a_home_inside_a_wall_is_come_near_to() {
    let mut floor = Floor::default();
    let corners = [[4.5, -0.5], [5.5, -0.5], [5.5, 0.5], [4.5, 0.5], [4.5, -0.5]].map(DVec2::from);
    corners.windows(2).for_each(|pair| floor.remember_wall(Segment::new(pair[0], pair[1])));
    let (_, corners) = way(&floor, DVec2::new(5.0, 0.0));
    let missing = corners.last().unwrap().distance(DVec2::new(5.0, 0.0));
    assert!(missing > 0.5 && missing <= NEAR_HOME, "{missing}");
}

/// A hall full of pillars with one door, on the side away from a home behind the opposite wall.
fn pillared_hall() -> Floor {
    let mut floor = Floor::default();
    let mut wall = |a: [f64; 2], b: [f64; 2]| floor.remember_wall(Segment::new(a.into(), b.into()));
    wall([3.0, -15.0], [3.0, 15.0]);
    wall([3.0, 15.0], [-27.0, 15.0]);
    wall([3.0, -15.0], [-27.0, -15.0]);
    wall([-27.0, -15.0], [-27.0, -1.0]);
    wall([-27.0, 1.0], [-27.0, 15.0]);
    for (row, column) in (-11..12).flat_map(|row| (0..23).map(move |column| (row, column))) {
        let [x, y] = [-26.0 + 1.2 * f64::from(column), 1.2 * f64::from(row)];
        wall([x, y], [x + 0.1, y]);
    }
    floor
}

#[test]
fn where_a_building_is_too_large_to_look_into_every_gap_the_wide_ones_still_lead_home() {
    let (floor, home) = (pillared_hall(), DVec2::new(6.0, 0.0));
    let footing = Footing { near: 100.0, ..Footing::default() };
    let mut search = Search::new(ease(&floor, &footing), home);
    search.begin(true);
    assert_eq!(search.next_end(), None);
    assert!(search.has_lost_patience(), "{} cells", search.expanded);
    let way = search.way(true).unwrap();
    assert!(search.leads_home(&way) && !search.has_lost_patience());
    assert!(way.iter().any(|cell| cell.middle().x < -27.0), "out by the door");
}
