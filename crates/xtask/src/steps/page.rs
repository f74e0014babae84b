use crate::failure::Failure;
use crate::page;
use crate::project::{Project, cargo};
use crate::serve::{Site, address, listen};
use crate::setup::{Browser, Need, npm_run};

pub(super) const IN_BROWSER: [Need; 2] = [Need::NodePackages, Need::Browser];

pub(super) fn check(project: &Project) -> Result<(), Failure> {
    page::build_wasm(project)?;
    npm_run("check").run()
}

/// Runs the Playwright tests on the page as `demo` serves it, headers and all; what they save is
/// replayed with the command line.
pub(super) fn test(project: &Project) -> Result<(), Failure> {
    let browser = Browser::provide()?;
    let site = Site::open(&project.dist()).map_err(|failure| {
        Failure::new(format!("{failure}\nBuild the page first: cargo xtask demo --build-only"))
    })?;
    cargo("build -p cogmap").run()?;
    let command = format!("debug/cogmap{}", std::env::consts::EXE_SUFFIX);
    let listener = listen(0)?;
    let address = address(&listener)?;
    std::thread::spawn(move || site.serve(listener));
    npm_run("test:browser")
        .variable("CHROMIUM_PATH", browser.chrome)
        .variable("COGMAP_BIN", project.target.join(command))
        .variable("COGMAP_URL", address)
        .run()
}
