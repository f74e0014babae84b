use cogmap_wasm::Laboratory;
use js_sys::{Array, JSON, Object, Reflect};
use tsify::Ts;
use wasm_bindgen::{JsCast, JsError, JsValue};
use wasm_bindgen_test::wasm_bindgen_test;

use super::{CELL, begin, going_home, log, message, number, of_homing, open, told, until_idle};

/// The run taken up again from what was kept of it.
pub(super) fn taken_up(situation: &str, log: Option<Vec<u8>>) -> Result<Laboratory, JsError> {
    taken_up_in(CELL, situation, log)
}

/// The same in a building that is not the usual one.
pub(super) fn taken_up_in(world: &str, situation: &str, log: Option<Vec<u8>>) -> Result<Laboratory, JsError> {
    let kept = Object::new();
    let known = JSON::parse(r#"[{"file":"cell","text":""}]"#).unwrap();
    Reflect::set(&known.clone().unchecked_into::<Array>().get(0), &"text".into(), &world.into()).unwrap();
    for (key, value) in [("name", "it".into()), ("situation", situation.into()), ("buildings", known)] {
        Reflect::set(&kept, &key.into(), &value).unwrap();
    }
    let mut laboratory = Laboratory::resume(&Ts::new_unchecked(kept.into()), log)?;
    while laboratory.resume_turn() {}
    Ok(laboratory)
}

/// All that can be told of a run, but for what can be undone: a run that is taken up begins anew with that.
fn everything(laboratory: &Laboratory) -> [String; 3] {
    let status: JsValue = laboratory.status().ok().unwrap().into();
    Reflect::delete_property::<Object>(status.unchecked_ref(), &"undoable".into()).unwrap();
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
