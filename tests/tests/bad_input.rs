//! One table of bad input: what is wrong, and what the message must say of the place and of the way
//! out. Arguments and files that do not exist are the command line's own table.

use cogmap_formats::{FormatError, session, world};

mod logs;

const WORLD: &str = r#"{ "format": "cogmap-world/1", "name": "Cell",
  "walls": [[[0,0],[5,0],[5,4],[0,4],[0,0]]],
  "boxes": [{"center": [4,3], "size": [0.5,0.4]}],
  "posts": [{"center": [4,1], "radius": 0.02}],
  "doors": [{"name": "d", "hinge": [2,0], "latch": [3,0]}],
  "start": {"position": [1,2], "heading_deg": 90},
  "routes": {"tour": [[2,2],[3,2]]},
  "rooms": [{"name": "cell", "outline": [[0,0],[5,0],[5,4]]}] }"#;

const SESSION: &str = r#"{ "format": "cogmap-session/1", "engine": "0.1.0",
  "source": { "from": "world",
    "world": {"format": "cogmap-world/1", "name": "Cell",
      "walls": [[[0,0],[5,0],[5,4],[0,4],[0,0]]], "start": {"position": [1,2]}},
    "robot": {"name": "mine", "laser": {"beams": 181}},
    "commands": [{"tick": 1, "do": "step", "turn": 0.3, "travel": 1.0}, {"tick": 9, "do": "stop"}],
    "ticks": 10 },
  "mappers": [{"mapper": "perceptual"}],
  "seed": 1 }"#;

const REPLAYED: &str = r#"{ "format": "cogmap-session/1", "engine": "0.1.0",
  "source": { "from": "log", "path": "a.log", "every": 0.5, "odometry_noise": 1.0,
    "sha256": "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad" },
  "mappers": [{"mapper": "odometry"}], "seed": 1 }"#;

/// What is wrong, and what the message says: of the place, and of the way out.
type Case<'a> = (&'a str, &'a str, &'a str, &'a str);

/// What is wrong with the message of a case, if anything is: it must begin with the file's name and
/// say both.
fn fault<T>(file: &str, case: Case<'_>, result: Result<T, FormatError>) -> Option<String> {
    let (from, to, place, way_out) = case;
    let Err(error) = result else { return Some(format!("`{from}` → `{to}` was accepted")) };
    let message = error.to_string();
    let good = message.starts_with(file) && message.contains(place) && message.contains(way_out);
    (!good).then(|| format!("`{from}` → `{to}`: no `{file}`, `{place}` and `{way_out}` in: {message}"))
}

fn check<T>(file: &str, case: Case<'_>, result: Result<T, FormatError>) {
    assert_eq!(fault(file, case, result), None);
}

