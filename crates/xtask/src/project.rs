use std::path::{Path, PathBuf};

use serde_json::Value;

use crate::failure::Failure;
use crate::job::Job;
use crate::lockfile::locked_version;

/// The checkout: where its parts lie and where its build goes.
#[derive(Debug)]
pub(crate) struct Project {
    pub(crate) root: PathBuf,
    /// Cargo's target directory, wherever the environment or a configuration puts it.
    pub(crate) target: PathBuf,
}

impl Project {
    /// Finds the workspace that the current directory belongs to and moves to its root, so that
    /// every command printed from then on can be typed there.
    pub(crate) fn enter() -> Result<Self, Failure> {
        let metadata = cargo("metadata --no-deps --format-version 1")
            .output()
            .and_then(|text| serde_json::from_str::<Value>(&text).ok())
            .ok_or_else(|| Failure::new("`cargo metadata` failed: run it to see the reason"))?;
        let path = |key: &str| {
            let text = metadata.get(key).and_then(Value::as_str);
            text.map(PathBuf::from).ok_or_else(|| Failure::new(format!("`cargo metadata` names no {key}")))
        };
        let project = Self { root: path("workspace_root")?, target: path("target_directory")? };
        std::env::set_current_dir(&project.root).map_err(|error| Failure::file(&project.root, &error))?;
        Ok(project)
    }

    /// The page's sources.
    pub(crate) fn web(&self) -> PathBuf {
        self.root.join("web")
    }

    /// The built page.
    pub(crate) fn dist(&self) -> PathBuf {
        self.web().join("dist")
    }

    /// Where Cargo-installed tools live, apart from the user's own.
    pub(crate) fn tools(&self) -> PathBuf {
        self.target.join("tools")
    }

    /// The version of a package that `Cargo.lock` pins.
    pub(crate) fn locked_version(&self, package: &str) -> Result<String, Failure> {
        let path = self.root.join("Cargo.lock");
        let lockfile = read(&path)?;
        let version = locked_version(&lockfile, package).ok_or_else(|| {
            let path = path.display();
            Failure::new(format!("{path} does not pin one version of {package}"))
        })?;
        Ok(version.to_owned())
    }
}

/// Cargo with these arguments. Inside a rustup toolchain the same toolchain answers.
pub(crate) fn cargo(words: &str) -> Job {
    Job::new("cargo").words(words)
}

/// Reads a text file, naming it in the error.
pub(crate) fn read(path: &Path) -> Result<String, Failure> {
    std::fs::read_to_string(path).map_err(|error| Failure::file(path, &error))
}

/// Writes a file, naming it in the error.
pub(crate) fn write(path: &Path, contents: &str) -> Result<(), Failure> {
    std::fs::write(path, contents).map_err(|error| Failure::file(path, &error))
}
