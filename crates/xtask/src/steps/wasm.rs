use std::path::{Path, PathBuf};

use serde_json::{Value, json};

use crate::failure::Failure;
use crate::job::Job;
use crate::project::{Project, cargo, read, write};
use crate::setup::{Browser, Need, wasm_bindgen, wasm_pack};

pub(super) const LINTERS: [Need; 2] = [Need::RustComponents, Need::WasmTarget];
pub(super) const IN_NODE: [Need; 3] = [Need::WasmTarget, Need::WasmBindgen, Need::WasmPack];
pub(super) const IN_CHROME: [Need; 4] = [Need::WasmTarget, Need::WasmBindgen, Need::WasmPack, Need::Browser];

/// Where `wasm-pack` finds the tests.
const CRATE: &str = "crates/wasm";

/// How long the tests may take, in seconds; the runner's own limit of 20 is short for a slow machine.
const PATIENCE: &str = "300";

pub(super) fn clippy(_: &Project) -> Result<(), Failure> {
    cargo("clippy -p cogmap-wasm --all-targets --target wasm32-unknown-unknown").words("-- -D warnings").run()
}

pub(super) fn test_in_node(project: &Project) -> Result<(), Failure> {
    test(project)?.words("--node").argument(CRATE).run()
}

pub(super) fn test_in_chrome(project: &Project) -> Result<(), Failure> {
    let browser = Browser::provide()?;
    let capabilities = capabilities(project, &browser.chrome)?;
    test(project)?
        .words("--headless --chrome --chromedriver")
        .argument(browser.driver)
        .argument(CRATE)
        .variable("WASM_BINDGEN_TEST_WEBDRIVER_JSON", capabilities)
        .variable("WASM_BINDGEN_TEST_TIMEOUT", PATIENCE)
        .run()
}

/// `wasm-pack test` with the test runner that fits, and leave to download nothing.
fn test(project: &Project) -> Result<Job, Failure> {
    let runner = wasm_bindgen(project)?;
    let job = Job::new(wasm_pack(project)?).words("test --mode no-install");
    Ok(match runner.parent() {
        Some(folder) => job.first_on_path(folder),
        None => job,
    })
}

/// Writes the crate's `webdriver.json` with this browser in it, and returns the new file.
fn capabilities(project: &Project, chrome: &Path) -> Result<PathBuf, Failure> {
    let source = project.root.join(CRATE).join("webdriver.json");
    let completed = with_browser(&read(&source)?, chrome)
        .map_err(|error| Failure::new(format!("{}: {error}", source.display())))?;
    let file = project.target.join("webdriver.json");
    write(&file, &completed)?;
    Ok(file)
}

fn with_browser(capabilities: &str, chrome: &Path) -> Result<String, String> {
    let mut parsed: Value = serde_json::from_str(capabilities).map_err(|error| error.to_string())?;
    parsed
        .get_mut("goog:chromeOptions")
        .and_then(Value::as_object_mut)
        .ok_or("no object goog:chromeOptions")?
        .insert("binary".to_owned(), json!(chrome.to_string_lossy()));
    Ok(parsed.to_string())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_browser_joins_the_options_that_are_there() {
        let source = r#"{"goog:chromeOptions":{"args":["--headless"]}}"#;
        let completed = with_browser(source, Path::new("/opt/chrome")).unwrap();
        let parsed: Value = serde_json::from_str(&completed).unwrap();
        let expected = json!({"goog:chromeOptions": {"args": ["--headless"], "binary": "/opt/chrome"}});
        assert_eq!(parsed, expected);
    }

    #[test]
    fn a_file_that_is_no_capabilities_is_an_error() {
        for broken in ["", "[]", "{}", r#"{"goog:chromeOptions":[]}"#] {
            assert!(with_browser(broken, Path::new("/opt/chrome")).is_err(), "{broken}");
        }
    }
}
