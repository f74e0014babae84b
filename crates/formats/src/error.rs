use std::fmt;

use thiserror::Error;

/// Where in a file something is wrong.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Place {
    /// The file as its user named it.
    pub file: String,
    /// From 1.
    pub line: Option<u32>,
    /// From 1.
    pub column: Option<u32>,
    /// The key's path, such as `walls[3][1]`; empty where no key is to blame.
    pub key: String,
}

impl Place {
    /// The file as a whole.
    #[must_use]
    pub fn file(file: &str) -> Self {
        Self { file: file.to_owned(), ..Self::default() }
    }

    /// A line of the file, from 1.
    #[must_use]
    pub fn line(file: &str, line: usize) -> Self {
        Self { line: Some(saturated(line)), ..Self::file(file) }
    }
}

/// A number of a line or column as it is kept; no file that is read has more than these.
pub(crate) fn saturated(number: usize) -> u32 {
    u32::try_from(number).unwrap_or(u32::MAX)
}

/// What a file says, fit for a message: short, and without characters that do things to a terminal.
pub(crate) fn tame(text: &str) -> String {
    let shown: Vec<char> = text.chars().filter(|letter| !letter.is_control()).take(401).collect();
    match (shown.get(..200), shown.len() > 400) {
        (Some(beginning), true) => {
            let end: Vec<char> = text.chars().rev().filter(|letter| !letter.is_control()).take(100).collect();
            beginning.iter().copied().chain(" … ".chars()).chain(end.into_iter().rev()).collect()
        }
        _ => shown.into_iter().collect(),
    }
}

impl fmt::Display for Place {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        out.write_str(&self.file)?;
        if let Some(line) = self.line {
            write!(out, ", line {line}")?;
        }
        if let Some(column) = self.column {
            write!(out, ", column {column}")?;
        }
        if !self.key.is_empty() {
            write!(out, ", at `{}`", self.key)?;
        }
        Ok(())
    }
}

/// One of several things wrong with a file, and the way out.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[error("{place}: {problem}")]
pub struct Complaint {
    /// Where it stands.
    pub place: Place,
    /// What is wrong and what to do.
    pub problem: String,
}

/// Why a file cannot be used: every message names the place and the way out.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub enum FormatError {
    /// The text is not JSON, or a value is of the wrong kind.
    #[error("{place}: {problem}; {remedy}")]
    Json {
        /// Where reading stopped.
        place: Place,
        /// What was found and what was expected.
        problem: String,
        /// What to do.
        remedy: String,
    },
    /// A key that the format does not have.
    #[error("{place}: unknown key `{key}`; {}", nearest_or_known(key, known))]
    UnknownKey {
        /// Where it stands.
        place: Place,
        /// The key.
        key: String,
        /// All keys known there.
        known: Vec<String>,
    },
    /// The file says that it is something else.
    #[error(
        "{place}: expected the format \"{expected}\", found {found}; pass a file of that format, or write \"format\": \"{expected}\" if it is one"
    )]
    WrongFormat {
        /// The file.
        place: Place,
        /// What can be read here.
        expected: &'static str,
        /// What the file says, as JSON.
        found: String,
    },
    /// The file follows the format, but what it describes cannot be.
    #[error("{}", lines(complaints))]
    Problems {
        /// The file.
        place: Place,
        /// Everything that is wrong, each with the way out.
        complaints: Vec<Complaint>,
    },
    /// A line that does not follow its format.
    #[error("{place}: {problem}; {remedy}")]
    Line {
        /// Which line.
        place: Place,
        /// What is wrong with it.
        problem: String,
        /// What to do.
        remedy: &'static str,
    },
    /// A picture that cannot become a world.
    #[error("{place}: {problem}; {remedy}")]
    Picture {
        /// The file.
        place: Place,
        /// What is wrong with it.
        problem: String,
        /// What to do.
        remedy: &'static str,
    },
    /// Compressed data that cannot be unpacked.
    #[error(
        "{place}: the gzip data is broken ({problem}); fetch the file again, or unpack it and pass the result"
    )]
    Gzip {
        /// The file.
        place: Place,
        /// What the unpacker says.
        problem: String,
    },
    /// More than the program takes.
    #[error("{place}: more than {limit} {unit}; cut the file into parts and read one at a time")]
    TooLarge {
        /// The file.
        place: Place,
        /// The most that is read.
        limit: usize,
        /// Of what.
        unit: &'static str,
    },
    /// A log without anything to map.
    #[error(
        "{place}: no usable scan ({seen}); a log needs at least one FLASER, RLASER or ROBOTLASER1 line of the CARMEN format"
    )]
    NoScan {
        /// The file.
        place: Place,
        /// What there was instead.
        seen: String,
    },
}

impl FormatError {
    /// Where in the file.
    #[must_use]
    pub fn place(&self) -> &Place {
        match self {
            Self::Json { place, .. }
            | Self::UnknownKey { place, .. }
            | Self::WrongFormat { place, .. }
            | Self::Problems { place, .. }
            | Self::Line { place, .. }
            | Self::Picture { place, .. }
            | Self::Gzip { place, .. }
            | Self::TooLarge { place, .. }
            | Self::NoScan { place, .. } => place,
        }
    }
}

fn lines(complaints: &[Complaint]) -> String {
    complaints.iter().map(ToString::to_string).collect::<Vec<_>>().join("\n")
}

fn nearest_or_known(key: &str, known: &[String]) -> String {
    match nearest(key, known) {
        Some(nearest) => format!("did you mean `{nearest}`?"),
        None if known.is_empty() => "no keys are known here: remove it".to_owned(),
        None => format!("known here: {}", known.join(", ")),
    }
}

/// The known word that looks most like `word`, if it looks like any of them.
pub(crate) fn nearest<'a>(word: &str, known: &'a [String]) -> Option<&'a str> {
    let word: String = word.chars().take(64).collect();
    known
        .iter()
        .map(|candidate| (strsim::jaro_winkler(&word, candidate), candidate.as_str()))
        .filter(|(likeness, _)| *likeness > 0.75)
        .max_by(|a, b| a.0.total_cmp(&b.0))
        .map(|(_, candidate)| candidate)
}
