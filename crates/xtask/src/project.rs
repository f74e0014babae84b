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
    /// Asks Cargo about the workspace that the current directory belongs to.
    pub(crate) fn find() -> Result<Self, Failure> {
        let metadata = cargo()
            .words("metadata --no-deps --format-version 1")
            .output()
            .and_then(|text| serde_json::from_str::<Value>(&text).ok())
            .ok_or_else(|| Failure::new("`cargo metadata` failed: run it to see the reason"))?;
        let path = |key: &str| {
            let text = metadata.get(key).and_then(Value::as_str);
            text.map(PathBuf::from)
                .ok_or_else(|| Failure::new(format!("`cargo metadata` names no {key}")))
        };
        Ok(Self {
            root: path("workspace_root")?,
            target: path("target_directory")?,
        })
    }

    /// Cargo, at the root of the workspace.
    pub(crate) fn cargo(&self, words: &str) -> Job {
        cargo().words(words).in_folder(&self.root)
    }

    /// The page's sources.
    pub(crate) fn web(&self) -> PathBuf {
        self.root.join("web")
    }

    /// The built page.
    pub(crate) fn dist(&self) -> PathBuf {
        self.root.join("web/dist")
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
            Failure::new(format!(
                "{} does not pin one version of {package}",
                path.display()
            ))
        })?;
        Ok(version.to_owned())
    }
}

/// Reads a text file, naming it in the error.
pub(crate) fn read(path: &Path) -> Result<String, Failure> {
    std::fs::read_to_string(path).map_err(|error| Failure::file(path, &error))
}

/// The Cargo that runs this program.
fn cargo() -> Job {
    Job::new(std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into()))
}
