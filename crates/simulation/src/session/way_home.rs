use cogmap_mapping::Sentence;
use cogmap_navigation::{Atlas, Belief, Decision, HomingEvent};

use super::{Homeward, Session, Source, Stamped, guide, pilot::length};
use crate::{Strategy, shortest_way};

/// How the last way home went, or goes.
#[derive(Clone, Debug, PartialEq)]
pub struct WayHome<'a> {
    /// Who found it.
    pub strategy: &'a Strategy,
    /// What the robot decided on it.
    pub decisions: &'a [Decision],
    /// How it ended; `None` while the robot is on its way.
    pub ending: Option<Ending<'a>>,
    /// Metres driven until the robot made the first decision on it.
    pub way_out: f64,
    /// Metres driven since.
    pub way_home: f64,
    /// Metres of the shortest way for a disc of its size through the building as it is now; `None` where no
    /// way leads home.
    pub shortest: Option<f64>,
    /// Metres from where the robot stands to where the run began.
    pub distance: f64,
    /// The same as the robot believes it; `None` where it knows no way back.
    pub believed: Option<f64>,
}

/// How a way home ended.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Ending<'a> {
    /// The robot stopped and said so: home is here.
    Home,
    /// The robot gave up, and why.
    Stuck(&'a Sentence),
    /// The user took over.
    Stopped,
}

impl Session {
    /// The last way home up to now; `None` where the robot was never told to go home. The shortest way is
    /// searched for anew at each call.
    #[must_use]
    pub fn way_home(&self) -> Option<WayHome<'_>> {
        let (world, here) = (self.world()?, self.world_from_robot()?.position);
        let Source::World { robot, .. } = &self.record.source else { return None };
        let Homeward { strategy, scans, decisions } = self.journal.homings.last()?;
        let (decisions, start) = (self.journal.decisions.get(*decisions..)?, world.start.position.into());
        let truth = &self.journal.truth;
        let from = truth.get(scans.checked_sub(1)?)?.pose.position;
        let along = |scans: &[Stamped]| length(scans.iter().map(|scan| scan.pose.position));
        let driven = truth.get(*scans..)?.iter().map(|scan| scan.pose.position);
        Some(WayHome {
            strategy,
            decisions,
            ending: self.ending(decisions),
            way_out: along(truth.get(..*scans)?),
            way_home: length([from].into_iter().chain(driven).chain([here])),
            shortest: shortest_way(world, robot.body.radius, from, start),
            distance: here.distance(start),
            believed: self.believed_distance(),
        })
    }

    fn ending<'a>(&self, decisions: &'a [Decision]) -> Option<Ending<'a>> {
        if self.homing().is_some() {
            return None;
        }
        let last = decisions.last().into_iter().flat_map(|decision| &decision.events);
        let mut by_itself = last.filter_map(|event| match event {
            HomingEvent::Home { .. } => Some(Ending::Home),
            HomingEvent::Stuck { why } => Some(Ending::Stuck(why)),
            _ => None,
        });
        by_itself.next_back().or(Some(Ending::Stopped))
    }

    fn believed_distance(&self) -> Option<f64> {
        let mapper = guide(&self.live.mappers, &self.record)?;
        Belief::of(mapper, &Atlas::of(mapper), self.odom_from_robot())?.distance_home()
    }
}
