use cogmap_geometry::{DVec2, Pose};
use cogmap_scene::{segment_of, thing_at};
use tsify::{Ts, Tsify};
use wasm_bindgen::{JsError, prelude::wasm_bindgen};

use super::Laboratory;
use crate::{
    contents::Contents,
    remembered::{Remembered, Walk, walked},
    story::Told,
    views::View,
};

/// What of a memory is pointed at, and what is told about it.
#[wasm_bindgen]
impl Laboratory {
    /// The thing of a memory that its view shows within `reach` pixels of a pixel.
    ///
    /// # Errors
    /// What is no view.
    pub fn pick(
        &self,
        view: &Ts<View>,
        x: f64,
        y: f64,
        reach: f64,
    ) -> Result<Option<Ts<Remembered>>, JsError> {
        let picked = self.picked(view.to_rust()?, DVec2::new(x, y), reach);
        Ok(picked.map(|thing| thing.into_ts()).transpose()?)
    }

    /// The thing that a walk through a memory leads to from another one, or from where the robot is.
    ///
    /// # Errors
    /// What is no view, no thing or no walk.
    #[allow(clippy::needless_pass_by_value, reason = "an optional value can cross in no other form")]
    pub fn walk(
        &self,
        view: &Ts<View>,
        from: Option<Ts<Remembered>>,
        walk: &Ts<Walk>,
    ) -> Result<Option<Ts<Remembered>>, JsError> {
        let (view, walk) = (view.to_rust()?, walk.to_rust()?);
        let from = from.map(|from| from.to_rust()).transpose()?;
        let there = view.mapper().and_then(|mapper| walked(self.run.session(), mapper, from, walk));
        Ok(there.map(|thing| Remembered::from(thing).into_ts()).transpose()?)
    }

    /// Sets a thing of a memory off in its view; without one, none any longer. `false` if nothing has changed by it.
    ///
    /// # Errors
    /// What is no view or no thing.
    #[allow(clippy::needless_pass_by_value, reason = "an optional value can cross in no other form")]
    pub fn set_off(&mut self, view: &Ts<View>, thing: Option<Ts<Remembered>>) -> Result<bool, JsError> {
        let view = view.to_rust()?;
        let thing = thing.map(|thing| thing.to_rust()).transpose()?.map(|thing| (view, thing));
        let before = std::mem::replace(&mut self.set_off, thing);
        Ok(before != thing)
    }

    /// What is known about the thing that is set off; nothing where none is, or it is not in mind at this moment.
    ///
    /// # Errors
    /// None that a page could cause.
    pub fn told(&self) -> Result<Option<Ts<Told>>, JsError> {
        Ok(self.story().map(|told| told.into_ts()).transpose()?)
    }

    /// What the memory in a view holds, with at most so many surfaces of each local space; nothing where there
    /// is no memory.
    ///
    /// # Errors
    /// What is no view.
    pub fn contents(&self, view: &Ts<View>, most: usize) -> Result<Option<Ts<Contents>>, JsError> {
        let contents = view.to_rust()?.mapper().and_then(|mapper| self.run.contents(mapper, most));
        Ok(contents.map(|contents| contents.into_ts()).transpose()?)
    }
}

impl Laboratory {
    fn picked(&self, view: View, pixel: DVec2, reach: f64) -> Option<Remembered> {
        let mapper = view.mapper()?;
        let [at, beside] = [pixel, pixel + DVec2::new(reach, 0.0)].map(|p| self.views.to_metres(view, p));
        let at_in_map = self.view_from_map(view, mapper).inverse() * at;
        let mind = self.run.session().mappers().get(mapper)?;
        thing_at(mind, self.shown, at_in_map, at.distance(beside)).map(Remembered::from)
    }

    fn story(&self) -> Option<Told> {
        let (view, thing) = self.set_off?;
        let mapper = view.mapper()?;
        let facts = self.run.facts(mapper, thing.into())?;
        let segment = segment_of(self.run.session().mappers().get(mapper)?, thing.into())?;
        let DVec2 { x, y } =
            self.views.to_pixels(view, self.view_from_map(view, mapper) * segment.midpoint());
        Some(Told { thing, x, y, facts })
    }

    /// How the map of a mapper lies in what its view shows.
    pub(super) fn view_from_map(&self, view: View, mapper: usize) -> Pose {
        let session = self.run.session();
        let middle = self.views.camera(view).center;
        let place = self.stance.view_from_map(session, mapper, middle);
        place.or(crate::scenes::shared_from_map(session, mapper)).unwrap_or(Pose::IDENTITY)
    }
}
