use std::fs;

use crate::workbench::{ROOM, Workbench};

/// Arguments, what the message must name, and the way out that it must show.
const CASES: [(&str, &str, &str); 65] = [
    ("fly", "'fly'", "--help"),
    ("relay room.world.json", "'relay'", "'replay'"),
    ("run", "<WORLD>", "Usage: cogmap run"),
    ("run room.world.json --sed 3", "'--sed'", "'--seed'"),
    ("run room.world.json --seed", "--seed", "a value is required"),
    ("run room.world.json --seed -1", "--seed", "not a number from 0"),
    ("run room.world.json --seed 1.5", "--seed", "not a number from 0"),
    ("run room.world.json --seed 99999999999999999999", "--seed", "not a number from 0"),
    (
        "run room.world.json --mapper slam",
        "--mapper",
        "[possible values: perceptual, consensus, transform, odometry]",
    ),
    ("run room.world.json --mapper odometry --mapper odometry", "`odometry` twice", "once"),
    ("run room.world.json --robot ugly", "--robot ugly", "perfect, good, bad"),
    ("run room.world.json --robot typo.robot.json", "typo.robot.json, line 1", "`laser`"),
    ("run room.world.json --robot blind.robot.json", "blind.robot.json", "beams"),
    ("run room.world.json --robot walk.log", "walk.log", "JSON"),
    ("run room.world.json --go-home --strategy teleport", "'teleport'", "retrace, tangent-bug, oracle]"),
    ("run room.world.json --strategy retrace", "--go-home", "Usage: cogmap run"),
    ("run room.world.json --go-home --strategy", "--strategy", "a value is required"),
    ("run room.world.json --route tour", "no route `tour`", "across, back"),
    ("run room.world.json --route points.json", "points.json", "[[x, y], …]"),
    ("run room.world.json --route empty-route.json", "empty-route.json", "at least one point"),
    ("run room.world.json --route outside.json", "outside.json", "move the point"),
    ("run room.world.json --route in", "--route in", "directory"),
    ("run no-routes.world.json", "no route", "--route random"),
    ("run nowhere.world.json", "nowhere.world.json", "no such file"),
    ("run in", "in: this is a directory", "name a file in it"),
    ("run plan.png", "plan.png: a picture does not say how large", "--resolution 0.05"),
    ("run plan.png --resolution 0.05", "plan.png: broken PNG picture", "save it again"),
    ("run plan.png --resolution 0", "--resolution", "metres of a pixel"),
    ("run room.world.json --resolution 0.05", "room.world.json is no picture", "leave --resolution out"),
    ("run lost.yaml", "lost.png: there is no such file", "`image`"),
    ("run scaleless.yaml", "scaleless.yaml: no `resolution`", "resolution: 0.05"),
    ("run walk.log", "walk.log: this is a log", "cogmap replay walk.log"),
    ("run empty.json", "empty.json: this is an empty file", "world.json"),
    ("run typo.world.json", "unknown key `wals`", "did you mean `walls`?"),
    ("run cut.world.json", "cut.world.json, line 3", "too early"),
    ("run latin1.world.json", "latin1.world.json: byte 43", "UTF-8"),
    ("run room.world.json --force", "--out <DIR>", "--force"),
    ("run room.world.json --dense", "--out <DIR>", "--dense"),
    ("run room.world.json --out walk.log", "--out walk.log: this is a file", "name a directory"),
    ("run room.world.json --out taken", "--out taken", "--force"),
    ("run room.world.json --out walk.log/in", "--out walk.log/in", "directory"),
    ("replay", "<LOG|SESSION>", "Usage: cogmap replay"),
    ("replay walk.log --every 0", "--every", "above 0"),
    ("replay walk.log --every nan", "--every", "a number such as"),
    ("replay walk.log --every -1", "--every", "above 0"),
    ("replay walk.log --odometry-noise -3", "--odometry-noise", "0 (no noise)"),
    ("replay broken.log --strict", "broken.log, line 3", "--strict"),
    ("replay text.log", "text.log: no usable scan", "FLASER"),
    ("replay cut.log.gz", "cut.log.gz: the gzip data is broken", "fetch the file again"),
    ("replay room.world.json", "room.world.json: this is a world", "cogmap run room.world.json"),
    ("replay plan.png", "plan.png: this is a picture", "CARMEN"),
    ("study flight", "no study `flight`", "loop-b"),
    ("study small --seeds 0", "--seeds", "1..=1000000"),
    ("study small --jobs none", "--jobs", "invalid"),
    ("study small --seed -1", "--seed", "not a number from 0"),
    ("study small --worlds nowhere.world.json", "--worlds nowhere.world.json: no such file", "*.world.json"),
    ("study small --worlds walk.log", "walk.log", "JSON"),
    ("study small --worlds no-routes.world.json", "has no route", "route"),
    ("study small --out walk.log", "--out walk.log: this is a file", "name a directory"),
    ("study claims --worlds room.world.json", "leave --worlds out", "loop-b"),
    ("study relations", "--log FILE", "--relations FILE"),
    ("study relations --relations walk.log", "--log <FILE>", "--log"),
    ("study relations --log room.world.json", "this is a world", "cogmap run"),
    ("study relations --log walk.log --relations text.log", "text.log, line", "t1 t2"),
    ("check", "<FILE>", "Usage: cogmap check"),
];

