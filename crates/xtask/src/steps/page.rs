use crate::failure::Failure;
use crate::page;
use crate::project::Project;
use crate::serve::{Site, address, listen};
use crate::setup::{Browser, Need, npm_run};

pub(super) const IN_BROWSER: [Need; 2] = [Need::NodePackages, Need::Browser];

pub(super) fn check(project: &Project) -> Result<(), Failure> {
    page::build_wasm(project)?;
    npm_run("check").run()
}

/// Runs the Playwright tests on the page as `demo` serves it, headers and all.
pub(super) fn test(project: &Project) -> Result<(), Failure> {
    let browser = Browser::provide()?;
    let site = Site::open(&project.dist()).map_err(|failure| {
        Failure::new(format!("{failure}\nBuild the page first: cargo xtask demo --build-only"))
    })?;
    let listener = listen(0)?;
    let address = address(&listener)?;
    std::thread::spawn(move || site.serve(listener));
    npm_run("test:browser").variable("CHROMIUM_PATH", browser.chrome).variable("COGMAP_URL", address).run()
}
