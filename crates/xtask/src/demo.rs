use crate::arguments::DemoOptions;
use crate::failure::Failure;
use crate::page;
use crate::port;
use crate::project::Project;
use crate::setup;

/// Builds the page and, unless that was all, serves it until the program is stopped.
pub(crate) fn run(project: &Project, options: &DemoOptions) -> Result<(), Failure> {
    if options.build_only {
        build(project)?;
        println!("\nThe page is in web/dist");
        return Ok(());
    }
    // Looked for before the build: a port that is in use shows at once.
    port::free(options.port)?;
    build(project)?;
    println!("\nOpen the address below in a browser (Ctrl-C stops serving it)");
    page::serve(port::free(options.port)?)
}

fn build(project: &Project) -> Result<(), Failure> {
    setup::provide(project, &page::BUILD_NEEDS)?;
    page::build(project)
}
