use std::rc::Rc;

use cogmap_formats::situation::{self, Situation};
use cogmap_geometry::{DVec2, Pose};
use cogmap_mapping::MapperSetup;
use cogmap_simulation::{Command, Driver, Robot, Session, Source, Stamped, TICK};

use crate::{
    courses::{Branch, Course, Courses, Deed},
    failure::Failure,
    homing::homing,
    landmarks::{Landmark, Landmarks},
    memories::memories,
    order::{Order, step_to},
    resumption::Resumption,
    status::{SourceKind, Status},
};

/// A step that has not led to a view after so many ticks is not waited for any longer.
const LONGEST_STEP: u64 = 5_000;

/// What a run is called.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Label {
    /// For people.
    pub(crate) name: String,
    /// For the files that are saved from it.
    pub(crate) stem: String,
    /// Whether it came from a file that somebody brought.
    pub(crate) foreign: bool,
    /// Whether that file says with what it runs.
    pub(crate) settled: bool,
    /// The name under which the page knows the building, if it does.
    pub(crate) building: Option<String>,
    /// What may make it differ from the recorded run.
    pub(crate) warnings: Vec<String>,
}

/// A session, and whoever drives it: the route's driver, the record, or a person.
pub(crate) struct Run {
    session: Session,
    label: Label,
    driver: Option<Driver>,
    /// Whether the robot may go on beyond what is recorded.
    live: bool,
    /// Whether an order was given that no tick has seen yet.
    told: bool,
    landmarks: Landmarks,
    courses: Courses,
    /// What is still to be gone through again, where a run is taken up at a moment.
    resumption: Option<Resumption>,
}

impl Run {
    /// A run that its driver takes along a route; without one the robot waits for orders.
    pub(crate) fn new(session: Session, label: Label, driver: Option<Driver>) -> Self {
        let live = driver.is_some();
        let (landmarks, courses) = (Landmarks::default(), Courses::default());
        Self { session, label, driver, live, told: false, landmarks, courses, resumption: None }
    }

    /// A run that has to be gone through again, turn by turn with [`Run::resume`], before it can be taken up.
    pub(crate) fn resuming(session: Session, label: Label, resumption: Resumption) -> Self {
        Self { resumption: Some(resumption), ..Self::new(session, label, None) }
    }

    /// One more turn of what is to be gone through again. `false` once the run is where it was left.
    pub(crate) fn resume(&mut self) -> bool {
        let Some(mut resumption) = self.resumption.take() else { return false };
        if resumption.turn(&mut self.session) {
            self.resumption = Some(resumption);
            return true;
        }
        let (position, end) = (self.session.position(), self.session.end());
        self.live = resumption.live;
        self.driver = resumption.driver;
        let last = self.session.record().commands().last();
        self.told = position == end && last.is_some_and(|last| last.tick == end);
        false
    }

    /// The run at this moment, as [`Run::resuming`] takes it up again.
    pub(crate) fn situation(&self) -> String {
        let situation = Situation {
            record: self.session.record().clone(),
            at: self.session.position(),
            live: self.live,
            on_route: self.driver.is_some(),
        };
        situation::write(&situation, self.label.building.as_deref())
    }

    pub(crate) fn label(&self) -> &Label {
        &self.label
    }

    pub(crate) fn session(&self) -> &Session {
        &self.session
    }

    /// One turn of the world: a tick or a reading. `false` if nothing is left to happen.
    pub(crate) fn advance(&mut self) -> bool {
        if self.waits() && !self.ask_driver() {
            return false;
        }
        self.told = false;
        self.session.advance()
    }

    /// Whether nothing will happen until an order comes.
    pub(crate) fn idle(&self) -> bool {
        self.waits() && self.driver.is_none()
    }

    /// Whether the record is at its end and the robot has nothing left to do.
    fn waits(&self) -> bool {
        let at_end = self.session.position() >= self.session.end();
        at_end && !self.told && (!self.live || self.session.at_rest())
    }

    fn ask_driver(&mut self) -> bool {
        let next = self.session.world_from_robot().and_then(|pose| self.driver.as_mut()?.next_command(pose));
        let Some(command) = next else {
            self.driver = None;
            return false;
        };
        self.session.command(command);
        true
    }

    /// Lets the run go on until the memory has taken in another view, or nothing is left to happen.
    pub(crate) fn advance_to_next_view(&mut self) {
        let views = self.views();
        for _ in 0..LONGEST_STEP {
            if !self.advance() || self.views() != views {
                return;
            }
        }
    }

