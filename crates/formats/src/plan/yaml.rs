use crate::{
    FormatError,
    error::{Place, nearest, tame},
};

/// The part of YAML that `map_server` files are written in: a key and a value a line, lists in
/// brackets or one element a line, comments.
pub(super) struct Yaml<'a> {
    file: &'a str,
    entries: Vec<Entry<'a>>,
}

/// One key.
struct Entry<'a> {
    /// From 1.
    line: usize,
    key: &'a str,
    values: Vec<&'a str>,
}

const FORM: &str = "write `key: value`, or a list as `key: [1, 2, 3]`, a line each";

impl<'a> Yaml<'a> {
    pub(super) fn read(text: &'a str, file: &'a str) -> Result<Self, FormatError> {
        let mut yaml = Self { file, entries: Vec::new() };
        for (index, line) in text.lines().enumerate() {
            let line_number = index + 1;
            let taken = yaml.take(line_number, without_comment(line).trim_end());
            taken.map_err(|problem| yaml.broken(line_number, problem))?;
        }
        Ok(yaml)
    }

    /// Takes in a line; an error says what is wrong with it.
    fn take(&mut self, line: usize, text: &'a str) -> Result<(), String> {
        let content = text.trim_start();
        if content.is_empty() || ["---", "..."].contains(&text) || text.starts_with('%') {
            return Ok(());
        }
        if let Some(element) = content.strip_prefix("- ") {
            let list = self.entries.last_mut().ok_or("a list element without a key above it")?;
            list.values.push(unquoted(element));
            return Ok(());
        }
        let entry = content.split_once(':').filter(|_| !text.starts_with(' '));
        let (key, value) = entry.ok_or_else(|| format!("\"{}\" is no key with a value", tame(content)))?;
        let key = key.trim_end();
        if self.find(key).is_some() {
            return Err(format!("`{}` stands here a second time", tame(key)));
        }
        let values = values(value.trim());
        let values = values.ok_or_else(|| format!("the list of `{}` does not end on its line", tame(key)))?;
        self.entries.push(Entry { line, key, values });
        Ok(())
    }

    /// Text that must be there.
    pub(super) fn text(&self, key: &str, example: &str) -> Result<String, FormatError> {
        let entry = self.find(key).ok_or_else(|| self.missing(key, example))?;
        match entry.values[..] {
            [value] if !value.is_empty() => Ok(value.to_owned()),
            _ => Err(self.wrong(key, "expected one value")),
        }
    }

    /// A number between two bounds, if it is there.
    pub(super) fn number(&self, key: &str, bounds: [f64; 2]) -> Result<Option<f64>, FormatError> {
        Ok(self.numbers::<1>(key, bounds)?.map(|[number]| number))
    }

    /// So many numbers, if they are there.
    pub(super) fn numbers<const N: usize>(
        &self,
        key: &str,
        [low, high]: [f64; 2],
    ) -> Result<Option<[f64; N]>, FormatError> {
        let Some(entry) = self.find(key) else { return Ok(None) };
        let number = |text: &&str| text.parse().ok().filter(|number: &f64| (low..=high).contains(number));
        let numbers: Option<Vec<f64>> = entry.values.iter().map(number).collect();
        let numbers = numbers.and_then(|numbers| <[f64; N]>::try_from(numbers).ok());
        let what = if N == 1 { "a number".to_owned() } else { format!("{N} numbers") };
        numbers.map(Some).ok_or_else(|| self.wrong(key, &format!("expected {what} from {low} to {high}")))
    }

    /// Yes or no, if it is there.
    pub(super) fn switch(&self, key: &str) -> Result<Option<bool>, FormatError> {
        match self.find(key).map(|entry| &entry.values[..]) {
            None => Ok(None),
            Some(["0" | "false" | "False" | "no"]) => Ok(Some(false)),
            Some(["1" | "true" | "True" | "yes"]) => Ok(Some(true)),
            Some(_) => Err(self.wrong(key, "expected 0 or 1")),
        }
    }

    /// The value of a key cannot be used.
    pub(super) fn wrong(&self, key: &str, problem: &str) -> FormatError {
        let (line, value) = self.find(key).map_or((0, String::new()), |it| (it.line, it.values.join(", ")));
        self.broken(line, format!("`{key}` is \"{}\": {problem}", tame(&value)))
    }

    /// A key that must be there is not.
    pub(super) fn missing(&self, key: &str, example: &str) -> FormatError {
        let known = [key.to_owned()];
        let meant = self.entries.iter().find(|entry| nearest(entry.key, &known).is_some());
        let meant = meant.map_or(String::new(), |entry| {
            format!(", but `{}` in line {}: did you mean `{key}`?", tame(entry.key), entry.line)
        });
        let problem = format!("no `{key}`, expected a line such as `{example}`{meant}");
        FormatError::Line { place: Place::file(self.file), problem, remedy: FORM }
    }

    fn find(&self, key: &str) -> Option<&Entry<'a>> {
        self.entries.iter().find(|entry| entry.key == key)
    }

    fn broken(&self, line: usize, problem: String) -> FormatError {
        FormatError::Line { place: Place::line(self.file, line), problem, remedy: FORM }
    }
}

/// What stands before a `#` that begins the line or follows a space, outside quotes.
fn without_comment(line: &str) -> &str {
    let (mut quote, mut before) = (None, ' ');
    for (index, letter) in line.char_indices() {
        match quote {
            Some(open) if open == letter => quote = None,
            Some(_) => {}
            None if letter == '#' && before.is_whitespace() => return &line[..index],
            None if letter == '"' || letter == '\'' => quote = Some(letter),
            None => {}
        }
        before = letter;
    }
    line
}

/// The elements of a list in brackets, or the one value; none of an empty value, whose elements may
/// follow below. `None` where a bracket is left open.
fn values(text: &str) -> Option<Vec<&str>> {
    match text.strip_prefix('[') {
        Some(list) => Some(list.strip_suffix(']')?.split(',').map(unquoted).collect()),
        None if text.is_empty() => Some(Vec::new()),
        None => Some(vec![unquoted(text)]),
    }
}

fn unquoted(text: &str) -> &str {
    let text = text.trim();
    let quoted = |mark: char| text.strip_prefix(mark)?.strip_suffix(mark);
    quoted('"').or_else(|| quoted('\'')).unwrap_or(text)
}