fn check_all<'a, T>(
    file: &str,
    cases: impl IntoIterator<Item = Case<'a>>,
    read: impl Fn(Case<'a>) -> Result<T, FormatError>,
) {
    let faults: Vec<String> = cases.into_iter().filter_map(|case| fault(file, case, read(case))).collect();
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

fn changed(text: &str, (from, to, ..): Case<'_>) -> String {
    if from == text {
        return to.to_owned();
    }
    assert!(text.contains(from), "nothing to change: {from}");
    text.replacen(from, to, 1)
}

/// Changes to the good world.
const BAD_WORLDS: &[Case<'_>] = &[
    (WORLD, "", "line 1", "ends too early"),
    (WORLD, "walls", "line 1", "begin the file with { \"format\": \"cogmap-world/1\""),
    (WORLD, "[]", "line 1", "begin the file with {"),
    (WORLD, "{\"walls\": [[[0", "line 1, column 14", "never closed"),
    ("] }", "], }", "line 8", "extra comma"),
    ("] }", "] } }", "line 8", "take out what is too much"),
    ("\"walls\"", "// walls\n\"walls\"", "line 2", "JSON has no comments"),
    ("\"walls\": [", "\"walls\": [NaN, ", "line 2, column 13", "comma, quote or bracket"),
    ("[5,0]", "[1e999,0]", "line 2", "number nearer to zero"),
    ("[5,0]", "[5,-Infinity]", "line 2", "comma, quote or bracket"),
    ("\"walls\"", "\"wals\"", "line 2, column 8", "did you mean `walls`?"),
    ("\"walls\"", "\"qqqqq\"", "line 2", "known here: $schema, format, name"),
    ("\"center\"", "\"centre\"", "at `boxes[0]`", "did you mean `center`?"),
    (
        "\"radius\"",
        "\"height\": 2, \"radius\"",
        "line 4, column 38, at `posts[0]`",
        "known here: center, radius",
    ),
    (
        "cogmap-world/1",
        "cogmap-world/2",
        "at `format`",
        "found \"cogmap-world/2\"; pass a file of that format",
    ),
    (
        "\"cogmap-world/1\"",
        "17",
        "line 1, column 13, at `format`",
        "expected the format \"cogmap-world/1\", found 17",
    ),
    ("\"format\": \"cogmap-world/1\", ", "", "at `format`", "write \"format\": \"cogmap-world/1\""),
    (WORLD, SESSION, "at `format`", "found \"cogmap-session/1\"; pass a file of that format"),
    ("\"name\": \"Cell\",", "", "line 8", "add the key `name`"),
    ("\"start\"", "\"routes\": {}, \"start\"", "line 7", "duplicate field `routes`; keep one of the two"),
    ("\"position\": [1,2],", "", "at `start`", "add the key `position`"),
    ("[5,0]", "\"5,0\"", "at `walls[0][1]`", "expected an array of length 2"),
    ("[5,0]", "[5,0,1]", "line 2, column 25, at `walls[0][1]`", "take out what is too much"),
    ("[5,0]", "[5]", "at `walls[0][1]`", "expected an array of length 2"),
    ("90", "\"north\"", "at `start.heading_deg`", "expected a number"),
    ("[5,0]", "[5e9,0]", "line 2, column 21, at `walls[0][1][0]`", "expected a number from -10000 to 10000"),
    (
        "[[0,0],[5,0],[5,4],[0,4],[0,0]]",
        "[[0,0]]",
        "line 2, column 13, at `walls[0]`",
        "expected at least 2 points, found 1: add some",
    ),
    ("0.02", "-0.02", "line 4, column 41, at `posts[0].radius`", "expected a number from 0.001"),
    ("[0.5,0.4]", "[0.5,0]", "at `boxes[0].size[1]`", "expected a number from 0.001"),
    ("\"latch\": [3,0]", "\"latch\": [2,0]", "line 5, column 52, at `doors[0].latch`", "move it"),
    (
        "}],\n  \"start\"",
        "}, {\"name\": \"d\", \"hinge\": [0,2], \"latch\": [0,3]}],\n  \"start\"",
        "at `doors[1].name`",
        "name",
    ),
    ("[1,2]", "[4,3]", "at `start", "box"),
    ("[1,2]", "[0.1,2]", "line 6, column 25, at `start.position`", "move the start"),
    ("[3,2]", "[9,2]", "line 7, column 29, at `routes.tour[1]`", "move the point"),
    (
        "[[0,0],[5,0],[5,4]]",
        "[[0,0],[5,0]]",
        "line 8, column 41, at `rooms[0].outline`",
        "expected at least 3 corners",
    ),
    ("\"size\"", "\"heading_deg\": 1e300, \"size\"", "at `boxes[0].heading_deg`", "expected a number from"),
];

#[test]
fn a_bad_world_names_the_place_and_the_way_out() {
    assert!(world::read(WORLD, "w.json").is_ok());
    check_all("w.json", BAD_WORLDS.iter().copied(), |case| world::read(&changed(WORLD, case), "w.json"));
    let deep = WORLD.replacen("[5,0]", &"[".repeat(100_000), 1);
    check("w.json", ("[5,0]", "[[[[…", "line 2", "expected a number"), world::read(&deep, "w.json"));
}

/// Changes to the good session.
const BAD_SESSIONS: &[Case<'_>] = &[
    (
        "cogmap-session/1",
        "cogmap-session/9",
        "line 1, column 13, at `format`",
        "expected the format \"cogmap-session/1\"",
    ),
    (SESSION, WORLD, "at `format`", "found \"cogmap-world/1\"; pass a file of that format"),
    (SESSION, "", "line 1", "ends too early"),
    ("\"seed\": 1", "\"sed\": 1", "line 9", "did you mean `seed`?"),
    ("\"seed\": 1", "\"seed\": -1", "at `seed`", "expected a whole number"),
    ("\"seed\": 1", "\"seed\": 1.5", "line 9, column 13, at `seed`", "expected a whole number"),
    ("\"from\": \"world\"", "\"from\": \"wrld\"", "at `source", "did you mean `world`?"),
    ("\"from\": \"world\",", "", "at `source`", "add the key `from`"),
    ("\"walls\"", "\"wals\"", "line 4, column 12, at `source.world`", "did you mean `walls`?"),
    ("[1,2]", "[1]", "at `source.world.start.position`", "array of length 2"),
    ("[1,2]", "[5,2]", "line 4, column 73, at `source.world.start.position`", "move the start"),
    (
        "\"beams\": 181",
        "\"beams\": 1000000000",
        "line 5, column 50, at `source.robot.laser.beams`",
        "choose a number from 2 to 10000",
    ),
    ("\"beams\"", "\"beems\"", "at `source.robot.laser`", "did you mean `beams`?"),
    (
        "\"ticks\": 10",
        "\"ticks\": 1000000000000000000",
        "line 7, column 14, at `source.ticks`",
        "at most 4320000 ticks",
    ),
    ("\"ticks\": 10", "\"ticks\": 1e30", "at `source`", "expected a whole number"),
    ("\"tick\": 9", "\"tick\": 0", "at `source.commands[1].tick`", "put commands in order, from 1"),
    (
        "\"tick\": 9",
        "\"tick\": 99",
        "line 6, column 82, at `source.commands[1].tick`",
        "the session's 10 ticks",
    ),
    (
        "\"turn\": 0.3",
        "\"turn\": 1e300",
        "at `source.commands[0].turn`",
        "choose a number from -1000 to 1000",
    ),
    ("\"stop\"", "\"fly\"", "line 6, column 96, at `source.commands[1]`", "write one of those"),
    (
        "{\"tick\": 9, \"do\": \"stop\"}",
        "{\"tick\": 9, \"do\": \"go_home\", \"strategy\": \"fly\"}",
        "line 6, column 119, at `source.commands[1]",
        "tangent-bug, oracle",
    ),
    (
        "{\"tick\": 9, \"do\": \"stop\"}",
        "{\"tick\": 9, \"do\": \"go_home\", \"strategy\": {\"strategy\": \"retrace\", \"passed\": 1e9}}",
        "at `source.commands[1].strategy.passed`",
        "choose a number from -1000000 to 1000000",
    ),
    (
        "{\"tick\": 9, \"do\": \"stop\"}",
        "{\"tick\": 9, \"do\": \"change\", \"what\": \"dor\", \"name\": \"d\", \"open\": true}",
        "at `source.commands[1]",
        "did you mean `door`?",
    ),
    ("\"perceptual\"", "\"perceptul\"", "at `mappers[0]", "did you mean `perceptual`?"),
    ("\"perceptual\"", "\"perceptual\", \"matching\": {\"x\": 1}", "at `mappers[0]`", "known here: "),
    ("[{\"mapper\": \"perceptual\"}]", "[]", "line 8, column 14, at `mappers`", "name from 1 to 16 mappers"),
    ("\"mappers\": [{\"mapper\": \"perceptual\"}],", "", "line 9", "add the key `mappers`"),
];

#[test]
fn a_bad_session_names_the_place_and_the_way_out() {
    assert!(session::read(SESSION, "s.json").is_ok());
    check_all("s.json", BAD_SESSIONS.iter().copied(), |case| {
        session::read(&changed(SESSION, case), "s.json")
    });
    let door = ", {\"tick\": 9, \"do\": \"change\", \"what\": \"door\", \"name\": \"d\", \"open\": true}";
    let changes = format!("\"stop\"}}{}]", door.repeat(2001));
    let case = ("\"stop\"}]", &*changes, "at `source.commands`", "at most 2000 can be run");
    check("s.json", case, session::read(&changed(SESSION, case), "s.json"));
    let seventeen = format!("[{}]", ["{\"mapper\": \"odometry\"}"; 17].join(","));
    let case = ("[{\"mapper\": \"perceptual\"}]", &*seventeen, "at `mappers`", "name from 1 to 16 mappers");
    check("s.json", case, session::read(&changed(SESSION, case), "s.json"));
}

/// Changes to the good session of a log.
const BAD_REPLAYS: &[Case<'_>] = &[
    ("a.log", "", "at `source.path`", "name the log's file"),
    ("ba7816bf", "zz7816bf", "line 3, column 15, at `source.sha256`", "write the log file's SHA-256"),
    ("\"every\": 0.5", "\"every\": 0", "at `source.every`", "choose a number from 0.001 to 1000"),
    (
        "\"odometry_noise\": 1.0",
        "\"odometry_noise\": 1e9",
        "at `source.odometry_noise`",
        "choose a number from 0 to 1000",
    ),
    (
        "\"odometry_noise\": 1.0",
        "\"odometry_noise\": -1",
        "line 2, column 79, at `source.odometry_noise`",
        "choose a number",
    ),
    ("\"path\"", "\"ticks\": 4, \"path\"", "at `source`", "known here: path, sha256, every"),
];

#[test]
fn a_bad_session_of_a_log_names_the_place_and_the_way_out() {
    assert!(session::read(REPLAYED, "s.json").is_ok());
    check_all("s.json", BAD_REPLAYS.iter().copied(), |case| {
        session::read(&changed(REPLAYED, case), "s.json")
    });
}
