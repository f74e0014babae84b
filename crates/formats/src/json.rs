//! JSON in with errors that name the place, and out in one fixed form.

mod layout;

use std::collections::BTreeMap;

use serde::{Deserialize, de::DeserializeOwned};
use serde_json::value::RawValue;

pub(crate) use layout::{write, write_file};

use crate::{
    FormatError,
    error::{Place, nearest, saturated, tame},
};

/// A piece of a larger JSON text: which file, where in it the piece begins, and under which key.
#[derive(Clone, Debug)]
pub(crate) struct Piece<'a> {
    pub(crate) text: &'a str,
    pub(crate) file: &'a str,
    /// The lines before the piece, and the columns before it in its first line.
    pub(crate) before: (usize, usize),
    pub(crate) key: String,
}

impl<'a> Piece<'a> {
    /// A whole file, without the mark that some editors put before it.
    pub(crate) fn whole(text: &'a str, file: &'a str) -> Self {
        let text = text.strip_prefix('\u{feff}').unwrap_or(text);
        Self { text, file, before: (0, 0), key: String::new() }
    }

    /// A part of this piece's text (a slice of it), found under `key`.
    pub(crate) fn part(&self, part: &'a str, key: &str) -> Self {
        let offset = (part.as_ptr() as usize).saturating_sub(self.text.as_ptr() as usize);
        let ahead = self.text.get(..offset).unwrap_or("");
        let lines = ahead.matches('\n').count();
        let columns = ahead.len() - ahead.rfind('\n').map_or(0, |at| at + 1);
        let before = if lines == 0 {
            (self.before.0, self.before.1 + columns)
        } else {
            (self.before.0 + lines, columns)
        };
        Self { text: part, file: self.file, before, key: join(&self.key, key) }
    }

    /// The value that the piece spells.
    pub(crate) fn read<T: DeserializeOwned>(&self) -> Result<T, FormatError> {
        let mut reader = serde_json::Deserializer::from_str(self.text);
        let value = serde_path_to_error::deserialize(&mut reader)
            .map_err(|error| self.explain(&error.path().to_string(), error.inner()))?;
        reader.end().map_err(|error| self.explain("", &error))?;
        Ok(value)
    }

    /// Makes sure that the file says what it is before its other keys are judged.
    pub(crate) fn expect_format(&self, expected: &'static str) -> Result<(), FormatError> {
        if self.text.trim_start().starts_with(|first| first != '{') {
            let (place, problem) = (Place::line(self.file, 1), "expected a JSON object".to_owned());
            let remedy = format!("begin the file with {{ \"format\": \"{expected}\"");
            return Err(FormatError::Json { place, problem, remedy });
        }
        #[derive(Deserialize)]
        struct Probe {
            format: Option<serde_json::Value>,
        }
        let probe: Result<Probe, _> = serde_json::from_str(self.text);
        let found = match probe {
            Ok(Probe { format: Some(serde_json::Value::String(format)) }) if format == expected => {
                return Ok(());
            }
            Ok(Probe { format: Some(format) }) => tame(&format.to_string()),
            Ok(Probe { format: None }) => "none".to_owned(),
            Err(_) => return Ok(()),
        };
        let place = self.locate("format");
        Err(FormatError::WrongFormat { place, expected, found })
    }

    /// Where the value under a path such as `boxes[3].size` stands, as far as the path leads.
    pub(crate) fn locate(&self, path: &str) -> Place {
        let mut piece = self.clone();
        for step in path.split(['.', '[']).map(|step| step.trim_end_matches(']')).filter(|s| !s.is_empty()) {
            let Some(inner) = piece.child(step) else { break };
            piece = Piece { key: String::new(), ..piece.part(inner, "") };
        }
        let (lines, columns) = piece.before;
        let known = piece.text.len() < self.text.len();
        Place {
            file: self.file.to_owned(),
            line: known.then(|| saturated(lines + 1)),
            column: known.then(|| saturated(columns + 1)),
            key: tame(&join(&self.key, path)),
        }
    }

    fn child(&self, step: &str) -> Option<&'a str> {
        if let Ok(index) = step.parse::<usize>() {
            let elements: Vec<&'a RawValue> = serde_json::from_str(self.text).ok()?;
            return elements.get(index).map(|value| value.get());
        }
        let members: BTreeMap<String, &'a RawValue> = serde_json::from_str(self.text).ok()?;
        members.get(step).map(|value| value.get())
    }

    fn explain(&self, path: &str, error: &serde_json::Error) -> FormatError {
        let message = plain(&error.to_string());
        if let Some((key, known)) = unknown_key(&message) {
            let place = self.place(&parent_of(path, &key), error);
            return FormatError::UnknownKey { place, key: tame(&key), known };
        }
        let place = self.place(path, error);
        let remedy = variant_remedy(&message).unwrap_or_else(|| remedy(error, &message));
        FormatError::Json { place, problem: tame(&message), remedy }
    }

    fn place(&self, path: &str, error: &serde_json::Error) -> Place {
        // A question mark stands for the member that was about to begin.
        let path = path.trim_end_matches(['.', '?']);
        let (line, column) = (error.line(), error.column());
        let columns = if line == 1 { self.before.1 } else { 0 };
        Place {
            file: self.file.to_owned(),
            line: (line > 0).then(|| saturated(self.before.0 + line)),
            column: (line > 0).then(|| saturated(columns + column.max(1))),
            key: tame(&join(&self.key, path)),
        }
    }
}

