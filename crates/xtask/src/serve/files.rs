use std::path::{Path, PathBuf};

use percent_encoding::percent_decode_str;

/// The file under `root` that a request means, if there is one; never a file outside `root`.
///
/// `root` is in canonical form. A path that ends in a slash means the `index.html` there.
pub(super) fn resolve(root: &Path, url: &str) -> Option<PathBuf> {
    let encoded = url.split(['?', '#']).next()?;
    let decoded = percent_decode_str(encoded).decode_utf8().ok()?;
    let relative = decoded.strip_prefix('/')?;
    let mut path = root.to_path_buf();
    for name in relative.split('/').filter(|name| !name.is_empty()) {
        path.push(plain_name(name)?);
    }
    if decoded.ends_with('/') {
        path.push("index.html");
    }
    // Links are followed here, so that none leads out.
    let path = path.canonicalize().ok()?;
    (path.is_file() && path.starts_with(root)).then_some(path)
}

/// A name that means one entry of a folder, on any operating system.
fn plain_name(name: &str) -> Option<&str> {
    let escapes = name == "." || name == ".." || name.contains(['\\', ':', '\0']);
    (!escapes).then_some(name)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::serve::scratch::Scratch;

    /// A folder with a site in it and a secret beside it.
    fn folder(name: &str) -> Scratch {
        let files = ["secret", "site/index.html", "site/a b/c.js"];
        Scratch::new(name, &files.map(|file| (file, "text")))
    }

    fn resolved(folder: &Scratch, url: &str) -> Option<String> {
        let site = folder.path().join("site");
        let path = resolve(&site, url)?;
        let relative = path.strip_prefix(site).unwrap();
        Some(relative.to_string_lossy().into_owned())
    }

    #[test]
    fn a_request_finds_its_file() {
        let folder = folder("finds");
        for (url, file) in [
            ("/", "index.html"),
            ("/?embed#world=1", "index.html"),
            ("/index.html", "index.html"),
            ("//index.html", "index.html"),
            ("/a%20b/c.js?v=2", "a b/c.js"),
        ] {
            assert_eq!(resolved(&folder, url).as_deref(), Some(file), "{url}");
        }
    }

    #[test]
    fn no_request_leaves_the_site() {
        let folder = folder("leaves");
        for url in [
            "/../secret",
            "/%2e%2e/secret",
            "/..%2fsecret",
            "/a%20b/../../secret",
            "/..\\secret",
            "/C:/secret",
            "/index.html%00",
            "/%ff",
            "secret",
            "http://127.0.0.1/secret",
            "",
            "/a%20b",
            "/a%20b/",
            "/nothing.html",
        ] {
            assert_eq!(resolved(&folder, url), None, "{url}");
        }
        let absolute = format!("/{}", folder.path().join("secret").display());
        assert_eq!(resolved(&folder, &absolute), None);
    }

    #[cfg(unix)]
    #[test]
    fn a_link_out_of_the_site_is_not_followed() {
        let folder = folder("link");
        let link = folder.path().join("site/link");
        std::os::unix::fs::symlink(folder.path().join("secret"), link).unwrap();
        assert_eq!(resolved(&folder, "/link"), None);
    }
}
