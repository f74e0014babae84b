use cogmap_geometry::{DVec2, Pose, normalize_angle};
use cogmap_mapping::perception::Reading;
use rand_core::SeedableRng;
use rand_pcg::Pcg64Mcg;

use super::{Recording, SessionRecord, Source};
use crate::chance::uniform;

impl Recording {
    /// The log as a session wants it: with worse odometry, then with fewer scans. Which scans stay
    /// is decided by the odometry as it was recorded, so that the same ones stay whatever the noise.
    #[must_use]
    pub fn varied(self, record: &SessionRecord) -> Self {
        let Source::Log { every, odometry_noise, .. } = &record.source else { return self };
        let kept = every.map(|every| kept(&self.readings, every));
        let mut varied =
            if *odometry_noise > 0.0 { worsened(self, *odometry_noise, record.seed) } else { self };
        if let Some(kept) = kept {
            let mut keep = kept.into_iter();
            varied.readings.retain(|_| keep.next().unwrap_or(true));
        }
        varied
    }
}

/// Which readings lie `every` metres or radians from the last one that was kept.
fn kept(readings: &[Reading], every: f64) -> Vec<bool> {
    let mut last: Option<Pose> = None;
    let far = |from: Pose, to: Pose| {
        from.position.distance(to.position) >= every
            || normalize_angle(to.heading - from.heading).abs() >= every
    };
    let mut keep = |reading: &Reading| {
        let pose = reading.odom_from_robot;
        let keep = last.is_none_or(|last| far(last, pose));
        if keep {
            last = Some(pose);
        }
        keep
    };
    readings.iter().map(&mut keep).collect()
}

/// The error that is added to one movement between scans.
#[derive(Clone, Copy)]
struct Fault {
    /// What the way travelled is multiplied by.
    stretch: f64,
    /// Radians added at its end.
    turn: f64,
}

impl Fault {
    /// No error at all.
    const NONE: Self = Self { stretch: 1.0, turn: 0.0 };

    /// A random error of that factor for a movement; three numbers of the generator each for way and turn.
    fn chance(moved: Pose, factor: f64, rng: &mut Pcg64Mcg) -> Self {
        let mut g = || 2.0 * (uniform(rng) + uniform(rng) + uniform(rng) - 1.5);
        let (way, turn) = (moved.position.length(), moved.heading.abs());
        Self { stretch: 1.0 + 0.02 * factor * g(), turn: 0.005 * factor * g() * (0.2 + way + turn) }
    }

    /// A movement with the error, of which so large a share has come about.
    fn spoil(self, moved: Pose, share: f64) -> Pose {
        let DVec2 { x, y } = moved.position * self.stretch;
        Pose::new(x, y, moved.heading + self.turn * share)
    }
}

/// The log with an error added to each movement from scan to scan; what odometry said between two
/// scans goes along.
fn worsened(recording: Recording, factor: f64, seed: u64) -> Recording {
    let mut rng = Pcg64Mcg::seed_from_u64(seed);
    let Recording { mut readings, mut odometry } = recording;
    let recorded: Vec<(f64, Pose)> = readings.iter().map(|r| (r.t, r.odom_from_robot)).collect();
    let mut faults = Vec::with_capacity(readings.len());
    for k in 1..readings.len() {
        let moved = recorded[k - 1].1.from_here(recorded[k].1);
        let fault = Fault::chance(moved, factor, &mut rng);
        readings[k].odom_from_robot = readings[k - 1].odom_from_robot * fault.spoil(moved, 1.0);
        faults.push(fault);
    }
    for record in &mut odometry {
        let Some(k) = recorded.partition_point(|(t, _)| *t <= record.t).checked_sub(1) else { continue };
        let (t, pose) = recorded[k];
        let span = recorded.get(k + 1).map(|(next, _)| next - t).filter(|span| *span > 0.0);
        let share = span.map_or(0.0, |span| ((record.t - t) / span).clamp(0.0, 1.0));
        let fault = faults.get(k).copied().unwrap_or(Fault::NONE);
        record.pose = readings[k].odom_from_robot * fault.spoil(pose.from_here(record.pose), share);
    }
    Recording { readings, odometry }
}

#[cfg(test)]
mod tests {
    use cogmap_mapping::perception::{Moment, Scan};

