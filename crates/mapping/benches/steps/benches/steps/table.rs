use cogmap_steps_bench::{SIZES, TASKS};

use crate::Outcome;

/// Prints the table, the ratios, and how a step grows with the map.
pub(crate) fn print(tasks: &[usize], native: &[Outcome], wasm: &Result<Vec<Outcome>, String>) {
    println!("\nA step, µs: mean over a run, best round");
    println!("{:<26}{:>8}{:>11}{:>11}{:>8}", "", "steps", "native", "wasm", "wasm÷");
    for (row, (&task, own)) in tasks.iter().zip(native).enumerate() {
        let other = wasm.as_ref().ok().and_then(|wasm| wasm.get(row));
        let cells = other.map_or(String::new(), |other| {
            format!("{:>11.1}{:>7.2}×", other.micros, other.micros / own.micros)
        });
        println!("{:<26}{:>8}{:>11.1}{cells}", TASKS[task], own.steps, own.micros);
    }
    print_growth("native", native);
    match wasm {
        Ok(wasm) => {
            print_growth("wasm", wasm);
            let same = native.iter().zip(wasm).all(|(own, other)| own.sum.to_bits() == other.sum.to_bits());
            println!("native and wasm end with {}", if same { "the same bits" } else { "DIFFERENT bits" });
        }
        Err(missing) => println!("wasm was not timed: {missing}"),
    }
}

fn print_growth(platform: &str, outcomes: &[Outcome]) {
    let Some(grown) = outcomes.len().checked_sub(SIZES.len()).map(|first| &outcomes[first..]) else { return };
    println!(
        "{platform}: a step with 100,000 surfaces takes {:.2} times as long as with 1,000 (at most 2)",
        grown[3].micros / grown[1].micros
    );
}
