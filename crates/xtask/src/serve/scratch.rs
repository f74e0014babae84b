use std::fs;
use std::path::{Path, PathBuf};

/// A folder of files for one test, gone when dropped.
pub(super) struct Scratch(PathBuf);

impl Scratch {
    /// Writes each file, given by its path in the folder and its text.
    pub(super) fn new(name: &str, files: &[(&str, &str)]) -> Self {
        let name = format!("cogmap-{name}-{}", std::process::id());
        let folder = std::env::temp_dir().join(name);
        fs::create_dir_all(&folder).unwrap();
        let folder = folder.canonicalize().unwrap();
        for (file, text) in files {
            let path = folder.join(file);
            fs::create_dir_all(path.parent().unwrap()).unwrap();
            fs::write(path, text).unwrap();
        }
        Self(folder)
    }

    pub(super) fn path(&self) -> &Path {
        &self.0
    }
}

impl Drop for Scratch {
    fn drop(&mut self) {
        fs::remove_dir_all(&self.0).unwrap();
    }
}
