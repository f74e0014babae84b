use cogmap_geometry::{
    DVec2, Segment,
    trig::{self, FRAC_PI_2, PI},
};
use proptest::{collection::vec, prelude::*, sample::select};

use super::{Disc, Fan, Hit, RayGrid};

/// Turns (radians) and shifts (metres) of a beam that cannot be told apart: what
/// it meets may be what any of these would meet.
const SLACK: f64 = 1e-9;

/// Range of one beam, tested against every solid.
fn brute_force(origin: DVec2, heading: f64, segments: &[Segment], discs: &[Disc]) -> f64 {
    let (sin, cos) = trig::sin_cos(heading);
    let direction = DVec2::new(cos, sin);
    let walls = segments.iter().map(|s| segment_range(origin, direction, s));
    let rounds = discs.iter().map(|d| disc_range(origin, direction, d));
    walls.chain(rounds).fold(f64::INFINITY, f64::min)
}

fn segment_range(origin: DVec2, direction: DVec2, segment: &Segment) -> f64 {
    if segment.distance_to(origin) <= SLACK {
        return 0.0;
    }
    let (along, to_a) = (segment.b - segment.a, segment.a - origin);
    let cross = direction.perp_dot(along);
    let (range, share) = (to_a.perp_dot(along) / cross, to_a.perp_dot(direction) / cross);
    if range >= 0.0 && (0.0..=1.0).contains(&share) { range } else { f64::INFINITY }
}

fn disc_range(origin: DVec2, direction: DVec2, disc: &Disc) -> f64 {
    let to_center = disc.center - origin;
    if (to_center.length() - disc.radius).abs() <= SLACK {
        return 0.0;
    }
    let (ahead, aside) = (to_center.dot(direction), to_center.perp_dot(direction));
    let half = (disc.radius * disc.radius - aside * aside).sqrt();
    let meets = [ahead - half, ahead + half].into_iter().find(|range| *range >= 0.0);
    meets.unwrap_or(f64::INFINITY)
}

/// The lowest and highest range of the beams that differ by less than anyone can
/// tell.
fn brute_range(fan: &Fan, beam: usize, segments: &[Segment], discs: &[Disc]) -> [f64; 2] {
    let heading = fan.heading + fan.spacing * beam as f64;
    let (sin, cos) = trig::sin_cos(heading);
    let aside = DVec2::new(-sin, cos) * SLACK;
    // A wall seen edge-on may be met at an end.
    let ends = segments.iter().flat_map(|s| [s.a - fan.origin, s.b - fan.origin]);
    let grazed =
        ends.filter(|end| end.dot(aside).abs() <= SLACK * SLACK).map(|end| end.dot(DVec2::new(cos, sin)));
    let nearest = grazed.filter(|range| *range >= 0.0).fold(f64::INFINITY, f64::min);
    let mut extremes = [nearest, 0.0];
    for shift in [DVec2::ZERO, aside, -aside] {
        for turn in [0.0, SLACK, -SLACK] {
            let range = brute_force(fan.origin + shift, heading + turn, segments, discs);
            extremes = [extremes[0].min(range), extremes[1].max(range)];
        }
    }
    extremes
}

/// Each range is within a millimetre of the truth, and names the solid it is of.
fn check(
    fan: &Fan,
    still: (&[Segment], &[Disc]),
    moving: (&[Segment], &[Disc]),
) -> Result<(), TestCaseError> {
    let mut hits = Vec::new();
    RayGrid::new(still.0, still.1).cast_with(fan, moving.0, moving.1, &mut hits);
    prop_assert_eq!(hits.len(), fan.beams);
    let (segments, discs) = ([still.0, moving.0].concat(), [still.1, moving.1].concat());
    for (beam, hit) in hits.iter().enumerate() {
        let [low, high] = brute_range(fan, beam, &segments, &discs);
        match hit {
            Some(hit) => {
                prop_assert!(
                    hit.range >= low - 1e-3 && hit.range <= high + 1e-3,
                    "{beam}: {hit:?} {low} {high}"
                );
                prop_assert!(hit.range < fan.range_max * (1.0 + 1e-12));
                check_solid(fan, beam, hit, still, moving)?;
            }
            None => prop_assert!(high >= fan.range_max - 1e-3, "{beam}: nothing, {low} {high}"),
        }
    }
    Ok(())
}

fn check_solid(
    fan: &Fan,
    beam: usize,
    hit: &Hit,
    still: (&[Segment], &[Disc]),
    moving: (&[Segment], &[Disc]),
) -> Result<(), TestCaseError> {
    let (sin, cos) = trig::sin_cos(fan.heading + fan.spacing * beam as f64);
    let direction = DVec2::new(cos, sin);
    let end = fan.origin + direction * hit.range;
    let distances = |(segments, discs): (&[Segment], &[Disc])| {
        let walls = segments.iter().map(|s| (s.distance_to(end), s.direction().map(DVec2::perp)));
        let rounds = discs.iter().map(|d| {
            let outwards = end - d.center;
            ((outwards.length() - d.radius).abs(), outwards.try_normalize().filter(|_| d.radius > 0.0))
        });
        walls.chain(rounds).collect::<Vec<_>>()
    };
    let (off, normal) = [distances(still), distances(moving)].concat()[hit.solid as usize];
    prop_assert!(off < 1e-3, "{beam}: {hit:?} is {off} m off");
    prop_assert!((0.0..=1.0).contains(&hit.incidence_cos));
    if let Some(normal) = normal.filter(|_| hit.range > 1e-3 && off < 1e-9) {
        prop_assert!((hit.incidence_cos - normal.dot(direction).abs()).abs() < 1e-3);
    }
    Ok(())
}

