use cogmap_geometry::{DVec2, trig};
use cogmap_mapping::{Sentence, say};
use serde::{Deserialize, Serialize};

use super::footing::Trust;
use crate::{
    HomingEvent, Mode,
    strategy::{Proposal, Situation, Wish},
};

/// When the fail-safe takes over, and when the robot gives up.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct RescueParams {
    /// Within this distance the robot has not come on, metres.
    pub progress: f64,
    /// So many decisions without coming on call the fail-safe.
    pub patience: usize,
    /// The fail-safe has done its work so far from where it was called, metres.
    pub rescued: f64,
    /// So often it may be called before the robot gives up.
    pub calls: usize,
    /// So often the robot looks aside, by a right angle each time, before it believes that there is no way.
    pub looks: usize,
    /// So often it distrusts what it remembers because that leaves no way, before it gives up.
    pub distrusts: usize,
    /// So often it hopes in vain that a wall which it saw long ago is gone, before it believes in all of them.
    pub hopes: usize,
    /// The robot gives up after so many times the length of its way out …
    pub budget: f64,
    /// … and so many metres.
    pub budget_base: f64,
}

impl Default for RescueParams {
    fn default() -> Self {
        Self {
            progress: 0.4,
            patience: 10,
            rescued: 1.5,
            calls: 8,
            looks: 4,
            distrusts: 2,
            hopes: 4,
            budget: 8.0,
            budget_base: 60.0,
        }
    }
}

/// What leads.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Lead {
    /// All that is remembered.
    Planning,
    /// The way that the robot has gone itself, and what it sees right now (§3.3.4).
    OwnWay,
}

/// The fail-safe: notices that the robot does not come on.
#[derive(Clone, Debug)]
pub(super) struct Rescue {
    params: RescueParams,
    lead: Lead,
    /// From where the robot should come on, and the decisions since.
    anchor: Option<DVec2>,
    waited: usize,
    /// Where the fail-safe was called.
    called: Option<DVec2>,
    calls: usize,
    looks: usize,
    distrusts: usize,
    /// Whether the robot hopes that a wall is gone, and how often it did so in vain.
    hoping: bool,
    dashed: usize,
    last: Option<DVec2>,
    /// Metres that the robot may still go.
    left: f64,
}

impl Lead {
    pub(super) fn mode(self) -> Mode {
        match self {
            Self::Planning => Mode::Planning,
            Self::OwnWay => Mode::Route,
        }
    }
}

impl Rescue {
    /// A fail-safe for a robot that has come so far, metres.
    pub(super) fn new(params: &RescueParams, way_out: f64) -> Self {
        Self {
            params: params.clone(),
            lead: Lead::Planning,
            anchor: None,
            waited: 0,
            called: None,
            calls: 0,
            looks: 0,
            distrusts: 0,
            hoping: false,
            dashed: 0,
            last: None,
            left: params.budget * way_out + params.budget_base,
        }
    }

    /// What leads now that the robot is here, on the floor.
    pub(super) fn lead(&mut self, robot: DVec2, events: &mut Vec<HomingEvent>) -> Lead {
        self.left -= self.last.replace(robot).map_or(0.0, |last| last.distance(robot));
        if self.anchor.is_none_or(|anchor| anchor.distance(robot) > self.params.progress) {
            self.anchor = Some(robot);
            self.waited = 0;
        }
        self.waited += 1;
        if self.lead == Lead::OwnWay && self.called.is_none_or(|at| at.distance(robot) > self.params.rescued)
        {
            self.lead = Lead::Planning;
            let why = say("the robot has come on again and plans as before", &[]);
            events.push(HomingEvent::FailsafeOff { why });
        }
        if self.waited > self.params.patience {
            self.waited = 0;
            let why = say("the robot has not come on for {} decisions", &[(self.params.patience as f64, 0)]);
            self.call(robot, why, events);
        }
        self.lead
    }

