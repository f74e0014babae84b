use cogmap_geometry::{DVec2, Pose, Segment};

use super::{Truth, Values, count};
use crate::{
    Mapping,
    metrics::{
        Mapped, Sample, blocked_steps, by_first_view, by_whole_way, displacement, duplicates, median,
        side_angles,
    },
};

/// A surface counts as displaced from here, metres (§3.2.3 shows one).
const DISPLACED: f64 = 0.5;

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
pub(super) fn score_way(mapping: &Mapping, (truth, samples): (&Truth, &[Sample]), values: &mut Values) {
    let mfis = mapping.mapper.mfis();
    let surfaces: Vec<Segment> = mfis.remembered().map(|surface| mfis.in_map(surface)).collect();
    let way: Vec<DVec2> = samples.iter().map(|sample| sample.map_from_robot.position).collect();
    let blocked = blocked_steps(&way, &surfaces, truth.radius);
    values.put("blocked_steps", count(blocked));
    values.put("blocked", f64::from(u8::from(blocked > 0)));
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
