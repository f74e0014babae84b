use tsify::Ts;
use wasm_bindgen::{JsError, prelude::wasm_bindgen};

use crate::{
    laboratory::Laboratory,
    resumption::{self, Kept},
};

/// What links hold and what a browser keeps of a run, and how it is taken up again.
#[wasm_bindgen]
impl Laboratory {
    /// A run at the moment at which it was left, once [`Laboratory::resume_turn`] has gone through what happened
    /// until then. A log's run needs that log.
    ///
    /// # Errors
    /// What is wrong with the situation, and where.
    #[allow(clippy::needless_pass_by_value, reason = "an optional array can cross in no other form")]
    pub fn resume(kept: &Ts<Kept>, log: Option<Vec<u8>>) -> Result<Self, JsError> {
        console_error_panic_hook::set_once();
        Ok(Self::of(resumption::resume(&kept.to_rust()?, log.as_deref())?))
    }

    /// One more turn of what has to be gone through again; `false` once the run is where it was left.
    pub fn resume_turn(&mut self) -> bool {
        self.run.resume()
    }

    /// This run at this moment, as text from which [`Laboratory::resume`] takes it up again.
    #[must_use]
    pub fn situation(&self) -> String {
        self.run.situation()
    }

    /// The name under which the page knows the building, where it does.
    #[wasm_bindgen(getter)]
    #[must_use]
    pub fn building(&self) -> Option<String> {
        self.run.label().building.clone()
    }

    /// What may make this run differ from the recorded one, each a sentence.
    #[wasm_bindgen(getter)]
    #[must_use]
    pub fn warnings(&self) -> Vec<String> {
        self.run.label().warnings.clone()
    }
}
