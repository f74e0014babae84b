#[path = "../../../../tests/tests/same_bytes/first_steps.rs"]
mod first_steps;
#[path = "../../../../tests/tests/same_bytes/ways_home.rs"]
mod ways_home;

use sha2::{Digest, Sha256};
use wasm_bindgen_test::wasm_bindgen_test;

use super::open;

pub(super) const SAME_SESSION: &str = include_str!("../../../../tests/goldens/same-bytes.session.json");
const SAME_BYTES: &str = include_str!("../../../../tests/goldens/same-bytes.txt");
const SAME_WORLDS: &str = include_str!("../../../../tests/goldens/same-bytes-worlds.txt");
const SAME_HOMING: &str = include_str!("../../../../tests/goldens/same-bytes-homing.txt");

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
