use std::path::{Path, PathBuf};

use crate::failure::Failure;
use crate::job::Job;
use crate::project::{Project, cargo, write};
use crate::setup::{Need, npm_run, wasm_bindgen};

/// What building the page needs.
pub(crate) const BUILD_NEEDS: [Need; 3] = [Need::WasmTarget, Need::WasmBindgen, Need::NodePackages];

/// The WebAssembly features that rustc emits here; the optimiser must know and keep them.
const FEATURES: &str = "--enable-simd --enable-bulk-memory --enable-nontrapping-float-to-int \
    --enable-sign-ext --enable-mutable-globals --enable-reference-types --enable-multivalue";

/// Faster and with names, by which the engine is parted; a function that is called once is not swallowed by its
/// caller, which may belong into the other part.
const OPTIMISE: &str = "-O3 --one-caller-inline-max-function-size 60 --debuginfo";

/// Builds the page into `web/dist`.
pub(crate) fn build(project: &Project) -> Result<(), Failure> {
    build_wasm(project)?;
    npm_run("build").run()
}

/// Serves the built page on this machine alone, headers and all, in place of this program.
pub(crate) fn serve(port: u16) -> Result<(), Failure> {
    Job::new("node")
        .words("web/node_modules/vite/bin/vite.js preview web --host 127.0.0.1 --strictPort --port")
        .argument(port.to_string())
        .run_instead()
}

/// Builds the engine in its two parts and its TypeScript face into `web/src/wasm`.
pub(crate) fn build_wasm(project: &Project) -> Result<(), Failure> {
    cargo("build --profile page --target wasm32-unknown-unknown -p cogmap-wasm").run()?;
    let compiled = project.target.join("wasm32-unknown-unknown/page/cogmap_wasm.wasm");
    let out = project.web().join("src/wasm");
    let stamp = out.join(".built-from");
    let origin = origin(project, &compiled)?;
    if std::fs::read_to_string(&stamp).is_ok_and(|built| built == origin) {
        return Ok(());
    }
    generate(project, &compiled, &out)?;
    optimise(project, &out)?;
    npm_run("split").run()?;
    write(&stamp, &origin)
}

/// What the generated files depend on, in a form that changes when any of it does.
fn origin(project: &Project, compiled: &Path) -> Result<String, Failure> {
    let changed = std::fs::metadata(compiled).and_then(|metadata| metadata.modified());
    let changed = changed.map_err(|error| Failure::file(compiled, &error))?;
    let version = project.locked_version("wasm-bindgen")?;
    let first = project.web().join("engine/first.txt");
    let first = std::fs::read_to_string(&first).map_err(|error| Failure::file(&first, &error))?;
    Ok(format!("{version} {OPTIMISE} {FEATURES} {changed:?} {} {first}", compiled.display()))
}

fn generate(project: &Project, compiled: &Path, out: &Path) -> Result<(), Failure> {
    if out.exists() {
        std::fs::remove_dir_all(out).map_err(|error| Failure::file(out, &error))?;
    }
    let bindings = Job::new(wasm_bindgen(project)?).words("--target bundler --out-dir").argument(out);
    bindings.argument(compiled).run()?;
    // The page instantiates the engine by itself, in two parts.
    write(&out.join("cogmap_wasm.js"), "export * from './cogmap_wasm_bg.js';\n")
}

fn optimise(project: &Project, out: &Path) -> Result<(), Failure> {
    let module = out.join("cogmap_wasm_bg.wasm");
    Job::new(package_command(project, "wasm-opt"))
        .words(OPTIMISE)
        .words(FEATURES)
        .argument(&module)
        .argument("-o")
        .argument(out.join("engine.wasm"))
        .run()
}

/// A command that one of the page's npm packages brings.
fn package_command(project: &Project, name: &str) -> PathBuf {
    let suffix = if cfg!(windows) { ".cmd" } else { "" };
    let commands = project.web().join("node_modules/.bin");
    commands.join(format!("{name}{suffix}"))
}
