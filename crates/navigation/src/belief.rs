use std::collections::BTreeMap;

use cogmap_geometry::{DVec2, Pose};
use cogmap_mapping::{
    Mapper,
    memory::{FrameId, StoredSurface},
};
use serde::{Deserialize, Serialize};

/// Something that the robot keeps in the coordinates of the place where it learnt it.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Anchored<T> {
    /// The place.
    pub frame: FrameId,
    /// What is kept, in that frame.
    pub value: T,
}

/// How the places of a map lie to the one that the robot is in: "here". A map with one frame has one
/// place; with several, the links say, and a place that is recognised brings home nearer (§3.2.3).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Atlas {
    here: FrameId,
    here_from_frame: BTreeMap<FrameId, Pose>,
    links: usize,
    /// Places that the robot went on to without knowing how they lie to the one before: what the wheels
    /// said there is the best guess until something better is known.
    guesses: Vec<Guess>,
}

/// How a place lies to another, as far as the wheels say.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Guess {
    left: FrameId,
    opened: FrameId,
    left_from_opened: Pose,
}

impl Atlas {
    /// The places as they lie to the one that the mapper believes the robot to be in.
    #[must_use]
    pub fn of(mapper: &Mapper) -> Self {
        let mfis = mapper.mfis();
        let here = mapper.path().last().map_or(FrameId::default(), |last| last.frame);
        let mut atlas = Self { here, links: mfis.links().len(), ..Self::default() };
        atlas.add(mapper, here, Pose::IDENTITY);
        atlas
    }

    /// Adds the places that links connect with one that lies so to here.
    fn add(&mut self, mapper: &Mapper, frame: FrameId, here_from_frame: Pose) {
        for (place, way) in mapper.mfis().ways_from(frame, f64::INFINITY) {
            self.here_from_frame.insert(place, here_from_frame * way.here_from_frame);
        }
    }

    /// A mapper that is lost begins a place without a link (§3.2.4). On the way home nobody has carried the
    /// robot off: more likely the world has changed, and the wheels say how the place lies.
    fn guess(&mut self, mapper: &Mapper, before: &Self) {
        let mfis = mapper.mfis();
        self.guesses.clone_from(&before.guesses);
        if before.here != self.here && self.here_from(before.here).is_none() {
            let [left, opened] = [before.here, self.here].map(|frame| mfis.map_from_frame(frame));
            let left_from_opened = left.from_here(opened);
            self.guesses.push(Guess { left: before.here, opened: self.here, left_from_opened });
        }
        for guess in self.guesses.clone().iter().rev() {
            let [left, opened] = [guess.left, guess.opened].map(|frame| self.here_from(frame));
            match (left, opened) {
                (None, Some(opened)) => {
                    self.add(mapper, guess.left, opened * guess.left_from_opened.inverse());
                }
                (Some(left), None) => self.add(mapper, guess.opened, left * guess.left_from_opened),
                _ => {}
            }
        }
    }

    /// A map of one place.
    #[cfg(test)]
    pub(crate) fn single() -> Self {
        let here = FrameId::default();
        Self { here, here_from_frame: BTreeMap::from([(here, Pose::IDENTITY)]), ..Self::default() }
    }

    /// Looks again where the robot has come to another place or learnt how two places lie to each
    /// other; `true` where it did.
    pub fn refresh(&mut self, mapper: &Mapper) -> bool {
        let here = mapper.path().last().map_or(FrameId::default(), |last| last.frame);
        let stale =
            here != self.here || self.links != mapper.mfis().links().len() || self.here_from_frame.is_empty();
        if stale {
            let before = std::mem::replace(self, Self::of(mapper));
            self.guess(mapper, &before);
        }
        stale
    }

    /// The place that all others are seen from.
    #[must_use]
    pub fn here(&self) -> FrameId {
        self.here
    }

    /// Where a place lies; `None` where no link leads to it.
    #[must_use]
    pub fn here_from(&self, frame: FrameId) -> Option<Pose> {
        self.here_from_frame.get(&frame).copied()
    }

    /// A point that is kept in a place, as it lies here.
    #[must_use]
    pub fn point(&self, kept: Anchored<DVec2>) -> Option<DVec2> {
        Some(self.here_from(kept.frame)? * kept.value)
    }

    /// A pose that is kept in a place, as it lies here.
    #[must_use]
    pub fn pose(&self, kept: Anchored<Pose>) -> Option<Pose> {
        Some(self.here_from(kept.frame)? * kept.value)
    }

    /// A stored surface, as it lies here.
    #[must_use]
    pub fn surface(&self, stored: &StoredSurface) -> Option<cogmap_geometry::Segment> {
        Some(self.here_from(stored.frame)? * stored.segment)
    }

    /// A point here, to be kept.
    #[must_use]
    pub fn keep<T>(&self, value: T) -> Anchored<T> {
        Anchored { frame: self.here, value }
    }
}

/// What the robot believes about itself and its home, in the place where it is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Belief {
    /// The place.
    pub here: FrameId,
    /// Where the robot is in it.
    pub here_from_robot: Pose,
    /// Where the run began, as it lies here; `None` where no link leads back to it.
    pub home: Option<Pose>,
}

impl Belief {
    /// What a mapper believes when odometry stands there; `None` before its first view.
    #[must_use]
    pub fn of(mapper: &Mapper, atlas: &Atlas, odom_from_robot: Pose) -> Option<Self> {
        let (here, here_from_robot) = mapper.frame_from_robot(odom_from_robot)?;
        let first = mapper.path().first()?;
        let home = atlas.pose(Anchored { frame: first.frame, value: first.frame_from_robot });
        Some(Self { here, here_from_robot, home })
    }

    /// Metres in a straight line to where home is believed to be.
    #[must_use]
    pub fn distance_home(&self) -> Option<f64> {
        Some(self.home?.position.distance(self.here_from_robot.position))
    }
}
