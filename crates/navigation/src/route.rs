use cogmap_geometry::{DVec2, Pose, Segment};
use cogmap_mapping::Mapper;

use crate::{Anchored, Atlas};

/// The way out as the robot remembers it (§3.3.4): its major waypoints, home first, each kept in the
/// place where it was passed. Between two of them the way is about straight, so going from one to the next
/// is trivial.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Route {
    waypoints: Vec<Anchored<DVec2>>,
}

impl Route {
    /// Generalises the path of a mapper: no view lies farther than `tolerance` metres from the line
    /// between two waypoints (Douglas and Peucker's rule).
    pub(crate) fn of(mapper: &Mapper, tolerance: f64) -> Self {
        let atlas = Atlas::of(mapper);
        let path = mapper.path();
        let kept: Vec<Anchored<Pose>> =
            path.iter().map(|point| Anchored { frame: point.frame, value: point.frame_from_robot }).collect();
        let seen: Vec<(usize, DVec2)> =
            kept.iter().enumerate().filter_map(|(k, &pose)| Some((k, atlas.pose(pose)?.position))).collect();
        let mut chosen = Vec::new();
        if let (Some(&(first, _)), Some(&(last, _))) = (seen.first(), seen.last()) {
            chosen.push(first);
            generalise(&seen, tolerance, &mut chosen);
            chosen.push(last);
        }
        chosen.dedup();
        let at = |k: usize| Anchored { frame: kept[k].frame, value: kept[k].value.position };
        Self { waypoints: chosen.into_iter().map(at).collect() }
    }

    /// The waypoints, home first, as they lie here; one to which no link leads is left out.
    pub(crate) fn seen_from(&self, atlas: &Atlas) -> Vec<DVec2> {
        self.waypoints.iter().filter_map(|&waypoint| atlas.point(waypoint)).collect()
    }
}

/// Adds the views between the first and the last that the line between them misses, in order.
fn generalise(path: &[(usize, DVec2)], tolerance: f64, chosen: &mut Vec<usize>) {
    let [first, between @ .., last] = path else { return };
    let line = Segment::new(first.1, last.1);
    let farthest = between
        .iter()
        .enumerate()
        .map(|(k, point)| (k + 1, line.distance_to(point.1)))
        .max_by(|a, b| a.1.total_cmp(&b.1));
    let Some((k, distance)) = farthest else { return };
    if distance > tolerance {
        generalise(&path[..=k], tolerance, chosen);
        chosen.push(path[k].0);
        generalise(&path[k..], tolerance, chosen);
    }
}
