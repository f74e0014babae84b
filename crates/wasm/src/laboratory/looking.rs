use std::rc::Rc;

use cogmap_geometry::{DVec2, Pose};
use cogmap_scene::{Bounds, MemoryOptions, Scene, Sheet};
use tsify::{Ts, Tsify};
use wasm_bindgen::{JsError, prelude::wasm_bindgen};
use web_sys::OffscreenCanvasRenderingContext2d;

use super::{Laboratory, all_views};
use crate::{
    canvas::{Canvas, Place},
    captions::Captions,
    explaining::explanation,
    explanation::{Explanation, StageKind},
    failure::Failure,
    layers::Layers,
    look::Look,
    scenes::{accentuate, explained, scene, with_drawn_way, with_left_ways},
    stance::Stance,
    views::View,
};

/// What was made for a view, to be painted.
#[derive(Clone, Debug)]
pub(super) struct Seen {
    scene: Rc<Scene>,
    bounds: Option<Bounds>,
    of: Whole,
}

/// Everything that what a view shows depends on.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Whole {
    /// Of the run.
    changes: u64,
    shown: MemoryOptions,
    pointed: Option<StageKind>,
    view_from_map: Option<Pose>,
}

/// What the views show, and how it is painted.
#[wasm_bindgen]
impl Laboratory {
    /// Tells how large a view is, in pixels of the page.
    ///
    /// # Errors
    /// What is no view.
    pub fn resize(&mut self, view: &Ts<View>, width: f64, height: f64) -> Result<(), JsError> {
        self.views.resize(view.to_rust()?, DVec2::new(width, height));
        Ok(())
    }

    /// Tells that a view has left the page.
    ///
    /// # Errors
    /// What is no view.
    pub fn close(&mut self, view: &Ts<View>) -> Result<(), JsError> {
        let view = view.to_rust()?;
        self.views.close(view);
        self.canvases.remove(&view);
        self.seen.remove(&view);
        Ok(())
    }

    /// Moves what all views show by so many pixels of one of them.
    ///
    /// # Errors
    /// What is no view.
    pub fn drag(&mut self, x: f64, y: f64, view: &Ts<View>) -> Result<(), JsError> {
        self.views.drag(DVec2::new(x, y), view.to_rust()?);
        Ok(())
    }

    /// Zooms all views by a factor, about a pixel of one of them or about the middle.
    ///
    /// # Errors
    /// What is no view.
    pub fn zoom(
        &mut self,
        factor: f64,
        view: &Ts<View>,
        x: Option<f64>,
        y: Option<f64>,
    ) -> Result<(), JsError> {
        let pixel = x.zip(y).map(|(x, y)| DVec2::new(x, y));
        self.views.zoom(factor, view.to_rust()?, pixel);
        Ok(())
    }

    /// Chooses what is shown of the memories.
    ///
    /// # Errors
    /// What is no layer.
    pub fn show(&mut self, layers: &Ts<Layers>) -> Result<(), JsError> {
        let layers = layers.to_rust()?;
        self.stance = layers.stance;
        self.shown = layers.into();
        Ok(())
    }

    /// Words the legends in another language: what they say in English, `{}` for a number, and what they are to say.
    pub fn word_legend(&mut self, english: Vec<String>, words: Vec<String>) {
        self.captions = Captions::new(english, words);
        self.seen.clear();
    }

    /// Why the memory in a view is as it is: its latest step taken apart; nothing where there is no step.
    ///
    /// # Errors
    /// What is no view.
    pub fn explain(&self, view: &Ts<View>) -> Result<Option<Ts<Explanation>>, JsError> {
        let mapper = view.to_rust()?.mapper();
        let explanation = mapper.and_then(|mapper| explanation(self.run.session(), mapper));
        Ok(explanation.map(|explanation| explanation.into_ts()).transpose()?)
    }

    /// Points out in a view what a stage of its latest step is about; without a stage, nothing.
    ///
    /// # Errors
    /// What is no view or no stage.
    #[allow(clippy::needless_pass_by_value, reason = "an optional value can cross in no other form")]
    pub fn point_out(&mut self, view: &Ts<View>, stage: Option<Ts<StageKind>>) -> Result<(), JsError> {
        let view = view.to_rust()?;
        self.pointed = stage.map(|stage| stage.to_rust()).transpose()?.map(|stage| (view, stage));
        Ok(())
    }

