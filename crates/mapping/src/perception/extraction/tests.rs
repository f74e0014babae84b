//! Requirements on extraction: a room gives its walls, chair legs give debris.

use cogmap_geometry::{DVec2, Pose, Segment, trig};
use proptest::prelude::*;

use super::*;
use crate::perception::End;

fn scan_of(walls: &[Segment], laser: Pose, range_max: f64) -> Scan {
    let increment = 0.5_f64.to_radians();
    let angle_min = -90.0_f64.to_radians();
    let ranges = (0..361)
        .map(|beam| {
            let (sin, cos) = trig::sin_cos(laser.heading + angle_min + increment * f64::from(beam));
            let ray = Segment::new(laser.position, laser.position + DVec2::new(cos, sin) * 100.0);
            walls
                .iter()
                .filter_map(|wall| ray.crossing(*wall))
                .map(|hit| hit.distance(laser.position))
                .fold(f64::INFINITY, f64::min)
        })
        .collect();
    Scan {
        robot_from_laser: Pose::IDENTITY,
        angle_min,
        angle_increment: increment,
        range_max,
        ranges,
        labels: Vec::new(),
    }
}

fn room(width: f64, depth: f64) -> Vec<Segment> {
    let corners = [DVec2::ZERO, DVec2::new(width, 0.0), DVec2::new(width, depth), DVec2::new(0.0, depth)];
    (0..4).map(|i| Segment::new(corners[i], corners[(i + 1) % 4])).collect()
}

/// The visible part of each wall of a convex room, in the order of the beams, and how far apart the beams
/// hit it at its two ends; `None` where so little of one of the walls is seen that it is no surface: by
/// too few beams, or less than twice the least length.
fn visible_parts(walls: &[Segment], laser: Pose, scan: &Scan) -> Option<Vec<(Segment, [f64; 2])>> {
    let hits: Vec<DVec2> = (0..scan.ranges.len()).map(|beam| laser * scan.point(beam).unwrap()).collect();
    let wall_of = |hit: DVec2| {
        (0..walls.len())
            .min_by(|&a, &b| walls[a].distance_to(hit).total_cmp(&walls[b].distance_to(hit)))
            .unwrap()
    };
    let corner = |a: usize, b: usize| {
        let ends = |wall: usize| [walls[wall].a, walls[wall].b];
        ends(a).into_iter().find(|end| ends(b).contains(end)).unwrap()
    };
    let numbered: Vec<(usize, DVec2)> = hits.into_iter().map(|hit| (wall_of(hit), hit)).collect();
    let runs: Vec<&[(usize, DVec2)]> = numbered.chunk_by(|a, b| a.0 == b.0).collect();
    let parts = runs.iter().enumerate().map(|(index, run)| {
        let (first, last) = (run[0], run[run.len() - 1]);
        let before = index.checked_sub(1).map_or(first.1, |before| corner(runs[before][0].0, first.0));
        let after = runs.get(index + 1).map_or(last.1, |after| corner(after[0].0, last.0));
        let spacing = [run[0].1.distance(run[1].1), last.1.distance(run[run.len() - 2].1)];
        (Segment::new(before, after), spacing)
    });
    let least = 2.0 * Extraction::default().min_length;
    let parts: Vec<(Segment, [f64; 2])> = runs.iter().all(|run| run.len() > 5).then(|| parts.collect())?;
    parts.iter().all(|(part, _)| part.length() > least).then_some(parts)
}

