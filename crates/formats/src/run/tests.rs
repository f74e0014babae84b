use cogmap_mapping::MapperSetup;
use cogmap_simulation::{Command, Robot, Source};
use serde_json::Value;

use super::*;

fn drive(mappers: &[&str]) -> Session {
    let text = r#"{ "format": "cogmap-world/1", "name": "Cell",
        "walls": [[[0,0],[6,0],[6,5],[0,5],[0,0]]],
        "boxes": [{"center": [4,4], "size": [0.8,0.5], "heading_deg": 20}],
        "start": {"position": [1,2]} }"#;
    let mut session = begin(text, "bad", mappers);
    for turn in [0.4, -0.3, 0.2] {
        step(&mut session, turn, 0.7);
    }
    step(&mut session, 0.0, 5.0);
    session
}

/// Two rooms and the door between them, through which the robot drives and on into the second.
fn passage(mappers: &[&str]) -> Session {
    let text = r#"{ "format": "cogmap-world/1", "name": "Two rooms",
        "walls": [[[0,0],[12,0],[12,5],[0,5],[0,0]], [[6,0],[6,2.1]], [[6,2.9],[6,5]]],
        "boxes": [{"center": [2,4.4], "size": [1.2,0.6]}, {"center": [9.5,0.5], "size": [1.4,0.6]}],
        "start": {"position": [2,2.5]} }"#;
    let mut session = begin(text, "perfect", mappers);
    for _ in 0..15 {
        step(&mut session, 0.0, 0.5);
    }
    session
}

fn step(session: &mut Session, turn: f64, travel: f64) {
    session.command(Command::Step { turn, travel });
    while session.advance() && !session.at_rest() {}
}

fn begin(text: &str, robot: &str, mappers: &[&str]) -> Session {
    let world = crate::world::read(text, "cell.world.json").unwrap();
    let mappers = mappers.iter().map(|name| MapperSetup::named(name).unwrap()).collect();
    let source = Source::world(world, Robot::named(robot).unwrap());
    Session::drive(SessionRecord::new(source, mappers, 7)).unwrap()
}

fn file<'a>(files: &'a [RunFile], name: &str) -> &'a str {
    &files.iter().find(|file| file.name == name).unwrap_or_else(|| panic!("no {name}")).text
}

#[test]
fn the_session_file_gives_every_file_again() {
    let files_then = files(&drive(&["perceptual", "odometry"]), Extras::default());
    let record = session::read(file(&files_then, "session.json"), "session.json").unwrap().record;
    let mut again = Session::drive(record).unwrap();
    again.jump(again.end());
    assert_eq!(files(&again, Extras::default()), files_then);
}

#[test]
fn one_mapper_leaves_plain_names_and_several_their_own() {
    let names = |mappers: &[&str]| -> Vec<String> {
        files(&drive(mappers), Extras::default()).into_iter().map(|file| file.name).collect()
    };
    assert_eq!(
        names(&["perceptual"]),
        [
            "session.json",
            "truth.tum",
            "odometry.tum",
            "estimate.tum",
            "map.json",
            "network.g2o",
            "events.jsonl",
            "report.json"
        ]
    );
    let two = names(&["odometry", "odometry"]);
    assert!(
        two.contains(&"map.odometry.json".to_owned()) && two.contains(&"estimate.odometry-2.tum".to_owned())
    );
}

#[test]
fn a_map_holds_every_surface_and_the_path() {
    let session = drive(&["perceptual"]);
    let map: Value = serde_json::from_str(&map(&session, 0)).unwrap();
    let mapper = &session.mappers()[0];
    assert_eq!(map["format"], "cogmap-map/1");
    assert_eq!(map["mapper"], "perceptual");
    assert_eq!(map["frames"], serde_json::json!([{"id": 0, "map_from_frame": [0.0, 0.0, 0.0]}]));
    assert_eq!(map["surfaces"].as_array().unwrap().len(), mapper.mfis().surfaces().len());
    let surface = &mapper.mfis().surfaces()[0];
    assert_eq!(map["surfaces"][0]["a"][0].as_f64(), Some(surface.segment.a.x));
    assert!(map["surfaces"][0]["true_wall"].is_u64() && map["surfaces"][0]["asr"].is_u64());
    assert_eq!(map["path"].as_array().unwrap().len(), mapper.path().len());
    assert!(map["path"][0]["heading"].is_number());
}

/// The words that a map keeps under a key of each row of a list.
fn column<'a>(map: &'a Value, list: &str, key: &str) -> Vec<&'a Value> {
    map[list].as_array().unwrap().iter().map(|row| &row[key]).collect()
}

