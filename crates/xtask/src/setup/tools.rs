use std::path::{Path, PathBuf};

use super::installing;
use crate::failure::Failure;
use crate::job::Job;
use crate::project::{Project, cargo};

const WASM_PACK_VERSION: &str = "0.15.1";

/// The `wasm-bindgen` command that fits the crate of that name in `Cargo.lock`.
pub(crate) fn wasm_bindgen(project: &Project) -> Result<PathBuf, Failure> {
    let version = project.locked_version("wasm-bindgen")?;
    provide(project, "wasm-bindgen", "wasm-bindgen-cli", &version)
}

/// The `wasm-pack` command.
pub(crate) fn wasm_pack(project: &Project) -> Result<PathBuf, Failure> {
    provide(project, "wasm-pack", "wasm-pack", WASM_PACK_VERSION)
}

/// The command of exactly this version: the project's own, the user's, or else installed now.
fn provide(project: &Project, command: &str, package: &str, version: &str) -> Result<PathBuf, Failure> {
    let file = format!("{command}{}", std::env::consts::EXE_SUFFIX);
    let own = project.tools().join("bin").join(&file);
    if is_version(&own, version) {
        return Ok(own);
    }
    if let Some(found) = on_path(&file).filter(|found| is_version(found, version)) {
        return Ok(found);
    }
    installing(&format!("{package} {version}"), || install(project, package, version))?;
    if is_version(&own, version) {
        return Ok(own);
    }
    Err(Failure::new(format!("{} is not version {version}, although it was just installed", own.display())))
}

/// Compiles a tool from crates.io into the target directory. Its own release profile (link-time
/// optimisation and all) would take twice as long and make no difference to minutes of work.
fn install(project: &Project, package: &str, version: &str) -> Result<(), Failure> {
    println!("   it is compiled from crates.io, which takes a minute or more");
    let build = project.tools().join("build");
    cargo("install --locked --quiet")
        .words(&format!("{package} --version {version}"))
        .argument("--root")
        .argument(project.tools())
        .argument("--target-dir")
        .argument(&build)
        .variable("CARGO_PROFILE_RELEASE_OPT_LEVEL", "1")
        .variable("CARGO_PROFILE_RELEASE_LTO", "off")
        .variable("CARGO_PROFILE_RELEASE_CODEGEN_UNITS", "16")
        .run()?;
    std::fs::remove_dir_all(&build).map_err(|error| Failure::file(&build, &error))
}

/// Whether `COMMAND --version` answers with its name and this version.
fn is_version(command: &Path, version: &str) -> bool {
    let answer = Job::new(command).words("--version").output();
    answer.is_some_and(|answer| answer.split_whitespace().nth(1) == Some(version))
}

/// The first file of this name in the directories of `PATH`.
pub(super) fn on_path(file: &str) -> Option<PathBuf> {
    let path = std::env::var_os("PATH")?;
    std::env::split_paths(&path).map(|folder| folder.join(file)).find(|candidate| candidate.is_file())
}
