use std::collections::{BTreeMap, VecDeque};

use cogmap_geometry::{DVec2, Pose, Segment};
use cogmap_mapping::{
    Mapper,
    memory::SurfaceId,
    perception::{Moment, Reading},
};
use serde::{Deserialize, Serialize};

use crate::{Anchored, Atlas, Belief, surroundings::Surroundings};

/// When the robot stops to trust what it remembers (§3.3.3, Fig. 3.29).
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct ForgettingParams {
    /// Nothing nearer than this is forgotten, metres.
    pub distance: f64,
    /// What one of so many scans at rest, the last ones, showed is not forgotten.
    pub scans: usize,
    /// A surface counts as seen where so many points of a scan …
    pub points: usize,
    /// … lie no farther from it than this, metres.
    pub offset: f64,
}

impl Default for ForgettingParams {
    fn default() -> Self {
        Self { distance: 5.0, scans: 5, points: 3, offset: 0.1 }
    }
}

/// The surfaces that the robot still trusts on its way home: a surface goes when it is far *and* the last
/// scans did not show it, and comes back when it is seen again. The map itself keeps all.
#[derive(Clone, Debug)]
pub(crate) struct Recent {
    params: ForgettingParams,
    /// The scan that last showed each trusted surface.
    seen: BTreeMap<SurfaceId, usize>,
    /// Scans at rest so far. It begins where nothing counts as seen lately.
    scan: usize,
    /// The last scans at rest, oldest first: they also show what is too small to be a surface.
    views: VecDeque<View>,
}

/// What a scan at rest saw.
#[derive(Clone, Debug)]
struct View {
    scan: usize,
    place_from_robot: Anchored<Pose>,
    /// In the robot's frame, metres.
    points: Vec<DVec2>,
}

/// Points of a scan nearer to each other than this tell no more than one, metres.
const THIN: f64 = 0.05;

impl Recent {
    /// At the command most is forgotten at once (§3.3.5): of what is far only what the present scan, which
    /// is still to come, shows.
    pub(crate) fn new(params: &ForgettingParams, mapper: &Mapper, atlas: &Atlas) -> Self {
        let seen = mapper.mfis().remembered().map(|stored| (stored.id, 0)).collect();
        let mut recent = Self { params: params.clone(), seen, scan: params.scans, views: VecDeque::new() };
        if let Some(last) = mapper.path().last() {
            recent.forget(mapper, atlas, last.frame_from_robot.position);
        }
        recent
    }

    /// Takes a scan in: what it shows is trusted, what is far and has not been seen lately is not.
    pub(crate) fn observe(&mut self, reading: &Reading, mapper: &Mapper, atlas: &Atlas, belief: &Belief) {
        let scan = &reading.scan;
        let points: Vec<DVec2> = (0..scan.ranges.len())
            .filter_map(|beam| scan.point(beam))
            .map(|point| scan.robot_from_laser * point)
            .collect();
        let here: Vec<DVec2> = points.iter().map(|&point| belief.here_from_robot * point).collect();
        if reading.moment != Moment::WithinStep {
            self.scan += 1;
            self.views.push_back(View {
                scan: self.scan,
                place_from_robot: atlas.keep(belief.here_from_robot),
                points: thinned(points),
            });
            if self.views.len() > self.params.scans {
                self.views.pop_front();
            }
        }
        let robot = belief.here_from_robot.position;
        for stored in mapper.mfis().remembered() {
            let Some(surface) = atlas.surface(stored) else { continue };
            if surface.distance_to(robot) <= scan.range_max && self.shows(&here, surface) {
                self.seen.insert(stored.id, self.scan);
            }
        }
        self.forget(mapper, atlas, robot);
    }

    fn shows(&self, view: &[DVec2], surface: Segment) -> bool {
        let on_it = view.iter().filter(|&&point| surface.distance_to(point) <= self.params.offset);
        on_it.take(self.params.points).count() == self.params.points
    }

    fn forget(&mut self, mapper: &Mapper, atlas: &Atlas, robot: DVec2) {
        let Self { params, seen, scan, .. } = self;
        seen.retain(|&id, &mut last| {
            let stored = mapper.mfis().get(id).filter(|_| mapper.mfis().remembers(id));
            let surface = stored.and_then(|stored| atlas.surface(stored));
            surface.is_some_and(|surface| params.keeps(surface.distance_to(robot), scan.saturating_sub(last)))
        });
    }

    /// What the last scan at rest saw, in the robot's frame, metres.
    pub(crate) fn view(&self) -> &[DVec2] {
        self.views.back().map_or(&[], |view| &view.points)
    }

    /// How many scans at rest it has had.
    pub(crate) fn scan(&self) -> usize {
        self.scan
    }

    /// Whether a surface is trusted.
    pub(crate) fn trusts(&self, id: SurfaceId) -> bool {
        self.seen.contains_key(&id)
    }

    /// How many surfaces are trusted.
    pub(crate) fn len(&self) -> usize {
        self.seen.len()
    }

    /// The trusted surfaces that a scan since that one has shown, and what the last of those scans saw, as
    /// all lies here.
    pub(crate) fn surroundings(&self, since: usize, mapper: &Mapper, atlas: &Atlas) -> Surroundings {
        let ids = self.seen.iter().filter(|&(_, &last)| last >= since).map(|(&id, _)| id);
        let surfaces = ids.filter_map(|id| atlas.surface(mapper.mfis().get(id)?)).collect();
        let views = self.views.iter().filter(|view| view.scan >= since);
        let seen = views.filter_map(|view| Some((atlas.pose(view.place_from_robot)?, &view.points)));
        let points = seen.flat_map(|(pose, points)| points.iter().map(move |&point| pose * point)).collect();
        Surroundings { surfaces, points }
    }
}

fn thinned(points: Vec<DVec2>) -> Vec<DVec2> {
    let mut kept: Vec<DVec2> = Vec::new();
    for point in points {
        if kept.last().is_none_or(|last| last.distance(point) >= THIN) {
            kept.push(point);
        }
    }
    kept
}

impl ForgettingParams {
    /// Whether a surface so many metres away that so many scans have not shown is still trusted.
    fn keeps(&self, distance: f64, unseen: usize) -> bool {
        distance <= self.distance || unseen < self.scans
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_near_is_kept_however_old() {
        assert!(ForgettingParams::default().keeps(4.9, 1_000));
    }

    #[test]
    fn what_was_seen_lately_is_kept_however_far() {
        assert!(ForgettingParams::default().keeps(50.0, 4));
    }

    #[test]
    fn what_is_far_and_old_is_forgotten() {
        assert!(!ForgettingParams::default().keeps(5.1, 5));
    }
}
