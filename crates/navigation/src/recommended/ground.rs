use std::{
    collections::{BTreeMap, VecDeque},
    sync::Arc,
};

use cogmap_geometry::{DVec2, Pose, Segment};
use cogmap_mapping::{Mapper, memory::FrameId, perception::Reading};

use super::{floor::Floor, sight::Sight};
use crate::{Atlas, Belief};

/// A scan is kept each so many metres or radians …
const KEPT_EACH: [f64; 2] = [0.25, 0.35];
/// … and at most so many of them.
const KEPT: usize = 300;
/// Places have come to lie otherwise when they moved by so much, metres and radians.
const SHIFT: [f64; 2] = [0.03, 0.01];

/// All that the robot remembers of the floor, each thing in the place where it was learnt, and laid
/// out on one floor as these places are believed to lie to each other.
#[derive(Clone, Debug)]
pub(super) struct Ground {
    /// The place in whose coordinates the floor is laid out.
    frame: FrameId,
    floor: Floor,
    sights: VecDeque<Arc<Sight>>,
    /// How the places lay when the floor was laid out.
    layout: BTreeMap<FrameId, Pose>,
    /// How much of the mapper's path and surfaces is on the floor already.
    path: usize,
    surfaces: usize,
    /// A place of which something is missing there because no link led to it.
    missing: Option<FrameId>,
}

impl Ground {
    /// A floor in the coordinates of the place where the robot is.
    pub(super) fn new(frame: FrameId) -> Self {
        Self {
            frame,
            floor: Floor::default(),
            sights: VecDeque::new(),
            layout: BTreeMap::new(),
            path: 0,
            surfaces: 0,
            missing: None,
        }
    }

    /// What is known of the floor.
    pub(super) fn floor(&self) -> &Floor {
        &self.floor
    }

    /// From the coordinates of the place where the robot is to the floor's; `None` where no link leads there.
    pub(super) fn floor_from_here(&self, atlas: &Atlas) -> Option<Pose> {
        Some(atlas.here_from(self.frame)?.inverse())
    }

    /// Takes a scan in; `moment` counts the decisions.
    pub(super) fn observe(&mut self, reading: &Reading, atlas: &Atlas, belief: &Belief, moment: u16) {
        let sight = Sight::of(reading, atlas, belief, moment);
        if let Some(floor_from_frame) = self.place(atlas, sight.laser.frame) {
            self.floor.see(floor_from_frame * sight.laser.value, &sight.points, sight.moment);
        }
        if self.sights.back().is_none_or(|last| !last.is_like(&sight, KEPT_EACH[0], KEPT_EACH[1])) {
            self.sights.push_back(Arc::new(sight));
            if self.sights.len() > KEPT {
                self.sights.pop_front();
            }
        }
    }

    /// Brings in what the mapper has added; lays everything out anew where places have come to lie
    /// otherwise. `true` where that was so.
    pub(super) fn follow(&mut self, mapper: &Mapper, atlas: &Atlas) -> bool {
        let stale = self.is_stale(atlas);
        if stale {
            let sights = std::mem::take(&mut self.sights);
            *self = Self::new(atlas.here());
            for sight in &sights {
                if let Some(floor_from_frame) = self.place(atlas, sight.laser.frame) {
                    self.floor.see(floor_from_frame * sight.laser.value, &sight.points, sight.moment);
                }
            }
            self.sights = sights;
        }
        self.add_surfaces(mapper, atlas);
        self.add_path(mapper, atlas);
        stale
    }

    /// Notes that something stands somewhere on the floor.
    pub(super) fn block(&mut self, point: DVec2, moment: u16) {
        self.floor.block(point, moment);
    }

    fn is_stale(&self, atlas: &Atlas) -> bool {
        let Some(floor_from_here) = self.floor_from_here(atlas) else { return true };
        if self.missing.is_some_and(|frame| atlas.here_from(frame).is_some()) {
            return true;
        }
        self.layout.iter().any(|(&frame, &was)| {
            let is = atlas.here_from(frame).map(|here_from_frame| floor_from_here * here_from_frame);
            is.is_none_or(|is| {
                let moved = was.from_here(is);
                moved.position.length() > SHIFT[0] || moved.heading.abs() > SHIFT[1]
            })
        })
    }

    /// Where a place lies on the floor.
    fn place(&mut self, atlas: &Atlas, frame: FrameId) -> Option<Pose> {
        if let Some(&place) = self.layout.get(&frame) {
            return Some(place);
        }
        let place = self.floor_from_here(atlas)? * atlas.here_from(frame)?;
        self.layout.insert(frame, place);
        Some(place)
    }

    fn add_surfaces(&mut self, mapper: &Mapper, atlas: &Atlas) {
        let mfis = mapper.mfis();
        for stored in mfis.surfaces().iter().skip(self.surfaces) {
            let Some(floor_from_frame) = self.place(atlas, stored.frame) else {
                self.missing = Some(stored.frame);
                continue;
            };
            if mfis.remembers(stored.id) {
                self.floor.remember_wall(floor_from_frame * stored.segment);
            }
        }
        self.surfaces = mfis.surfaces().len();
    }

    fn add_path(&mut self, mapper: &Mapper, atlas: &Atlas) {
        let path = mapper.path();
        for k in self.path..path.len() {
            let at = |k: usize, ground: &mut Self| -> Option<DVec2> {
                let point = path.get(k)?;
                Some(ground.place(atlas, point.frame)? * point.frame_from_robot.position)
            };
            let Some(to) = at(k, self) else { continue };
            let from = k.checked_sub(1).and_then(|k| at(k, self)).filter(|from| from.distance(to) < 3.0);
            self.floor.travel(Segment::new(from.unwrap_or(to), to));
        }
        self.path = path.len();
    }
}
