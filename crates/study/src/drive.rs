use cogmap_geometry::Pose;
use cogmap_mapping::perception::{Moment, Reading};
use cogmap_simulation::{Driver, Robot, Session, SessionRecord, Source};

use crate::{Course, condition::Treatment, kidnap::Kidnap};

/// Whoever drives has arrived so near to the end of the route, metres.
const ARRIVED: f64 = 0.5;

/// A drive through a building as the robot's program and the truth saw it; every mapper of a study
/// is fed from the same one.
#[derive(Clone, Debug, Default)]
pub struct Drive {
    /// The scans in order of time.
    pub looks: Vec<Look>,
    /// Whether the person at the controls came to the end of the route.
    pub arrived: bool,
    /// The first look after the robot was moved unseen.
    pub kidnapped: Option<usize>,
}

/// What the robot saw, and what only the simulation knows of it.
#[derive(Clone, Debug)]
pub struct Look {
    /// What reaches the mappers.
    pub reading: Reading,
    /// Where the robot truly was.
    pub world_from_robot: Pose,
    /// What each beam truly hit.
    pub beam_solids: Vec<Option<u32>>,
}

/// Drives a course with a robot; all chance comes from the seed.
///
/// # Errors
/// The world or the route cannot be driven.
pub fn drive(course: &Course, robot: &Robot, seed: u64) -> Result<Drive, String> {
    let mut driver = Driver::new(&course.world, robot, &course.route)?;
    let source = Source::world(course.world.as_ref().clone(), robot.clone());
    let mut session = Session::drive(SessionRecord::new(source, Vec::new(), seed)).map_err(|problems| {
        let first = problems.first();
        first.map_or_else(String::new, |problem| format!("{}: {}", problem.place, problem.message))
    })?;
    let mut drive = Drive { looks: look(&session).into_iter().collect(), ..Drive::default() };
    if let Some(kidnap) = Kidnap::drawn(course, seed) {
        step(&mut session, &mut driver, (&mut drive.looks, kidnap.steps));
        drive.kidnapped = Some(drive.looks.len());
        driver = kidnap.perform(&mut session, course, robot)?;
    }
    step(&mut session, &mut driver, (&mut drive.looks, usize::MAX));
    let end = course.route.last().copied();
    let here = session.world_from_robot().map(|pose| pose.position);
    drive.arrived = here.zip(end).is_some_and(|(here, end)| here.distance(end) <= ARRIVED);
    Ok(drive)
}

/// Follows the person at the controls for so many steps, or to the end of the route.
fn step(session: &mut Session, driver: &mut Driver, (looks, steps): (&mut Vec<Look>, usize)) {
    for _ in 0..steps {
        let Some(command) = session.world_from_robot().and_then(|pose| driver.next_command(pose)) else {
            return;
        };
        session.command(command);
        loop {
            session.advance();
            if session.journal().odometry.len() > looks.len() {
                looks.extend(look(session));
            }
            if session.at_rest() {
                break;
            }
        }
    }
}

/// What the robot saw last.
fn look(session: &Session) -> Option<Look> {
    let odometry = session.journal().odometry.last()?;
    let reading = Reading {
        t: odometry.t,
        odom_from_robot: odometry.pose,
        moment: session.last_moment()?,
        scan: session.last_scan()?.clone(),
    };
    let beam_solids = session.last_beam_solids()?.to_vec();
    Some(Look { reading, world_from_robot: session.journal().truth.last()?.pose, beam_solids })
}

impl Drive {
    /// What reaches the mappers, in order.
    pub fn readings(&self) -> impl Iterator<Item = &Reading> {
        self.looks.iter().map(|look| &look.reading)
    }

    /// The same drive with worse odometry, and with fewer scans.
    #[must_use]
    pub fn treated(&self, treatment: Treatment) -> Self {
        let mut drive = self.clone();
        if treatment.odometry != 1.0 {
            drive.exaggerate(treatment.odometry);
        }
        if let Some(every) = treatment.every {
            drive.thin(every);
        }
        drive
    }