proptest! {
    #[test]
    fn a_noise_free_room_gives_its_visible_walls_to_within_a_beam_spacing(
        width in 3.0f64..7.0, depth in 3.0f64..7.0,
        x in 0.25f64..0.75, y in 0.25f64..0.75, heading in -3.1f64..3.1,
    ) {
        let laser = Pose::new(width * x, depth * y, heading);
        let walls = room(width, depth);
        let scan = scan_of(&walls, laser, 20.0);
        let expected = visible_parts(&walls, laser, &scan);
        prop_assume!(expected.is_some());
        let (expected, view) = (expected.unwrap(), extract(&scan, &Extraction::default()));
        prop_assert_eq!(view.surfaces.len(), expected.len());
        for (surface, (part, spacing)) in view.surfaces.iter().zip(&expected) {
            let seen = laser * surface.segment;
            prop_assert!(surface.residual < 1e-9);
            prop_assert!(seen.a.distance(part.a) <= spacing[0], "{seen:?} {part:?}");
            prop_assert!(seen.b.distance(part.b) <= spacing[1], "{seen:?} {part:?}");
        }
    }

    #[test]
    fn four_chair_legs_are_never_bridged(
        x in 1.0f64..3.0, y in -1.0f64..1.0, turn in 0.0f64..1.5, apart in 0.4f64..0.6,
    ) {
        let corners = [(0.0, 0.0), (apart, 0.0), (apart, apart), (0.0, apart)]
            .map(|(dx, dy)| Pose::new(x, y, turn) * DVec2::new(dx, dy));
        let side = Pose::new(0.0, 0.0, turn);
        let (u, v) = (side.forward() * 0.03, side.rotate(DVec2::Y) * 0.03);
        let legs: Vec<Segment> = corners
            .iter()
            .flat_map(|&corner| {
                let square = [corner, corner + u, corner + u + v, corner + v];
                (0..4).map(move |i| Segment::new(square[i], square[(i + 1) % 4]))
            })
            .collect();
        let view = extract(&scan_of(&legs, Pose::IDENTITY, 8.0), &Extraction::default());
        for surface in &view.surfaces {
            let leg_of = |end: DVec2| {
                let distance = |leg: usize| corners[leg].distance(end);
                (0..4).min_by(|&a, &b| distance(a).total_cmp(&distance(b))).unwrap()
            };
            prop_assert!(surface.length() < 0.3);
            prop_assert_eq!(leg_of(surface.segment.a), leg_of(surface.segment.b));
        }
    }

    #[test]
    fn any_scan_gives_surfaces_in_the_order_of_their_beams(
        ranges in prop::collection::vec(prop_oneof![Just(f64::INFINITY), Just(f64::NAN), 0.0f64..9.0, -1.0f64..0.0], 0..200),
    ) {
        let scan = Scan {
            robot_from_laser: Pose::new(0.2, 0.0, 0.0),
            angle_min: -1.5, angle_increment: 0.015, range_max: 8.0, ranges, labels: Vec::new(),
        };
        let view = extract(&scan, &Extraction::default());
        for surface in &view.surfaces {
            prop_assert!(surface.beams[0] < surface.beams[1]);
            prop_assert!(surface.length() >= 0.15 && surface.residual.is_finite());
        }
        for pair in view.surfaces.windows(2) {
            prop_assert!(pair[0].beams[1] <= pair[1].beams[0]);
        }
    }
}

#[test]
fn a_box_in_front_of_a_wall_hides_it() {
    let wall = Segment::new(DVec2::new(4.0, -3.0), DVec2::new(4.0, 3.0));
    let front = Segment::new(DVec2::new(2.0, -0.5), DVec2::new(2.0, 0.5));
    let view = extract(&scan_of(&[wall, front], Pose::IDENTITY, 8.0), &Extraction::default());
    assert_eq!(view.surfaces.len(), 3);
    assert_eq!(view.surfaces[0].ends, [End::True, End::Occlusion]);
    assert_eq!(view.surfaces[1].ends, [End::True, End::True]);
    assert_eq!(view.surfaces[2].ends, [End::Occlusion, End::True]);
}

#[test]
fn a_corridor_ends_at_the_sensors_limit() {
    let walls = [
        Segment::new(DVec2::new(-30.0, -1.0), DVec2::new(30.0, -1.0)),
        Segment::new(DVec2::new(-30.0, 1.0), DVec2::new(30.0, 1.0)),
    ];
    let view = extract(&scan_of(&walls, Pose::IDENTITY, 8.0), &Extraction::default());
    assert_eq!(view.surfaces.len(), 2);
    for surface in &view.surfaces {
        assert_eq!(surface.ends, [End::RangeLimit, End::RangeLimit]);
        assert!(surface.length() > 5.5 && surface.length() < 8.0);
    }
}

#[test]
fn only_fine_extraction_keeps_a_niche_from_turning_its_wall() {
    let outline =
        [(0.0, 1.0), (1.5, 1.0), (1.5, 1.12), (2.9, 1.12), (2.9, 1.0), (4.3, 1.0), (4.3, 1.12), (5.7, 1.12)];
    let corners = outline.map(DVec2::from);
    let walls: Vec<Segment> = corners.windows(2).map(|ends| Segment::new(ends[0], ends[1])).collect();
    let most_askew = |params: &Extraction| {
        let view = extract(&scan_of(&walls, Pose::IDENTITY, 8.19), params);
        let long = view.surfaces.iter().filter(|surface| surface.length() > 0.5);
        long.map(|surface| surface.segment.angle_to(walls[0]).to_degrees()).fold(0.0, f64::max)
    };
    let (coarse, fine) = (most_askew(&Extraction::default()), most_askew(&Extraction::fine()));
    assert!(coarse > 1.0 && fine < 0.5, "{coarse}° and {fine}°");
}
