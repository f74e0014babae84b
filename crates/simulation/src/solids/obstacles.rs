use cogmap_geometry::{DVec2, Segment};
use parry2d_f64::{
    bounding_volume::Aabb,
    partitioning::{Bvh, BvhBuildStrategy, BvhNode},
};

use crate::{Disc, Solids};

/// Solids in a tree, to find quickly what is near.
#[derive(Clone)]
pub struct Obstacles {
    solids: Vec<Solid>,
    tree: Bvh,
}

/// What a body can run into: what stands still, and people.
#[derive(Clone, Copy)]
pub struct Surroundings<'a> {
    /// What stands still.
    pub obstacles: &'a Obstacles,
    /// People, where they are now.
    pub people: &'a [Disc],
}

impl<'a> From<&'a Obstacles> for Surroundings<'a> {
    fn from(obstacles: &'a Obstacles) -> Self {
        Self { obstacles, people: &[] }
    }
}

impl Surroundings<'_> {
    /// The nearest point of what is nearest to a point, of all that is closer than `within` metres: how far
    /// it is, and where.
    pub(crate) fn nearest(&self, point: DVec2, within: f64) -> Option<(f64, DVec2)> {
        let still = self.obstacles.nearest(point, within).map(|nearest| (nearest.distance, nearest.point));
        let people = self.people.iter().map(|&person| Solid::Disc(person).nearest(point));
        people.filter(|(distance, _)| *distance < within).chain(still).min_by(|a, b| a.0.total_cmp(&b.0))
    }
}

/// The nearest point of the nearest solid.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Nearest {
    /// Metres; negative inside a disc.
    pub distance: f64,
    /// Where it is, metres.
    pub point: DVec2,
    /// Whose it is, numbered as in [`Solids`].
    pub solid: u32,
}

#[derive(Clone, Copy)]
pub(crate) enum Solid {
    Segment(Segment),
    Disc(Disc),
}

impl Obstacles {
    /// Sorts solids into a tree; those with numbers that are not finite are left out.
    #[must_use]
    pub fn new(solids: &Solids) -> Self {
        let segments = solids.segments.iter().copied().map(Solid::Segment);
        let all = segments.chain(solids.discs.iter().copied().map(Solid::Disc));
        let all: Vec<Solid> = all.chain(solids.added.iter().copied().map(Solid::Segment)).collect();
        let leaves = all.iter().map(Solid::bounds).enumerate();
        let leaves = leaves.filter(|(_, bounds)| bounds.mins.is_finite() && bounds.maxs.is_finite());
        let tree = Bvh::from_iter(BvhBuildStrategy::Binned, leaves);
        Self { solids: all, tree }
    }

    /// The solid nearest to a point, of those closer than `within` metres; of two equally near, the
    /// one with the lower number.
    #[must_use]
    pub fn nearest(&self, point: DVec2, within: f64) -> Option<Nearest> {
        let mut best: Option<Nearest> = None;
        for (solid, shape) in self.around(point - within, point + within) {
            let (distance, nearest) = shape.nearest(point);
            let closer = best.is_none_or(|b| (distance, solid) < (b.distance, b.solid));
            if distance < within && closer {
                best = Some(Nearest { distance, point: nearest, solid });
            }
        }
        best
    }

    /// Whether a disc can move along a line without coming closer than its radius to anything.
    #[must_use]
    pub fn leaves_free(&self, way: Segment, radius: f64) -> bool {
        let (low, high) = (way.a.min(way.b) - radius, way.a.max(way.b) + radius);
        self.around(low, high).all(|(_, shape)| shape.distance_to(way) >= radius)
    }

    /// The solids whose bounding boxes touch the box between two corners, in the tree's order.
    pub(crate) fn around(&self, low: DVec2, high: DVec2) -> impl Iterator<Item = (u32, Solid)> + '_ {
        let query = BvhNode::leaf(Aabb::new(low, high), 0);
        let touching = self.tree.leaves(move |node: &BvhNode| node.intersects(&query));
        touching.filter_map(|solid| Some((solid, *self.solids.get(solid as usize)?)))
    }

    /// Lowest and highest corner of the box around all solids; `None` where there are none.
    pub(crate) fn bounds(&self) -> Option<[DVec2; 2]> {
        let bounds = (!self.tree.is_empty()).then(|| self.tree.root_aabb())?;
        Some([bounds.mins, bounds.maxs])
    }
}