    /// Makes the error of each movement so many times what it was; what truly happened stays.
    fn exaggerate(&mut self, factor: f64) {
        let was: Vec<Pose> = self.looks.iter().map(|look| look.reading.odom_from_robot).collect();
        for k in 1..self.looks.len() {
            let truly = self.looks[k - 1].world_from_robot.from_here(self.looks[k].world_from_robot);
            let error = truly.from_here(was[k - 1].from_here(was[k]));
            let larger =
                Pose::new(factor * error.position.x, factor * error.position.y, factor * error.heading);
            let odom_from_last = self.looks[k - 1].reading.odom_from_robot;
            self.looks[k].reading.odom_from_robot = odom_from_last * truly * larger;
        }
    }

    /// Keeps a scan each so many metres or radians, and lets each of them be the end of a step.
    fn thin(&mut self, every: f64) {
        let kidnapped = self.kidnapped.and_then(|first| Some(self.looks.get(first)?.reading.t));
        let mut last: Option<Pose> = None;
        self.looks.retain(|look| {
            let far = last.is_none_or(|last| {
                let moved = last.from_here(look.world_from_robot);
                moved.position.length() >= every || moved.heading.abs() >= every
            });
            if far {
                last = Some(look.world_from_robot);
            }
            far
        });
        self.looks.iter_mut().for_each(|look| look.reading.moment = Moment::StepEnd);
        self.kidnapped = kidnapped.map(|t| self.looks.partition_point(|look| look.reading.t < t));
    }
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use super::*;

    fn short_drive(seed: u64) -> Drive {
        let world = r#"{"format": "cogmap-world/1", "name": "Cell", "start": {"position": [1, 2]},
            "walls": [[[0,0],[5,0],[5,4],[0,4],[0,0]]], "routes": {"across": [[2,2],[3,3],[4,3]]}}"#;
        let course = Course::through(&Arc::new(serde_json::from_str(world).unwrap()), "across").unwrap();
        drive(&course, &Robot::named("bad").unwrap(), seed).unwrap()
    }

    fn error(drive: &Drive, k: usize) -> Pose {
        let (from, to) = (&drive.looks[k - 1], &drive.looks[k]);
        let truly = from.world_from_robot.from_here(to.world_from_robot);
        truly.from_here(from.reading.odom_from_robot.from_here(to.reading.odom_from_robot))
    }

    #[test]
    fn worse_odometry_errs_so_many_times_more_on_the_same_drive() {
        let drive = short_drive(1);
        let worse = drive.treated(Treatment { odometry: 3.0, every: None });
        assert!(drive.arrived && drive.looks.len() > 20);
        for k in 1..drive.looks.len() {
            assert_eq!(drive.looks[k].reading.scan, worse.looks[k].reading.scan);
            let (was, is) = (error(&drive, k), error(&worse, k));
            assert!((is.position - was.position * 3.0).length() < 1e-9, "{k}");
            assert!((is.heading - was.heading * 3.0).abs() < 1e-9, "{k}");
        }
    }

    #[test]
    fn a_thinned_drive_has_steps_of_that_length() {
        let thin = short_drive(1).treated(Treatment { odometry: 1.0, every: Some(0.5) });
        for pair in thin.looks.windows(2) {
            let moved = pair[0].world_from_robot.from_here(pair[1].world_from_robot);
            assert!(moved.position.length() >= 0.5 || moved.heading.abs() >= 0.5);
            assert_eq!(pair[1].reading.moment, Moment::StepEnd);
        }
    }

    #[test]
    fn the_seed_decides_everything() {
        let ends = |seed| short_drive(seed).looks.last().unwrap().reading.clone();
        assert_eq!(ends(4), ends(4));
        assert_ne!(ends(4), ends(5));
    }
}