    use super::super::Stamped;
    use super::*;

    /// A robot that drives along a bend; odometry is recorded four times from scan to scan.
    fn bend() -> Recording {
        let at = |t: f64| Pose::new(0.3 * t, 0.01 * t * t, 0.02 * t);
        let scan = Scan {
            robot_from_laser: Pose::IDENTITY,
            angle_min: 0.0,
            angle_increment: 0.1,
            range_max: 8.0,
            ranges: vec![1.0],
            labels: Vec::new(),
        };
        let reading = |k: u32| Reading {
            t: f64::from(k),
            odom_from_robot: at(f64::from(k)),
            moment: Moment::StepEnd,
            scan: scan.clone(),
        };
        let odometry = (0..200).map(|k| f64::from(k) / 4.0).map(|t| Stamped { t, pose: at(t) });
        Recording { readings: (0..50).map(reading).collect(), odometry: odometry.collect() }
    }

    fn record(every: Option<f64>, odometry_noise: f64, seed: u64) -> SessionRecord {
        let source = Source::Log { path: "bend.log".into(), sha256: String::new(), every, odometry_noise };
        SessionRecord::new(source, Vec::new(), seed)
    }

    #[test]
    fn a_session_that_asks_for_nothing_gets_the_log() {
        assert_eq!(bend().varied(&record(None, 0.0, 1)), bend());
    }

    #[test]
    fn thinning_keeps_the_first_scan_and_then_one_each_so_many_metres() {
        let thin = bend().varied(&record(Some(1.0), 0.0, 1));
        assert_eq!(thin.readings[0], bend().readings[0]);
        for pair in thin.readings.windows(2) {
            let [from, to] = [&pair[0], &pair[1]].map(|reading| reading.odom_from_robot.position);
            assert!((1.0..2.2).contains(&from.distance(to)), "{from} {to}");
        }
        assert_eq!(thin.odometry, bend().odometry);
    }

    #[test]
    fn noise_changes_the_odometry_alone_and_the_seed_decides_how() {
        let noisy = bend().varied(&record(None, 3.0, 1));
        assert_eq!(noisy, bend().varied(&record(None, 3.0, 1)));
        assert_ne!(noisy, bend().varied(&record(None, 3.0, 2)));
        for (noisy, clean) in noisy.readings.iter().zip(&bend().readings) {
            assert_eq!((noisy.t, &noisy.scan), (clean.t, &clean.scan));
        }
        assert_ne!(noisy.readings[49].odom_from_robot, bend().readings[49].odom_from_robot);
    }

    #[test]
    fn the_noise_of_a_movement_stays_within_its_bounds() {
        let noisy = bend().varied(&record(None, 4.0, 1));
        for (clean, noisy) in bend().readings.windows(2).zip(noisy.readings.windows(2)) {
            let was = clean[0].odom_from_robot.from_here(clean[1].odom_from_robot);
            let is = noisy[0].odom_from_robot.from_here(noisy[1].odom_from_robot);
            let way = was.position.length();
            assert!((is.position - was.position).length() <= 0.06 * 4.0 * way + 1e-9);
            let turned = normalize_angle(is.heading - was.heading).abs();
            assert!(turned <= 0.015 * 4.0 * (0.2 + way + was.heading.abs()) + 1e-9);
        }
    }

    #[test]
    fn the_same_scans_stay_whatever_the_noise() {
        let times = |noise| -> Vec<f64> {
            bend().varied(&record(Some(0.8), noise, 1)).readings.iter().map(|r| r.t).collect()
        };
        assert_eq!(times(0.0), times(20.0));
    }

    #[test]
    fn odometry_between_scans_goes_along_with_the_scans() {
        let noisy = bend().varied(&record(None, 5.0, 4));
        for reading in &noisy.readings {
            let same = noisy.odometry.iter().find(|record| record.t == reading.t).unwrap().pose;
            assert!(same.position.distance(reading.odom_from_robot.position) < 1e-9);
            assert!(normalize_angle(same.heading - reading.odom_from_robot.heading).abs() < 1e-9);
        }
        for pair in noisy.odometry.windows(2) {
            assert!(pair[0].pose.position.distance(pair[1].pose.position) < 0.6, "no jump between records");
        }
    }
}
