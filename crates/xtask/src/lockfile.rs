/// The version of `package` that the text of a `Cargo.lock` pins.
///
/// `None` unless there is exactly one: with two versions locked, neither is *the* version.
pub(crate) fn locked_version<'a>(lockfile: &'a str, package: &str) -> Option<&'a str> {
    let mut versions = lockfile
        .split("[[package]]")
        .filter(|entry| value(entry, "name") == Some(package))
        .filter_map(|entry| value(entry, "version"));
    let version = versions.next()?;
    versions.next().is_none().then_some(version)
}

/// The string that `key = "…"` holds in one entry.
fn value<'a>(entry: &'a str, key: &str) -> Option<&'a str> {
    entry.lines().find_map(|line| {
        let (name, value) = line.split_once('=')?;
        let quoted = value.trim().strip_prefix('"')?.strip_suffix('"')?;
        (name.trim() == key).then_some(quoted)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    const LOCKFILE: &str = r#"
version = 4

[[package]]
name = "wasm-bindgen"
version = "0.2.126"
source = "registry+https://github.com/rust-lang/crates.io-index"
dependencies = [
 "wasm-bindgen-macro",
]

[[package]]
name = "wasm-bindgen-macro"
version = "0.2.125"

[[package]]
name = "hashbrown"
version = "0.16.1"

[[package]]
name = "hashbrown"
version = "0.17.1"
"#;

    #[test]
    fn the_version_is_that_of_the_package_with_exactly_this_name() {
        assert_eq!(locked_version(LOCKFILE, "wasm-bindgen"), Some("0.2.126"));
        assert_eq!(locked_version(LOCKFILE, "wasm-bindgen-macro"), Some("0.2.125"));
    }

    #[test]
    fn a_missing_or_ambiguous_package_has_no_version() {
        assert_eq!(locked_version(LOCKFILE, "wasm"), None);
        assert_eq!(locked_version(LOCKFILE, "hashbrown"), None);
        assert_eq!(locked_version("", "wasm-bindgen"), None);
        assert_eq!(locked_version(&LOCKFILE.replace('"', ""), "wasm-bindgen"), None);
    }
}
