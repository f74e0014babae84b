//! The checks that make up `cargo xtask test`, and running them.

mod page;
mod rust;
mod wasm;

use std::time::{Duration, Instant};

use crate::failure::Failure;
use crate::page::BUILD_NEEDS;
use crate::project::Project;
use crate::setup::{self, Need};

/// One check of the project.
struct Step {
    name: &'static str,
    title: &'static str,
    needs: &'static [Need],
    run: fn(&Project) -> Result<(), Failure>,
}

impl Step {
    const fn new(
        name: &'static str,
        title: &'static str,
        needs: &'static [Need],
        run: fn(&Project) -> Result<(), Failure>,
    ) -> Self {
        Self { name, title, needs, run }
    }
}

/// Every check, in the order in which they run: the quick ones first.
const STEPS: [Step; 10] = [
    Step::new("fmt", "formatting", &rust::LINTERS, rust::format),
    Step::new("clippy", "clippy for this machine", &rust::LINTERS, rust::clippy),
    Step::new("clippy-wasm", "clippy for wasm32", &wasm::LINTERS, wasm::clippy),
    Step::new("doc", "documentation", &[], rust::document),
    Step::new("rust", "Rust tests", &[], rust::test),
    Step::new("wasm-chrome", "wasm tests in a browser", &wasm::IN_CHROME, wasm::test_in_chrome),
    Step::new("wasm-node", "wasm tests in Node.js", &wasm::IN_NODE, wasm::test_in_node),
    Step::new("web-check", "types of the page", &BUILD_NEEDS, page::check),
    Step::new("web-build", "build of the page", &BUILD_NEEDS, crate::page::build),
    Step::new("browser", "the page in a browser", &page::IN_BROWSER, page::test),
];

/// Whether a step has this name.
pub(crate) fn exists(name: &str) -> bool {
    STEPS.iter().any(|step| step.name == name)
}

/// Prints the steps.
pub(crate) fn list() {
    for Step { name, title, .. } in &STEPS {
        println!("{name:<12} {title}");
    }
}

/// Runs the chosen steps, or all of them, up to the first that fails.
pub(crate) fn run(project: &Project, chosen: &[String]) -> Result<(), Failure> {
    let start = Instant::now();
    let is_chosen = |step: &&Step| chosen.is_empty() || chosen.iter().any(|it| it == step.name);
    let steps: Vec<_> = STEPS.iter().filter(is_chosen).collect();
    for step in &steps {
        setup::provide(project, step.needs)?;
    }
    let set_up = start.elapsed();
    let mut times = Vec::new();
    for step in steps {
        times.push((step.name, run_step(project, step)?));
    }
    println!("\n━━ everything passed");
    print_time("set-up", set_up);
    for (name, time) in times {
        print_time(name, time);
    }
    print_time("all", start.elapsed());
    Ok(())
}

fn run_step(project: &Project, step: &Step) -> Result<Duration, Failure> {
    let Step { name, title, .. } = step;
    println!("\n━━ {name}: {title}");
    let start = Instant::now();
    let outcome = (step.run)(project);
    let time = start.elapsed();
    let seconds = time.as_secs_f64();
    if let Err(failure) = outcome {
        return Err(Failure::new(format!(
            "{title} failed after {seconds:.1} s: {failure}\nRun this step alone with:\n  \
             cargo xtask test {name}"
        )));
    }
    println!("   {name} passed in {seconds:.1} s");
    Ok(time)
}

fn print_time(name: &str, time: Duration) {
    println!("   {name:<12} {:>7.1} s", time.as_secs_f64());
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_step_has_a_name_of_its_own() {
        for (index, step) in STEPS.iter().enumerate() {
            let later = STEPS.iter().skip(index + 1);
            assert!(later.clone().all(|it| it.name != step.name), "{}", step.name);
            assert!(exists(step.name));
        }
    }

    #[test]
    fn a_failed_step_says_how_to_run_it_alone() {
        let step = Step::new("sink", "a sinking", &[], |_| Err(Failure::new("a leak")));
        let project = Project { root: "/nowhere".into(), target: "/nowhere/target".into() };
        let failure = run_step(&project, &step).unwrap_err().to_string();
        assert!(failure.contains("a leak"), "{failure}");
        assert!(failure.contains("cargo xtask test sink"), "{failure}");
    }
}
