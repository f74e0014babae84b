use std::fmt;

use cogmap_formats::FormatError;
use cogmap_simulation::Problem;
use js_sys::Error;
use wasm_bindgen::{JsCast, JsError, JsValue};

/// Why the page could not have what it asked for, in words for whoever uses it.
#[derive(Debug, PartialEq)]
pub(crate) struct Failure(String);

impl Failure {
    pub(crate) fn new(reason: &impl fmt::Display) -> Self {
        Self(reason.to_string())
    }
}

impl From<FormatError> for Failure {
    fn from(error: FormatError) -> Self {
        Self::new(&error)
    }
}

/// Everything that is wrong with a world or a session, a line each.
impl From<Vec<Problem>> for Failure {
    fn from(problems: Vec<Problem>) -> Self {
        let lines: Vec<_> =
            problems.iter().map(|Problem { place, message }| format!("{place}: {message}")).collect();
        Self(lines.join("\n"))
    }
}

/// What a browser throws.
impl From<JsValue> for Failure {
    fn from(thrown: JsValue) -> Self {
        let message = thrown.dyn_ref::<Error>().map(|error| String::from(error.message()));
        Self(message.or_else(|| thrown.as_string()).unwrap_or_else(|| "the browser refused".to_owned()))
    }
}

impl fmt::Display for Failure {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(&self.0)
    }
}

/// The one way in which an error reaches the page: as an `Error` with the message.
impl From<Failure> for JsError {
    fn from(failure: Failure) -> Self {
        Self::new(&failure.0)
    }
}