    /// Shows everything again.
    pub fn fit(&mut self) {
        self.views.fit();
    }

    /// Paints a view on its canvas, which has `density` pixels to one of the page. `true` if room had to be
    /// made, so that what was painted of other views before shows too little.
    ///
    /// # Errors
    /// What is no view or no look, and what the browser has against painting.
    pub fn paint(
        &mut self,
        view: &Ts<View>,
        context: &OffscreenCanvasRenderingContext2d,
        look: &Ts<Look>,
        density: f64,
    ) -> Result<bool, JsError> {
        let (view, look) = (view.to_rust()?, look.to_rust()?);
        let Seen { mut scene, bounds, .. } = self.seen(view);
        let DVec2 { x: width, y: height } = self.views.size(view);
        let legend = self.views.has_legend(view);
        let sheet =
            Sheet { width, height, theme: look.into(), camera: None, title: false, legend, scale_bar: true };
        let before = self.views.shared_camera();
        // What moves around the robot goes where it will.
        if view.mapper().is_none() || self.stance == Stance::Map {
            self.views.make_room(bounds);
        }
        self.views.make_room_for_legend(sheet.strip(&scene));
        // What is set off has no room made for it: the picture would jump under whoever points.
        self.accentuate(view, &mut scene);
        let camera = self.views.camera(view);
        let place = Place { corner: DVec2::ZERO, density };
        let canvas = self.canvases.entry(view).or_default();
        let sheet = Sheet { camera: Some(camera), ..sheet };
        canvas.paint(context, &scene, &sheet, place).map_err(Failure::from)?;
        Ok(self.views.shared_camera() != before)
    }

    /// Paints the world and every memory in a row, with titles and legends, each in a square of that
    /// many pixels of the page.
    ///
    /// # Errors
    /// What is no look, and what the browser has against painting.
    pub fn picture(
        &self,
        context: &OffscreenCanvasRenderingContext2d,
        look: &Ts<Look>,
        side: f64,
        density: f64,
    ) -> Result<(), JsError> {
        let sheet = Sheet::new(side, side, look.to_rust()?.into());
        for (index, view) in all_views(&self.run).enumerate() {
            let place = Place { corner: DVec2::new(side * index as f64, 0.0), density };
            let scene = scene(self.run.session(), view, self.shown).into();
            Canvas::default().paint(context, &scene, &sheet, place).map_err(Failure::from)?;
        }
        Ok(())
    }
}

impl Laboratory {
    /// What a view shows at this moment; while nothing has changed but the camera, what was made for it before.
    fn seen(&mut self, view: View) -> Seen {
        let of = Whole {
            changes: self.run.changes(),
            shown: self.shown,
            pointed: self.pointed.filter(|(pointed, _)| *pointed == view).map(|(_, stage)| stage),
            view_from_map: view.mapper().map(|mapper| self.view_from_map(view, mapper)),
        };
        if let Some(seen) = self.seen.get(&view).filter(|seen| seen.of == of) {
            return seen.clone();
        }
        let mut scene = self.scene(view, &of);
        self.captions.put(&mut scene);
        let seen = Seen { bounds: scene.bounds(), scene: scene.into(), of };
        self.seen.insert(view, seen.clone());
        seen
    }

    fn scene(&self, view: View, of: &Whole) -> Scene {
        let session = self.run.session();
        let Some(mapper) = view.mapper() else {
            let scene = with_left_ways(scene(session, view, self.shown), self.run.left_ways());
            return with_drawn_way(scene, &self.run.way_ahead());
        };
        let scene = explained(session, mapper, of.pointed.map(StageKind::stage), self.shown);
        scene.seen_from(of.view_from_map.unwrap_or(Pose::IDENTITY))
    }

    /// Sets off in the picture of a view what is to be set off in it.
    fn accentuate(&self, view: View, scene: &mut Rc<Scene>) {
        let set_off_here = self.set_off.filter(|(other, _)| *other == view);
        if let (Some(mapper), Some((_, thing))) = (view.mapper(), set_off_here) {
            let (scene, view_from_map) = (Rc::make_mut(scene), self.view_from_map(view, mapper));
            accentuate(scene, self.run.session(), mapper, thing.into(), view_from_map);
        }
    }
}
