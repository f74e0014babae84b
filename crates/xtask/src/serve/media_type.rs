use std::path::Path;

/// The media type of a file, by its extension; browsers insist on those of modules and wasm.
pub(super) fn of(path: &Path) -> &'static str {
    let extension = path.extension().and_then(|it| it.to_str()).unwrap_or("");
    match extension.to_ascii_lowercase().as_str() {
        "html" => "text/html; charset=utf-8",
        "js" | "mjs" => "text/javascript; charset=utf-8",
        "css" => "text/css; charset=utf-8",
        "wasm" => "application/wasm",
        "json" | "map" => "application/json",
        "webmanifest" => "application/manifest+json",
        "svg" => "image/svg+xml",
        "png" => "image/png",
        "jpg" | "jpeg" => "image/jpeg",
        "webp" => "image/webp",
        "ico" => "image/x-icon",
        "woff2" => "font/woff2",
        "gz" => "application/gzip",
        "txt" | "log" | "md" => "text/plain; charset=utf-8",
        _ => "application/octet-stream",
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn browsers_get_the_types_they_insist_on() {
        for (file, expected) in [
            ("index.html", "text/html; charset=utf-8"),
            ("assets/app-1a2b.js", "text/javascript; charset=utf-8"),
            ("assets/cogmap_wasm_bg.WASM", "application/wasm"),
            ("manifest.webmanifest", "application/manifest+json"),
            ("worlds/office.world.json", "application/json"),
            ("intel.log.gz", "application/gzip"),
        ] {
            assert_eq!(of(Path::new(file)), expected, "{file}");
        }
    }

    #[test]
    fn an_unknown_file_is_bytes() {
        assert_eq!(of(Path::new("LICENSE")), "application/octet-stream");
        assert_eq!(of(Path::new("run.xyz")), "application/octet-stream");
    }
}
