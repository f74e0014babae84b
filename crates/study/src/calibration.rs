//! How far raw odometry is off at the end of a route: what makes a robot `good` or `bad`.
//!
//! The two robots of §3.1.4 are set by this figure alone, with no mapper at work, so that none is
//! tuned to fail: over the loop of 90 m the median final heading error is about 10° and about 90°.

use cogmap_geometry::{DVec2, Pose, normalize_angle};
use cogmap_simulation::{Driver, LaserParams, Robot, Session, SessionRecord, Source, World};
use serde::{Deserialize, Serialize};

/// How far odometry is off at the end of one drive.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Drift {
    /// Everything random of the drive came from it.
    pub seed: u64,
    /// Heading by odometry less the true one, radians, counter-clockwise; more than a half turn where it is.
    pub heading: f64,
    /// From where odometry believes the robot to be to where it is, metres.
    pub position: f64,
    /// Length of the way, metres.
    pub travelled: f64,
}

/// What many drives show of a robot.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Calibration {
    /// How many drives.
    pub runs: usize,
    /// Median of the heading error's amount, radians.
    pub heading: f64,
    /// What half of the drives lie between: the first and the third quartile of it, radians.
    pub heading_quartiles: [f64; 2],
    /// Median distance between belief and truth, metres.
    pub position: f64,
    /// Median length of the way, metres.
    pub travelled: f64,
}

/// Drives a route with one seed and no mapper: the same wheels slip in the same way as in any other
/// drive of that robot, route and seed.
///
/// # Errors
/// What is wrong with the world or the route.
pub fn drift(world: &World, robot: &Robot, route: &[DVec2], seed: u64) -> Result<Drift, String> {
    let mut driver = Driver::new(world, robot, route)?;
    // Nobody looks at the scans, and the laser has its own chance: the cheapest one will do.
    let laser = LaserParams { beams: 2, ..LaserParams::default() };
    let source = Source::world(world.clone(), Robot { laser, ..robot.clone() });
    let problem = |problems: Vec<cogmap_simulation::Problem>| {
        problems.first().map_or_else(String::new, |first| format!("`{}` {}", first.place, first.message))
    };
    let mut session = Session::drive(SessionRecord::new(source, Vec::new(), seed)).map_err(problem)?;
    while let Some(command) = session.world_from_robot().and_then(|pose| driver.next_command(pose)) {
        session.command(command);
        while session.advance() && !session.at_rest() {}
    }
    let journal = session.journal();
    let [truth, odometry] = [&journal.truth, &journal.odometry].map(|way| {
        let poses: Vec<Pose> = way.iter().map(|stamped| stamped.pose).collect();
        poses
    });
    Ok(Drift {
        seed,
        heading: turned(&odometry) - turned(&truth),
        position: ends_apart(&truth, &odometry),
        travelled: truth.windows(2).map(|pair| pair[0].position.distance(pair[1].position)).sum(),
    })
}

impl Calibration {
    /// The figures of many drives; `None` of none.
    #[must_use]
    pub fn of(drifts: &[Drift]) -> Option<Self> {
        let sorted = |value: fn(&Drift) -> f64| {
            let mut values: Vec<f64> = drifts.iter().map(value).collect();
            values.sort_by(f64::total_cmp);
            values
        };
        let heading = sorted(|drift| drift.heading.abs());
        Some(Self {
            runs: drifts.len(),
            heading: quantile(&heading, 2)?,
            heading_quartiles: [quantile(&heading, 1)?, quantile(&heading, 3)?],
            position: quantile(&sorted(|drift| drift.position), 2)?,
            travelled: quantile(&sorted(|drift| drift.travelled), 2)?,
        })
    }
}

/// All turns of a way added up, radians, so that a whole turn counts.
fn turned(way: &[Pose]) -> f64 {
    way.windows(2).map(|pair| normalize_angle(pair[1].heading - pair[0].heading)).sum()
}

/// Metres between the ends of two ways that are laid over each other at their beginnings.
fn ends_apart(one: &[Pose], other: &[Pose]) -> f64 {
    let end = |way: &[Pose]| Some(way.first()?.from_here(*way.last()?).position);
    end(one).zip(end(other)).map_or(0.0, |(one, other)| one.distance(other))
}

/// So many quarters into sorted numbers.
fn quantile(sorted: &[f64], quarters: usize) -> Option<f64> {
    sorted.get(((sorted.len().checked_sub(1)?) * quarters + 2) / 4).copied()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A free floor and a square of 4 m, driven round twice.
    fn square() -> (World, Vec<DVec2>) {
        let text = r#"{"format": "cogmap-world/1", "name": "Floor", "start": {"position": [0, 0]}}"#;
        let corners = [[1.0, 0.0], [1.0, 1.0], [0.0, 1.0], [0.0, 0.0]].map(DVec2::from);
        (serde_json::from_str(text).unwrap(), [corners, corners].concat())
    }

    #[test]
    fn the_perfect_robot_does_not_drift() {
        let (world, route) = square();
        let drift = drift(&world, &Robot::named("perfect").unwrap(), &route, 1).unwrap();
        assert!(drift.heading.abs() < 1e-9 && drift.position < 1e-9, "{drift:?}");
        assert!((drift.travelled - 8.0).abs() < 0.01, "{drift:?}");
    }

    #[test]
    fn an_axle_that_is_longer_than_believed_shows_in_every_turn() {
        let (world, route) = square();
        let mut robot = Robot::named("perfect").unwrap();
        robot.odometry.axle = 0.05;
        let drift = drift(&world, &robot, &route, 1).unwrap();
        // Seven quarter turns, each believed to be 5 % wider than it is.
        let wanted = 7.0 * std::f64::consts::FRAC_PI_2 * 0.05;
        assert!((drift.heading.abs() - wanted).abs() < 0.02, "{drift:?}");
    }

    #[test]
    fn the_figures_are_medians_and_quartiles() {
        let drifts = [-4.0, 1.0, 0.0, -3.0, 2.0].map(|heading| Drift {
            seed: 1,
            heading,
            position: heading * heading,
            travelled: 9.0,
        });
        let calibration = Calibration::of(&drifts).unwrap();
        assert_eq!((calibration.runs, calibration.heading, calibration.position), (5, 2.0, 4.0));
        assert_eq!(calibration.heading_quartiles, [1.0, 3.0]);
        assert_eq!(Calibration::of(&[]), None);
    }
}
