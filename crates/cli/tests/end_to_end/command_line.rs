use std::fs;
use std::process::Stdio;

use crate::workbench::{ROOM, Workbench};

/// The files but for the one that tells the time.
fn lasting(bench: &Workbench, directory: &str) -> Vec<(String, Vec<u8>)> {
    let mut files = bench.files_in(directory);
    files.retain(|(name, _)| name != "timing.json");
    files
}

fn names(files: &[(String, Vec<u8>)]) -> Vec<&str> {
    files.iter().map(|(name, _)| name.as_str()).collect()
}

/// Tells which file differs, not how: some are large.
fn assert_same(first: &[(String, Vec<u8>)], again: &[(String, Vec<u8>)]) {
    assert_eq!(names(first), names(again));
    for ((name, one), (_, other)) in first.iter().zip(again) {
        assert!(one == other, "{name} differs");
    }
}

#[test]
fn a_drive_leaves_every_file_and_its_session_gives_them_again_byte_for_byte() {
    let bench = Workbench::new();
    bench.cogmap("run room.world.json --seed 3 --out first").done();
    let first = lasting(&bench, "first");
    assert_eq!(
        names(&first),
        [
            "estimate.tum",
            "events.jsonl",
            "map.json",
            "map.png",
            "map.svg",
            "network.g2o",
            "odometry.tum",
            "report.json",
            "session.json",
            "truth.tum",
        ]
    );
    assert!(bench.path("first/timing.json").exists());
    bench.cogmap("replay first/session.json --out again").done();
    assert_same(&first, &lasting(&bench, "again"));
}

#[test]
fn a_log_leaves_every_file_but_the_truth_and_its_session_gives_them_again() {
    let bench = Workbench::new();
    bench.cogmap("replay walk.log --every 0.3 --odometry-noise 2 --seed 9 --out first").done();
    let first = lasting(&bench, "first");
    assert_eq!(
        names(&first),
        [
            "estimate.tum",
            "events.jsonl",
            "map.json",
            "map.png",
            "map.svg",
            "network.g2o",
            "odometry.tum",
            "report.json",
            "session.json",
        ]
    );
    bench.cogmap("replay first/session.json --out again").done();
    assert_same(&first, &lasting(&bench, "again"));
}

#[test]
fn several_mappers_leave_files_with_their_names() {
    let bench = Workbench::new();
    bench.cogmap("replay walk.log --mapper odometry --mapper perceptual --out both").done();
    let files = bench.files_in("both");
    for stem in ["estimate", "map", "events"] {
        for mapper in ["odometry", "perceptual"] {
            let beginning = format!("{stem}.{mapper}.");
            assert!(names(&files).iter().any(|name| name.starts_with(&beginning)), "{beginning}");
        }
    }
    assert!(!bench.path("both/map.json").exists());
    bench.cogmap("replay walk.log --mapper odometry --out one").done();
    assert_eq!(bench.read("one/map.json"), bench.read("both/map.odometry.json"));
}

#[test]
fn the_trajectories_have_a_row_a_scan_and_more_when_dense() {
    let bench = Workbench::new();
    bench.cogmap("replay walk.log --out plain").done();
    assert_eq!(bench.read("plain/estimate.tum").lines().count(), 24);
    assert_eq!(bench.read("plain/odometry.tum").lines().count(), 24);
    bench.cogmap("run room.world.json --out plain-run").done();
    bench.cogmap("run room.world.json --dense --out dense-run").done();
    let rows = |name: &str| bench.read(name).lines().count();
    assert!(rows("dense-run/odometry.tum") > 2 * rows("plain-run/odometry.tum"));
    assert_eq!(rows("dense-run/odometry.tum"), rows("dense-run/estimate.tum"));
    assert_eq!(bench.read("plain-run/map.json"), bench.read("dense-run/map.json"));
}

#[test]
fn the_seed_decides_and_nothing_else() {
    let bench = Workbench::new();
    bench.put("room.world.json", ROOM.replace("[6,0],[6,4],[0,4]", "[14,0],[14,10],[0,10]"));
    for (seed, out) in [("1", "default"), ("2", "other")] {
        bench.cogmap(&format!("run room.world.json --route random --seed {seed} --out {out}")).done();
    }
    bench.cogmap("run room.world.json --route random --out again").done();
    assert_same(&lasting(&bench, "default"), &lasting(&bench, "again"));
    assert_ne!(bench.read("default/odometry.tum"), bench.read("other/odometry.tum"));
}

