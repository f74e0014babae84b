//! A scan of 361 beams over 180°, 30 m, three ways, in generated offices.

use cogmap_bench::{
    Task, differences,
    race::{Outcome, micros, race},
};

const SIZES: [usize; 3] = [200, 2_000, 20_000];

fn main() {
    // `cargo test --benches` starts this too; timing is not a test.
    if !std::env::args().any(|argument| argument == "--bench") {
        return;
    }
    let outcomes = race(None, |task| matches!(task, Task::Cast(..)));
    for (platform, wasm) in [("native", false), ("wasm", true)] {
        print_ratios(&outcomes, platform, wasm);
    }
    for size in SIZES {
        let (differ, beams) = differences(size);
        println!("ours and parry over 1 mm apart, {size} segments: {differ} of {beams} beams");
    }
}

fn print_ratios(outcomes: &[Outcome], platform: &str, wasm: bool) {
    let time = |size, method| {
        let (native, other) = micros(outcomes, Task::Cast(size, method))?;
        if wasm { other } else { Some(native) }
    };
    let faster = SIZES.map(|size| Some(time(size, 1)? / time(size, 0)?));
    let least = faster.into_iter().flatten().reduce(f64::min);
    let growth = time(SIZES[2], 0).zip(time(SIZES[0], 0)).map(|(large, small)| large / small);
    if let Some((least, growth)) = least.zip(growth) {
        println!(
            "{platform}: at least {least:.1}× faster than parry (wanted 8); largest office {growth:.2}× slower than smallest (at most 2)"
        );
    }
}
