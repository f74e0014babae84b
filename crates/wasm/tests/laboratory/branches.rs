use cogmap_wasm::Laboratory;
use js_sys::Reflect;
use wasm_bindgen::JsValue;
use wasm_bindgen_test::wasm_bindgen_test;

use super::{CELL, begin, keeping::taken_up, number, open, same_bytes::SAME_SESSION, ts, until_idle};

/// A laboratory whose robot has been told to turn and to drive ahead.
fn driven() -> Laboratory {
    let mut laboratory = begin(CELL, "good").ok().unwrap();
    laboratory.take_over();
    until_idle(&mut laboratory);
    nudge(&mut laboratory, 0, 1);
    nudge(&mut laboratory, 1, 0);
    laboratory
}

/// Tells the robot something, whatever it does, and lets it finish.
fn nudge(laboratory: &mut Laboratory, ahead: i8, left: i8) {
    laboratory.order(&ts(&format!(r#"{{"kind":"nudge","ahead":{ahead},"left":{left}}}"#))).ok().unwrap();
    until_idle(laboratory);
}

/// What the timeline marks, each as its kind and its position.
pub(super) fn marks(laboratory: &mut Laboratory) -> Vec<(JsValue, JsValue)> {
    let of = |mark: &JsValue, key: &str| Reflect::get(mark, &key.into()).unwrap();
    let marks = laboratory.landmarks().ok().unwrap().into_iter().map(JsValue::from);
    marks.map(|mark| (of(&of(&mark, "what"), "kind"), of(&mark, "position"))).collect()
}

#[wasm_bindgen_test]
fn what_was_told_is_undone_and_done_again_to_the_last_bit() {
    let mut laboratory = driven();
    let (session, map) = (laboratory.save_session(), laboratory.map_json(0));
    assert!(laboratory.undo());
    assert_ne!(laboratory.save_session(), session);
    assert!(laboratory.redo());
    assert_eq!(laboratory.save_session(), session);
    assert_eq!(laboratory.map_json(0), map);
    assert!(!laboratory.redo());
}

#[wasm_bindgen_test]
fn the_other_branch_is_gone_over_to_and_kept_as_it_is() {
    let mut laboratory = driven();
    let old = laboratory.save_session();
    laboratory.jump(number(&laboratory, "end") / 2.0);
    nudge(&mut laboratory, 0, -1);
    let new = laboratory.save_session();
    assert_eq!(number(&laboratory, "branches"), 1.0);
    for course in [&old, &new] {
        laboratory.switch_branch();
        assert_eq!(&laboratory.save_session(), course);
        assert!(laboratory.situation().len() > 100);
        assert_eq!(number(&laboratory, "branches"), 1.0);
    }
}

#[wasm_bindgen_test]
fn marks_that_lie_ahead_are_kept_when_the_run_goes_back_or_is_taken_up_there() {
    let mut laboratory = open("same-bytes.session.json", SAME_SESSION.as_bytes(), None).ok().unwrap();
    laboratory.jump(f64::INFINITY);
    let all = marks(&mut laboratory);
    assert!(!all.is_empty());
    laboratory.jump(1.0);
    assert_eq!(marks(&mut laboratory), all);
    let mut again = taken_up(&laboratory.situation(), None).ok().unwrap();
    assert_eq!(number(&again, "position"), 1.0);
    assert_eq!(marks(&mut again), all);
    assert!(!again.undo(), "a run that is taken up begins anew with what can be undone");
}
