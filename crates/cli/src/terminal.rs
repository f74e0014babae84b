use std::io::{self, Write};
use std::process::ExitCode;

use crate::failure::Failure;

/// Prints to standard output. That nobody listens any more is no failure.
pub(crate) fn say(text: &str) -> Result<(), Failure> {
    let mut out = io::stdout().lock();
    match out.write_all(text.as_bytes()).and_then(|()| out.flush()) {
        Err(error) if error.kind() != io::ErrorKind::BrokenPipe => {
            Err(Failure::run(format!("standard output cannot be written: {error}")))
        }
        _ => Ok(()),
    }
}

/// Prints a remark to standard error that stops nothing.
pub(crate) fn remark(text: &str) {
    let _ = writeln!(io::stderr(), "note: {text}");
}

/// Prints why the command did not finish.
pub(crate) fn complain(failure: &Failure) {
    let _ = writeln!(io::stderr(), "error: {failure}");
}

/// Prints what the argument parser answers: help and version, or what is wrong with the arguments.
pub(crate) fn usage(answer: &clap::Error) -> ExitCode {
    let _ = answer.print();
    if answer.use_stderr() { ExitCode::from(2) } else { ExitCode::SUCCESS }
}