/// Coordinates with many coincidences, and some with none.
fn coordinate() -> impl Strategy<Value = f64> {
    prop_oneof![(-8i32..8).prop_map(f64::from), -20.0..20.0f64]
}

prop_compose! {
    fn point()(x in coordinate(), y in coordinate()) -> DVec2 { DVec2::new(x, y) }
}

prop_compose! {
    fn segment()(a in point(), b in point(), kind in 0..6) -> Segment {
        match kind {
            0 => Segment::new(a, a),
            1 => Segment::new(a, DVec2::new(b.x, a.y)),
            2 => Segment::new(a, DVec2::new(a.x, b.y)),
            _ => Segment::new(a, a + (b - a) * 0.3),
        }
    }
}

prop_compose! {
    fn disc()(center in point(), radius in select(vec![0.0, 0.02, 0.25, 1.0, 7.0])) -> Disc {
        Disc { center, radius }
    }
}

prop_compose! {
    fn fan()(
        origin in point(),
        heading in prop_oneof![(-4i32..5).prop_map(|k| f64::from(k) * PI / 4.0), -7.0..7.0f64],
        spacing in select(vec![PI / 360.0, PI / 180.0, -PI / 180.0, 0.0, 0.3, 1.0, FRAC_PI_2, -3.0]),
        beams in 0usize..400,
        range_max in select(vec![0.5, 8.19, 30.0, 81.9, f64::INFINITY]),
    ) -> Fan {
        Fan { origin, heading, spacing, beams, range_max }
    }
}

proptest! {
    #[test]
    fn a_cast_is_as_exact_as_brute_force(
        segments in vec(segment(), 0..60),
        discs in vec(disc(), 0..8),
        fan in fan(),
        moving in (vec(segment(), 0..3), vec(disc(), 0..3)),
    ) {
        check(&fan, (&segments, &discs), (&moving.0, &moving.1))?;
    }

    #[test]
    fn a_cast_among_many_short_walls_is_as_exact(
        walls in vec((point(), -2.0..2.0f64, -2.0..2.0f64), 200..300),
        fan in fan(),
    ) {
        let wall = |&(a, x, y): &(DVec2, f64, f64)| Segment::new(a, a + DVec2::new(x, y));
        let walls: Vec<_> = walls.iter().map(wall).collect();
        check(&Fan { beams: 90, ..fan }, (&walls, &[]), (&[], &[]))?;
    }

    #[test]
    fn a_sensor_on_a_wall_meets_it_at_once(
        segments in vec(segment(), 1..20),
        share in select(vec![0.0, 0.25, 0.5, 1.0]),
        fan in fan(),
    ) {
        let origin = segments[0].a.lerp(segments[0].b, share);
        let fan = Fan { origin, ..fan };
        check(&fan, (&segments, &[]), (&[], &[]))?;
    }

    #[test]
    fn no_number_makes_a_cast_fail(
        numbers in vec(select(vec![0.0, 1.0, -1.0, 1e-300, 1e9, -1e18, 1e300, f64::MAX, f64::INFINITY, f64::NAN]), 12),
        beams in 0usize..20,
    ) {
        let at = |k: usize| DVec2::new(numbers[k], numbers[k + 1]);
        let fan = Fan { origin: at(0), heading: numbers[2], spacing: numbers[3], beams, range_max: numbers[4] };
        let segments = [Segment::new(at(5), at(7)), Segment::new(DVec2::ONE, DVec2::NEG_ONE)];
        let discs = [Disc { center: at(9), radius: numbers[11] }];
        let mut hits = Vec::new();
        RayGrid::new(&segments, &discs).cast_with(&fan, &segments, &discs, &mut hits);
        prop_assert_eq!(hits.len(), beams);
        prop_assert!(hits.iter().flatten().all(|hit| hit.range >= 0.0 && hit.range.is_finite()));
    }
}

#[test]
fn a_beam_along_a_wall_meets_its_nearer_end() {
    let wall = Segment::new(DVec2::new(8.0, 2.0), DVec2::new(5.0, 2.0));
    let fan = Fan { origin: DVec2::new(1.0, 2.0), heading: 0.0, spacing: 0.1, beams: 1, range_max: 30.0 };
    let mut hits = Vec::new();
    RayGrid::new(&[wall], &[]).cast(&fan, &mut hits);
    assert_eq!(hits[0].map(|hit| hit.range), Some(4.0));
}

#[test]
fn no_beam_slips_through_a_corner() {
    let (corner, origin) = (DVec2::new(3.0, 4.0), DVec2::new(0.5, 0.25));
    let walls = [Segment::new(DVec2::new(-3.0, 4.0), corner), Segment::new(corner, DVec2::new(3.0, -4.0))];
    let grid = RayGrid::new(&walls, &[]);
    let exact = trig::atan2(corner.y - origin.y, corner.x - origin.x);
    let mut hits = Vec::new();
    for step in -200..=200 {
        let heading = exact + f64::from(step) * 1e-16;
        grid.cast(&Fan { origin, heading, spacing: 0.01, beams: 1, range_max: 30.0 }, &mut hits);
        assert!(hits[0].is_some());
    }
}
