use std::path::PathBuf;

use super::installing;
use super::tools::on_path;
use crate::failure::Failure;
use crate::job::Job;

const BROWSERS: [&str; 5] =
    ["chromium", "chromium-browser", "google-chrome", "google-chrome-stable", "chrome"];
const DRIVERS: [&str; 1] = ["chromedriver"];

const ADVICE: &str = "\
The browser tests need Chromium (or Chrome) and a chromedriver of the same version.
Install both, for example with
  apt-get install chromium chromium-driver          (Debian)
  dnf install chromium chromedriver                 (Fedora)
  pacman -S chromium                                (Arch; the driver comes with it)
  brew install --cask google-chrome chromedriver    (macOS)
or set CHROME and CHROMEDRIVER to the two programs";

/// A browser to run tests in, and the program that drives it.
#[derive(Debug)]
pub(crate) struct Browser {
    pub(crate) chrome: PathBuf,
    pub(crate) driver: PathBuf,
}

impl Browser {
    /// Finds the browser, or installs it where the system's package manager may.
    pub(crate) fn provide() -> Result<Self, Failure> {
        if let Some(browser) = Self::find()? {
            return Ok(browser);
        }
        let apt = apt().ok_or_else(|| Failure::new(ADVICE))?;
        installing("Chromium and its driver", || {
            apt.clone().words("update").run()?;
            apt.words("install -y --no-install-recommends chromium chromium-driver").run()
        })
        .map_err(|failure| Failure::new(format!("{failure}\n{ADVICE}")))?;
        Self::find()?.ok_or_else(|| Failure::new(ADVICE))
    }

    fn find() -> Result<Option<Self>, Failure> {
        let chrome = locate("CHROME", &BROWSERS)?;
        let driver = locate("CHROMEDRIVER", &DRIVERS)?;
        Ok(chrome.zip(driver).map(|(chrome, driver)| Self { chrome, driver }))
    }
}

/// The program that an environment variable names, else the first of these names on `PATH`.
fn locate(variable: &str, names: &[&str]) -> Result<Option<PathBuf>, Failure> {
    let Some(named) = std::env::var_os(variable).map(PathBuf::from) else {
        return Ok(names.iter().find_map(|name| on_path(&format!("{name}{}", std::env::consts::EXE_SUFFIX))));
    };
    if named.is_file() {
        return Ok(Some(named));
    }
    let named = named.display();
    Err(Failure::new(format!("{variable} is {named}, which is no file: set it to the program, or unset it")))
}

/// `apt-get` with the right to install, or nothing where it is missing or not ours to use.
fn apt() -> Option<Job> {
    on_path("apt-get")?;
    let is_root = Job::new("id").words("-u").output()?.trim() == "0";
    let job = if is_root {
        Job::new("env")
    } else {
        let sudo = Job::new("sudo").words("-n");
        sudo.clone().words("true").output()?;
        sudo.words("env")
    };
    Some(job.words("DEBIAN_FRONTEND=noninteractive apt-get --quiet"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_program_that_is_nowhere_is_not_located() {
        let located = locate("COGMAP_NO_SUCH_VARIABLE", &["cogmap-no-such-program"]);
        assert!(matches!(located, Ok(None)));
    }

    #[test]
    fn a_variable_that_names_no_file_is_an_error() {
        let located = locate("CARGO_MANIFEST_DIR", &["sh"]);
        assert!(located.is_err_and(|error| error.to_string().contains("CARGO_MANIFEST_DIR")));
    }
}
