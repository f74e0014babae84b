//! One table: microseconds for a step, natively and as wasm in Node.

mod native;
mod table;
mod wasm;

use std::path::Path;

use cogmap_steps_bench::{SIZES, TASKS};

/// A recorded log from outside this project.
const LOG: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../../../../shared/data/logs/intel.log.gz");
/// Each task is run so often; the best round counts, for what else the machine does only adds.
const ROUNDS: usize = 5;

/// What a task gave.
struct Outcome {
    steps: usize,
    /// Microseconds for a step.
    micros: f64,
    /// Where it led, to compare platforms bit for bit.
    sum: f64,
}

fn main() {
    // `cargo test --benches` starts this too; timing is not a test.
    if !std::env::args().any(|argument| argument == "--bench") {
        return;
    }
    let log = Some(Path::new(LOG)).filter(|log| log.is_file());
    if log.is_none() {
        println!("the log is missing, so the mappers are not timed on it: {LOG}");
    }
    let first = if log.is_some() { 0 } else { TASKS.len() - SIZES.len() };
    let tasks: Vec<usize> = (first..TASKS.len()).collect();
    let native = native::run(&tasks, log);
    let wasm = wasm::run(&tasks, log);
    table::print(&tasks, &native, &wasm);
}
