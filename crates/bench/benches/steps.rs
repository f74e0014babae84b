//! Extraction and each mapper's step on a recorded log, and how a step of the recommended mapper grows with the
//! map: the log first, then maps of so many surfaces, then decisions on ways home.

use std::path::Path;

use cogmap_bench::{
    Task,
    race::{micros, race},
};

/// A recorded log from outside this project.
const LOG: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../../shared/data/logs/intel.log.gz");

fn main() {
    // `cargo test --benches` starts this too; timing is not a test.
    if !std::env::args().any(|argument| argument == "--bench") {
        return;
    }
    let log = Some(Path::new(LOG)).filter(|log| log.is_file());
    if log.is_none() {
        println!("the log is missing, so nothing is timed on it: {LOG}");
    }
    let outcomes = race(log, |task| match task {
        Task::Extraction | Task::Mapper(_) => log.is_some(),
        Task::Grown(_) | Task::WayHome(_) => true,
        Task::Cast(..) => false,
    });
    if let Some((native, wasm)) = micros(&outcomes, Task::Mapper("consensus")) {
        println!("consensus: {:.2} ms a reading of the log (at most 0.5)", native / 1e3);
        if let Some(wasm) = wasm {
            println!("consensus: as wasm {:.2} times that (at most 1.5)", wasm / native);
        }
    }
    if let Some((small, large)) =
        micros(&outcomes, Task::Grown(1_000)).zip(micros(&outcomes, Task::Grown(100_000)))
    {
        println!("a step with 100,000 surfaces: {:.2} times one with 1,000 (at most 2)", large.0 / small.0);
        if let Some((small, large)) = small.1.zip(large.1) {
            println!("as wasm: {:.2} times", large / small);
        }
    }
    for &setting in outcomes.iter().filter_map(|outcome| match &outcome.task {
        Task::WayHome(setting) => Some(setting),
        _ => None,
    }) {
        let Some((native, wasm)) = micros(&outcomes, Task::WayHome(setting)) else { continue };
        println!("a decision on the way home, {setting}: {:.2} ms in the mean (at most 5)", native / 1e3);
        if let Some(wasm) = wasm {
            println!("as wasm: {:.2} times that (at most 1.5)", wasm / native);
        }
    }
}
