//! One table: microseconds for a scan, three ways, natively and as wasm in Node.

mod native;
mod table;
mod wasm;

use cogmap_raycast_bench::{METHODS, POSES, SIZES};

/// A cell of the table still to be timed.
#[derive(Clone, Copy)]
struct Trial {
    /// Index into [`SIZES`].
    size: usize,
    /// Index into [`METHODS`].
    method: usize,
    /// Scans in a round.
    scans: usize,
    /// Rounds, the best of which counts: what else the machine does only adds.
    rounds: usize,
}

/// What a trial gave.
struct Outcome {
    /// How many segments the office really has.
    segments: usize,
    /// Microseconds for a scan in the best round.
    micros: f64,
    /// All ranges of a round added up, to compare platforms bit for bit.
    sum: f64,
}

fn main() {
    // `cargo test --benches` starts this too; timing is not a test.
    if !std::env::args().any(|argument| argument == "--bench") {
        return;
    }
    let trials = trials();
    let native = native::run(&trials);
    let wasm = wasm::run(&trials);
    table::print(&trials, &native, &wasm);
    native::print_differences();
}

fn trials() -> Vec<Trial> {
    let sizes = 0..SIZES.len();
    let each = |size| {
        (0..METHODS.len()).map(move |method| {
            let (scans, rounds) = [(POSES, 100), (POSES, 12), (POSES / 16, 4)][method];
            Trial { size, method, scans, rounds }
        })
    };
    sizes.flat_map(each).collect()
}