#[test]
fn a_map_holds_the_network_of_local_spaces() {
    for name in ["perceptual", "consensus"] {
        let session = passage(&[name]);
        let map: Value = serde_json::from_str(&map(&session, 0)).unwrap();
        let network = session.mappers()[0].network().unwrap();
        assert_eq!((network.asrs().len(), network.exits().len()), (2, 1), "{name}");
        assert_eq!(column(&map, "exits", "between"), [&serde_json::json!([0, 1])]);
        assert_eq!(column(&map, "exits", "frame"), [&Value::from(network.exits()[0].frame.0)]);
        assert_eq!(column(&map, "asrs", "exits"), [&serde_json::json!([0]), &serde_json::json!([0])]);
        assert!(column(&map, "asrs", "outline").iter().all(|outline| outline.as_array().unwrap().len() > 3));
        for list in ["surfaces", "path"] {
            let asrs = column(&map, list, "asr");
            assert!(asrs.contains(&&Value::from(0)) && asrs.contains(&&Value::from(1)), "{name}: {list}");
        }
    }
}

#[test]
fn a_mapper_that_knows_no_local_spaces_says_so() {
    let session = passage(&["transform"]);
    let map: Value = serde_json::from_str(&map(&session, 0)).unwrap();
    assert_eq!((&map["exits"], &map["asrs"]), (&serde_json::json!([]), &serde_json::json!([])));
    assert!(column(&map, "surfaces", "asr").iter().all(|asr| asr.is_null()));
    let report: Value = serde_json::from_str(&report(&session, Extras::default())).unwrap();
    assert!(report["mappers"][0]["asrs"].is_null() && report["mappers"][0]["loops_closed"].is_null());
}

#[test]
fn the_pose_graph_holds_every_frame_and_link() {
    let session = passage(&["consensus"]);
    let mfis = session.mappers()[0].mfis();
    assert!(mfis.frames().len() > 1, "the way is long enough for a second frame");
    let text = network(&session, 0);
    let count = |tag: &str| text.lines().filter(|line| line.starts_with(tag)).count();
    assert_eq!(count("VERTEX_SE2 "), mfis.frames().len());
    assert_eq!(count("EDGE_SE2 "), mfis.links().len());
    assert_eq!(count(""), mfis.frames().len() + mfis.links().len() + 1);
}

#[test]
fn an_event_line_begins_with_its_step_and_kind() {
    let session = drive(&["perceptual"]);
    let text = events(&session, 0);
    assert_eq!(text.lines().count(), session.journal().mappers[0].events.len());
    for line in text.lines() {
        assert!(line.starts_with("{\"step\":") && line.contains(",\"kind\":\""), "{line}");
        serde_json::from_str::<Value>(line).unwrap();
    }
    assert!(text.contains("\"kind\":\"placed\"") && text.contains("\"kind\":\"collision\""), "{text}");
}

#[test]
fn the_report_counts_and_names_every_parameter() {
    let session = drive(&["perceptual"]);
    let report: Value = serde_json::from_str(&report(&session, Extras::default())).unwrap();
    let journal = &session.journal().mappers[0];
    assert_eq!(report["mappers"][0]["views"], journal.reports.len());
    assert_eq!(report["mappers"][0]["surfaces"], session.mappers()[0].mfis().surfaces().len());
    assert_eq!(report["run"]["scans"], session.journal().odometry.len());
    assert_eq!(report["mappers"][0]["asrs"], 1);
    assert_eq!(
        (&report["mappers"][0]["exits"], &report["mappers"][0]["loops_closed"]),
        (&0.into(), &0.into())
    );
    assert!(report["run"]["collisions"].as_u64().unwrap() > 0);
    assert!(report["run"]["path_length"].as_f64().unwrap() > 2.0);
    assert_eq!(report["source"]["robot"]["laser"]["beams"], 361);
    assert!(report["mappers"][0]["parameters"]["matching"].is_object());
    assert_eq!(report["program"]["version"], env!("CARGO_PKG_VERSION"));
}

#[test]
fn trajectories_have_a_row_a_scan_and_end_where_the_robot_stopped() {
    let session = drive(&["perceptual"]);
    let files = files(&session, Extras::default());
    let truth = tum::read(file(&files, "truth.tum"), "truth.tum").unwrap();
    let last = truth.last().unwrap();
    assert!((last.t - session.time()).abs() < 1e-9);
    assert!(last.pose.position.distance(session.world_from_robot().unwrap().position) < 1e-9);
    assert!(truth.len() - session.journal().truth.len() <= 1);
    for name in ["odometry.tum", "estimate.tum"] {
        let rows = tum::read(file(&files, name), name).unwrap();
        assert!(rows.iter().map(|row| row.t).eq(truth.iter().map(|row| row.t)), "{name}");
    }
}