fn join(outer: &str, inner: &str) -> String {
    match (outer, inner) {
        (outer, "") => outer.to_owned(),
        ("", inner) => inner.to_owned(),
        (outer, inner) if inner.starts_with('[') => format!("{outer}{inner}"),
        (outer, inner) => format!("{outer}.{inner}"),
    }
}

/// The path without the unknown key itself, which the message names anyway.
fn parent_of(path: &str, key: &str) -> String {
    match path.strip_suffix(key) {
        Some("") => String::new(),
        Some(parent) => parent.strip_suffix('.').unwrap_or(path).to_owned(),
        None => path.to_owned(),
    }
}

/// What serde says, without the position and in fewer terms of Rust.
fn plain(message: &str) -> String {
    let message = message.rsplit_once(" at line ").map_or(message, |(before, _)| before);
    let Some((found, expected)) = message.rsplit_once(", expected ") else { return message.to_owned() };
    let expected = match expected {
        "f64" => "a number",
        "u64" | "u32" | "usize" => "a whole number, not negative",
        _ if expected.starts_with("struct ") || expected.starts_with("internally tagged enum ") => {
            "an object in {}"
        }
        _ => expected,
    };
    format!("{found}, expected {expected}")
}

/// Takes apart what serde says about keys and variants that a type does not have.
fn unknown_key(message: &str) -> Option<(String, Vec<String>)> {
    let rest = message.strip_prefix("unknown field `")?;
    let (key, rest) = rest.rsplit_once("`, expected").or_else(|| rest.rsplit_once("`, there are"))?;
    let (key, rest) = match key.split_once("`, expected") {
        Some((key, more)) => (key, format!("{more}{rest}")),
        None => (key, rest.to_owned()),
    };
    let known = rest.split('`').skip(1).step_by(2).map(str::to_owned).collect();
    Some((key.to_owned(), known))
}

fn variant_remedy(message: &str) -> Option<String> {
    let as_key = format!("unknown field {}", message.strip_prefix("unknown variant ")?);
    let (word, known) = unknown_key(&as_key)?;
    Some(
        nearest(&word, &known)
            .map_or("write one of those".to_owned(), |word| format!("did you mean `{word}`?")),
    )
}

fn remedy(error: &serde_json::Error, message: &str) -> String {
    use serde_json::error::Category;
    if message == "number out of range" {
        return "write a number nearer to zero".to_owned();
    }
    if message == "trailing characters" {
        return "take out what is too much here".to_owned();
    }
    match error.classify() {
        Category::Eof => "the file ends too early: a bracket or quote is never closed, or it was cut off".to_owned(),
        Category::Syntax => {
            "look just before this place for a missing or extra comma, quote or bracket (JSON has no comments, NaN or Infinity)"
                .to_owned()
        }
        Category::Data | Category::Io => match message.strip_prefix("missing field ") {
            Some(field) => format!("add the key {field}"),
            None if message.starts_with("duplicate field") => "keep one of the two".to_owned(),
            None => "correct the value".to_owned(),
        },
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde::Deserialize;

    #[derive(Debug, Deserialize)]
    #[serde(deny_unknown_fields)]
    #[allow(dead_code, reason = "only its errors are read")]
    struct Sample {
        walls: Vec<[f64; 2]>,
    }

    fn error(text: &str) -> String {
        Piece::whole(text, "a.json").read::<Sample>().unwrap_err().to_string()
    }

    #[test]
    fn an_error_names_file_line_column_and_key() {
        let message = error("{\n  \"walls\": [[1, 2],\n [3, \"x\"]]}");
        assert!(
            message.starts_with("a.json, line 3, column 8, at `walls[1][1]`: invalid type: string"),
            "{message}"
        );
    }

    #[test]
    fn an_unknown_key_is_answered_with_the_nearest() {
        assert!(error("{\"wals\": []}").ends_with("unknown key `wals`; did you mean `walls`?"));
        assert!(error("{\"qqq\": []}").ends_with("unknown key `qqq`; known here: walls"));
        assert!(error("{\"`, expected\": []}").contains("unknown key"));
    }

    #[test]
    fn an_unknown_key_named_like_its_parent_is_told_apart() {
        #[derive(Debug, Deserialize)]
        #[serde(deny_unknown_fields)]
        #[allow(dead_code, reason = "only its errors are read")]
        struct Outer {
            sample: Sample,
        }
        let text = r#"{"sample": {"sample": 1}}"#;
        let message = Piece::whole(text, "a.json").read::<Outer>().unwrap_err().to_string();
        assert!(message.contains("at `sample`: unknown key `sample`"), "{message}");
    }

    #[test]
    fn what_a_file_says_is_quoted_short_and_without_control_characters() {
        let message = error(&format!("{{\"walls\": \"\\u001b[31m{}\"}}", "x".repeat(100_000)));
        assert!(message.len() < 600 && !message.contains('\u{1b}'), "{message}");
        let message = error(&format!("{{\"{}\": 1}}", "\\u0007y".repeat(100_000)));
        assert!(message.len() < 600 && !message.contains('\u{7}'), "{message}");
    }

    #[test]
    fn a_part_knows_where_it_stands_in_the_whole() {
        let text = "{\n \"in\": {\"walls\": [[0]]}}";
        let whole = Piece::whole(text, "a.json");
        let part = whole.part(&text[9..25], "in");
        let message = part.read::<Sample>().unwrap_err().to_string();
        assert!(message.starts_with("a.json, line 2, column 21, at `in.walls[0]`"), "{message}");
    }
}