fn bench() -> Workbench {
    let bench = Workbench::new();
    for directory in ["in", "taken"] {
        fs::create_dir(bench.path(directory)).unwrap();
    }
    bench.put("taken/report.json", "{}");
    bench.put("plan.png", b"\x89PNG\r\n\x1a\n");
    bench.put("lost.yaml", "image: lost.png\nresolution: 0.05\n");
    bench.put("scaleless.yaml", "image: plan.png\n");
    bench.put("empty.json", "");
    bench.put("typo.world.json", ROOM.replace("\"walls\"", "\"wals\""));
    bench.put("cut.world.json", &ROOM[..60]);
    bench.put("latin1.world.json", latin1(ROOM));
    bench.put(
        "no-routes.world.json",
        ROOM.replace("\"across\": [[3,1.6],[5,2.4]], \"back\": [[2,2],[1,3]]", ""),
    );
    bench.put("points.json", r#"[{"x":1,"y":2}]"#);
    bench.put("empty-route.json", "[]");
    bench.put("outside.json", "[[40, 40]]");
    bench.put("typo.robot.json", r#"{"name":"mine","body":{},"lasers":{},"odometry":{}}"#);
    bench.put("blind.robot.json", r#"{"name":"mine","body":{},"laser":{"beams":0},"odometry":{}}"#);
    bench.put("text.log", "Dear diary,\nno robot today.\n");
    bench.put("broken.log", "# fine\nODOM 0 0 0 0 0 0 0 h 0\nFLASER 181 1.0 oops\n");
    bench.put("cut.log.gz", b"\x1f\x8b\x08\x00\x00\x00\x00\x00\x00\x03\x4b");
    bench
}

/// The world's name with an é as ISO 8859-1 writes it.
fn latin1(world: &str) -> Vec<u8> {
    let at = world.find("Room").unwrap() + 1;
    let mut bytes = world.as_bytes().to_vec();
    bytes[at] = 0xe9;
    bytes
}

#[test]
fn each_bad_argument_is_named_with_the_way_out() {
    let bench = bench();
    let mut wrong = String::new();
    for (arguments, named, way_out) in CASES {
        let outcome = bench.cogmap(arguments);
        let as_it_should = outcome.code == Some(2)
            && outcome.err.contains(named)
            && outcome.err.contains(way_out)
            && !outcome.err.contains("panicked")
            && outcome.out.is_empty();
        if !as_it_should {
            wrong += &format!("cogmap {arguments}\n  should name {named:?} and {way_out:?}: {outcome:#?}\n");
        }
    }
    assert!(wrong.is_empty(), "{wrong}");
}

#[test]
fn a_refused_command_leaves_no_files() {
    let bench = bench();
    for arguments in [
        "run typo.world.json --out new",
        "replay text.log --out new",
        "run room.world.json --route x --out new",
    ] {
        assert_eq!(bench.cogmap(arguments).code, Some(2), "{arguments}");
        assert!(!bench.path("new").exists(), "{arguments}");
    }
}

#[test]
fn no_argument_at_all_shows_the_help() {
    let outcome = Workbench::new().cogmap("");
    assert_eq!(outcome.code, Some(2));
    assert!(outcome.err.contains("Example: cogmap run"), "{outcome:?}");
}

#[test]
#[cfg(unix)]
fn arguments_that_are_no_text_are_no_trouble() {
    use std::ffi::OsStr;
    use std::os::unix::ffi::OsStrExt;
    let odd = OsStr::from_bytes(b"\xff\xfe");
    let bench = Workbench::new();
    for arguments in [
        vec![odd],
        vec![OsStr::new("check"), odd],
        vec![OsStr::new("run"), odd],
        vec![OsStr::new("run"), OsStr::new("room.world.json"), OsStr::new("--route"), odd],
        vec![OsStr::new("run"), OsStr::new("room.world.json"), OsStr::new("--robot"), odd],
        vec![OsStr::new("replay"), OsStr::new("walk.log"), OsStr::new("--mapper"), odd],
        vec![OsStr::new("replay"), OsStr::new("walk.log"), OsStr::new("--every"), odd],
    ] {
        let outcome = bench.cogmap_with(&arguments);
        assert_eq!(outcome.code, Some(2), "{arguments:?}: {outcome:?}");
        assert!(outcome.err.starts_with("error: ") && !outcome.err.contains("panicked"), "{outcome:?}");
    }
}
