//! One table: microseconds for a scan, three ways, natively and as wasm in Node.

mod native;
mod table;
mod wasm;

use cogmap_raycast_bench::{BATCH, METHODS, POSES, SIZES};

/// A cell of the table still to be timed.
#[derive(Clone, Copy)]
struct Trial {
    /// Index into [`SIZES`].
    size: usize,
    /// Index into [`METHODS`].
    method: usize,
    /// Batches of scans in a round.
    batches: usize,
    /// Rounds; each batch's best one counts, for what else the machine does only
    /// adds.
    rounds: usize,
}

/// What a trial gave.
struct Outcome {
    /// How many segments the office really has.
    segments: usize,
    /// Microseconds for a scan.
    micros: f64,
    /// All ranges added up, to compare platforms bit for bit.
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
            let (batches, rounds) = [(POSES / BATCH, 800), (POSES / BATCH, 40), (1, 4)][method];
            Trial { size, method, batches, rounds }
        })
    };
    sizes.flat_map(each).collect()
}
