//! The two commands a developer needs: `cargo xtask demo` and `cargo xtask test`.
//!
//! Both install what is missing before they start, from the package registries alone (crates.io,
//! npm, rustup, the system's package manager), and nothing outside this checkout but the wasm
//! target and, where it is missing, Chromium. They say what they run in words that can be typed.
#![allow(
    clippy::print_stdout,
    clippy::print_stderr,
    reason = "a program for the terminal: what it prints is its purpose"
)]

mod arguments;
mod demo;
mod failure;
mod job;
mod lockfile;
mod page;
mod port;
mod project;
mod setup;
mod steps;

use std::process::ExitCode;

use arguments::{Request, USAGE};
use failure::Failure;
use project::Project;

fn main() -> ExitCode {
    let request = match arguments::parse(lexopt::Parser::from_env()) {
        Ok(request) => request,
        Err(error) => {
            eprintln!("error: {error}\n\n{USAGE}");
            return ExitCode::from(2);
        }
    };
    match fulfil(&request) {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => {
            eprintln!("\nerror: {failure}");
            ExitCode::FAILURE
        }
    }
}

fn fulfil(request: &Request) -> Result<(), Failure> {
    match request {
        Request::Help => {
            println!("{USAGE}");
            Ok(())
        }
        Request::ListSteps => {
            steps::list();
            Ok(())
        }
        Request::Test(chosen) => steps::run(&Project::enter()?, chosen),
        Request::Demo(options) => demo::run(&Project::enter()?, options),
    }
}
