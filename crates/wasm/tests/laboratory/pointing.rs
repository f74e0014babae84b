use cogmap_wasm::Laboratory;
use js_sys::{Array, Reflect};
use wasm_bindgen::{JsCast, JsValue};
use wasm_bindgen_test::wasm_bindgen_test;

use super::{CELL, begin, surfaces, ts, until_idle};

fn of(object: &JsValue, path: &str) -> JsValue {
    path.split('.').fold(object.clone(), |object, key| Reflect::get(&object, &key.into()).unwrap())
}

fn number(object: &JsValue, path: &str) -> f64 {
    of(object, path).as_f64().unwrap()
}

/// A laboratory whose robot has driven its route, with its memory 600 pixels wide and 500 high.
fn driven() -> Laboratory {
    let mut laboratory = begin(CELL, "good").ok().unwrap();
    until_idle(&mut laboratory);
    laboratory.resize(&ts("\"first\""), 600.0, 500.0).ok().unwrap();
    laboratory
}

/// What is told about a thing that is set off in the first memory.
fn told(laboratory: &mut Laboratory, thing: &str) -> Option<JsValue> {
    laboratory.set_off(&ts("\"first\""), Some(ts(thing))).ok().unwrap();
    laboratory.told().ok().unwrap().map(JsValue::from)
}

fn picked(laboratory: &Laboratory, view: &str, [x, y]: [f64; 2], reach: f64) -> Option<String> {
    let picked: JsValue = laboratory.pick(&ts(view), x, y, reach).ok().unwrap()?.into();
    Some(format!("{} {}", of(&picked, "kind").as_string().unwrap(), number(&picked, "number")))
}

#[wasm_bindgen_test]
fn what_is_told_of_a_surface_lies_where_it_is_picked_within_reach_and_no_farther() {
    let mut laboratory = driven();
    let story = told(&mut laboratory, r#"{"kind":"surface","number":0}"#).unwrap();
    let at = [number(&story, "x"), number(&story, "y")];
    assert_eq!(picked(&laboratory, "\"first\"", at, 5.0), Some("surface 0".to_owned()));
    assert!(number(&story, "facts.length") > 0.0);
    let outside = [2.0, 2.0];
    assert_eq!(picked(&laboratory, "\"first\"", outside, 5.0), None);
    assert!(picked(&laboratory, "\"first\"", outside, 1e4).is_some());
    assert_eq!(picked(&laboratory, "\"world\"", at, 5.0), None);
    assert_eq!(picked(&laboratory, "\"first\"", [f64::NAN; 2], 5.0), None);
}

#[wasm_bindgen_test]
fn a_thing_stays_where_it_is_drawn_when_the_memory_is_looked_at_from_elsewhere() {
    let mut laboratory = driven();
    let layers = |stance: &str| {
        format!(
            r#"{{"colours":"view","exits":true,"network":false,"truth":false,"fit":"first_view","homing":true,"stance":"{stance}"}}"#
        )
    };
    let mut places = Vec::new();
    for stance in ["map", "robot"] {
        laboratory.show(&ts(&layers(stance))).ok().unwrap();
        let story = told(&mut laboratory, r#"{"kind":"surface","number":0}"#).unwrap();
        places.push([number(&story, "x"), number(&story, "y")]);
        assert_eq!(
            picked(&laboratory, "\"first\"", places[places.len() - 1], 5.0),
            Some("surface 0".to_owned())
        );
    }
    assert_ne!(places[0], places[1]);
}

#[wasm_bindgen_test]
fn setting_the_same_thing_off_again_changes_nothing_and_what_is_not_there_has_no_story() {
    let mut laboratory = driven();
    let mut set_off = |thing: Option<&str>| laboratory.set_off(&ts("\"first\""), thing.map(ts)).ok().unwrap();
    let surface = r#"{"kind":"surface","number":1}"#;
    assert!(set_off(Some(surface)));
    assert!(!set_off(Some(surface)));
    assert!(set_off(None));
    assert!(laboratory.told().ok().unwrap().is_none());
    assert!(told(&mut laboratory, r#"{"kind":"exit","number":9}"#).is_none());
    assert!(laboratory.set_off(&ts("\"first\""), Some(ts(r#"{"kind":"wall","number":1}"#))).is_err());
}

#[wasm_bindgen_test]
fn the_contents_count_what_the_status_counts() {
    let laboratory = driven();
    let contents: JsValue = laboratory.contents(&ts("\"first\""), 3).ok().unwrap().unwrap().into();
    assert_eq!(number(&contents, "surfaces"), surfaces(&laboratory));
    let places: Array = of(&contents, "places").unchecked_into();
    assert_eq!(of(&places.get(0), "nearest").unchecked_into::<Array>().length(), 3);
    assert!(laboratory.contents(&ts("\"second\""), 3).ok().unwrap().is_none());
}
