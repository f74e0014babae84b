//! What a person did to a run, so that it can be undone; and the futures that were left, so that they can be
//! gone back to.

use std::rc::Rc;

use cogmap_geometry::DVec2;
use cogmap_simulation::{Driver, Session, Source, Stamped, TICK};

/// So many deeds can be undone.
const DEEDS: usize = 100;
/// So many futures that were left are kept.
const BRANCHES: usize = 8;

/// One course of a run: what was told, who drives, and how far one had come.
#[derive(Clone)]
pub(crate) struct Course {
    pub(crate) source: Rc<Source>,
    pub(crate) driver: Option<Rc<Driver>>,
    /// Whether the driver follows a way that a person drew.
    pub(crate) drawn: bool,
    pub(crate) live: bool,
    pub(crate) position: u64,
}

/// A future that was left when the run went on otherwise from an earlier moment.
#[derive(Clone)]
pub(crate) struct Branch {
    pub(crate) course: Course,
    /// Where the robot went in it from the parting on, in the world, metres.
    pub(crate) way: Rc<[DVec2]>,
}

/// A course and the futures that were left before it.
#[derive(Clone)]
pub(crate) struct Deed {
    pub(crate) course: Course,
    pub(crate) branches: Vec<Branch>,
}

/// What can be undone, done again, and gone back to.
#[derive(Clone, Default)]
pub(crate) struct Courses {
    pub(crate) undo: Vec<Deed>,
    pub(crate) redo: Vec<Deed>,
    pub(crate) branches: Vec<Branch>,
    /// The truth that lies ahead, as far as the run has ever come: the journal forgets it when going back.
    ahead: Vec<Stamped>,
}

impl Courses {
    /// Notes that something is about to be told that makes another course.
    pub(crate) fn leave(&mut self, session: &Session, course: Course) {
        self.redo.clear();
        self.undo.push(Deed { course: course.clone(), branches: self.branches.clone() });
        if self.undo.len() > DEEDS {
            self.undo.remove(0);
        }
        if session.position() < session.end() {
            let way = self.way(session, session.position()).into();
            self.branches.push(Branch { course, way });
            if self.branches.len() > BRANCHES {
                self.branches.remove(0);
            }
        }
        self.ahead.clear();
    }

    /// Keeps what the journal is about to forget, as the run goes back to a position.
    #[allow(clippy::cast_precision_loss, reason = "no run lasts 2^53 ticks")]
    pub(crate) fn go_back(&mut self, session: &Session, to: u64) {
        let truth = &session.journal().truth;
        let Some(last) = truth.last() else { return };
        let cut = truth.partition_point(|stamped| stamped.t <= to as f64 * TICK);
        let beyond = self.ahead.iter().filter(|stamped| stamped.t > last.t).copied();
        self.ahead = truth[cut..].iter().copied().chain(beyond).collect();
    }

    /// Forgets the future: the run has gone over to another course.
    pub(crate) fn go_over(&mut self) {
        self.ahead.clear();
    }

    /// Where the robot goes on this course from a position on, as far as the run has ever come.
    #[allow(clippy::cast_precision_loss, reason = "no run lasts 2^53 ticks")]
    pub(crate) fn way(&self, session: &Session, from: u64) -> Vec<DVec2> {
        let truth = &session.journal().truth;
        let from = from as f64 * TICK;
        let last = truth.last().map_or(0.0, |last| last.t);
        let begun = truth.partition_point(|stamped| stamped.t <= from).saturating_sub(1);
        let beyond = self.ahead.iter().filter(|stamped| stamped.t > last);
        truth[begun..].iter().chain(beyond).map(|stamped| stamped.pose.position).collect()
    }
}
