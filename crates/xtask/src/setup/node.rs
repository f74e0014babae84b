use super::installing;
use crate::failure::Failure;
use crate::job::Job;
use crate::project::{Project, read, write};

/// The oldest Node.js that the page's bundler runs on.
const OLDEST_NODE: (u32, u32) = (20, 19);

/// npm is a script, which Windows starts only under its full name.
const NPM: &str = if cfg!(windows) { "npm.cmd" } else { "npm" };

/// A script of `web/package.json`.
pub(crate) fn npm_run(script: &str) -> Job {
    npm(&format!("--prefix web run {script}"))
}

/// Installs the packages that `web/package-lock.json` names, unless the very same are there.
pub(super) fn provide_packages(project: &Project) -> Result<(), Failure> {
    check_node()?;
    let lockfile = read(&project.web().join("package-lock.json"))?;
    let stamp = project.web().join("node_modules/.cogmap-installed.json");
    if std::fs::read_to_string(&stamp).is_ok_and(|installed| installed == lockfile) {
        return Ok(());
    }
    installing("the page's npm packages", || {
        npm("--prefix web ci --no-audit --no-fund").run()?;
        write(&stamp, &lockfile)
    })
}

/// npm, told that no package shall fetch a browser: the system's is used.
fn npm(words: &str) -> Job {
    Job::new(NPM)
        .words(words)
        .variable("PLAYWRIGHT_SKIP_BROWSER_DOWNLOAD", "1")
        .variable("PUPPETEER_SKIP_DOWNLOAD", "1")
}

fn check_node() -> Result<(), Failure> {
    let answer = Job::new("node").words("--version").output();
    let (major, minor) = OLDEST_NODE;
    let found = match answer.as_deref().map(str::trim) {
        Some(version) if is_recent(version) => return Ok(()),
        Some(version) => format!("Node.js is {version}"),
        None => "there is no Node.js on PATH".to_owned(),
    };
    Err(Failure::new(format!(
        "{found}: install Node.js {major}.{minor} or later with npm (https://nodejs.org)"
    )))
}

/// Whether a version such as `v20.19.2` is new enough.
fn is_recent(version: &str) -> bool {
    let mut numbers =
        version.trim_start_matches('v').split('.').map_while(|number| number.parse::<u32>().ok());
    match (numbers.next(), numbers.next()) {
        (Some(major), Some(minor)) => (major, minor) >= OLDEST_NODE,
        _ => false,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_a_recent_node_will_do() {
        for recent in ["v20.19.0", "v20.20.2", "v22.1.0"] {
            assert!(is_recent(recent), "{recent}");
        }
        for old in ["v20.18.9", "v18.19.0", "v0.12.1", "v", "", "twenty"] {
            assert!(!is_recent(old), "{old}");
        }
    }
}
