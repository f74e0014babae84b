use cogmap_geometry::{DVec2, Segment};
use cogmap_mapping::{Mapper, PathPoint};

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
        Self::through(mapper, &path_of(mapper, &atlas), tolerance)
    }

    /// The same without its loops: where the path came back to within `same` metres of where it had been
    /// before, what lies between is left out. From where the robot stands it leads back out of whatever was
    /// tried since, and then home.
    pub(crate) fn without_loops(mapper: &Mapper, tolerance: f64, same: f64) -> Self {
        let atlas = Atlas::of(mapper);
        let mut path = path_of(mapper, &atlas);
        path.reverse();
        let mut kept = Vec::new();
        let mut next = 0;
        while let Some(&(k, here)) = path.get(next) {
            kept.push((k, here));
            let again = path.iter().rposition(|&(_, there)| there.distance(here) <= same);
            next = again.unwrap_or(next).max(next) + 1;
        }
        kept.extend(path.last().filter(|&home| kept.last() != Some(home)).copied());
        kept.reverse();
        Self::through(mapper, &kept, tolerance)
    }

    fn through(mapper: &Mapper, seen: &[(usize, DVec2)], tolerance: f64) -> Self {
        let mut chosen = Vec::new();
        if let (Some(&(first, _)), Some(&(last, _))) = (seen.first(), seen.last()) {
            chosen.push(first);
            generalise(seen, tolerance, &mut chosen);
            chosen.push(last);
        }
        chosen.dedup();
        let path = mapper.path();
        let at = |k: usize| Anchored { frame: path[k].frame, value: path[k].frame_from_robot.position };
        Self { waypoints: chosen.into_iter().map(at).collect() }
    }

    /// The waypoints, home first, as they lie here; one to which no link leads is left out.
    pub(crate) fn seen_from(&self, atlas: &Atlas) -> Vec<DVec2> {
        self.waypoints.iter().filter_map(|&waypoint| atlas.point(waypoint)).collect()
    }
}

/// Where each view was taken, as it lies here; one to which no link leads is left out.
fn path_of(mapper: &Mapper, atlas: &Atlas) -> Vec<(usize, DVec2)> {
    let at = |point: &PathPoint| {
        let kept = Anchored { frame: point.frame, value: point.frame_from_robot.position };
        atlas.point(kept)
    };
    mapper.path().iter().enumerate().filter_map(|(k, point)| Some((k, at(point)?))).collect()
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
