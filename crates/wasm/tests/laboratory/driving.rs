use cogmap_wasm::Laboratory;
use js_sys::Array;
use wasm_bindgen::{JsCast, JsValue};
use wasm_bindgen_test::wasm_bindgen_test;

use super::{CELL, begin, message, number, remembered, surfaces, told, ts, until_idle};

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
fn a_page_can_look_anywhere() {
    let mut laboratory = begin(CELL, "bad").ok().unwrap();
    laboratory.resize(&ts(r#""world""#), 640.0, 480.0).ok().unwrap();
    laboratory.resize(&ts(r#""fourth""#), f64::NAN, -3.0).ok().unwrap();
    laboratory.drag(f64::INFINITY, 3.0, &ts(r#""first""#)).ok().unwrap();
    laboratory.zoom(0.0, &ts(r#""world""#), None, None).ok().unwrap();
    laboratory.zoom(1e300, &ts(r#""first""#), Some(1.0), Some(f64::NAN)).ok().unwrap();
    laboratory.fit();
    laboratory.close(&ts(r#""fourth""#)).ok().unwrap();
    let layers = r#"{"colours":"asr","exits":true,"network":true,"truth":true,"fit":"best_fit","homing":false,"stance":"robot"}"#;
    laboratory.show(&ts(layers)).ok().unwrap();
    assert!(laboratory.reach(320.0, 100.0));
    assert!(!laboratory.reach(f64::NAN, 100.0));
    laboratory.jump(-1.0);
    laboratory.jump(f64::INFINITY);
}

#[wasm_bindgen_test]
fn a_building_is_made_from_a_number_and_its_robot_stands_where_the_status_says() {
    let mut laboratory = begin("generated:7", "bad").ok().unwrap();
    assert_eq!(told(&laboratory, "name"), JsValue::from("Office floor 7"));
    let pose = |laboratory: &Laboratory| told(laboratory, "pose").unchecked_into::<Array>().join(" ");
    let before = pose(&laboratory);
    laboratory.advance_to_next_view();
    laboratory.advance_to_next_view();
    assert_ne!(pose(&laboratory), before);
    assert!(message(begin("generated:castle", "bad")).contains("castle"));
}
