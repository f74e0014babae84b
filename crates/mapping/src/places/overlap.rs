use cogmap_geometry::{DVec2, Metric, Segment};
use serde::{Deserialize, Serialize};

use super::{AsrId, Network, sight};
use crate::memory::Mfis;

/// Of the robot's path points so far apart are taken, metres.
const PATH_SPACING: f64 = 0.5;

/// When a new space is an old one (§3.2.3): it mostly overlaps with it in the map. The thesis names no
/// numbers; these are ours.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Overlap {
    /// This share of the new space's surfaces lies in the old one, and so does the robot.
    pub share: f64,
    /// The old space is taken as wider by this, metres …
    pub tolerance: f64,
    /// … and by this share of the way since the robot left it: the ends of a map need not meet …
    pub drift: f64,
    /// … but not by more than this, metres.
    pub tolerance_max: f64,
    /// What lies farther than this from where the robot was in a space does not count for where the space is, metres.
    pub around: f64,
    /// A new space is compared again until the robot has gone this far in it, metres.
    pub within: f64,
}

impl Default for Overlap {
    fn default() -> Self {
        Self { share: 0.5, tolerance: 0.3, drift: 0.01, tolerance_max: 2.0, around: 4.0, within: 5.0 }
    }
}

impl Overlap {
    /// How much wider a space is taken that was left so many metres of way ago.
    pub(super) fn tolerance_after(&self, way: f64) -> f64 {
        (self.tolerance + self.drift * way).min(self.tolerance_max)
    }
}

/// The share of some surfaces, all in the map, that lies within a hull grown by a tolerance.
pub(super) fn share_within(surfaces: &[Segment], hull: &[DVec2], tolerance: f64) -> f64 {
    let points: Vec<DVec2> = surfaces.iter().flat_map(|&surface| sight::samples(surface)).collect();
    if points.is_empty() || hull.len() < 3 {
        return 0.0;
    }
    let inside = points.iter().filter(|&&point| is_within(point, hull, tolerance)).count();
    #[allow(clippy::cast_precision_loss, reason = "a space has a few thousand samples")]
    let share = inside as f64 / points.len() as f64;
    share
}

/// The hull of a space in the map: where the robot was in it, and its surfaces around there. What is farther off was
/// mostly seen through doors that it has not gone through yet.
pub(super) fn hull_of(network: &Network, mfis: &Mfis, asr: AsrId, around: f64) -> Vec<DVec2> {
    let mut points: Vec<DVec2> = Vec::new();
    for at in network.visits().places_in(asr) {
        if points.last().is_none_or(|last| last.distance_from(at) >= PATH_SPACING) {
            points.push(at);
        }
    }
    let visited = points.clone();
    let is_near = |point: &DVec2| visited.iter().any(|at| at.distance_from(*point) <= around);
    let surfaces = network.surfaces_of(asr).iter().filter_map(|&id| mfis.get(id));
    points.extend(surfaces.flat_map(|surface| sight::samples(mfis.in_map(surface))).filter(is_near));
    convex_hull(points)
}

/// Whether a point lies in a convex polygon, or not farther than a tolerance outside.
pub(super) fn is_within(point: DVec2, hull: &[DVec2], tolerance: f64) -> bool {
    let mut edges = hull.iter().zip(hull.iter().cycle().skip(1));
    let inside = edges.clone().all(|(&a, &b)| (b - a).perp_dot(point - a) >= 0.0);
    inside || edges.any(|(&a, &b)| Segment::new(a, b).distance_to(point) <= tolerance)
}

/// The area of a convex polygon, square metres.
pub(super) fn area_of(hull: &[DVec2]) -> f64 {
    let edges = hull.iter().zip(hull.iter().cycle().skip(1));
    edges.map(|(a, b)| a.perp_dot(*b)).sum::<f64>() / 2.0
}

/// The corners of the smallest convex polygon around some points, counter-clockwise (Andrew's
/// monotone chain); fewer than three where they lie on a line.
pub(super) fn convex_hull(mut points: Vec<DVec2>) -> Vec<DVec2> {
    points.sort_by(|a, b| a.x.total_cmp(&b.x).then(a.y.total_cmp(&b.y)));
    points.dedup();
    let chain = |points: &mut dyn Iterator<Item = DVec2>| {
        let mut chain: Vec<DVec2> = Vec::new();
        for point in points {
            while let [.., a, b] = chain[..] {
                if (b - a).perp_dot(point - a) > 0.0 {
                    break;
                }
                chain.pop();
            }
            chain.push(point);
        }
        chain.pop();
        chain
    };
    let mut hull = chain(&mut points.iter().copied());
    hull.extend(chain(&mut points.iter().rev().copied()));
    hull
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    prop_compose! {
        fn any_point()(x in -9.0f64..9.0, y in -9.0f64..9.0) -> DVec2 { DVec2::new(x, y) }
    }

    proptest! {
        #[test]
        fn a_hull_holds_all_its_points(points in prop::collection::vec(any_point(), 3..40)) {
            let hull = convex_hull(points.clone());
            for point in points {
                prop_assert!(is_within(point, &hull, 1e-9));
            }
        }
    }

    #[test]
    fn a_hull_goes_round_the_outermost_points() {
        let square = [[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0], [1.0, 1.0], [1.0, 0.0]];
        let hull = convex_hull(square.map(DVec2::from).to_vec());
        assert_eq!(hull, [[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0]].map(DVec2::from));
        assert!((area_of(&hull) - 4.0).abs() < 1e-12);
    }

    #[test]
    fn half_a_wall_inside_is_a_half() {
        let square = [[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0]].map(DVec2::from);
        let wall = Segment::new(DVec2::new(0.0, 1.0), DVec2::new(4.0, 1.0));
        assert!((share_within(&[wall], &square, 0.0) - 0.5).abs() < 1e-9);
        assert!((share_within(&[wall], &square, 1.0) - 0.75).abs() < 1e-9);
    }
}
