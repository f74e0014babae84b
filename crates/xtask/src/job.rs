use std::ffi::{OsStr, OsString};
use std::fmt;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use crate::failure::Failure;

/// One program to run: printed as it could be typed, and named so again when it fails.
#[derive(Debug, Clone)]
pub(crate) struct Job {
    program: OsString,
    arguments: Vec<OsString>,
    variables: Vec<(&'static str, OsString)>,
    first_on_path: Option<PathBuf>,
}

impl Job {
    pub(crate) fn new(program: impl Into<OsString>) -> Self {
        Self { program: program.into(), arguments: Vec::new(), variables: Vec::new(), first_on_path: None }
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

    /// Looks programs up in this folder before all others.
    pub(crate) fn first_on_path(mut self, folder: impl Into<PathBuf>) -> Self {
        self.first_on_path = Some(folder.into());
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

    /// Prints the command and lets it take this program's place, so that what stops the one stops the other.
    #[cfg(unix)]
    pub(crate) fn run_instead(&self) -> Result<(), Failure> {
        use std::os::unix::process::CommandExt;

        println!("$ {self}");
        Err(self.failure(&self.command().exec().to_string()))
    }

    /// Prints the command and runs it: here, no program can take another's place.
    #[cfg(not(unix))]
    pub(crate) fn run_instead(&self) -> Result<(), Failure> {
        self.run()
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
        if let Some(folder) = &self.first_on_path {
            command.env("PATH", path_starting_with(folder));
        }
        command
    }

    fn failure(&self, reason: &str) -> Failure {
        Failure::new(format!("this command failed ({reason}):\n  {self}"))
    }
}

impl fmt::Display for Job {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        if let Some(folder) = &self.first_on_path {
            write!(formatter, "PATH={}:\"$PATH\" ", quoted(folder.as_os_str()))?;
        }
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

/// The search path with this folder in front; as it was if it cannot be written so.
fn path_starting_with(folder: &Path) -> OsString {
    let path = std::env::var_os("PATH").unwrap_or_default();
    let folders = std::iter::once(folder.to_path_buf()).chain(std::env::split_paths(&path));
    std::env::join_paths(folders).unwrap_or(path)
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
            .variable("RUSTDOCFLAGS", "-D warnings")
            .first_on_path("/opt/tools");
        let typed =
            r#"PATH=/opt/tools:"$PATH" RUSTDOCFLAGS='-D warnings' cargo doc --workspace 'it'\''s here'"#;
        assert_eq!(job.to_string(), typed);
    }

    #[test]
    fn a_failed_job_names_its_command() {
        let failure = Job::new("cogmap-no-such-program").words("--flag").run();
        assert!(failure.is_err_and(|it| it.to_string().contains("cogmap-no-such-program --flag")));
        let failure = Job::new("cogmap-no-such-program").run_instead();
        assert!(failure.is_err_and(|it| it.to_string().contains("cogmap-no-such-program")));
    }

    #[test]
    fn a_program_that_does_not_exist_has_no_output() {
        assert_eq!(Job::new("cogmap-no-such-program").output(), None);
    }

    #[test]
    fn the_folder_comes_first_on_the_path() {
        let path = path_starting_with(Path::new("/opt/tools"));
        let first = std::env::split_paths(&path).next();
        assert_eq!(first.as_deref(), Some(Path::new("/opt/tools")));
    }
}
