use cogmap_formats::{carmen, session, world};
use cogmap_geometry::DVec2;
use proptest::prelude::*;

const LOG: &str = "\
# a comment
PARAM robot_front_laser_max 30.0 host 0.1
PARAM robot_frontlaser_offset 0.2 host 0.1
ODOM 0.1 0.2 0.3 0.4 0.5 0 12.5 host 0.1
FLASER 5 1.0 2.0 3.0 2.0 1.0 0.3 0 0.1 0.1 0 0.1 12.6 host 0.2
SYNC tag
RLASER 5 1.0 2.0 81.83 2.0 1.0 0.3 0 0.1 0.1 0 0.1 12.6 host 0.2
ROBOTLASER1 0 -1.5708 3.1416 0.7854 50 0.01 0 5 1 2 3 4 5 2 7 7 1 0 0 1 0 0 0 0 0 0 0 12.7 host 0.3
";

/// What a damaged log may hold where a word was.
fn word() -> impl Strategy<Value = String> {
    prop_oneof![
        Just("nan".to_owned()),
        Just("-inf".to_owned()),
        Just("1e308".to_owned()),
        Just("-1".to_owned()),
        Just("18446744073709551616".to_owned()),
        Just("99999999999".to_owned()),
        Just(String::new()),
        Just("\n".to_owned()),
        any::<f64>().prop_map(|number| number.to_string()),
        "\\PC{0,9}",
    ]
}

fn damaged() -> impl Strategy<Value = String> {
    let words: Vec<&'static str> = LOG.split_inclusive([' ', '\n']).collect();
    prop::collection::vec((0..words.len(), word()), 1..12).prop_map(move |changes| {
        let mut words: Vec<String> = words.iter().map(|&word| word.to_owned()).collect();
        for (index, word) in changes {
            let end = words[index].chars().last().unwrap_or(' ');
            words[index] = format!("{word}{end}");
        }
        words.concat()
    })
}

proptest! {
    #[test]
    fn a_damaged_log_gives_usable_scans_or_an_error(log in damaged(), strict: bool) {
        let Ok(log) = carmen::read(log.as_bytes(), "damaged.log", strict) else { return Ok(()) };
        prop_assert!(!log.recording.readings.is_empty());
        prop_assert_eq!(log.recording.readings.len(), log.counts.scans);
        prop_assert_eq!(log.recording.odometry.len(), log.counts.odometry);
        for reading in &log.recording.readings {
            let pose = reading.odom_from_robot * reading.scan.robot_from_laser;
            prop_assert!(pose.position.is_finite() && pose.heading.is_finite() && reading.t.is_finite());
            prop_assert!(reading.scan.angle_increment > 0.0 && reading.scan.range_max > 0.0);
            prop_assert!(reading.scan.ranges.len() >= 2);
            for beam in 0..reading.scan.ranges.len() {
                prop_assert!(reading.scan.point(beam).is_none_or(DVec2::is_finite));
            }
        }
    }

    #[test]
    fn no_bytes_break_the_readers(bytes in prop::collection::vec(any::<u8>(), 0..400), packed: bool) {
        let bytes = if packed { [&[0x1f, 0x8b, 8, 0][..], &bytes].concat() } else { bytes };
        prop_assert!(carmen::read(&bytes, "a.log", false).is_err());
        let text = String::from_utf8_lossy(&bytes);
        prop_assert!(world::read(&text, "a.json").is_err() && session::read(&text, "a.json").is_err());
    }

    #[test]
    fn a_world_cut_off_anywhere_is_an_error(cut in 1usize..100) {
        let text = r#"{"format": "cogmap-world/1", "name": "Closet", "walls": [[[0,0],[3,0]]], "start": {"position": [1,1]}}"#;
        let cut = text.len().saturating_sub(cut);
        prop_assert!(world::read(text, "a").is_ok() && world::read(&text[..cut], "a").is_err());
    }
}

#[test]
fn a_damaged_line_costs_only_itself() {
    let broken = LOG.replace("12.6 host 0.2\nSYNC", "soon host 0.2\nSYNC");
    let log = carmen::read(broken.as_bytes(), "a.log", false).unwrap();
    assert_eq!((log.counts.scans, log.counts.broken, log.counts.lines), (2, 1, 8));
    assert_eq!(log.skipped[0].line, 5);
    assert_eq!(log.counts.unknown["SYNC"], 1);
    let whole = carmen::read(LOG.as_bytes(), "a.log", true).unwrap();
    assert_eq!((whole.counts.scans, whole.counts.params, whole.counts.comments), (3, 2, 1));
}

#[test]
fn one_scan_under_two_keywords_is_one_scan() {
    let twice = "FLASER 2 1 2 0 0 0 0 0 0 5.0 h 0\n\
                 ROBOTLASER1 0 -1 2 0.5 9 0 0 2 1 2 0 0 0 0 0 0 0 0 0 0 0 0 5.0 h 0\n";
    let log = carmen::read(twice.as_bytes(), "a.log", true).unwrap();
    assert_eq!((log.counts.scans, log.counts.duplicates), (1, 1));
}

#[test]
fn a_clock_that_goes_back_keeps_the_order_of_the_file() {
    let back = "FLASER 2 1 2 0 0 0 0 0 0 5.0 h 0\nFLASER 2 1 3 0 0 0 0 0 0 4.0 h 0\n";
    let log = carmen::read(back.as_bytes(), "a.log", true).unwrap();
    assert_eq!(log.counts.not_later, 1);
    assert_eq!(log.recording.readings.iter().map(|reading| reading.t).collect::<Vec<_>>(), [5.0, 4.0]);
}

#[test]
fn a_line_without_end_is_one_broken_line() {
    let mut log = vec![b'7'; 3 << 20];
    log.extend_from_slice(b"\nFLASER 2 1 2 0 0 0 0 0 0 5.0 h 0\r\n");
    let log = carmen::read(&log, "a.log", false).unwrap();
    assert_eq!((log.counts.scans, log.counts.broken), (1, 1));
    assert!(log.skipped[0].reason.contains("longer than"));
}
