//! `cogmap`, the laboratory without a window: drives virtual robots, maps recorded logs and checks
//! files, with the very code that the page runs.
//!
//! - [`arguments`] says what can be asked for,
//! - [`run`], [`replay`], [`study`] and [`check`] do it, [`figures`] draws what the thesis drew,
//! - [`input`] tells a world from a log from a session, [`building`] makes a world of a floor plan,
//!   [`log`] finds and prepares a recording,
//! - [`homing`] lets the robot go home and says how it went,
//! - [`output`] owns a run's directory, [`conclusion`] fills it, [`summary`] says what came out,
//! - [`failure`] is every way to end badly: what, where, and the way out.

mod arguments;
mod building;
mod check;
mod conclusion;
mod failure;
mod figures;
mod homing;
mod input;
mod log;
mod output;
mod progress;
mod records;
mod replay;
mod run;
mod study;
mod summary;
mod table;
mod terminal;
mod timing;

use std::process::ExitCode;

use arguments::{Arguments, Request};
use clap::Parser;
use failure::Failure;

fn main() -> ExitCode {
    let arguments = match Arguments::try_parse() {
        Ok(arguments) => arguments,
        Err(answer) => return terminal::usage(&answer),
    };
    match fulfil(&arguments.request) {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => {
            terminal::complain(&failure);
            failure.exit_code()
        }
    }
}

fn fulfil(request: &Request) -> Result<(), Failure> {
    match request {
        Request::Run(arguments) => run::run(arguments),
        Request::Replay(arguments) => replay::replay(arguments),
        Request::Study(arguments) => study::study(arguments),
        Request::Check(arguments) => check::check(&arguments.files, arguments.picture.resolution),
        Request::Figures(arguments) => figures::figures(arguments),
    }
}
