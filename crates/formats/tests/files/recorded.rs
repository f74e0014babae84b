use std::{fs, path::PathBuf};

use cogmap_formats::carmen::{self, CarmenLog};
use cogmap_geometry::trig::FRAC_PI_2;

/// A recorded log, where the folder of shared data stands beside the project.
fn log(name: &str) -> Option<CarmenLog> {
    let path = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../../../shared/data/logs").join(name);
    let Ok(bytes) = fs::read(&path) else {
        println!("skipped: no {}", path.display());
        return None;
    };
    Some(carmen::read(&bytes, name, true).unwrap())
}

fn share_seen(log: &CarmenLog) -> f64 {
    let scans = log.recording.readings.iter().map(|reading| &reading.scan);
    let (seen, all) = scans.fold((0, 0), |(seen, all), scan| {
        let beams = scan.ranges.len();
        (seen + (0..beams).filter(|&beam| scan.range(beam).is_some()).count(), all + beams)
    });
    seen as f64 / all as f64
}

#[test]
fn the_log_of_the_intel_laboratory_is_read_whole() {
    let Some(log) = log("intel.log.gz") else { return };
    let counts = &log.counts;
    assert_eq!((counts.scans, counts.odometry, counts.comments), (2663, 11_147, 1));
    assert_eq!((counts.broken, counts.duplicates, counts.not_later), (0, 0, 0));
    assert!(counts.unknown.is_empty() && log.warnings.is_empty());
    for reading in &log.recording.readings {
        let scan = &reading.scan;
        assert_eq!((scan.ranges.len(), scan.angle_min), (180, -FRAC_PI_2));
        assert!((scan.bearing(179) - 89_f64.to_radians()).abs() < 1e-12);
        assert!((50.0..81.83).contains(&scan.range_max));
        assert_eq!(scan.robot_from_laser, cogmap_geometry::Pose::IDENTITY);
    }
    assert_eq!(log.recording.readings[0].t, 976_052_857.349);
    assert!((share_seen(&log) - (1.0 - 13_435.0 / 479_340.0)).abs() < 1e-12);
}

#[test]
fn the_laser_of_the_sena_robot_sits_ahead_of_its_centre() {
    let Some(log) = log("sena.log.gz") else { return };
    assert_eq!((log.counts.scans, log.counts.odometry, log.counts.broken), (225, 0, 0));
    assert!(log.warnings.is_empty());
    for reading in &log.recording.readings {
        let scan = &reading.scan;
        assert_eq!(scan.ranges.len(), 361);
        assert!((scan.bearing(360) - FRAC_PI_2).abs() < 1e-12);
        assert!((58.0..81.91).contains(&scan.range_max), "real walls stand up to 58 m away");
        assert_eq!(scan.robot_from_laser.position.to_array(), [0.78, 0.0]);
        assert!(scan.robot_from_laser.heading.abs() < 1e-5);
    }
    assert!((share_seen(&log) - (1.0 - 9312.0 / 81_225.0)).abs() < 1e-12);
}
