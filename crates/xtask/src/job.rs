use std::ffi::{OsStr, OsString};
use std::fmt;
use std::process::{Command, Stdio};

use crate::failure::Failure;

/// One program to run: printed as it could be typed, and named so again when it fails.
#[derive(Debug, Clone)]
pub(crate) struct Job {
    program: OsString,
    arguments: Vec<OsString>,
    variables: Vec<(&'static str, OsString)>,
}

impl Job {
    pub(crate) fn new(program: impl Into<OsString>) -> Self {
        Self { program: program.into(), arguments: Vec::new(), variables: Vec::new() }
    }

    /// Adds arguments written in one string, split at white space.
    pub(crate) fn words(mut self, words: &str) -> Self {
        let words = words.split_whitespace().map(OsString::from);
        self.arguments.extend(words);
        self
    }

    /// Adds one argument as it is: a path, or anything with spaces.
    pub(crate) fn argument(mut self, argument: impl Into<OsString>) -> Self {
        self.arguments.push(argument.into());
        self
    }

    pub(crate) fn variable(mut self, name: &'static str, value: impl Into<OsString>) -> Self {
        self.variables.push((name, value.into()));
        self
    }

    /// Prints the command and runs it, its output going to the terminal.
    pub(crate) fn run(&self) -> Result<(), Failure> {
        println!("$ {self}");
        let status = self.command().status();
        match status {
            Ok(status) if status.success() => Ok(()),
            Ok(status) => Err(self.failure(&status.to_string())),
            Err(error) => Err(self.failure(&error.to_string())),
        }
    }

    /// Runs the command silently and returns what it wrote, or nothing if it failed.
    pub(crate) fn output(&self) -> Option<String> {
        let output = self.command().stderr(Stdio::null()).output().ok()?;
        let text = String::from_utf8(output.stdout).ok()?;
        output.status.success().then_some(text)
    }

    fn command(&self) -> Command {
        let mut command = Command::new(&self.program);
        command.args(&self.arguments).stdin(Stdio::null());
        for (name, value) in &self.variables {
            command.env(name, value);
        }
        command
    }

    fn failure(&self, reason: &str) -> Failure {
        Failure::new(format!("this command failed ({reason}):\n  {self}"))
    }
}

impl fmt::Display for Job {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (name, value) in &self.variables {
            write!(formatter, "{name}={} ", quoted(value))?;
        }
        formatter.write_str(&quoted(&self.program))?;
        for argument in &self.arguments {
            write!(formatter, " {}", quoted(argument))?;
        }
        Ok(())
    }
}

/// The text as a shell would read it back.
fn quoted(text: &OsStr) -> String {
    let text = text.to_string_lossy();
    let plain = |c: char| c.is_ascii_alphanumeric() || "-_./:=@+,".contains(c);
    if !text.is_empty() && text.chars().all(plain) {
        return text.into_owned();
    }
    format!("'{}'", text.replace('\'', r"'\''"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_job_reads_as_it_could_be_typed() {
        let job = Job::new("cargo")
            .words("doc --workspace")
            .argument("it's here")
            .variable("RUSTDOCFLAGS", "-D warnings");
        let typed = r"RUSTDOCFLAGS='-D warnings' cargo doc --workspace 'it'\''s here'";
        assert_eq!(job.to_string(), typed);
    }

    #[test]
    fn a_failed_job_names_its_command() {
        let failure = Job::new("cogmap-no-such-program").words("--flag").run();
        assert!(failure.is_err_and(|it| it.to_string().contains("cogmap-no-such-program --flag")));
    }

    #[test]
    fn a_program_that_does_not_exist_has_no_output() {
        assert_eq!(Job::new("cogmap-no-such-program").output(), None);
    }
}
