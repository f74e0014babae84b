//! The laboratory as the page uses it.

#[path = "../../../../tests/tests/same_bytes/first_steps.rs"]
mod first_steps;
#[path = "../../../../tests/tests/same_bytes/ways_home.rs"]
mod ways_home;

use cogmap_wasm::Laboratory;
use js_sys::{Error, JSON, Object, Reflect};
use sha2::{Digest, Sha256};
use tsify::{Ts, Tsify};
use wasm_bindgen::{JsCast, JsError, JsValue};
use wasm_bindgen_test::wasm_bindgen_test;

/// A room with a route through it.
const CELL: &str = r#"{
    "format": "cogmap-world/1", "name": "Cell",
    "walls": [[[0,0],[5,0],[5,4],[0,4],[0,0]]],
    "start": {"position": [1,2]},
    "routes": {"tour": [[2,2],[3.5,2.5]]}
}"#;

const SAME_SESSION: &str = include_str!("../../../../tests/goldens/same-bytes.session.json");
const SAME_BYTES: &str = include_str!("../../../../tests/goldens/same-bytes.txt");
const SAME_WORLDS: &str = include_str!("../../../../tests/goldens/same-bytes-worlds.txt");
const SAME_HOMING: &str = include_str!("../../../../tests/goldens/same-bytes-homing.txt");

fn ts<T: Tsify>(json: &str) -> Ts<T> {
    Ts::new_unchecked(JSON::parse(json).unwrap())
}