impl Solid {
    fn bounds(&self) -> Aabb {
        match *self {
            Self::Segment(s) => Aabb::new(s.a.min(s.b), s.a.max(s.b)),
            Self::Disc(d) => Aabb::new(d.center - d.radius, d.center + d.radius),
        }
    }

    /// Metres to the nearest point, and that point.
    pub(crate) fn nearest(&self, point: DVec2) -> (f64, DVec2) {
        match *self {
            Self::Segment(s) => {
                let nearest = s.closest_point(point);
                (nearest.distance(point), nearest)
            }
            Self::Disc(d) => {
                let outward = (point - d.center).try_normalize().unwrap_or(DVec2::X);
                (point.distance(d.center) - d.radius, d.center + outward * d.radius)
            }
        }
    }

    /// Metres between the solid and a line.
    pub(crate) fn distance_to(&self, way: Segment) -> f64 {
        match *self {
            Self::Segment(s) if s.crossing(way).is_some() => 0.0,
            Self::Segment(s) => {
                let ends = s.distance_to(way.a).min(s.distance_to(way.b));
                ends.min(way.distance_to(s.a)).min(way.distance_to(s.b))
            }
            Self::Disc(d) => way.distance_to(d.center) - d.radius,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    prop_compose! {
        fn any_point()(x in -9.0f64..9.0, y in -9.0f64..9.0) -> DVec2 { DVec2::new(x, y) }
    }

    prop_compose! {
        fn any_solids()(
            ends in prop::collection::vec((any_point(), any_point()), 0..30),
            discs in prop::collection::vec((any_point(), 0.01f64..1.0), 0..30),
        ) -> Solids {
            Solids {
                segments: ends.into_iter().map(|(a, b)| Segment::new(a, b)).collect(),
                discs: discs.into_iter().map(|(center, radius)| Disc { center, radius }).collect(),
                ..Solids::default()
            }
        }
    }

    proptest! {
        #[test]
        fn the_nearest_solid_is_the_one_that_trying_all_finds(solids in any_solids(), p in any_point()) {
            let segments = solids.segments.iter().map(|s| s.distance_to(p));
            let discs = solids.discs.iter().map(|d| d.center.distance(p) - d.radius);
            let best = segments.chain(discs).fold(f64::INFINITY, f64::min);
            match Obstacles::new(&solids).nearest(p, 3.0) {
                Some(found) => {
                    prop_assert_eq!(found.distance, best);
                    prop_assert!((found.point.distance(p) - best.abs()).abs() < 1e-9);
                }
                None => prop_assert!(best >= 3.0),
            }
        }

        #[test]
        fn a_free_way_has_no_point_too_close(
            solids in any_solids(), a in any_point(), b in any_point(), radius in 0.05f64..0.8,
        ) {
            let obstacles = Obstacles::new(&solids);
            let free = obstacles.leaves_free(Segment::new(a, b), radius);
            let at = |share: f64| obstacles.nearest(a.lerp(b, share), radius - 1e-9).is_none();
            let sampled = (0..=400).all(|k| at(f64::from(k) / 400.0));
            prop_assert!(sampled || !free);
        }
    }

    #[test]
    fn solids_without_a_finite_place_are_left_out() {
        let wall = Segment::new(DVec2::new(f64::NAN, 0.0), DVec2::ONE);
        let solids = Solids { segments: vec![wall], ..Solids::default() };
        assert_eq!(Obstacles::new(&solids).nearest(DVec2::ZERO, 5.0), None);
    }

    #[test]
    fn a_heap_of_solids_in_one_place_is_no_trouble() {
        let wall = Segment::new(DVec2::ZERO, DVec2::X);
        let solids = Solids { segments: vec![wall; 50_000], ..Solids::default() };
        let nearest = Obstacles::new(&solids).nearest(DVec2::new(0.5, 0.25), 1.0).unwrap();
        assert_eq!((nearest.distance, nearest.solid), (0.25, 0));
    }
}
