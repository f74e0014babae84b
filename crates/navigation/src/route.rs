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
        Self::through(mapper, &cut_loops(&path_of(mapper, &atlas), same), tolerance)
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

/// Leaves out what lies between two points of a path that are no farther from each other than `same` metres;
/// of all such the robot, which looks back from the end, takes the point nearest to the beginning.
fn cut_loops(path: &[(usize, DVec2)], same: f64) -> Vec<(usize, DVec2)> {
    let mut kept: Vec<(usize, DVec2)> = path.last().copied().into_iter().collect();
    let mut left = path;
    while let Some(&(_, here)) = left.last() {
        let again = left.iter().position(|&(_, there)| there.distance(here) <= same);
        left = &left[..again.unwrap_or(0)];
        kept.extend(left.last());
    }
    kept.extend(path.first().filter(|&first| kept.last() != Some(first)).copied());
    kept.reverse();
    kept
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

#[cfg(test)]
mod tests {
    use super::*;

    fn numbered(points: &[[f64; 2]]) -> Vec<(usize, DVec2)> {
        points.iter().map(|&point| point.into()).enumerate().collect()
    }

    #[test]
    fn a_loop_is_left_out_and_both_ends_are_kept() {
        // There, round a block, and on from where the round began.
        let round =
            [[0.0, 0.0], [1.0, 0.0], [2.0, 0.0], [3.0, 0.0], [3.0, 1.0], [2.0, 1.0], [2.1, 0.1], [2.0, -1.0]];
        let kept: Vec<usize> = cut_loops(&numbered(&round), 0.3).into_iter().map(|(k, _)| k).collect();
        assert_eq!(kept, [0, 1, 6, 7]);
    }

    #[test]
    fn a_way_into_a_dead_end_and_out_again_is_no_way() {
        let tried = [[0.0, 0.0], [1.0, 0.0], [2.0, 0.0], [3.0, 0.0], [2.0, 0.0], [1.0, 0.0]];
        let kept = cut_loops(&numbered(&tried), 0.3);
        assert_eq!(kept.iter().map(|&(k, _)| k).collect::<Vec<_>>(), [0, 5]);
    }

    #[test]
    fn waypoints_stand_where_the_path_bends() {
        let path = numbered(&[[0.0, 0.0], [1.0, 0.05], [2.0, 0.0], [2.0, 1.0], [2.05, 2.0], [2.0, 3.0]]);
        let mut chosen = vec![0];
        generalise(&path, 0.15, &mut chosen);
        chosen.push(5);
        assert_eq!(chosen, [0, 2, 5]);
    }
}
