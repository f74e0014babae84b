use js_sys::Reflect;
use wasm_bindgen::JsValue;
use wasm_bindgen_test::wasm_bindgen_test;

use super::{CELL, begin, log, message, number, open, remembered, surfaces, told, until_idle};

#[wasm_bindgen_test]
fn a_saved_session_opens_to_the_same_map() {
    let mut laboratory = begin(CELL, "bad").ok().unwrap();
    until_idle(&mut laboratory);
    let mut opened = open("cell.session.json", laboratory.save_session().as_bytes(), None).ok().unwrap();
    until_idle(&mut opened);
    assert_eq!(opened.map_json(0), laboratory.map_json(0));
    assert_eq!(opened.save_session(), laboratory.save_session());
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
fn every_file_of_a_run_can_be_taken_away_and_tells_of_the_same_run() {
    let mut laboratory = begin(CELL, "bad").ok().unwrap();
    until_idle(&mut laboratory);
    let rows = laboratory.table().lines().count() - 1;
    let files: Vec<JsValue> = laboratory.text_files().ok().unwrap().into_iter().map(JsValue::from).collect();
    let get = |file: &JsValue, key: &str| Reflect::get(file, &key.into()).unwrap().as_string().unwrap();
    let of = |name: &str| {
        files.iter().find(|file| get(file, "name") == name).map(|file| get(file, "text")).unwrap()
    };
    assert_eq!(of("truth.tum").lines().count(), rows);
    assert_eq!(of("map.json"), laboratory.map_json(0));
    assert_eq!(of("session.json"), laboratory.save_session());
    assert!(of("network.g2o").contains("VERTEX_SE2"));
}
