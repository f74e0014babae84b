use cogmap_wasm::Laboratory;
use js_sys::{Array, JSON, Reflect};
use wasm_bindgen::{JsCast, JsValue};
use wasm_bindgen_test::wasm_bindgen_test;

use super::{
    begin, branches::marks, keeping::taken_up_in, log, number, open, remembered, surfaces, told, ts,
    until_idle,
};

/// Two rooms with a door and a gap between them, and a route from the one to the other.
const ROOMS: &str = r#"{
    "format": "cogmap-world/1", "name": "Rooms",
    "walls": [[[0,0],[8,0],[8,5],[0,5],[0,0]], [[4,0],[4,1]], [[4,2],[4,3.5]], [[4,4.5],[4,5]]],
    "doors": [{"name": "south", "hinge": [4,2], "latch": [4,1], "open": true}],
    "start": {"position": [1,1.5]},
    "routes": {"through": [[6.5,1.5]]},
    "rooms": [{"name": "West", "outline": [[0,0],[4,0],[4,5],[0,5]]},
        {"name": "East", "outline": [[4,0],[8,0],[8,5],[4,5]]}]
}"#;

/// A laboratory whose robot waits in the first room.
fn rooms() -> Laboratory {
    let mut laboratory = begin(ROOMS, "good").ok().unwrap();
    laboratory.take_over();
    until_idle(&mut laboratory);
    laboratory
}

/// Changes something; what is answered says why not.
fn alter(laboratory: &mut Laboratory, alteration: &str) -> Option<String> {
    let objection: JsValue = laboratory.alter(&ts(alteration)).ok().unwrap()?.into();
    Reflect::get(&objection, &"kind".into()).unwrap().as_string()
}

