//! The laboratory as the page uses it.

mod branches;
mod changing;
mod driving;
mod files;
mod homing;
mod keeping;
mod plots;
mod pointing;
mod same_bytes;

use cogmap_wasm::Laboratory;
use js_sys::{Error, JSON, Reflect};
use tsify::{Ts, Tsify};
use wasm_bindgen::{JsCast, JsError, JsValue};

/// A room with a route through it.
const CELL: &str = r#"{
    "format": "cogmap-world/1", "name": "Cell",
    "walls": [[[0,0],[5,0],[5,4],[0,4],[0,0]]],
    "start": {"position": [1,2]},
    "routes": {"tour": [[2,2],[3.5,2.5]]}
}"#;

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
