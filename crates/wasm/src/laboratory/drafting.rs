use cogmap_formats::world;
use cogmap_scene::{Camera, Sheet, plan_scene};
use serde::Deserialize;
use tsify::{Ts, Tsify};
use wasm_bindgen::{JsError, prelude::wasm_bindgen};
use web_sys::OffscreenCanvasRenderingContext2d;

use super::Laboratory;
use crate::{
    canvas::paint_once,
    draft::{Checked, Draft},
    failure::Failure,
    look::Look,
};

/// What a sheet shows of a draft, and how large it is.
#[derive(Clone, Copy, Debug, Deserialize, Tsify)]
#[serde(deny_unknown_fields)]
pub struct Frame {
    /// The point in its middle, metres.
    pub center: [f64; 2],
    /// Its scale.
    pub pixels_per_metre: f64,
    /// Pixels of the page.
    pub width: f64,
    /// Pixels of the page.
    pub height: f64,
    /// Pixels of the canvas to one of the page.
    pub density: f64,
}

/// Buildings that are drawn, before anything drives in them.
#[wasm_bindgen]
impl Laboratory {
    /// The building as it is at this moment, as a world file; a log has none.
    #[must_use]
    pub fn world_file(&self) -> Option<String> {
        self.run.session().world().map(world::write)
    }

    /// An empty sheet with a start.
    ///
    /// # Errors
    /// None that a page could cause.
    pub fn blank(name: String) -> Result<Ts<Draft>, JsError> {
        Ok(Draft::blank(name).into_ts()?)
    }

    /// The building of a world file, whether or not it can be driven in. `file` is its name, for messages.
    ///
    /// # Errors
    /// What keeps the text from being a world file, and where.
    pub fn draft(text: &str, file: &str) -> Result<Ts<Draft>, JsError> {
        Ok(Draft::of(world::parse(text, file).map_err(Failure::from)?).into_ts()?)
    }

    /// What is wrong with a drawn building, and its file.
    ///
    /// # Errors
    /// What is no draft.
    pub fn check(draft: &Ts<Draft>) -> Result<Ts<Checked>, JsError> {
        Ok(Checked::of(&draft.to_rust()?).into_ts()?)
    }

    /// Paints a drawn building on the sheet that it is drawn on.
    ///
    /// # Errors
    /// What is no draft, frame or look, and what the browser has against painting.
    pub fn paint_draft(
        draft: &Ts<Draft>,
        context: &OffscreenCanvasRenderingContext2d,
        look: &Ts<Look>,
        frame: &Ts<Frame>,
    ) -> Result<(), JsError> {
        let Frame { center, pixels_per_metre, width, height, density } = frame.to_rust()?;
        let Some(world) = draft.to_rust()?.world() else { return Ok(()) };
        let camera = Some(Camera { center: center.into(), pixels_per_metre });
        let look = look.to_rust()?.into();
        let sheet = Sheet { camera, title: false, legend: false, ..Sheet::new(width, height, look) };
        Ok(paint_once(context, &plan_scene(&world), &sheet, density).map_err(Failure::from)?)
    }
}