#[test]
fn routes_and_robots_come_by_name_or_from_files() {
    let bench = Workbench::new();
    bench.put("mine.json", "[[2, 2], [1, 3]]");
    bench.cogmap("run room.world.json --robot perfect --route back --out named").done();
    bench.cogmap("run room.world.json --robot perfect --route mine.json --out file").done();
    assert_eq!(bench.read("named/session.json"), bench.read("file/session.json"));
    let session: serde_json::Value = serde_json::from_str(&bench.read("named/session.json")).unwrap();
    bench.put("my.robot.json", session["source"]["robot"].to_string());
    bench.cogmap("run room.world.json --robot my.robot.json --route back --out robot").done();
    assert_eq!(bench.read("named/map.json"), bench.read("robot/map.json"));
}

#[test]
fn the_summary_says_what_came_out_and_where_it_is() {
    let bench = Workbench::new();
    let outcome = bench.cogmap("run room.world.json --mapper perceptual --mapper odometry --out both").done();
    for word in
        ["Room", "across", "perceptual", "odometry", "views", "surfaces", "fallbacks", "weak", "both/"]
    {
        assert!(outcome.out.contains(word), "{word}: {}", outcome.out);
    }
    assert!(outcome.err.is_empty(), "no progress bar in a pipe: {}", outcome.err);
    let outcome = bench.cogmap("run room.world.json").done();
    assert!(outcome.out.contains("--out DIR"), "{}", outcome.out);
}

#[test]
fn a_directory_with_another_run_is_refused_and_left_alone_unless_forced() {
    let bench = Workbench::new();
    bench.cogmap("replay walk.log --mapper odometry --mapper perceptual --out place").done();
    let before = bench.files_in("place");
    assert_eq!(bench.cogmap("replay walk.log --out place").code, Some(2));
    assert_same(&before, &bench.files_in("place"));
    bench.cogmap("replay walk.log --out place --force").done();
    assert!(bench.path("place/map.json").exists());
    assert!(!bench.path("place/map.odometry.json").exists(), "nothing of the earlier run is left");
}

#[test]
fn a_session_can_be_run_again_in_its_own_place_and_with_other_mappers() {
    let bench = Workbench::new();
    bench.cogmap("run room.world.json --out place").done();
    let before = lasting(&bench, "place");
    bench.cogmap("replay place/session.json --out place --force").done();
    assert_same(&before, &lasting(&bench, "place"));
    bench.cogmap("replay place/session.json --mapper odometry --out other").done();
    assert_eq!(bench.read("place/truth.tum"), bench.read("other/truth.tum"));
    assert_ne!(bench.read("place/map.json"), bench.read("other/map.json"));
}

#[test]
fn a_log_is_found_beside_its_session_and_must_be_the_same_one() {
    let bench = Workbench::new();
    bench.cogmap("replay walk.log --out first").done();
    fs::create_dir(bench.path("moved")).unwrap();
    fs::rename(bench.path("walk.log"), bench.path("moved/walk.log")).unwrap();
    fs::copy(bench.path("first/session.json"), bench.path("moved/session.json")).unwrap();
    bench.cogmap("replay moved/session.json --out again").done();
    assert_same(&lasting(&bench, "first"), &lasting(&bench, "again"));

    let gone = bench.cogmap("replay first/session.json");
    assert_eq!(gone.code, Some(2));
    assert!(gone.err.contains("walk.log") && gone.err.contains("help:"), "{}", gone.err);

    bench.put("moved/walk.log", crate::workbench::walk() + "# edited\n");
    let changed = bench.cogmap("replay moved/session.json");
    assert_eq!(changed.code, Some(2));
    assert!(changed.err.contains("not the log") && changed.err.contains("help:"), "{}", changed.err);
}

