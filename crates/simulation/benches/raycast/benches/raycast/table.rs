use cogmap_raycast_bench::{METHODS, POSES, RANGE_MAX, SIZES};

use crate::{Outcome, Trial};

/// Prints the table, the ratios and how ours grows with the office.
pub(crate) fn print(trials: &[Trial], native: &[Outcome], wasm: &Result<Vec<Outcome>, String>) {
    println!(
        "\nA scan of 361 beams over 180°, {RANGE_MAX} m, µs: mean of {POSES} poses, each batch's best round"
    );
    println!("{:>9} │ {:>46} │ {:>46}", "", "native", "wasm, simd128, Node");
    let heading = format!("{:>8} {:>8} {:>9} {:>8} {:>9}", "ours", "parry", "brute", "parry÷", "brute÷");
    println!("{:>9} │ {heading} │ {heading}", "segments");
    let wasm_outcomes = wasm.as_deref().unwrap_or_default();
    for (size, row) in native.chunks(METHODS.len()).enumerate() {
        let other = wasm_outcomes.chunks(METHODS.len()).nth(size).map_or(String::new(), cells);
        println!("{:>9} │ {} │ {other}", row[0].segments, cells(row));
    }
    print_growth("native", native);
    match wasm {
        Ok(wasm) => {
            print_growth("wasm", wasm);
            let ours = || trials.iter().zip(native.iter().zip(wasm)).filter(|(trial, _)| trial.method == 0);
            let same = ours().all(|(_, (native, wasm))| native.sum.to_bits() == wasm.sum.to_bits());
            println!(
                "native and wasm ranges of ours are {}",
                if same { "the same bits" } else { "NOT the same bits" }
            );
        }
        Err(missing) => println!("wasm was not timed: {missing}"),
    }
}

fn cells(row: &[Outcome]) -> String {
    let [ours, parry, brute] = [0, 1, 2].map(|method| row[method].micros);
    let (by_parry, by_brute) = (parry / ours, brute / ours);
    format!("{ours:>8.2} {parry:>8.1} {brute:>9.1} {by_parry:>7.1}× {by_brute:>8.1}×")
}

fn print_growth(platform: &str, outcomes: &[Outcome]) {
    let ours = |size: usize| outcomes[size * METHODS.len()].micros;
    let growth = ours(SIZES.len() - 1) / ours(0);
    let least =
        outcomes.chunks(METHODS.len()).map(|row| row[1].micros / row[0].micros).fold(f64::INFINITY, f64::min);
    println!(
        "{platform}: at least {least:.1}× faster than parry (wanted 8); largest office {growth:.2}× slower than smallest (at most 2)"
    );
}
