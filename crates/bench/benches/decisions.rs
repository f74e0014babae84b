//! How long the recommended strategy thinks: the mean and the slowest of all decisions on many ways home, in
//! generated buildings and in the largest designed one. Words after `--` choose the rows whose names hold one of them.

use std::path::Path;

use cogmap_bench::thinking::{Thinking, in_a_designed_building, on_a_generated_floor};
use cogmap_simulation::{Session, Setting};

/// The designed building of 120 m round.
const LARGE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../worlds/environment-a.world.json");
/// So much of its round is driven before the robot is told to go home.
const SHARES: [f64; 3] = [0.4, 0.6, 0.75];
/// The generated floors, and the ways through the large building.
const FLOORS: std::ops::RangeInclusive<u64> = 1..=25;
const WAYS: std::ops::RangeInclusive<u64> = 1..=5;

fn main() -> Result<(), String> {
    // `cargo test --benches` starts this too; timing is not a test.
    if !std::env::args().any(|argument| argument == "--bench") {
        return Ok(());
    }
    println!(
        "{:<24}{:>10}{:>12}{:>9}{:>12}",
        "ms for a decision", "ways home", "decisions", "mean", "slowest"
    );
    let mut all = Thinking::default();
    let words: Vec<String> = std::env::args().skip(1).filter(|word| !word.starts_with('-')).collect();
    let wanted = |name: &str| words.is_empty() || words.iter().any(|word| name.contains(word));
    for setting in Setting::ALL.into_iter().filter(|setting| wanted(setting.name())) {
        let starts: Vec<_> = FLOORS.filter_map(|seed| on_a_generated_floor(setting, seed)).collect();
        all.add(print(setting.name(), &starts));
    }
    for share in SHARES {
        let name = format!("environment A, {:.0} %", 100.0 * share);
        if wanted(&name) {
            let starts = WAYS.map(|seed| in_a_designed_building(Path::new(LARGE), share, seed));
            all.add(print(&name, &starts.collect::<Result<Vec<_>, _>>()?));
        }
    }
    println!(
        "a decision takes {:.2} ms in the mean (at most 5), {:.1} at worst (at most 50)",
        all.mean(),
        all.slowest
    );
    Ok(())
}

/// Prints how long decisions of ways home of one kind take together.
fn print(name: &str, starts: &[Session]) -> Thinking {
    let all = Thinking::of(starts);
    println!("{name:<24}{:>10}{:>12}{:>9.2}{:>12.1}", starts.len(), all.decisions, all.mean(), all.slowest);
    all
}
