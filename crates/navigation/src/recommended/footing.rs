use serde::{Deserialize, Serialize};

use super::{
    floor::{Floor, Spot},
    tiles::{CELL, Cell},
};

/// What it costs to go somewhere, by what is remembered of the floor there; a metre of floor that is
/// known to be free costs 1.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Footing {
    /// A metre of floor that was never seen, for a robot that has not been disappointed yet.
    pub unknown: f64,
    /// Nothing leads the robot's middle nearer than this to what is believed to stand somewhere, metres: a little
    /// less than its radius, because what is seen from afar is seen a little beside its place.
    pub hard: f64,
    /// Nearer than this each metre costs …
    pub tight: f64,
    /// … so many times as much, except where the robot has passed itself.
    pub tight_cost: f64,
    /// Nearer than this to something each metre costs …
    pub soft: f64,
    /// … so many times as much.
    pub soft_cost: f64,
    /// What stands nearer to the robot than this is trusted, metres, …
    pub near: f64,
    /// … and what was found again in so many of the last decisions.
    pub recent: u16,
    /// What is neither leaves a barrier: a metre of it costs this, times (1 + visits)².
    pub barrier: f64,
    /// A metre within the robot's leeway although something seems to stand too near.
    pub squeeze: f64,
    /// So near to itself the robot may squeeze, metres.
    pub leeway: f64,
}

impl Default for Footing {
    fn default() -> Self {
        Self {
            unknown: 1.6,
            hard: 0.21,
            tight: 0.26,
            tight_cost: 3.0,
            soft: 0.40,
            soft_cost: 1.3,
            near: 5.0,
            recent: 10,
            barrier: 100.0,
            squeeze: 20.0,
            leeway: 0.35,
        }
    }
}

/// Which part of the memory is trusted.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Trust {
    /// All of it, each thing as the parameters say.
    Memory,
    /// All of it, however old: walls that were believed gone have turned out to stand too often.
    Everything,
    /// What the last scans found, and the way that the robot itself has gone (§3.3.4).
    OwnWay,
}

/// What one decision makes of the floor.
#[derive(Clone, Copy, Debug)]
pub(super) struct Ease<'a> {
    pub(super) floor: &'a Floor,
    pub(super) footing: &'a Footing,
    pub(super) trust: Trust,
    pub(super) robot: Cell,
    pub(super) moment: u16,
}

/// What a cell costs, in tenths a metre; the highest value stands for "no way".
pub(super) const NO_WAY: u16 = u16::MAX;
/// Beyond the way that it has gone everything costs so much more for a robot that trusts nothing else.
const OFF_THE_WAY: f64 = 4.0;
/// Found within so many decisions counts as seen by the last scans.
const LAST: u16 = 3;

impl Ease<'_> {
    /// What a metre there costs, in tenths.
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a float saturates")]
    pub(super) fn cost(&self, cell: Cell) -> u16 {
        let spot = self.floor.spot(cell);
        let base = self.base(spot);
        if spot.crowd() == 0 {
            return (10.0 * base) as u16;
        }
        let (nearest, firmness) = self.around(cell);
        let firmness = f64::from(firmness);
        let barrier = self.footing.barrier * firmness * firmness;
        let cost = if nearest < self.footing.hard {
            if !self.within_leeway(cell) {
                return NO_WAY;
            }
            base * self.footing.squeeze
        } else if nearest < self.footing.tight && !spot.is_travelled() {
            base * self.footing.tight_cost
        } else if nearest < self.footing.soft {
            base * self.footing.soft_cost
        } else {
            base
        };
        ((10.0 * (cost + barrier)) as u16).min(NO_WAY - 1)
    }

    /// How firm the wall of long ago that stands in the way at a cell is: 0 where there is none, else one more
    /// than it was met.
    pub(super) fn barrier(&self, cell: Cell) -> u8 {
        if self.floor.spot(cell).crowd() == 0 { 0 } else { self.around(cell).1 }
    }

    fn base(&self, spot: Spot) -> f64 {
        match self.trust {
            _ if spot.is_travelled() => 1.0,
            Trust::Memory | Trust::Everything if spot.is_known_free() => 1.0,
            Trust::Memory | Trust::Everything => self.footing.unknown,
            Trust::OwnWay => OFF_THE_WAY,
        }
    }

    fn within_leeway(&self, cell: Cell) -> bool {
        let leeway = self.footing.leeway / CELL;
        f64::from(cell.distance_squared(self.robot)) <= leeway * leeway
    }

    /// Metres to the nearest thing that is trusted, and how firm the firmest of the others is.
    fn around(&self, cell: Cell) -> (f64, u8) {
        let (mut nearest, mut firmness) = (f64::INFINITY, 0);
        let middle = cell.middle();
        self.floor.look_around(cell, |at, spot| {
            let distance = (at.middle() + spot.at()).distance_squared(middle);
            if self.is_trusted(at, spot) {
                nearest = nearest.min(distance);
            } else if self.trust == Trust::Memory && distance < self.footing.tight * self.footing.tight {
                firmness = firmness.max(spot.visits().saturating_add(1));
            }
        });
        (nearest.sqrt(), firmness)
    }

    fn is_trusted(&self, at: Cell, spot: Spot) -> bool {
        let age = self.moment.wrapping_sub(spot.met());
        match self.trust {
            Trust::OwnWay => spot.is_found() && age <= LAST,
            Trust::Everything => true,
            Trust::Memory => {
                let near = self.footing.near / CELL;
                (spot.is_found() && age <= self.footing.recent)
                    || f64::from(at.distance_squared(self.robot)) <= near * near
            }
        }
    }
}
