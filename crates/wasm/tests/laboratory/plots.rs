use cogmap_wasm::Laboratory;
use js_sys::{Array, Float64Array, Reflect};
use wasm_bindgen::{JsCast, JsValue};
use wasm_bindgen_test::wasm_bindgen_test;

use super::{CELL, begin, log, number, open, remembered, surfaces, ts, until_idle};

/// The first mapper's curve.
fn curve(laboratory: &mut Laboratory) -> JsValue {
    let plots: JsValue = laboratory.plots().ok().unwrap().into();
    let curves: Array = of(&plots, "curves").unchecked_into();
    curves.get(0)
}

fn of(object: &JsValue, key: &str) -> JsValue {
    Reflect::get(object, &key.into()).unwrap()
}

fn numbers(object: &JsValue, key: &str) -> Vec<f64> {
    of(object, key).dyn_into::<Float64Array>().unwrap().to_vec()
}

#[wasm_bindgen_test]
fn curves_cross_as_typed_arrays_with_a_value_for_each_view() {
    let mut laboratory = begin(CELL, "good").ok().unwrap();
    until_idle(&mut laboratory);
    let curve = curve(&mut laboratory);
    let views = remembered(&laboratory, "views").as_f64().unwrap();
    for values in [numbers(&curve, "times"), numbers(&curve, "positions"), numbers(&curve, "surfaces")] {
        assert_eq!(values.len() as f64, views);
    }
    assert_eq!(numbers(&curve, "surfaces").last(), Some(&surfaces(&laboratory)));
    assert_eq!(numbers(&of(&curve, "off"), "metres").len() as f64, views);
    assert!(!numbers(&of(&curve, "wideness"), "metres").is_empty());
}

#[wasm_bindgen_test]
fn a_position_of_a_curve_is_the_moment_of_its_view() {
    let mut laboratory = begin(CELL, "good").ok().unwrap();
    until_idle(&mut laboratory);
    let curve = curve(&mut laboratory);
    for (view, position) in numbers(&curve, "positions").into_iter().enumerate() {
        laboratory.jump(position);
        assert_eq!(number(&laboratory, "position"), position);
        assert_eq!(remembered(&laboratory, "views").as_f64(), Some((view + 1) as f64));
        assert_eq!(surfaces(&laboratory), numbers(&curve, "surfaces")[view]);
    }
}

#[wasm_bindgen_test]
fn a_log_has_no_errors_to_plot_and_its_positions_are_its_readings() {
    let mut laboratory = open("room.log", log(12).as_bytes(), None).ok().unwrap();
    until_idle(&mut laboratory);
    let curve = curve(&mut laboratory);
    assert!(of(&curve, "off").is_undefined());
    let positions = numbers(&curve, "positions");
    assert!(positions.is_sorted() && positions.len() > 2, "{positions:?}");
    laboratory.jump(positions[1]);
    assert_eq!(remembered(&laboratory, "views").as_f64(), Some(2.0));
}

#[wasm_bindgen_test]
fn only_a_memory_with_places_has_a_schematic() {
    let laboratory = begin(CELL, "good").ok().unwrap();
    let schematic: JsValue = laboratory.schematic(&ts("\"first\"")).ok().unwrap().unwrap().into();
    assert_eq!(of(&schematic, "places").unchecked_into::<Array>().length(), 1);
    for view in ["\"world\"", "\"second\""] {
        assert!(laboratory.schematic(&ts(view)).ok().unwrap().is_none());
    }
}
