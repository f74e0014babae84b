use std::{
    path::{Path, PathBuf},
    process::Command,
};

use crate::{Outcome, ROUNDS};

const TARGET: &str = "wasm32-unknown-unknown";
const FOLDER: &str = env!("CARGO_MANIFEST_DIR");

/// Builds the same code for wasm with 128-bit SIMD and times the tasks in Node; otherwise what is
/// missing and how to get it.
pub(crate) fn run(tasks: &[usize], log: Option<&Path>) -> Result<Vec<Outcome>, String> {
    let module = build()?;
    let mut node = Command::new("node");
    node.arg(Path::new(FOLDER).join("node.mjs")).arg(module).arg(log.unwrap_or(Path::new("-")));
    node.args(tasks.iter().map(|task| format!("{task}:{ROUNDS}")));
    let output =
        node.output().map_err(|why| format!("node does not start ({why}): install Node 20 or newer"))?;
    let text = String::from_utf8_lossy(&output.stdout);
    let outcomes: Option<Vec<_>> = text.lines().map(outcome).collect();
    outcomes.filter(|outcomes| outcomes.len() == tasks.len()).ok_or_else(|| {
        let trouble = String::from_utf8_lossy(&output.stderr);
        format!("the wasm module failed in Node:\n{trouble}")
    })
}

fn outcome(line: &str) -> Option<Outcome> {
    let mut words = line.split(' ');
    let steps = words.next()?.parse().ok()?;
    let micros = words.next()?.parse().ok()?;
    let sum = words.next()?.parse().ok()?;
    Some(Outcome { steps, micros, sum })
}

fn build() -> Result<PathBuf, String> {
    let folder = target_folder().ok_or("this bench was not started from a target folder")?;
    let cargo = std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
    let mut build = Command::new(cargo);
    build.current_dir(FOLDER).args(["build", "--release", "--lib", "--target", TARGET]).arg("--target-dir");
    build.arg(&folder).env_remove("RUSTFLAGS").env_remove("CARGO_ENCODED_RUSTFLAGS");
    build.env("CARGO_TARGET_WASM32_UNKNOWN_UNKNOWN_RUSTFLAGS", "-C target-feature=+simd128");
    match build.status() {
        Ok(status) if status.success() => {
            Ok(folder.join(TARGET).join("release").join("cogmap_steps_bench.wasm"))
        }
        Ok(_) => Err(format!(
            "the build for {TARGET} failed; if the target is missing: rustup target add {TARGET}"
        )),
        Err(why) => Err(format!("cargo does not start: {why}")),
    }
}

/// `TARGET` of `TARGET/release/deps/steps-0123456789abcdef`.
fn target_folder() -> Option<PathBuf> {
    Some(std::env::current_exe().ok()?.ancestors().nth(3)?.to_path_buf())
}
