use crate::failure::Failure;
use crate::page;
use crate::port;
use crate::project::{Project, cargo};
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
    if !project.dist().join("index.html").is_file() {
        return Err(Failure::new("web/dist holds no page: build it first, cargo xtask demo --build-only"));
    }
    cargo("build -p cogmap").run()?;
    let command = format!("debug/cogmap{}", std::env::consts::EXE_SUFFIX);
    npm_run("test:browser")
        .variable("CHROMIUM_PATH", browser.chrome)
        .variable("COGMAP_BIN", project.target.join(command))
        .variable("COGMAP_PORT", port::free(0)?.to_string())
        .variable("COGMAP_URL", "")
        .run()
}
