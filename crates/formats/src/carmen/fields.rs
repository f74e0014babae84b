use cogmap_geometry::Pose;

/// Poses farther from the origin than this, metres, are taken for damage.
const FAR: f64 = 1e8;
/// Stamps beyond this, seconds, are taken for damage.
const LATE: f64 = 1e13;
/// The most readings that one scan may have.
const BEAM_LIMIT: usize = 10_000;

/// The words of one line, taken one after the other; the bytes need not be text.
pub(super) struct Fields<'a> {
    words: Vec<&'a [u8]>,
    next: usize,
}

impl<'a> Fields<'a> {
    pub(super) fn of(line: &'a [u8]) -> Self {
        let words = line.split(u8::is_ascii_whitespace).filter(|word| !word.is_empty()).collect();
        Self { words, next: 0 }
    }

    pub(super) fn word(&mut self) -> Option<&'a [u8]> {
        let word = self.words.get(self.next).copied()?;
        self.next += 1;
        Some(word)
    }

    fn left(&self) -> usize {
        self.words.len() - self.next
    }

    /// Any number that Rust can spell, also infinite or none at all.
    pub(super) fn number(&mut self, what: &str) -> Result<f64, String> {
        let word = self.word().ok_or_else(|| format!("the line ends before {what}"))?;
        let number = std::str::from_utf8(word).ok().and_then(|word| word.parse().ok());
        number.ok_or_else(|| format!("`{}` is not a number, where {what} should be", shown(word)))
    }

    /// A finite number within `limit` of zero.
    pub(super) fn bounded(&mut self, what: &str, limit: f64) -> Result<f64, String> {
        let number = self.number(what)?;
        let usable = number.is_finite() && number.abs() <= limit;
        usable.then_some(number).ok_or_else(|| format!("{what} is {number:e}"))
    }

    pub(super) fn skip(&mut self, count: usize, what: &str) -> Result<(), String> {
        (0..count).try_for_each(|_| self.number(what).map(|_| ()))
    }

    /// How many numbers follow, believed only where the line is long enough.
    pub(super) fn count(&mut self, what: &str) -> Result<usize, String> {
        let number = self.number(&format!("the number of {what}"))?;
        if !(number >= 0.0 && number.fract() == 0.0 && number <= BEAM_LIMIT as f64) {
            return Err(format!("the number of {what} is {number}, not a whole number up to {BEAM_LIMIT}"));
        }
        let count = number as usize;
        if count > self.left() {
            return Err(format!("it announces {count} {what} but has only {} words left", self.left()));
        }
        Ok(count)
    }

    pub(super) fn numbers(&mut self, count: usize, what: &str) -> Result<Vec<f64>, String> {
        (0..count).map(|_| self.number(what)).collect()
    }

    pub(super) fn pose(&mut self, what: &str) -> Result<Pose, String> {
        let x = self.bounded(what, FAR)?;
        let y = self.bounded(what, FAR)?;
        Ok(Pose::new(x, y, self.bounded(what, FAR)?))
    }

    pub(super) fn stamp(&mut self) -> Result<f64, String> {
        self.bounded("the time stamp", LATE)
    }
}

/// A word as it can be shown: text, and not too much of it.
pub(super) fn shown(word: &[u8]) -> String {
    let text = String::from_utf8_lossy(word.get(..96).unwrap_or(word));
    text.chars().filter(|letter| !letter.is_control()).take(32).collect()
}