/// Clicks with a tool at a pixel of the view of the world.
fn click(laboratory: &mut Laboratory, tool: &str, [x, y]: [f64; 2]) -> Option<String> {
    alter(laboratory, &format!(r#"{{"kind":"at","tool":"{tool}","x":{x},"y":{y}}}"#))
}

/// What the session holds under a key of its latest command.
fn latest(laboratory: &Laboratory, key: &str) -> JsValue {
    let session = JSON::parse(&laboratory.save_session()).unwrap();
    let source = Reflect::get(&session, &"source".into()).unwrap();
    let commands: Array = Reflect::get(&source, &"commands".into()).unwrap().unchecked_into();
    Reflect::get(&commands.at(-1), &key.into()).unwrap()
}

/// How many boxes stand in the building.
fn boxes(laboratory: &Laboratory) -> JsValue {
    Reflect::get(&told(laboratory, "building"), &"boxes".into()).unwrap()
}

/// Where a point of the world is seen, found out by two boxes that are dropped and taken back.
fn pixel(laboratory: &mut Laboratory, [x, y]: [f64; 2]) -> [f64; 2] {
    laboratory.resize(&ts(r#""world""#), 1000.0, 1000.0).ok().unwrap();
    let mut seen = |pixel: f64| {
        assert_eq!(click(laboratory, "drop", [pixel; 2]), None);
        let center: Array = latest(laboratory, "center").unchecked_into();
        assert!(laboratory.undo());
        [0, 1].map(|axis| center.get(axis).as_f64().unwrap())
    };
    let (low, high) = (seen(10.0), seen(990.0));
    let along = |axis: usize, metres: f64| 10.0 + 980.0 * (metres - low[axis]) / (high[axis] - low[axis]);
    [along(0, x), along(1, y)]
}

#[wasm_bindgen_test]
fn a_box_that_is_dropped_is_seen_by_the_laser_and_undone() {
    let (mut laboratory, mut without) = (rooms(), rooms());
    let session = laboratory.save_session();
    let there = pixel(&mut laboratory, [2.0, 2.6]);
    assert_eq!(click(&mut laboratory, "drop", there), None);
    for laboratory in [&mut laboratory, &mut without] {
        laboratory.order(&ts(r#"{"kind":"nudge","ahead":0,"left":1}"#)).ok().unwrap();
        until_idle(laboratory);
    }
    assert!(surfaces(&laboratory) > surfaces(&without));
    assert!(laboratory.undo() && laboratory.undo());
    assert_eq!(laboratory.save_session(), session);
    assert!(laboratory.redo());
    assert_eq!(boxes(&laboratory), 1.0);
    assert_eq!(click(&mut laboratory, "remove", there), None);
    assert_eq!(boxes(&laboratory), 0.0);
    assert_eq!(click(&mut laboratory, "remove", there).as_deref(), Some("no_box"));
    assert_eq!(alter(&mut laboratory, r#"{"kind":"remove_nearest"}"#).as_deref(), Some("no_box"));
}

#[wasm_bindgen_test]
fn what_cannot_be_is_answered_and_changes_nothing() {
    let mut laboratory = rooms();
    let (session, undoable) = (laboratory.save_session(), number(&laboratory, "undoable"));
    let robot = pixel(&mut laboratory, [1.0, 1.5]);
    let wall = pixel(&mut laboratory, [4.0, 0.5]);
    for (tool, place, objection) in [
        ("drop", robot, "drop"),
        ("carry", wall, "carry"),
        ("door", robot, "no_door"),
        ("remove", wall, "no_box"),
    ] {
        assert_eq!(click(&mut laboratory, tool, place).as_deref(), Some(objection));
        assert!(click(&mut laboratory, tool, [1e300; 2]).is_some());
    }
    assert_eq!(alter(&mut laboratory, r#"{"kind":"door","name":"north"}"#).as_deref(), Some("no_door"));
    assert_eq!(alter(&mut laboratory, r#"{"kind":"carry_to","room":7}"#).as_deref(), Some("no_place"));
    assert_eq!(laboratory.save_session(), session);
    assert_eq!(number(&laboratory, "undoable"), undoable);
    assert!(laboratory.alter(&ts(r#"{"kind":"burn"}"#)).is_err());
}

#[wasm_bindgen_test]
fn the_robot_is_carried_off_and_does_not_notice() {
    let mut laboratory = rooms();
    let there = pixel(&mut laboratory, [6.0, 3.0]);
    assert_eq!(click(&mut laboratory, "carry", there), None);
    let pose: Array = told(&laboratory, "pose").unchecked_into();
    assert!((pose.get(0).as_f64().unwrap() - 6.0).abs() < 0.02);
    let way = number(&laboratory, "travelled");
    laboratory.order(&ts(r#"{"kind":"nudge","ahead":0,"left":1}"#)).ok().unwrap();
    until_idle(&mut laboratory);
    assert!(number(&laboratory, "travelled") < way + 0.2, "it was not driven there");
    let off = Reflect::get(&remembered(&laboratory, "off"), &"distance".into()).unwrap();
    assert!(off.as_f64().unwrap() > 4.0);
    assert_eq!(alter(&mut laboratory, r#"{"kind":"carry_to","room":0}"#), None);
    let pose: Array = told(&laboratory, "pose").unchecked_into();
    assert!(pose.get(0).as_f64().unwrap() < 4.0);
    let kinds = marks(&mut laboratory).into_iter().filter_map(|(kind, _)| kind.as_string());
    assert_eq!(kinds.filter(|kind| kind == "kidnapped").count(), 2);
}

#[wasm_bindgen_test]
fn a_route_goes_round_a_door_that_is_shut_also_when_the_run_is_taken_up_again() {
    let mut laboratory = begin(ROOMS, "good").ok().unwrap();
    laboratory.advance_to_next_view();
    assert_eq!(alter(&mut laboratory, r#"{"kind":"door","name":"south"}"#), None);
    assert_eq!(told(&laboratory, "on_route"), JsValue::TRUE);
    let mut again = taken_up_in(ROOMS, &laboratory.situation(), None).ok().unwrap();
    assert_eq!(told(&again, "on_route"), JsValue::TRUE);
    for laboratory in [&mut laboratory, &mut again] {
        until_idle(laboratory);
        assert_eq!(number(laboratory, "collisions"), 0.0);
        let pose: Array = told(laboratory, "pose").unchecked_into();
        assert!(pose.get(0).as_f64().unwrap() > 6.0, "the other way leads there as well");
    }
    assert_eq!(again.save_session(), laboratory.save_session());
    assert_eq!(again.map_json(0), laboratory.map_json(0));
}

#[wasm_bindgen_test]
fn a_change_at_an_earlier_moment_makes_a_branch() {
    let mut laboratory = begin(ROOMS, "good").ok().unwrap();
    until_idle(&mut laboratory);
    let old = laboratory.save_session();
    laboratory.jump(number(&laboratory, "end") / 2.0);
    assert_eq!(alter(&mut laboratory, r#"{"kind":"drop_ahead"}"#), None);
    assert_eq!(number(&laboratory, "branches"), 1.0);
    assert_eq!(told(&laboratory, "on_route"), JsValue::FALSE);
    laboratory.switch_branch();
    assert_eq!(laboratory.save_session(), old);
}

#[wasm_bindgen_test]
fn a_change_while_a_person_steers_is_a_deed_of_its_own() {
    let mut laboratory = rooms();
    let steer = |laboratory: &mut Laboratory, order: &str| {
        laboratory.order(&ts(order)).ok().unwrap();
        for _ in 0..20 {
            laboratory.advance();
        }
    };
    let before = number(&laboratory, "undoable");
    steer(&mut laboratory, r#"{"kind":"steer","ahead":0.2,"left":0}"#);
    assert_eq!(alter(&mut laboratory, r#"{"kind":"door","name":"south"}"#), None);
    steer(&mut laboratory, r#"{"kind":"stop"}"#);
    assert_eq!(number(&laboratory, "undoable"), before + 2.0);
    assert!(laboratory.undo());
    assert_eq!(latest(&laboratory, "do"), JsValue::from("drive"));
}

#[wasm_bindgen_test]
fn a_log_has_no_building_to_change() {
    let mut laboratory = open("ahead.log", log(5).as_bytes(), None).ok().unwrap();
    assert!(told(&laboratory, "building").is_undefined());
    for tool in ["door", "drop", "remove", "carry"] {
        assert_eq!(click(&mut laboratory, tool, [10.0; 2]).as_deref(), Some("no_building"));
    }
}
