use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use crate::arguments::OutputArguments;
use crate::failure::Failure;

/// The beginnings and the ends of the names of all files that a run may leave; between them a
/// mapper's name may stand.
const RUN_FILES: [(&str, &str); 16] = [
    ("session", "json"),
    ("truth", "tum"),
    ("odometry", "tum"),
    ("estimate", "tum"),
    ("map", "json"),
    ("map", "svg"),
    ("map", "png"),
    ("network", "g2o"),
    ("events", "jsonl"),
    ("report", "json"),
    ("timing", "json"),
    ("runs", "csv"),
    ("summary", "json"),
    ("curve", "svg"),
    ("curve", "png"),
    ("plan", "txt"),
];

/// A directory that belongs to one run. Each file appears in it whole or not at all.
#[derive(Debug)]
pub(crate) struct Output {
    directory: PathBuf,
    older: Vec<String>,
}

impl Output {
    /// The directory that the arguments name, if they name one.
    pub(crate) fn of(arguments: &OutputArguments) -> Result<Option<Self>, Failure> {
        Self::at(arguments.out.as_deref(), arguments.force)
    }

    /// The directory of that name, if one is named.
    pub(crate) fn at(directory: Option<&Path>, force: bool) -> Result<Option<Self>, Failure> {
        directory.map(|directory| Self::claim(directory, force)).transpose()
    }

    /// Makes the directory, or takes one that exists. One with the files of another run is taken
    /// only with `force`.
    fn claim(directory: &Path, force: bool) -> Result<Self, Failure> {
        create(directory)?;
        let older = run_files_in(directory)?;
        if let (Some(first), false) = (older.first(), force) {
            let message =
                format!("--out {}: it holds the files of another run ({first})", directory.display());
            return Err(
                Failure::input(message).help("name another directory, or replace that run with --force")
            );
        }
        let output = Self { directory: directory.to_owned(), older };
        output.try_to_write()?;
        Ok(output)
    }

    /// Where the files go.
    pub(crate) fn directory(&self) -> &Path {
        &self.directory
    }

    /// Writes the files, and takes away what else an earlier run left.
    pub(crate) fn write_all(&self, files: &[(String, Vec<u8>)]) -> Result<(), Failure> {
        for (name, content) in files {
            self.write(name, content)?;
        }
        for name in &self.older {
            if !files.iter().any(|(written, _)| written == name) {
                let path = self.directory.join(name);
                fs::remove_file(&path).map_err(|error| Failure::unwritable(&path, &error))?;
            }
        }
        Ok(())
    }

    /// Writes one file under another name and gives it its own when it is complete.
    pub(crate) fn write(&self, name: &str, content: &[u8]) -> Result<(), Failure> {
        let path = self.directory.join(name);
        let partial = self.directory.join(format!(".{name}.partial"));
        let written = fs::write(&partial, content).and_then(|()| fs::rename(&partial, &path));
        written.map_err(|error| {
            let _ = fs::remove_file(&partial);
            Failure::unwritable(&path, &error)
        })
    }

    /// A run may take long: whether its files can be written is tried before it starts.
    fn try_to_write(&self) -> Result<(), Failure> {
        let probe = self.directory.join(".cogmap.partial");
        fs::write(&probe, b"")
            .and_then(|()| fs::remove_file(&probe))
            .map_err(|error| unusable(&self.directory, &error))
    }
}

/// Makes a directory where there is none.
pub(crate) fn create(directory: &Path) -> Result<(), Failure> {
    if directory.exists() && !directory.is_dir() {
        return Err(Failure::input(format!("--out {}: this is a file", directory.display()))
            .help("name a directory; it is made if it is missing"));
    }
    fs::create_dir_all(directory).map_err(|error| unusable(directory, &error))
}

fn unusable(directory: &Path, error: &io::Error) -> Failure {
    Failure::input(format!("--out {}: cannot be written to: {error}", directory.display()))
        .help("name a directory that you may write to")
}

fn run_files_in(directory: &Path) -> Result<Vec<String>, Failure> {
    let entries = fs::read_dir(directory).map_err(|error| unusable(directory, &error))?;
    let mut names: Vec<String> = entries
        .filter_map(|entry| entry.ok()?.file_name().into_string().ok())
        .filter(|name| is_run_file(name))
        .collect();
    names.sort();
    Ok(names)
}

fn is_run_file(name: &str) -> bool {
    let Some((stem, extension)) = name.rsplit_once('.') else { return false };
    let first = stem.split('.').next().unwrap_or(stem);
    stem.matches('.').count() <= 1 && RUN_FILES.contains(&(first, extension))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn file(name: &str, content: &str) -> (String, Vec<u8>) {
        (name.to_owned(), content.as_bytes().to_vec())
    }

    #[test]
    fn a_missing_directory_is_made() {
        let place = tempfile::tempdir().unwrap();
        let inner = place.path().join("a/b");
        let output = Output::claim(&inner, false).unwrap();
        output.write_all(&[file("map.json", "{}")]).unwrap();
        assert_eq!(fs::read_to_string(inner.join("map.json")).unwrap(), "{}");
        assert_eq!(fs::read_dir(&inner).unwrap().count(), 1);
    }

    #[test]
    fn a_directory_with_another_run_is_refused_unless_forced() {
        let place = tempfile::tempdir().unwrap();
        fs::write(place.path().join("estimate.odometry.tum"), "").unwrap();
        let refusal = Output::claim(place.path(), false).unwrap_err().to_string();
        assert!(refusal.contains("estimate.odometry.tum") && refusal.contains("--force"), "{refusal}");
        let output = Output::claim(place.path(), true).unwrap();
        output.write_all(&[file("estimate.tum", "0 0 0 0 0 0 0 1\n")]).unwrap();
        assert!(!place.path().join("estimate.odometry.tum").exists());
    }

    #[test]
    fn files_that_no_run_left_stay_and_do_not_matter() {
        let place = tempfile::tempdir().unwrap();
        for name in ["notes.txt", "plan.png", "map.final.old.json", "sessions.json"] {
            fs::write(place.path().join(name), "mine").unwrap();
        }
        Output::claim(place.path(), false).unwrap().write_all(&[file("map.json", "{}")]).unwrap();
        assert_eq!(fs::read_dir(place.path()).unwrap().count(), 5);
    }

    #[test]
    fn a_file_is_no_directory() {
        let place = tempfile::NamedTempFile::new().unwrap();
        let refusal = Output::claim(place.path(), true).unwrap_err().to_string();
        assert!(refusal.contains("this is a file"), "{refusal}");
    }
}
