use cogmap_geometry::DVec2;
use serde::{Deserialize, Serialize};

use crate::{Anchored, Atlas, route::Route, strategy::Situation};

/// When the remembered route takes over, and how it is followed (§3.3.3–§3.3.4).
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct FailsafeParams {
    /// Whether there is a fail-safe at all.
    pub on: bool,
    /// It takes over too where so many decisions in a row have brought the robot nowhere: ours, for it does
    /// not only get stuck without options but also between two of them. 0 for never.
    pub patience: usize,
    /// Nowhere is within this distance, metres.
    pub nowhere: f64,
    /// Whether the sense of direction takes over again as soon as an option toward home appears (§3.3.4:
    /// always try a shortcut). Otherwise the route is followed to its end.
    pub shortcuts: bool,
    /// Not before the robot has come so far along the route, metres.
    pub leave: f64,
    /// How far the path may lie from the line between two waypoints, metres.
    pub tolerance: f64,
    /// A waypoint counts as passed from here, metres.
    pub passed: f64,
}

impl Default for FailsafeParams {
    fn default() -> Self {
        Self {
            on: true,
            patience: 10,
            nowhere: 1.0,
            shortcuts: true,
            leave: 1.0,
            tolerance: 0.15,
            passed: 0.3,
        }
    }
}

/// Counts the decisions that brought the robot nowhere.
#[derive(Clone, Debug, Default)]
pub(crate) struct Patience {
    anchor: Option<Anchored<DVec2>>,
    decisions: usize,
}

impl Patience {
    /// How many decisions in a row, this one included, have not led farther than `nowhere` metres away.
    pub(crate) fn wear(&mut self, here: DVec2, atlas: &Atlas, nowhere: f64) -> usize {
        let anchor = self.anchor.and_then(|anchor| atlas.point(anchor));
        if anchor.is_none_or(|anchor| anchor.distance(here) > nowhere) {
            self.anchor = Some(atlas.keep(here));
            self.decisions = 0;
        }
        self.decisions += 1;
        self.decisions
    }

    pub(crate) fn renew(&mut self) {
        *self = Self::default();
    }
}

/// The remembered route being followed.
#[derive(Clone, Debug)]
pub(crate) struct Following {
    route: Route,
    /// How many waypoints are still ahead.
    ahead: usize,
    /// Of what was remembered before this scan at rest nothing counts: what blocks may be wrong
    /// (Fig. 3.30).
    pub(crate) since: usize,
    /// Where the robot began to follow.
    from: Anchored<DVec2>,
}

impl Following {
    /// Begins where the robot stands, with a fresh scan.
    pub(crate) fn begin(situation: &Situation, tolerance: f64, scan: usize) -> Self {
        let from = situation.atlas.keep(situation.belief.here_from_robot.position);
        let route = Route::without_loops(situation.mapper, tolerance, 2.0 * tolerance);
        Self { route, ahead: usize::MAX, since: scan, from }
    }

    /// The waypoints still ahead, home first; the robot is on the way to the last.
    pub(crate) fn waypoints(&mut self, here: DVec2, atlas: &Atlas, passed: f64) -> Vec<DVec2> {
        let mut waypoints = self.route.seen_from(atlas);
        self.ahead = self.ahead.min(waypoints.len());
        while self.ahead > 1 && waypoints[self.ahead - 1].distance(here) <= passed {
            self.ahead -= 1;
        }
        waypoints.truncate(self.ahead);
        waypoints
    }

    /// Metres from where the robot began to follow.
    pub(crate) fn come(&self, here: DVec2, atlas: &Atlas) -> f64 {
        atlas.point(self.from).map_or(0.0, |from| from.distance(here))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn to_and_fro_is_nowhere() {
        let (mut patience, atlas) = (Patience::default(), Atlas::single());
        let worn = (0..6).map(|k| {
            let x = if k % 2 == 0 { 0.0 } else { 0.9 };
            patience.wear(DVec2::new(x, 0.0), &atlas, 1.0)
        });
        assert_eq!(worn.collect::<Vec<_>>(), [1, 2, 3, 4, 5, 6]);
        assert_eq!(patience.wear(DVec2::new(1.1, 0.0), &atlas, 1.0), 1);
    }
}
