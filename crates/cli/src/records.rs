use cogmap_simulation::{Recording, Session, Stamped};

/// What odometry said between the scans, for trajectories with a row for each record: every tick of
/// a drive, every record of a log.
pub(crate) struct Records {
    list: Option<Vec<Stamped>>,
    of_drive: bool,
}

impl Records {
    /// Those of a drive, written down while it goes on; none unless they are wanted.
    pub(crate) fn of_drive(wanted: bool) -> Self {
        Self { list: wanted.then(Vec::new), of_drive: true }
    }

    /// Those of a log; none unless they are wanted.
    pub(crate) fn of_log(recording: &Recording, wanted: bool) -> Self {
        Self { list: wanted.then(|| recording.odometry.clone()), of_drive: false }
    }

    /// Writes down what odometry says after a turn of the session.
    pub(crate) fn note(&mut self, session: &Session) {
        if let (Some(list), true) = (&mut self.list, self.of_drive) {
            list.push(Stamped { t: session.time(), pose: session.odom_from_robot() });
        }
    }

    /// All of them, in order of time.
    pub(crate) fn list(&self) -> Option<&[Stamped]> {
        self.list.as_deref()
    }
}
