use tsify::{Ts, Tsify};
use wasm_bindgen::{JsError, prelude::wasm_bindgen};

use super::Laboratory;
use crate::{plots::Plots, schematic::Schematic, views::View};

/// What of a run can be plotted, and its places as a schematic.
#[wasm_bindgen]
impl Laboratory {
    /// What can be plotted, as far as the run has ever come. Only what is new since the last time is worked out.
    ///
    /// # Errors
    /// None that a page could cause.
    pub fn plots(&mut self) -> Result<Ts<Plots>, JsError> {
        Ok(self.run.behind_the_scenes().plots().into_ts()?)
    }

    /// The network of local spaces in a view as a schematic; nothing where the view shows none.
    ///
    /// # Errors
    /// What is no view.
    pub fn schematic(&self, view: &Ts<View>) -> Result<Option<Ts<Schematic>>, JsError> {
        let schematic = view.to_rust()?.mapper().and_then(|mapper| self.run.schematic(mapper));
        Ok(schematic.map(|schematic| schematic.into_ts()).transpose()?)
    }
}
