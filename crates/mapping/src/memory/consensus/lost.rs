use cogmap_geometry::{Pose, trig};
use serde::{Deserialize, Serialize};

use super::look::{Agreement, FreeSpace};

/// When the robot notices that it is not where it believed to be. Entering new space is no reason: what
/// is new contradicts nothing.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Loss {
    /// Whether to notice at all.
    pub on: bool,
    /// When a view and the last one contradict each other. They were taken so near to each other that
    /// this can be sharper than what is said of older ones.
    pub free_space: FreeSpace,
    /// A view is doubted when more than this share of the beams contradicts, wherever odometry can have
    /// carried the robot …
    pub contradiction: f64,
    /// … of so many that tell anything. A doubted view is the last one when the next has as many …
    pub evidence: u32,
    /// … of which no more than this share contradicts.
    pub settled: f64,
    /// The robot is lost after so many doubted views in a row; none of them is mapped …
    pub views: u32,
    /// … whose shares add up to this.
    pub certain: f64,
    /// Odometry can err by so many times what it was found to err in the mean …
    pub error_times: f64,
    /// … of about so many views, …
    pub error_views: f64,
    /// … and this, metres …
    pub error: f64,
    /// … or this, radians.
    pub error_turn: f64,
}

impl Default for Loss {
    fn default() -> Self {
        Self {
            on: true,
            free_space: FreeSpace { margin: 0.08, margin_per_range: 0.02 },
            contradiction: 0.12,
            evidence: 20,
            settled: 0.1,
            views: 2,
            certain: 0.7,
            error_times: 4.0,
            error_views: 20.0,
            error: 0.05,
            error_turn: 2.0 * trig::PI / 180.0,
        }
    }
}

impl Loss {
    /// Whether a view was not taken where it bears the last one out so far.
    pub(super) fn doubts(&self, agreement: Agreement, doubt: Doubt) -> bool {
        let told = agreement.evidence() >= self.evidence;
        if doubt.views == 0 {
            told && agreement.contradiction() > self.contradiction
        } else {
            !told || agreement.contradiction() > self.settled
        }
    }

    /// Whether these doubts are enough to be lost.
    pub(super) fn is_lost(&self, doubt: Doubt) -> bool {
        doubt.views >= self.views && doubt.contradiction >= self.certain
    }
}

/// The views in a row that cannot have been taken where the robot believes to be.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Doubt {
    /// How many.
    pub(super) views: u32,
    /// What share of each contradicted, added up.
    contradiction: f64,
}

impl Doubt {
    /// One more. Where too little tells anything, the doubt grows as if it had not quite settled.
    pub(super) fn grow(&mut self, agreement: Agreement, params: &Loss) {
        self.views += 1;
        self.contradiction += agreement.contradiction().max(params.settled);
    }
}

/// How much odometry errs from view to view: it is found out in each that is recognised.
#[derive(Clone, Copy, Debug)]
pub(super) struct Habit {
    /// The mean of its square, square metres …
    way: f64,
    /// … and square radians.
    turn: f64,
}

impl Default for Habit {
    /// A robot does not know its wheels to begin with.
    fn default() -> Self {
        Self { way: 0.1 * 0.1, turn: 0.1 * 0.1 }
    }
}

impl Habit {
    /// Odometry was wrong by so much.
    pub(super) fn learn(&mut self, by: Pose, params: &Loss) {
        let share = 1.0 / params.error_views;
        self.way += share * (by.position.length_squared() - self.way);
        self.turn += share * (by.heading * by.heading - self.turn);
    }

    /// Whether it can be wrong by so much after so many views.
    pub(super) fn allows(&self, by: Pose, views: u32, params: &Loss) -> bool {
        let times = params.error_times * f64::from(views);
        by.position.length() <= params.error + times * self.way.sqrt()
            && by.heading.abs() <= params.error_turn + times * self.turn.sqrt()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn agreement(agreeing: u32, contradicting: u32) -> Agreement {
        Agreement { agreeing, contradicting }
    }

    #[test]
    fn a_doubt_outlasts_a_view_that_tells_nothing() {
        let loss = Loss::default();
        let (none, mut some) = (Doubt::default(), Doubt::default());
        some.grow(agreement(50, 50), &loss);
        for (view, first, after) in [
            (agreement(0, 0), false, true),
            (agreement(100, 0), false, false),
            (agreement(89, 11), false, true),
            (agreement(80, 20), true, true),
        ] {
            assert_eq!((loss.doubts(view, none), loss.doubts(view, some)), (first, after), "{view:?}");
        }
    }

    #[test]
    fn one_view_is_never_enough_and_weak_doubts_take_longer() {
        let loss = Loss::default();
        let views = |contradicting: u32| {
            let mut doubt = Doubt::default();
            while !loss.is_lost(doubt) {
                doubt.grow(agreement(100 - contradicting, contradicting), &loss);
            }
            doubt.views
        };
        assert_eq!([100, 50, 20, 0].map(views), [2, 2, 4, 7]);
    }

    #[test]
    fn odometry_may_err_as_it_was_found_to_err_before() {
        let loss = Loss::default();
        let (jump, turn) = (Pose::new(0.3, 0.0, 0.0), Pose::new(0.0, 0.0, 0.3));
        let habit_of = |by: Pose| {
            let mut habit = Habit::default();
            (0..100).for_each(|_| habit.learn(by, &loss));
            habit
        };
        let good = habit_of(Pose::new(0.005, 0.0, 0.005));
        assert!(!good.allows(jump, 1, &loss) && !good.allows(turn, 1, &loss));
        let bad = habit_of(Pose::new(0.0, 0.1, 0.1));
        assert!(bad.allows(jump, 1, &loss) && bad.allows(turn, 1, &loss));
    }
}
