use std::borrow::Cow;
use std::fmt;

use serde::{Deserialize, Serialize};

/// Why something was done, for people: in clauses, so that a reader may have it in another language.
///
/// Written out it is English; that is also its form in files.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(into = "String", from = "String")]
pub struct Sentence {
    /// What the semicolons part.
    pub clauses: Vec<Clause>,
}

/// A part of a sentence: a pattern, and the numbers that take the places of its `{}`.
#[derive(Clone, Debug, PartialEq)]
pub struct Clause {
    /// English, the same for whatever numbers.
    pub pattern: Cow<'static, str>,
    /// Each with the number of its decimals.
    pub numbers: Vec<(f64, usize)>,
}

/// A sentence of one clause; the numbers, each with its decimals, take the places of `{}` in turn.
#[must_use]
pub fn say(pattern: &'static str, numbers: &[(f64, usize)]) -> Sentence {
    let pattern = Cow::Borrowed(pattern);
    Sentence { clauses: vec![Clause { pattern, numbers: numbers.to_vec() }] }
}

impl Sentence {
    /// This, and then that.
    #[must_use]
    pub fn then(mut self, that: Self) -> Self {
        self.clauses.extend(that.clauses);
        self
    }

    /// Whether all that another one says is said.
    #[must_use]
    pub fn says(&self, other: &Self) -> bool {
        other.clauses.iter().all(|clause| self.clauses.contains(clause))
    }
}

impl fmt::Display for Sentence {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (index, clause) in self.clauses.iter().enumerate() {
            let mark = if index == 0 { "" } else { "; " };
            write!(formatter, "{mark}{clause}")?;
        }
        Ok(())
    }
}

impl fmt::Display for Clause {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut rest = self.pattern.as_ref();
        for &(number, decimals) in &self.numbers {
            let Some((before, after)) = rest.split_once("{}") else { break };
            write!(formatter, "{before}{number:.decimals$}")?;
            rest = after;
        }
        formatter.write_str(rest)
    }
}

impl From<Sentence> for String {
    fn from(sentence: Sentence) -> Self {
        sentence.to_string()
    }
}

/// What somebody else has worded already.
impl From<String> for Sentence {
    fn from(text: String) -> Self {
        Self { clauses: vec![Clause { pattern: Cow::Owned(text), numbers: Vec::new() }] }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_take_their_places_and_semicolons_part_the_clauses() {
        let home = say("home is {} m away, {} %", &[(1.25, 1), (49.6, 0)]);
        assert_eq!(home.to_string(), "home is 1.2 m away, 50 %");
        assert_eq!(home.then(say("it waits", &[])).to_string(), "home is 1.2 m away, 50 %; it waits");
        assert_eq!(Sentence::default().to_string(), "");
    }

    #[test]
    fn what_is_said_is_found_whatever_else_is() {
        let (one, two) = (say("one", &[]), say("two {}", &[(2.0, 0)]));
        let both = one.clone().then(two.clone());
        assert!(both.says(&one) && both.says(&two) && both.says(&Sentence::default()));
        assert!(!one.says(&both) && !both.says(&say("two {}", &[(3.0, 0)])));
    }

    #[test]
    fn in_files_it_is_a_text() {
        let sentence = say("{} m", &[(2.0, 1)]);
        let text = serde_json::to_string(&sentence).unwrap();
        assert_eq!(text, "\"2.0 m\"");
        let read: Sentence = serde_json::from_str(&text).unwrap();
        assert_eq!(read.to_string(), sentence.to_string());
        let braces = Sentence::from("a {} of somebody's".to_owned());
        assert_eq!(braces.to_string(), "a {} of somebody's");
    }
}
