//! Logs and trajectories, whose lines are numbered.

use cogmap_formats::{carmen, tum};

use super::check;

#[test]
fn a_bad_line_of_a_log_names_its_number_and_the_way_out() {
    let scan = "FLASER 2 1.0 2.0 0 0 0 0 0 0 12.5 host 0.1";
    let cases = [
        ("FLASER 180 1 2 3", "announces 180 readings but has only 3 words left"),
        ("FLASER 1000000000000000000 1", "is 1000000000000000000, not a whole number up to 10000"),
        ("FLASER 2.5 1 2", "is 2.5, not a whole number"),
        ("FLASER two 1 2", "`two` is not a number, where the number of readings should be"),
        ("FLASER 1 1.0 0 0 0 0 0 0 12.5", "a scan of 1 readings shows nothing"),
        ("FLASER 2 1,0 2.0 0 0 0 0 0 0 12.5", "`1,0` is not a number"),
        ("FLASER 2 1.0 2.0 0 0 0 0 0 0", "ends before the time stamp"),
        ("RLASER 2 1.0 2.0 0 0 NaN 0 0 0 12.5", "the laser's pose is NaN"),
        ("ODOM 0 inf 0 0 0 0 12.5", "the pose is inf"),
        ("ODOM 0 0 0", "ends before the velocities"),
        ("ODOM 0 0 0 0 0 0 1e99", "the time stamp is 1e99"),
        ("ROBOTLASER1 0 -1.57 3.14 0 81.9 0.01 0 2 1 2 0", "are no fan"),
        ("ROBOTLASER1 0 -1.57 3.14 0.0174 81.9 0.01 0 2 1 2 9", "announces 9 remissions"),
        ("PARAM", "the parameter has no name"),
    ];
    for (line, reason) in cases {
        let log = format!("# log\n{scan}\n{line}\n{scan}\n");
        let case = ("a good line", line, "a.log, line 3", reason);
        check("a.log", case, carmen::read(log.as_bytes(), "a.log", true));
        check(
            "a.log",
            (case.0, line, case.2, "read without `--strict`"),
            carmen::read(log.as_bytes(), "a.log", true),
        );
        let lenient = carmen::read(log.as_bytes(), "a.log", false).unwrap();
        assert!(lenient.skipped[0].line == 3 && lenient.skipped[0].reason.contains(reason), "{line}");
    }
}

#[test]
fn a_file_that_is_no_log_is_told_so() {
    let way_out = "a log needs at least one FLASER, RLASER or ROBOTLASER1 line";
    let cases: [(&[u8], &str, &str); 8] = [
        (b"", "no usable scan", way_out),
        (b"# nothing\n# but comments\n", "no usable scan", way_out),
        (b"ODOM 0 0 0 0 0 0 1.5 host 0\n", "1 odometry records", way_out),
        (b"<html><body>404</body></html>", "unknown lines such as `<html><body>404</body></html>`", way_out),
        (b"FLASER 9 1\nFLASER 9 2\n", "2 broken lines, the first, line 1: it announces 9 readings", way_out),
        (b"FLASER 2 nan inf 0 0 0 0 0 0 1.5 host 0\n", "1 scans without a single distance", way_out),
        (b"\xff\xfe\x00FLASER\xff", "no usable scan", way_out),
        (b"\x1f\x8b\x08\x00\x00\x00", "gzip data is broken", "fetch the file again"),
    ];
    for (bytes, place, way_out) in cases {
        let shown = String::from_utf8_lossy(bytes);
        check("a.log", ("a log", &shown, place, way_out), carmen::read(bytes, "a.log", false));
    }
}

#[test]
fn a_bad_trajectory_names_its_line_and_the_way_out() {
    for (row, problem) in
        [("1 2 3", "3 words"), ("1 2 nan 0 0 0 0 1", "`nan`"), ("1 2 3 0 0 0 0 0", "quaternion")]
    {
        let text = format!("# t x y z qx qy qz qw\n0 0 0 0 0 0 0 1\n{row}\n");
        check("t.tum", ("a row", row, "t.tum, line 3", problem), tum::read(&text, "t.tum"));
        check(
            "t.tum",
            ("a row", row, "t.tum, line 3", "write `t x y z qx qy qz qw`"),
            tum::read(&text, "t.tum"),
        );
    }
}