#[test]
fn what_belongs_to_logs_is_refused_for_a_drive() {
    let bench = Workbench::new();
    bench.cogmap("run room.world.json --out drive").done();
    for option in ["--every 0.5", "--odometry-noise 2", "--seed 4", "--strict"] {
        let outcome = bench.cogmap(&format!("replay drive/session.json {option}"));
        assert_eq!(outcome.code, Some(2), "{option}");
        let name = option.split(' ').next().unwrap();
        assert!(outcome.err.contains(name) && outcome.err.contains("cogmap run"), "{}", outcome.err);
    }
}

#[test]
fn broken_lines_are_counted_and_skipped() {
    let bench = Workbench::new();
    bench.put("broken.log", crate::workbench::walk() + "FLASER 181 1.0 oops\nHELLO\n");
    let outcome = bench.cogmap("replay broken.log --out out").done();
    assert!(outcome.err.contains("1 broken line") && outcome.err.contains("--strict"), "{}", outcome.err);
    assert_eq!(bench.read("out/estimate.tum").lines().count(), 24);
}

#[test]
#[cfg(unix)]
fn nobody_listening_is_no_failure() {
    let bench = Workbench::new();
    for arguments in [&["--help"][..], &["check", "room.world.json"], &["replay", "walk.log", "--out", "out"]]
    {
        let mut child =
            bench.command().args(arguments).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
        drop(child.stdout.take());
        let output = child.wait_with_output().unwrap();
        let err = String::from_utf8_lossy(&output.stderr);
        assert!(output.status.success() && !err.contains("panicked"), "{arguments:?}: {err}");
    }
    assert!(bench.path("out/map.json").exists());
}

#[test]
fn a_robot_that_goes_home_says_how_it_went_and_its_session_takes_it_home_again() {
    let bench = Workbench::new();
    for strategy in ["recommended", "retrace", "oracle"] {
        let arguments = format!("run room.world.json --route across --go-home --strategy {strategy}");
        let outcome = bench.cogmap(&format!("{arguments} --out {strategy}")).done();
        let told = outcome.out.split("Went home by").nth(1).unwrap();
        assert!(told.starts_with(&format!(" `{strategy}`")) && told.contains("stopped by itself"), "{told}");
        assert!(told.contains("m from its start") && told.contains("m out; "), "{told}");
        let first = lasting(&bench, strategy);
        let again = bench.cogmap(&format!("replay {strategy}/session.json --out {strategy}-again")).done();
        assert_same(&first, &lasting(&bench, &format!("{strategy}-again")));
        assert!(again.out.contains(&format!("Went home by `{strategy}`")), "{}", again.out);
        let session = bench.read(&format!("{strategy}/session.json"));
        assert!(session.contains(&format!("\"do\":\"go_home\",\"strategy\":\"{strategy}\"}}")), "{session}");
        let events = bench.read(&format!("{strategy}/events.jsonl"));
        let place =
            |kind: &str| events.find(&format!("\"kind\":\"{kind}\"")).unwrap_or_else(|| panic!("{kind}"));
        assert!(place("go_home") < place("home"), "{events}");
        assert!(bench.read(&format!("{strategy}/report.json")).contains("\"ending\": \"home\""));
    }
}

#[test]
fn other_mappers_are_shown_the_same_way_home() {
    let bench = Workbench::new();
    bench.cogmap("run room.world.json --go-home --out ours").done();
    bench.cogmap("replay ours/session.json --mapper odometry --mapper perceptual --out others").done();
    assert_eq!(bench.read("ours/truth.tum"), bench.read("others/truth.tum"));
    let others = lasting(&bench, "others");
    bench.cogmap("replay others/session.json --out again").done();
    assert_same(&others, &lasting(&bench, "again"));
}

#[test]
fn a_robot_that_cannot_go_home_has_failed_and_says_why() {
    let bench = Workbench::new();
    // The start is nearer to the wall than the person at the controls keeps, so the oracle gives up.
    bench.put("tight.world.json", ROOM.replace("[1,1]", "[0.27,1]"));
    let outcome = bench.cogmap("run tight.world.json --route across --go-home --strategy oracle");
    assert_eq!(outcome.code, Some(1), "{}", outcome.out);
    assert!(outcome.err.contains("gave up") && outcome.err.contains("--strategy"), "{}", outcome.err);
    assert!(outcome.out.contains("gave up: no way leads back"), "{}", outcome.out);
}