    fn call(&mut self, robot: DVec2, why: Sentence, events: &mut Vec<HomingEvent>) {
        self.calls += 1;
        if self.lead == Lead::Planning {
            self.lead = Lead::OwnWay;
            self.called = Some(robot);
            events.push(HomingEvent::FailsafeOn { why });
        } else {
            self.lead = Lead::Planning;
        }
    }

    /// Why the robot should give up, where it has tried enough.
    pub(super) fn is_spent(&self) -> Option<Sentence> {
        if self.calls > self.params.calls {
            return Some(say(
                "the fail-safe has been called {} times in vain",
                &[(self.params.calls as f64, 0)],
            ));
        }
        (self.left < 0.0).then(|| say("the robot has gone many times its way out without coming home", &[]))
    }

    /// A way was found, which leads through a wall of long ago or not.
    pub(super) fn settle(&mut self, hoping: bool) {
        self.looks = 0;
        self.hoping = hoping;
    }

    /// The way that the robot had in mind turned out closed.
    pub(super) fn closed(&mut self) {
        self.dashed += usize::from(std::mem::take(&mut self.hoping));
    }

    /// Which part of the memory the robot goes by.
    pub(super) fn trust(&self) -> Trust {
        match self.lead {
            Lead::OwnWay => Trust::OwnWay,
            Lead::Planning if self.dashed >= self.params.hopes => Trust::Everything,
            Lead::Planning => Trust::Memory,
        }
    }

    /// Looks around where there is no way; then distrusts what it remembers, looks around again, and gives up.
    pub(super) fn no_way(&mut self, situation: &Situation, events: &mut Vec<HomingEvent>) -> Proposal {
        self.looks += 1;
        let mode = self.lead.mode();
        if self.looks > self.params.looks {
            if self.lead == Lead::OwnWay || self.distrusts >= self.params.distrusts {
                let why = say("every way home that the robot knows or can think of is closed", &[]);
                return Proposal::new(Wish::GiveUp, mode, why);
            }
            self.looks = 1;
            self.distrusts += 1;
            let floor = self.last.unwrap_or_default();
            self.call(
                floor,
                say("what the robot remembers leaves no way: it trusts its eyes alone", &[]),
                events,
            );
        }
        let why = say("every way home that the robot knows or can think of seems closed", &[]);
        let bearing = situation.belief.here_from_robot.heading + trig::FRAC_PI_2;
        Proposal::new(Wish::Face(bearing), mode, why)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_robot_that_does_not_come_on_calls_the_failsafe_and_one_that_does_is_handed_back() {
        let params = RescueParams::default();
        let (mut rescue, mut events) = (Rescue::new(&params, 10.0), Vec::new());
        let leads: Vec<Lead> = (0..12).map(|_| rescue.lead(DVec2::ZERO, &mut events)).collect();
        assert_eq!((leads[0], *leads.last().unwrap()), (Lead::Planning, Lead::OwnWay));
        assert_eq!(rescue.lead(DVec2::new(2.0, 0.0), &mut events), Lead::Planning);
        assert!(matches!(events[..], [HomingEvent::FailsafeOn { .. }, HomingEvent::FailsafeOff { .. }]));
    }

    #[test]
    fn a_robot_that_has_gone_too_far_gives_up() {
        let params = RescueParams { budget: 2.0, budget_base: 1.0, ..RescueParams::default() };
        let mut rescue = Rescue::new(&params, 3.0);
        for k in 0..9 {
            assert_eq!(rescue.is_spent(), None, "{k}");
            rescue.lead(DVec2::new(f64::from(k % 2), 0.0), &mut Vec::new());
        }
        assert!(rescue.is_spent().is_some());
    }

    #[test]
    fn hopes_that_were_in_vain_too_often_make_every_wall_stand() {
        let params = RescueParams { hopes: 2, ..RescueParams::default() };
        let mut rescue = Rescue::new(&params, 10.0);
        for hoping in [true, false, true] {
            assert_eq!(rescue.trust(), Trust::Memory);
            rescue.settle(hoping);
            rescue.closed();
        }
        assert_eq!(rescue.trust(), Trust::Everything);
    }
}