    pub(crate) fn jump(&mut self, position: u64) {
        self.resumption = None;
        if position < self.session.position() {
            self.courses.go_back(&self.session, position);
        }
        self.session.jump(position.min(self.session.end()));
        self.told = false;
    }

    /// Goes back to when the first mapper took the view before its latest.
    pub(crate) fn back_to_previous_view(&mut self) {
        let before = self.views().checked_sub(2);
        let report = before.and_then(|before| self.session.journal().mappers.first()?.reports.get(before));
        if let Some(position) = report.map(|report| self.position_at(report.t)) {
            self.jump(position);
        }
    }

    /// What the timeline marks, in order, as far as the run has ever come.
    pub(crate) fn landmarks(&mut self) -> Vec<Landmark> {
        let mut landmarks = std::mem::take(&mut self.landmarks);
        landmarks.note(&self.session, |t| self.position_at(t));
        self.landmarks = landmarks;
        self.landmarks.all(&self.session)
    }

    /// The position at which what happened at a time, in seconds, has just happened.
    pub(crate) fn position_at(&self, t: f64) -> u64 {
        match &self.session.record().source {
            Source::World { .. } => (t / TICK).round() as u64,
            Source::Log { .. } => self.session.journal().odometry.partition_point(|scan| scan.t <= t) as u64,
        }
    }

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

    /// The robot that is driven; a log's robot is not known.
    fn robot(&self) -> Option<&Robot> {
        match &self.session.record().source {
            Source::World { robot, .. } => Some(robot),
            Source::Log { .. } => None,
        }
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
        self.live = true;
        self.told = true;
        self.session.command(command);
        self.landmarks.forget_after(self.session.position());
    }

    /// Whether a person is steering right now: what is told then belongs to the same deed.
    fn steers_on(&self) -> bool {
        let last = self.session.record().commands().last().map(|timed| &timed.command);
        let moves =
            matches!(last, Some(Command::Drive { linear, angular }) if *linear != 0.0 || *angular != 0.0);
        moves && self.driver.is_none() && self.session.position() >= self.session.end()
    }

    fn course(&self) -> Course {
        let (source, position) = (self.session.record().source.clone().into(), self.session.position());
        Course { source, driver: self.driver.clone().map(Rc::new), live: self.live, position }
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
            self.landmarks.forget_after(parting);
            self.courses.go_over();
            (self.live, self.courses.branches) = (course.live, branches);
            self.driver = course.driver.map(Rc::unwrap_or_clone);
            self.jump(course.position);
        }
    }

    /// Where the robot went in the futures that were left, in the world, metres.
    pub(crate) fn left_ways(&self) -> impl Iterator<Item = &[DVec2]> {
        self.courses.branches.iter().map(|branch| &*branch.way)
    }

    fn views(&self) -> usize {
        self.session.journal().mappers.first().map_or(0, |mapper| mapper.reports.len())
    }

    /// Shows the run to other mappers: a drive stays where it is, a log, which may be long, begins anew.
    pub(crate) fn remap(&mut self, mappers: Vec<MapperSetup>) -> Result<(), Failure> {
        let position = if self.robot().is_some() { self.session.position() } else { 0 };
        self.landmarks = Landmarks::default();
        self.session = self.session.remapped(mappers)?;
        self.session.jump(position);
        Ok(())
    }

    pub(crate) fn status(&self) -> Status {
        let session = &self.session;
        let journal = session.journal();
        let pose = session.world_from_robot();
        let truth_known = pose.is_some();
        Status {
            source: if truth_known { SourceKind::World } else { SourceKind::Log },
            foreign: self.label.foreign,
            settled: self.label.settled,
            name: self.label.name.clone(),
            stem: self.label.stem.clone(),
            robot: self.robot().map(|robot| robot.name.clone()),
            seed: session.record().seed,
            position: session.position(),
            end: session.end(),
            time: session.time(),
            idle: self.idle(),
            on_route: self.driver.is_some(),
            collisions: journal.mappers.first().map_or(0, |mapper| mapper.collisions().count()),
            travelled: length_of(if truth_known { &journal.truth } else { &journal.odometry }),
            pose: pose.map(|Pose { position, heading }| [position.x, position.y, heading]),
            memories: memories(session),
            homing: homing(session),
            undoable: self.courses.undo.len(),
            redoable: self.courses.redo.len(),
            branches: self.courses.branches.len(),
        }
    }
}

fn length_of(path: &[Stamped]) -> f64 {
    path.windows(2)
        .map(|pair| match pair {
            [from, to] => from.pose.position.distance(to.pose.position),
            _ => 0.0,
        })
        .sum()
}
