use std::fmt;
use std::path::Path;
use std::process::ExitCode;

use cogmap_formats::FormatError;

/// Why a command did not finish: what is wrong and where, and the way out.
#[derive(Debug)]
pub(crate) struct Failure {
    fault: Fault,
    message: String,
    way_out: Option<String>,
}

/// Whose fault it is; the exit code tells scripts.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Fault {
    /// The run failed: exit code 1.
    Run,
    /// Bad usage or bad input: exit code 2.
    Input,
}

impl Failure {
    /// What was asked for or read is wrong.
    pub(crate) fn input(message: impl Into<String>) -> Self {
        Self { fault: Fault::Input, message: message.into(), way_out: None }
    }

    /// The input was right and yet the run did not succeed.
    pub(crate) fn run(message: impl Into<String>) -> Self {
        Self { fault: Fault::Run, message: message.into(), way_out: None }
    }

    /// A file or directory that should have been read.
    pub(crate) fn unreadable(path: &Path, error: &std::io::Error) -> Self {
        Self::input(format!("{}: {}", path.display(), plainly(error)))
    }

    /// A file or directory that should have been written.
    pub(crate) fn unwritable(path: &Path, error: &std::io::Error) -> Self {
        Self::run(format!("{}: cannot be written: {}", path.display(), plainly(error)))
    }

    /// Says what to do about it.
    pub(crate) fn help(mut self, way_out: impl Into<String>) -> Self {
        self.way_out = Some(way_out.into());
        self
    }

    /// What the process ends with.
    pub(crate) fn exit_code(&self) -> ExitCode {
        ExitCode::from(match self.fault {
            Fault::Run => 1,
            Fault::Input => 2,
        })
    }
}

impl From<FormatError> for Failure {
    fn from(error: FormatError) -> Self {
        Self::input(error.to_string())
    }
}

/// The system's word for an error without its number.
fn plainly(error: &std::io::Error) -> String {
    match error.kind() {
        std::io::ErrorKind::NotFound => "there is no such file".into(),
        std::io::ErrorKind::PermissionDenied => "permission denied".into(),
        _ => error.to_string(),
    }
}

impl fmt::Display for Failure {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(&self.message)?;
        match &self.way_out {
            Some(way_out) => write!(formatter, "\n  help: {way_out}"),
            None => Ok(()),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_message_comes_first_and_the_way_out_below_it() {
        let failure = Failure::input("a.log: nothing in it").help("name another file");
        assert_eq!(failure.to_string(), "a.log: nothing in it\n  help: name another file");
    }

    #[test]
    fn a_failed_run_and_a_bad_input_end_differently() {
        assert_eq!(Failure::run("stuck").exit_code(), ExitCode::from(1));
        assert_eq!(Failure::input("no file").exit_code(), ExitCode::from(2));
    }
}
