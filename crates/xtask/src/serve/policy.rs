/// The policy that a page declares in its `<meta>` tag, as a header for everything beside it.
///
/// A tag binds the page but not its workers, and cannot carry `frame-ancestors`, which is added:
/// lessons may embed the page anywhere.
pub(super) fn header(page: &str) -> Option<String> {
    let tag = page
        .split('<')
        .filter_map(|after| after.split_once('>').map(|(tag, _)| tag))
        .find(|tag| tag.starts_with("meta") && tag.contains("Content-Security-Policy"))?;
    let (_, content) = tag.split_once("content=\"")?;
    let (policy, _) = content.split_once('"')?;
    let directives: Vec<_> = policy.split(';').map(squeeze).collect();
    let stated = directives.iter().filter(|directive| !directive.is_empty());
    let stated: Vec<_> = stated.map(String::as_str).collect();
    (!stated.is_empty()).then(|| format!("{}; frame-ancestors *", stated.join("; ")))
}

/// One directive, its line breaks and indentation reduced to single spaces.
fn squeeze(directive: &str) -> String {
    directive.split_whitespace().collect::<Vec<_>>().join(" ")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_header_says_what_the_page_says_and_allows_embedding() {
        let page = "<html><head><meta charset=\"utf-8\"><meta\n  \
            http-equiv=\"Content-Security-Policy\"\n  content=\"default-src 'self';\n    \
            script-src 'self' 'wasm-unsafe-eval';\"></head>";
        let expected = "default-src 'self'; script-src 'self' 'wasm-unsafe-eval'; frame-ancestors *";
        assert_eq!(header(page).as_deref(), Some(expected));
    }

    #[test]
    fn a_page_without_a_policy_yields_no_header() {
        for page in [
            "",
            "<p>Content-Security-Policy</p>",
            "<meta http-equiv=\"Content-Security-Policy\">",
            "<meta http-equiv=\"Content-Security-Policy\" content=\" ; \">",
        ] {
            assert_eq!(header(page), None, "{page}");
        }
    }
}
