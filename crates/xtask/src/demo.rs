use crate::arguments::DemoOptions;
use crate::failure::Failure;
use crate::page;
use crate::project::Project;
use crate::serve::{Site, address, listen};
use crate::setup;

/// Builds the page and, unless that was all, serves it until the program is stopped.
pub(crate) fn run(project: &Project, options: &DemoOptions) -> Result<(), Failure> {
    if options.build_only {
        build(project)?;
        println!("\nThe page is in web/dist");
        return Ok(());
    }
    // Taken before the build: a port that is in use shows at once.
    let listener = listen(options.port)?;
    let site = build(project)?;
    println!("\nCogmap is at {} (Ctrl-C stops it)", address(&listener)?);
    site.serve(listener)
}

fn build(project: &Project) -> Result<Site, Failure> {
    setup::provide(project, &page::BUILD_NEEDS)?;
    page::build(project)?;
    Site::open(&project.dist())
}
