use cogmap_geometry::{DVec2, Pose, Segment};
use cogmap_mapping::perception::Moment;

use super::{Truth, Values, count};
use crate::{
    Drive, Mapping,
    metrics::{
        Mapped, Sample, blocked_steps, by_first_view, by_whole_way, displacement, duplicates, median,
        rectangle_fit, room_at, side_angles,
    },
};

/// A surface counts as displaced from here, metres (§3.2.3 shows one).
const DISPLACED: f64 = 0.5;
/// A surface this long is part of a room's outline, metres …
const OF_OUTLINE: f64 = 0.5;
/// … if it was seen so near to a side of it, metres …
const ON_SIDE: f64 = 0.15;
/// … and turned against it by no more than this, radians.
const ALONG_SIDE: f64 = 5.0 * cogmap_geometry::trig::PI / 180.0;

/// How well surfaces are placed.
pub(super) fn score(surfaces: &[Mapped], (truth, samples): (&Truth, &[Sample]), values: &mut Values) {
    values.put("surfaces", count(surfaces.len()));
    values.put("surfaces_long", count(surfaces.iter().filter(|s| s.is_long()).count()));
    if let (Some(first), Some(whole)) = (by_first_view(samples), by_whole_way(samples)) {
        score_displacement(surfaces, truth, [first, whole], values);
        let angle = side_angles(surfaces, truth.walls.lines(), whole);
        values.put("side_angle", angle.map(f64::to_degrees));
    }
    let found = duplicates(surfaces, truth.walls.lines());
    values.put("walls", count(found.walls));
    values.put("pieces", count(found.pieces));
    values.put("length_mapped", found.mapped);
    values.put("length_shown", found.shown);
}

/// Whether a surface of the map stands in the robot's way.
pub(super) fn score_way(drive: &Drive, mapping: &Mapping, truth: &Truth, values: &mut Values) {
    let mfis = mapping.mapper.mfis();
    let remembered = || mfis.remembered().map(|surface| (surface.step, mfis.in_map(surface)));
    let surfaces: Vec<Segment> = remembered().map(|(_, segment)| segment).collect();
    let ends = drive.looks.iter().enumerate().filter(|(_, look)| look.reading.moment == Moment::StepEnd);
    let way: Vec<(usize, DVec2)> = ends.map(|(look, _)| (look, mapping.estimate[look].position)).collect();
    let points: Vec<DVec2> = way.iter().map(|(_, point)| *point).collect();
    let blocked = blocked_steps(&points, &surfaces, truth.radius);
    values.put("blocked_steps", count(blocked));
    values.put("blocked", f64::from(u8::from(blocked > 0)));
    let blocked_then = way.windows(2).any(|step| {
        let until = mapping.look_of_report.partition_point(|&look| look <= step[1].0);
        let known: Vec<Segment> =
            remembered().filter(|(stored, _)| *stored < until).map(|(_, segment)| segment).collect();
        blocked_steps(&[step[0].1, step[1].1], &known, truth.radius) > 0
    });
    values.put("blocked_then", f64::from(u8::from(blocked_then)));
}

/// How well the room in which the robot spent most of its way, if it is a rectangle, is one in the map.
pub(super) fn score_room(surfaces: &[Mapped], (truth, samples): (&Truth, &[Sample]), values: &mut Values) {
    let mut stays = vec![0_usize; truth.rooms.len()];
    for sample in samples {
        if let Some(room) = room_at(&truth.rooms, sample.world_from_robot.position) {
            stays[room] += 1;
        }
    }
    let longest = truth.rooms.iter().zip(stays).max_by_key(|(_, stay)| *stay).map(|(room, _)| room);
    let Some(room) = longest.filter(|room| room.len() == 4) else { return };
    let corners = room.iter().zip(room.iter().cycle().skip(1));
    let sides: Vec<Segment> = corners.map(|(&a, &b)| Segment::new(a, b)).collect();
    let bounds = |surface: &&Mapped| {
        let seen = surface.in_world;
        let on =
            |side: &Segment| side.distance_to(seen.midpoint()) < ON_SIDE && side.angle_to(seen) < ALONG_SIDE;
        seen.length() >= OF_OUTLINE && sides.iter().any(on)
    };
    let outline: Vec<Segment> = surfaces.iter().filter(bounds).map(|surface| surface.in_map).collect();
    if outline.len() < sides.len() {
        return;
    }
    if let Some(fit) = rectangle_fit(&outline) {
        values.put("rectangle", fit.rms);
        values.put("rectangle_angle", fit.angle.to_degrees());
    }
}

fn score_displacement(surfaces: &[Mapped], truth: &Truth, laid: [Pose; 2], values: &mut Values) {
    let of = |long: bool, world_from_map| -> Vec<f64> {
        let chosen = surfaces.iter().filter(|surface| !long || surface.is_long());
        let far = |surface| Some(displacement(surface, truth.walls.lines(), world_from_map)?.total());
        chosen.filter_map(far).collect()
    };
    let displaced = |far: &[f64]| count(far.iter().filter(|far| **far > DISPLACED).count());
    let [first, whole] = laid.map(|laid| of(true, laid));
    let [first_any, whole_any] = laid.map(|laid| of(false, laid));
    values.put("displacement", median(&first));
    values.put("walls_named", count(first.len()));
    values.put("displaced_first", displaced(&first));
    values.put("displaced", displaced(&whole));
    values.put("any_named", count(first_any.len()));
    values.put("displaced_any_first", displaced(&first_any));
    values.put("displaced_any", displaced(&whole_any));
}
