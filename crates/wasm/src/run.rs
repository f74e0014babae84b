mod altering;
mod deeds;
mod following;
mod keeping;
mod plotting;
mod telling;

use cogmap_geometry::Pose;
use cogmap_mapping::MapperSetup;
use cogmap_simulation::{Door, Driver, Robot, Session, Source, Stamped, TICK};

use crate::{
    courses::Courses,
    failure::Failure,
    homing::{homing, led},
    landmarks::{Landmark, Landmarks},
    memories::memories,
    plots::Curves,
    resumption::Resumption,
    status::{BuildingStatus, DoorStatus, SourceKind, Status},
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
    /// Whether the driver follows a way that a person drew, not the building's route.
    drawn: bool,
    /// Whether the robot may go on beyond what is recorded.
    live: bool,
    /// Whether an order was given that no tick has seen yet.
    told: bool,
    landmarks: Landmarks,
    curves: Curves,
    courses: Courses,
    /// What is still to be gone through again, where a run is taken up at a moment.
    resumption: Option<Resumption>,
}

impl Run {
    /// A run that its driver takes along a route; without one the robot waits for orders.
    pub(crate) fn new(session: Session, label: Label, driver: Option<Driver>) -> Self {
        let live = driver.is_some();
        Self {
            session,
            label,
            driver,
            drawn: false,
            live,
            told: false,
            landmarks: Landmarks::default(),
            curves: Curves::default(),
            courses: Courses::default(),
            resumption: None,
        }
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
        self.go_to(position);
        self.told = false;
    }

    /// Goes to a moment, having noted what the journal is about to forget.
    fn go_to(&mut self, position: u64) {
        if position < self.session.position() {
            self.note_landmarks();
            self.note_curves();
            self.courses.go_back(&self.session, position);
        }
        self.session.jump(position.min(self.session.end()));
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
        self.note_landmarks();
        self.landmarks.all(&self.session)
    }

    fn note_landmarks(&mut self) {
        let mut landmarks = std::mem::take(&mut self.landmarks);
        landmarks.note(&self.session, |t| self.position_at(t));
        self.landmarks = landmarks;
    }

    /// The position at which what happened at a time, in seconds, has just happened.
    pub(crate) fn position_at(&self, t: f64) -> u64 {
        match &self.session.record().source {
            Source::World { .. } => (t / TICK).round() as u64,
            Source::Log { .. } => self.session.journal().odometry.partition_point(|scan| scan.t <= t) as u64,
        }
    }

    /// The robot that is driven; a log's robot is not known.
    fn robot(&self) -> Option<&Robot> {
        match &self.session.record().source {
            Source::World { robot, .. } => Some(robot),
            Source::Log { .. } => None,
        }
    }

    fn views(&self) -> usize {
        self.session.journal().mappers.first().map_or(0, |mapper| mapper.reports.len())
    }

    /// Shows the run to other mappers: a drive stays where it is, a log, which may be long, begins anew.
    pub(crate) fn remap(&mut self, mappers: Vec<MapperSetup>) -> Result<(), Failure> {
        let position = if self.robot().is_some() { self.session.position() } else { 0 };
        self.landmarks = Landmarks::default();
        self.curves = Curves::default();
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
            on_route: self.driver.is_some() && !self.drawn,
            way_left: self.way_left(),
            collisions: journal.mappers.first().map_or(0, |mapper| mapper.collisions().count()),
            travelled: driven(session, if truth_known { &journal.truth } else { &journal.odometry }),
            pose: pose.map(|Pose { position, heading }| [position.x, position.y, heading]),
            building: building(session),
            memories: memories(session),
            led: led(session),
            homing: homing(session),
            undoable: self.courses.undo.len(),
            redoable: self.courses.redo.len(),
            branches: self.courses.branches.len(),
        }
    }
}

/// What can be changed around the robot.
fn building(session: &Session) -> Option<BuildingStatus> {
    let world = session.world()?;
    let door = |door: &Door| DoorStatus { name: door.name.clone(), open: door.open };
    Some(BuildingStatus {
        doors: world.doors.iter().map(door).collect(),
        boxes: world.boxes.len(),
        rooms: world.rooms.iter().map(|room| room.name.clone()).collect(),
        people: session.people().len(),
        odometry_noise: session.noise().odometry,
        laser_noise: session.noise().laser,
    })
}

/// Metres of a way, but for those over which the robot was carried.
fn driven(session: &Session, way: &[Stamped]) -> f64 {
    let carried: Vec<f64> = session.times_carried().collect();
    way.windows(2)
        .map(|pair| match pair {
            [from, to] if !carried.iter().any(|t| (from.t..to.t).contains(t)) => {
                from.pose.position.distance(to.pose.position)
            }
            _ => 0.0,
        })
        .sum()
}
