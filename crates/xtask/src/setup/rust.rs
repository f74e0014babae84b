use std::path::Path;

use super::installing;
use crate::failure::Failure;
use crate::job::Job;
use crate::project::cargo;

const WASM_TARGET: &str = "wasm32-unknown-unknown";

/// Sees to rustfmt and clippy.
pub(super) fn provide_components() -> Result<(), Failure> {
    let answers = |words| cargo(words).output().is_some();
    if answers("fmt --version") && answers("clippy --version") {
        return Ok(());
    }
    installing("rustfmt and clippy", || rustup("component add rustfmt clippy"))
}

/// Sees to the standard library for wasm.
pub(super) fn provide_wasm_target() -> Result<(), Failure> {
    let sysroot = Job::new("rustc").words("--print sysroot").output();
    let library = |root: &str| {
        let targets = Path::new(root.trim()).join("lib/rustlib");
        targets.join(WASM_TARGET).join("lib").is_dir()
    };
    if sysroot.is_some_and(|root| library(&root)) {
        return Ok(());
    }
    installing(&format!("the Rust target {WASM_TARGET}"), || rustup(&format!("target add {WASM_TARGET}")))
}

fn rustup(words: &str) -> Result<(), Failure> {
    let rustup = Job::new("rustup");
    if rustup.clone().words("--version").output().is_none() {
        return Err(Failure::new(format!(
            "the Rust toolchain lacks a part, and there is no rustup to run `rustup {words}`: \
             install rustup, or that part with the package manager that Rust came from"
        )));
    }
    rustup.words(words).run()
}
