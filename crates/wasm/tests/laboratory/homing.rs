use js_sys::JSON;
use wasm_bindgen::JsValue;
use wasm_bindgen_test::wasm_bindgen_test;

use super::{going_home, message, of_homing, open, told, ts, until_idle};

#[wasm_bindgen_test]
fn a_robot_that_is_told_to_go_home_goes_there_and_says_why() {
    let mut laboratory = going_home("recommended");
    while of_homing(&laboratory, "why").is_falsy() {
        assert!(laboratory.advance());
    }
    assert_eq!(of_homing(&laboratory, "lead"), JsValue::from("planning"));
    assert_eq!(of_homing(&laboratory, "by"), JsValue::from("perceptual"));
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
        assert_eq!(written(&of_homing(&opened, key)), written(&of_homing(&laboratory, key)), "{key}");
    }
}

fn written(value: &JsValue) -> String {
    String::from(JSON::stringify(value).unwrap())
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
    assert!(told(&laboratory, "led").is_undefined());
    laboratory.order(&ts(r#"{"kind":"nudge","ahead":0,"left":1}"#)).ok().unwrap();
    until_idle(&mut laboratory);
    assert!(told(&laboratory, "homing").is_undefined());
    assert!(!told(&laboratory, "led").is_undefined());
    laboratory.order(&ts(r#"{"kind":"go_home","strategy":"retrace"}"#)).ok().unwrap();
    until_idle(&mut laboratory);
    assert_eq!(of_homing(&laboratory, "ended"), JsValue::from("home"));
    assert!(message(laboratory.order(&ts(r#"{"kind":"go_home","strategy":"fly"}"#))).contains("oracle"));
}
