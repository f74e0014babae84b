//! What the steps need, found where it is and installed where it is not.

mod browser;
mod node;
mod rust;
mod tools;

use std::time::Instant;

use crate::failure::Failure;
use crate::project::Project;

pub(crate) use browser::Browser;
pub(crate) use node::npm_run;
pub(crate) use tools::{wasm_bindgen, wasm_pack};

/// Something that must be installed before a step can run.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Need {
    /// rustfmt and clippy.
    RustComponents,
    /// Rust's standard library for `wasm32-unknown-unknown`.
    WasmTarget,
    /// The `wasm-bindgen` command and its test runner, of the version that `Cargo.lock` pins.
    WasmBindgen,
    /// The `wasm-pack` command.
    WasmPack,
    /// The page's npm packages.
    NodePackages,
    /// Chromium or Chrome, and the driver of the same version.
    Browser,
}

/// Installs whatever is missing; says nothing about what is there.
pub(crate) fn provide(project: &Project, needs: &[Need]) -> Result<(), Failure> {
    for need in needs {
        match need {
            Need::RustComponents => rust::provide_components()?,
            Need::WasmTarget => rust::provide_wasm_target()?,
            Need::WasmBindgen => drop(wasm_bindgen(project)?),
            Need::WasmPack => drop(wasm_pack(project)?),
            Need::NodePackages => node::provide_packages(project)?,
            Need::Browser => drop(Browser::provide()?),
        }
    }
    Ok(())
}

/// Announces an installation and the time it took.
fn installing(what: &str, install: impl FnOnce() -> Result<(), Failure>) -> Result<(), Failure> {
    println!("\n━━ set-up: installing {what}");
    let start = Instant::now();
    install()?;
    println!("   installed {what} in {:.1} s", start.elapsed().as_secs_f64());
    Ok(())
}
