use std::rc::Rc;

use cogmap_geometry::DVec2;
use cogmap_simulation::Command;

use super::Run;
use crate::{
    courses::{Branch, Course, Deed},
    failure::Failure,
    order::{Order, step_to},
};

/// What a person does to a run, and how it is undone.
impl Run {
    /// Ends the playing of the route: the robot finishes its step and waits.
    pub(crate) fn take_over(&mut self) {
        if self.driver.is_some() {
            self.courses.leave(&self.session, self.course());
        }
        self.driver = None;
    }

    /// Tells the robot what to do; a log's robot cannot be told anything.
    pub(crate) fn order(&mut self, order: Order) -> Result<(), Failure> {
        if let Some(robot) = self.robot() {
            self.tell(order.command(&robot.body)?);
        }
        Ok(())
    }

    /// Sends the robot straight to a point of the world; `false` if it cannot be sent there.
    pub(crate) fn reach(&mut self, point: DVec2) -> bool {
        let step = self.session.world_from_robot().and_then(|pose| step_to(point, pose));
        step.map(|step| self.tell(step)).is_some()
    }

    fn tell(&mut self, command: Command) {
        if self.session.refusal(&command).is_none() && !self.steers_on() {
            self.courses.leave(&self.session, self.course());
        }
        self.driver = None;
        self.enter(command);
    }

    /// Writes a command down, from which on the run goes on beyond what is recorded.
    pub(crate) fn enter(&mut self, command: Command) {
        self.live = true;
        self.told = true;
        self.session.command(command);
        self.forget_after(self.session.position());
    }

    /// Whether a person is steering right now: what is told then belongs to the same deed.
    fn steers_on(&self) -> bool {
        let told = self.session.record().commands().iter().map(|timed| &timed.command);
        let last = told.rev().find(|command| !matches!(command, Command::Change(_)));
        let moves =
            matches!(last, Some(Command::Drive { linear, angular }) if *linear != 0.0 || *angular != 0.0);
        moves && self.driver.is_none() && self.session.position() >= self.session.end()
    }

    pub(super) fn course(&self) -> Course {
        let (source, position) = (self.session.record().source.clone().into(), self.session.position());
        let driver = self.driver.clone().map(Rc::new);
        Course { source, driver, drawn: self.drawn, live: self.live, position }
    }

    /// Takes back the last thing that a person told the robot; `false` if there is none.
    pub(crate) fn undo(&mut self) -> bool {
        let Some(deed) = self.courses.undo.pop() else { return false };
        let undone = self.deed();
        self.go_over_to(deed);
        self.courses.redo.push(undone);
        true
    }

    /// Does again what was undone; `false` if there is nothing.
    pub(crate) fn redo(&mut self) -> bool {
        let Some(deed) = self.courses.redo.pop() else { return false };
        let done = self.deed();
        self.go_over_to(deed);
        self.courses.undo.push(done);
        true
    }

    fn deed(&self) -> Deed {
        Deed { course: self.course(), branches: self.courses.branches.clone() }
    }

    /// Goes over to the future that was left longest ago, and keeps this one in its place.
    pub(crate) fn switch_branch(&mut self) {
        if self.courses.branches.is_empty() {
            return;
        }
        let here = self.session.position();
        let left = self.deed();
        let branch = self.courses.branches.remove(0);
        let mut branches = std::mem::take(&mut self.courses.branches);
        let parting = self.session.record().source.parts_from(&branch.course.source).unwrap_or(0);
        branches.push(Branch {
            course: left.course.clone(),
            way: self.courses.way(&self.session, parting).into(),
        });
        self.courses.undo.push(left);
        self.courses.redo.clear();
        let course = Course { position: here, ..branch.course };
        self.go_over_to(Deed { course, branches });
    }

    fn go_over_to(&mut self, Deed { course, branches }: Deed) {
        let parting = self.session.record().source.parts_from(&course.source).unwrap_or(0);
        if self.session.go_over_to(&course.source) {
            self.forget_after(parting);
            self.courses.go_over();
            (self.live, self.drawn, self.courses.branches) = (course.live, course.drawn, branches);
            self.driver = course.driver.map(Rc::unwrap_or_clone);
            self.jump(course.position);
        }
    }

    /// Where the robot went in the futures that were left, in the world, metres.
    pub(crate) fn left_ways(&self) -> impl Iterator<Item = &[DVec2]> {
        self.courses.branches.iter().map(|branch| &*branch.way)
    }
}
