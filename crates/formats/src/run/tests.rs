use cogmap_mapping::MapperSetup;
use cogmap_simulation::{Command, Robot, Source};
use serde_json::Value;

use super::*;

fn drive(mappers: &[&str]) -> Session {
    let text = r#"{ "format": "cogmap-world/1", "name": "Cell",
        "walls": [[[0,0],[6,0],[6,5],[0,5],[0,0]]],
        "boxes": [{"center": [4,4], "size": [0.8,0.5], "heading_deg": 20}],
        "start": {"position": [1,2]} }"#;
    let world = crate::world::read(text, "cell.world.json").unwrap();
    let mappers = mappers.iter().map(|name| MapperSetup::named(name).unwrap()).collect();
    let source = Source::world(world, Robot::named("bad").unwrap());
    let mut session = Session::drive(SessionRecord::new(source, mappers, 7)).unwrap();
    for turn in [0.4, -0.3, 0.2] {
        session.command(Command::Step { turn, travel: 0.7 });
        while session.advance() && !session.at_rest() {}
    }
    session.command(Command::Step { turn: 0.0, travel: 5.0 });
    while session.advance() && !session.at_rest() {}
    session
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
    assert!(map["surfaces"][0]["true_wall"].is_u64() && map["surfaces"][0]["asr"].is_null());
    assert_eq!(map["path"].as_array().unwrap().len(), mapper.path().len());
    assert!(map["path"][0]["heading"].is_number());
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