fn begin(world: &str, robot: &str) -> Result<Laboratory, JsError> {
    let setup =
        format!(r#"{{"file":"cell.world.json","robot":"{robot}","mappers":["perceptual"],"seed":1}}"#);
    let setup = JSON::parse(&setup).unwrap();
    Reflect::set(&setup, &"world".into(), &world.into()).unwrap();
    Laboratory::new(&Ts::new_unchecked(setup))
}

fn open(name: &str, bytes: &[u8], other: Option<Vec<u8>>) -> Result<Laboratory, JsError> {
    let opening = format!(r#"{{"name":"{name}","robot":"bad","mappers":["perceptual"],"seed":1}}"#);
    Laboratory::open(&ts(&opening), bytes, other)
}

/// What the status says under a key of the first memory.
fn remembered(laboratory: &Laboratory, key: &str) -> JsValue {
    let memories: js_sys::Array = told(laboratory, "memories").unchecked_into();
    Reflect::get(&memories.get(0), &key.into()).unwrap()
}

fn surfaces(laboratory: &Laboratory) -> f64 {
    remembered(laboratory, "surfaces").as_f64().unwrap()
}

/// What the status says under a key.
fn told(laboratory: &Laboratory, key: &str) -> JsValue {
    let status: JsValue = laboratory.status().ok().unwrap().into();
    Reflect::get(&status, &key.into()).unwrap()
}

fn number(laboratory: &Laboratory, key: &str) -> f64 {
    told(laboratory, key).as_f64().unwrap()
}

fn message<T>(result: Result<T, JsError>) -> String {
    let Err(error) = result else { panic!("an error was to be expected") };
    String::from(JsValue::from(error).unchecked_into::<Error>().message())
}

fn until_idle(laboratory: &mut Laboratory) {
    for _ in 0..100_000 {
        if !laboratory.advance() {
            return;
        }
    }
    panic!("the run never ends");
}

/// A log of a robot that drives straight ahead between two walls.
fn log(scans: usize) -> String {
    let scan = |number: usize| {
        let x = number as f64 * 0.2;
        let ranges = (0..180).map(|beam| {
            let bearing = (f64::from(beam) - 89.5).to_radians();
            let (sin, cos) = cogmap_geometry::trig::sin_cos(bearing);
            format!("{:.3}", (2.0 / sin.abs()).min((9.0 - x) / cos))
        });
        let ranges: Vec<_> = ranges.collect();
        format!("FLASER 180 {} {x} 0 0 {x} 0 0 {number} robot {number}\n", ranges.join(" "))
    };
    (0..scans).map(scan).collect()
}

#[wasm_bindgen_test]
fn a_run_follows_its_route_and_then_waits() {
    let mut laboratory = begin(CELL, "bad").ok().unwrap();
    assert!(!laboratory.idle());
    until_idle(&mut laboratory);
    assert!(laboratory.idle());
    assert!(surfaces(&laboratory) >= 3.0);
    assert_eq!(remembered(&laboratory, "asrs"), JsValue::from(1));
    assert!(number(&laboratory, "travelled") > 2.0);
    assert_eq!(told(&laboratory, "source"), JsValue::from("world"));
}

#[wasm_bindgen_test]
fn an_order_ends_the_route_and_is_obeyed() {
    let mut laboratory = begin(CELL, "perfect").ok().unwrap();
    laboratory.order(&ts(r#"{"kind":"nudge","ahead":0,"left":1}"#)).ok().unwrap();
    assert_eq!(told(&laboratory, "on_route"), JsValue::FALSE);
    until_idle(&mut laboratory);
    let way = number(&laboratory, "travelled");
    assert!(way < 0.1, "turning is not travelling: {way}");
    assert!(number(&laboratory, "time") > 0.0);
    assert!(message(laboratory.order(&ts(r#"{"kind":"fly"}"#))).contains("fly"));
}

/// What the status says about the way home under a key.
fn of_homing(laboratory: &Laboratory, key: &str) -> JsValue {
    let homing = told(laboratory, "homing");
    if homing.is_undefined() { homing } else { Reflect::get(&homing, &key.into()).unwrap() }
}

/// A laboratory whose robot has driven its route and is told to go home.
fn going_home(strategy: &str) -> Laboratory {
    let mut laboratory = begin(CELL, "good").ok().unwrap();
    until_idle(&mut laboratory);
    assert!(told(&laboratory, "homing").is_undefined());
    laboratory.order(&ts(&format!(r#"{{"kind":"go_home","strategy":"{strategy}"}}"#))).ok().unwrap();
    assert!(!laboratory.idle());
    laboratory
}

#[wasm_bindgen_test]
fn a_robot_that_is_told_to_go_home_goes_there_and_says_why() {
    let mut laboratory = going_home("recommended");
    while of_homing(&laboratory, "why").is_falsy() {
        assert!(laboratory.advance());
    }
    assert_eq!(of_homing(&laboratory, "lead"), JsValue::from("planning"));
    assert!(of_homing(&laboratory, "ended").is_undefined());
    until_idle(&mut laboratory);
    assert_eq!(of_homing(&laboratory, "ended"), JsValue::from("home"));
    assert!(of_homing(&laboratory, "distance").as_f64().unwrap() < 0.7);
    assert!(of_homing(&laboratory, "believed").as_f64().unwrap() <= 0.35);
}

#[wasm_bindgen_test]
fn a_way_home_replays_to_the_same_end() {
    let mut laboratory = going_home("faithful");
    until_idle(&mut laboratory);
    let mut opened = open("cell.session.json", laboratory.save_session().as_bytes(), None).ok().unwrap();
    until_idle(&mut opened);
    assert_eq!(opened.map_json(0), laboratory.map_json(0));
    for key in ["ended", "why", "decisions", "believed", "distance"] {
        assert!(!of_homing(&laboratory, key).is_undefined(), "{key}");
        assert_eq!(of_homing(&opened, key), of_homing(&laboratory, key), "{key}");
    }
}

#[wasm_bindgen_test]
fn a_way_home_can_be_stopped_and_begun_again() {
    let mut laboratory = going_home("retrace");
    for _ in 0..100 {
        laboratory.advance();
    }
    laboratory.order(&ts(r#"{"kind":"stop"}"#)).ok().unwrap();
    until_idle(&mut laboratory);
    assert_eq!(of_homing(&laboratory, "ended"), JsValue::from("stopped"));
    laboratory.order(&ts(r#"{"kind":"nudge","ahead":0,"left":1}"#)).ok().unwrap();
    until_idle(&mut laboratory);
    assert!(told(&laboratory, "homing").is_undefined());
    laboratory.order(&ts(r#"{"kind":"go_home","strategy":"retrace"}"#)).ok().unwrap();
    until_idle(&mut laboratory);
    assert_eq!(of_homing(&laboratory, "ended"), JsValue::from("home"));
    assert!(message(laboratory.order(&ts(r#"{"kind":"go_home","strategy":"fly"}"#))).contains("oracle"));
}

#[wasm_bindgen_test]
fn going_back_and_on_again_changes_nothing() {
    let mut laboratory = begin(CELL, "bad").ok().unwrap();
    until_idle(&mut laboratory);
    let (end, map) = (number(&laboratory, "end"), laboratory.map_json(0));
    laboratory.jump(end / 2.0);
    assert_ne!(laboratory.map_json(0), map);
    laboratory.jump(end);
    assert_eq!(laboratory.map_json(0), map);
}

#[wasm_bindgen_test]
fn a_saved_session_opens_to_the_same_map() {
    let mut laboratory = begin(CELL, "bad").ok().unwrap();
    until_idle(&mut laboratory);
    let mut opened = open("cell.session.json", laboratory.save_session().as_bytes(), None).ok().unwrap();
    until_idle(&mut opened);
    assert_eq!(opened.map_json(0), laboratory.map_json(0));
    assert_eq!(opened.save_session(), laboratory.save_session());
}

/// The run taken up again from what was kept of it.
fn taken_up(situation: &str, log: Option<Vec<u8>>) -> Result<Laboratory, JsError> {
    let kept = Object::new();
    let known = JSON::parse(r#"[{"file":"cell","text":""}]"#).unwrap();
    Reflect::set(&known.clone().unchecked_into::<js_sys::Array>().get(0), &"text".into(), &CELL.into())
        .unwrap();
    for (key, value) in [("name", "it".into()), ("situation", situation.into()), ("buildings", known)] {
        Reflect::set(&kept, &key.into(), &value).unwrap();
    }
    let mut laboratory = Laboratory::resume(&Ts::new_unchecked(kept.into()), log)?;
    while laboratory.resume_turn() {}
    Ok(laboratory)
}

/// All that can be told of a run.
fn everything(laboratory: &Laboratory) -> [String; 3] {
    let status: JsValue = laboratory.status().ok().unwrap().into();
    let status = String::from(JSON::stringify(&status).unwrap());
    [laboratory.save_session(), laboratory.map_json(0), status]
}

#[wasm_bindgen_test]
fn a_run_is_taken_up_where_it_was_left_and_its_route_goes_on() {
    let mut laboratory = begin(CELL, "bad").ok().unwrap();
    laboratory.advance_to_next_view();
    for _ in 0..25 {
        laboratory.advance();
    }
    let mut again = taken_up(&laboratory.situation(), None).ok().unwrap();
    assert_eq!(everything(&again), everything(&laboratory));
    assert_eq!(again.building().as_deref(), Some("cell"));
    assert_eq!(told(&again, "on_route"), JsValue::TRUE);
    until_idle(&mut again);
    until_idle(&mut laboratory);
    assert_eq!(everything(&again), everything(&laboratory));
}

#[wasm_bindgen_test]
fn an_order_that_no_tick_has_seen_is_kept_as_well() {
    let mut laboratory = going_home("recommended");
    let mut again = taken_up(&laboratory.situation(), None).ok().unwrap();
    assert!(!again.idle());
    until_idle(&mut again);
    until_idle(&mut laboratory);
    assert_eq!(of_homing(&again, "ended"), JsValue::from("home"));
    assert_eq!(everything(&again), everything(&laboratory));
}

#[wasm_bindgen_test]
fn the_moment_that_is_shown_is_kept_as_well() {
    let mut laboratory = begin(CELL, "good").ok().unwrap();
    laboratory.advance_to_next_view();
    laboratory.jump(10.0);
    let again = taken_up(&laboratory.situation(), None).ok().unwrap();
    assert_eq!(number(&again, "position"), 10.0);
    assert_eq!(everything(&again), everything(&laboratory));
}

#[wasm_bindgen_test]
fn a_log_is_taken_up_where_it_was_left() {
    let log = log(10);
    let mut laboratory = open("ahead.log", log.as_bytes(), None).ok().unwrap();
    for _ in 0..4 {
        laboratory.advance();
    }
    let situation = laboratory.situation();
    assert!(message(taken_up(&situation, None)).contains("ahead.log"));
    let mut again = taken_up(&situation, Some(log.into_bytes())).ok().unwrap();
    assert_eq!(again.map_json(0), laboratory.map_json(0));
    until_idle(&mut again);
    assert_eq!(number(&again, "position"), 10.0);
}

#[wasm_bindgen_test]
fn other_mappers_are_shown_the_same_drive() {
    let mut laboratory = begin(CELL, "bad").ok().unwrap();
    laboratory.advance_to_next_view();
    let (position, map) = (number(&laboratory, "position"), laboratory.map_json(0));
    laboratory.remap(vec!["consensus".to_owned(), "perceptual".to_owned()]).ok().unwrap();
    assert_eq!(number(&laboratory, "position"), position);
    assert_eq!(laboratory.map_json(1), map);
    assert_eq!(told(&laboratory, "on_route"), JsValue::TRUE);
    let consensus = ["consensus".to_owned(), "consensus".to_owned()];
    assert!(message(laboratory.remap(consensus.to_vec())).contains("twice"));
    assert!(message(laboratory.remap(vec!["guess".to_owned()])).contains("transform"));
    assert!(laboratory.remap(Vec::new()).is_err());
}

#[wasm_bindgen_test]
fn a_log_is_mapped_and_mapped_again() {
    let log = log(30);
    let mut laboratory = open("ahead.log", log.as_bytes(), None).ok().unwrap();
    assert_eq!(told(&laboratory, "source"), JsValue::from("log"));
    assert_eq!(number(&laboratory, "end"), 30.0);
    until_idle(&mut laboratory);
    assert!(surfaces(&laboratory) >= 2.0);
    laboratory.remap(vec!["odometry".to_owned()]).ok().unwrap();
    assert_eq!(number(&laboratory, "position"), 0.0);
    until_idle(&mut laboratory);
    assert_eq!(remembered(&laboratory, "mapper"), JsValue::from("odometry"));
    let session = laboratory.save_session();
    assert!(message(open("s.json", session.as_bytes(), None)).contains("ahead.log"));
    assert!(open("s.json", session.as_bytes(), Some(log.into_bytes())).is_ok());
}

#[wasm_bindgen_test]
fn what_cannot_be_opened_gets_an_answer() {
    for (name, content, answer) in [
        ("cut.json", r#"{"format":"cogmap-session/1","#, "cut.json"),
        ("hut.json", r#"{"format":"cogmap-world/1","name":"Hut"}"#, "start"),
        ("empty.log", "# nothing\n", "empty.log"),
        ("nothing", "", "nothing"),
    ] {
        let told = message(open(name, content.as_bytes(), None));
        assert!(told.contains(answer), "{name}: {told}");
    }
    assert!(message(begin(CELL, "lazy")).contains("perfect"));
    assert!(message(begin("[]", "bad")).contains("cell.world.json"));
}

#[wasm_bindgen_test]
fn a_page_can_look_anywhere() {
    let mut laboratory = begin(CELL, "bad").ok().unwrap();
    laboratory.resize(&ts(r#""world""#), 640.0, 480.0).ok().unwrap();
    laboratory.resize(&ts(r#""fourth""#), f64::NAN, -3.0).ok().unwrap();
    laboratory.drag(f64::INFINITY, 3.0);
    laboratory.zoom(0.0, &ts(r#""world""#), None, None).ok().unwrap();
    laboratory.zoom(1e300, &ts(r#""first""#), Some(1.0), Some(f64::NAN)).ok().unwrap();
    laboratory.fit();
    laboratory.close(&ts(r#""fourth""#)).ok().unwrap();
    laboratory
        .show(&ts(r#"{"colours":"asr","exits":true,"network":true,"truth":true,"homing":false}"#))
        .ok()
        .unwrap();
    assert!(laboratory.reach(320.0, 100.0));
    assert!(!laboratory.reach(f64::NAN, 100.0));
    laboratory.jump(-1.0);
    laboratory.jump(f64::INFINITY);
}

#[wasm_bindgen_test]
fn one_session_gives_the_same_bytes_everywhere() {
    let mut laboratory = open("same-bytes.session.json", SAME_SESSION.as_bytes(), None).ok().unwrap();
    laboratory.jump(f64::INFINITY);
    assert!(SAME_BYTES.lines().count() >= 4, "one line a mapper");
    for (mapper, known) in SAME_BYTES.lines().enumerate() {
        let digest = Sha256::digest(laboratory.map_json(mapper).as_bytes());
        let digest: String = digest.iter().map(|byte| format!("{byte:02x}")).collect();
        assert_eq!(digest, known, "mapper {mapper}");
    }
}

#[wasm_bindgen_test]
fn every_mapper_gives_the_same_bytes_everywhere_in_every_designed_world() {
    let mut known = SAME_WORLDS.lines();
    for (name, file) in first_steps::WORLDS {
        for line in first_steps::digests(name, file).lines() {
            assert_eq!(Some(line), known.next());
        }
    }
    assert_eq!(known.next(), None);
}

#[wasm_bindgen_test]
fn every_strategy_goes_the_same_way_home_everywhere() {
    let mut known = SAME_HOMING.lines();
    for (name, file) in ways_home::WORLDS {
        for line in ways_home::digests(name, file).lines() {
            assert_eq!(Some(line), known.next());
        }
    }
    assert_eq!(known.next(), None);
}

#[wasm_bindgen_test]
fn a_building_is_made_from_a_number_and_its_robot_stands_where_the_status_says() {
    let mut laboratory = begin("generated:7", "bad").ok().unwrap();
    assert_eq!(told(&laboratory, "name"), JsValue::from("Office floor 7"));
    let pose = |laboratory: &Laboratory| told(laboratory, "pose").unchecked_into::<js_sys::Array>().join(" ");
    let before = pose(&laboratory);
    laboratory.advance_to_next_view();
    laboratory.advance_to_next_view();
    assert_ne!(pose(&laboratory), before);
    assert!(message(begin("generated:castle", "bad")).contains("castle"));
}
