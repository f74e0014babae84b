use cogmap_mapping::Sentence;
use serde::Serialize;
use tsify::Tsify;

/// A part of the engine's reason for something, which the page says in its own language.
#[derive(Clone, Debug, PartialEq, Serialize, Tsify)]
pub struct Clause {
    /// English, with `{}` in the places of the numbers.
    pub pattern: String,
    /// The numbers, each with how many decimals are said of it.
    pub numbers: Vec<(f64, usize)>,
}

/// The clauses of a sentence.
pub(crate) fn clauses(sentence: &Sentence) -> Vec<Clause> {
    let worded = |clause: &cogmap_mapping::Clause| Clause {
        pattern: clause.pattern.to_string(),
        numbers: clause.numbers.clone(),
    };
    sentence.clauses.iter().map(worded).collect()
}
