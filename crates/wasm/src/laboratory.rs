mod drafting;
mod looking;
mod plotting;
mod pointing;
mod saving;

use std::collections::BTreeMap;

use cogmap_geometry::DVec2;
use cogmap_scene::MemoryOptions;
use tsify::{Ts, Tsify};
use wasm_bindgen::{JsError, prelude::wasm_bindgen};

use looking::Seen;

use crate::{
    alteration::{Alteration, Objection, Pointer},
    canvas::Canvas,
    captions::Captions,
    explanation::StageKind,
    landmarks::Landmark,
    opening,
    order::Order,
    remembered::Remembered,
    run::Run,
    scenes::scene,
    setup::{Choices, Opening, Setup},
    stance::Stance,
    status::Status,
    tracked::Tracked,
    views::{View, Views},
    ways::Followed,
};

/// What is no farther than this from where a person points is meant, pixels of the page.
const FINGER: f64 = 22.0;

/// The laboratory as the page knows it: a run, and views of it.
#[wasm_bindgen]
pub struct Laboratory {
    pub(crate) run: Tracked<Run>,
    views: Views,
    shown: MemoryOptions,
    stance: Stance,
    /// The stage of the latest step that is pointed out, and in which view.
    pointed: Option<(View, StageKind)>,
    /// The thing of a memory that is set off from the rest, and in which view.
    set_off: Option<(View, Remembered)>,
    canvases: BTreeMap<View, Canvas>,
    captions: Captions,
    /// What was made for each view last.
    seen: BTreeMap<View, Seen>,
}

#[wasm_bindgen]
impl Laboratory {
    /// What a run can be made of.
    ///
    /// # Errors
    /// None that a page could cause.
    pub fn choices() -> Result<Ts<Choices>, JsError> {
        Ok(Choices::all().into_ts()?)
    }

    /// A run in a building, the robot about to be driven along the building's first route.
    ///
    /// # Errors
    /// What is wrong with the set-up or with the world file, and where.
    #[wasm_bindgen(constructor)]
    pub fn new(setup: &Ts<Setup>) -> Result<Self, JsError> {
        console_error_panic_hook::set_once();
        Ok(Self::of(opening::start(&setup.to_rust()?)?))
    }

    /// What somebody brought: a recorded log, a session or a world. A session that was made from a
    /// log needs that log beside it.
    ///
    /// # Errors
    /// What is wrong with the file, and where.
    #[allow(clippy::needless_pass_by_value, reason = "an optional array can cross in no other form")]
    pub fn open(opening: &Ts<Opening>, bytes: &[u8], other: Option<Vec<u8>>) -> Result<Self, JsError> {
        console_error_panic_hook::set_once();
        Ok(Self::of(opening::open(&opening.to_rust()?, bytes, other.as_deref())?))
    }

    /// One turn of the world: a tick of a drive, a reading of a log. `false` if nothing is left to happen.
    pub fn advance(&mut self) -> bool {
        self.run.advance()
    }

    /// Goes on until the memory has taken in another view, or nothing is left to happen.
    pub fn advance_to_next_view(&mut self) {
        self.run.advance_to_next_view();
    }

    /// Goes back to when the view before the latest was taken.
    pub fn back_to_previous_view(&mut self) {
        self.run.back_to_previous_view();
    }

    /// Goes to any moment of the run, in ticks or readings.
    pub fn jump(&mut self, position: f64) {
        self.run.jump(position as u64);
    }

    /// Seconds since the beginning.
    #[wasm_bindgen(getter)]
    pub fn time(&self) -> f64 {
        self.run.session().time()
    }

    /// Whether nothing will happen until an order comes.
    #[wasm_bindgen(getter)]
    pub fn idle(&self) -> bool {
        self.run.idle()
    }

    /// What the run looks like at this moment.
    ///
    /// # Errors
    /// None that a page could cause.
    pub fn status(&self) -> Result<Ts<Status>, JsError> {
        Ok(self.run.status().into_ts()?)
    }

    /// What the timeline marks, in order, as far as the run has ever come.
    ///
    /// # Errors
    /// None that a page could cause.
    pub fn landmarks(&mut self) -> Result<Vec<Ts<Landmark>>, JsError> {
        Ok(self.run.behind_the_scenes().landmarks().iter().map(Tsify::into_ts).collect::<Result<_, _>>()?)
    }

    /// Tells the robot what to do.
    ///
    /// # Errors
    /// What is no order, or no strategy.
    pub fn order(&mut self, order: &Ts<Order>) -> Result<(), JsError> {
        Ok(self.run.order(order.to_rust()?)?)
    }

    /// Changes something in the building, or carries the robot off. What is answered says why nothing was changed.
    ///
    /// # Errors
    /// What is no alteration.
    pub fn alter(&mut self, alteration: &Ts<Alteration>) -> Result<Option<Ts<Objection>>, JsError> {
        let Self { run, views, .. } = self;
        let objection = run.alter(&alteration.to_rust()?, |pixel| {
            let [at, beside] =
                [pixel, pixel + DVec2::new(FINGER, 0.0)].map(|p| views.to_metres(View::World, p));
            Pointer { at, reach: at.distance(beside) }
        });
        Ok(objection.map(|objection| objection.into_ts()).transpose()?)
    }

    /// Takes back the last thing that a person told the robot; `false` if there is none.
    pub fn undo(&mut self) -> bool {
        self.run.undo()
    }

    /// Does again what was undone; `false` if there is nothing.
    pub fn redo(&mut self) -> bool {
        self.run.redo()
    }

    /// Goes over to another future that was left, at the same moment if it lasts so long.
    pub fn switch_branch(&mut self) {
        self.run.switch_branch();
    }

    /// Ends the playing of the route: the robot finishes its step and waits for orders.
    pub fn take_over(&mut self) {
        self.run.take_over();
    }

    /// Sends the robot straight to what the view of the world shows at a pixel; `false` if it cannot be sent there.
    pub fn reach(&mut self, x: f64, y: f64) -> bool {
        self.run.reach(self.views.to_metres(View::World, DVec2::new(x, y)))
    }

    /// Sends the robot along a line that somebody drew in the view of the world: the pixels of its points, x and y in
    /// turns. What is answered says what becomes of it.
    ///
    /// # Errors
    /// None that a page could cause.
    pub fn follow(&mut self, line: &[f64]) -> Result<Ts<Followed>, JsError> {
        let pixels = line.as_chunks::<2>().0.iter().map(|&[x, y]| DVec2::new(x, y));
        let line: Vec<_> = pixels.map(|pixel| self.views.to_metres(View::World, pixel)).collect();
        Ok(self.run.follow(&line).into_ts()?)
    }

    /// Lets other mappers take in the run: a drive goes on from this moment, a log from its beginning.
    ///
    /// # Errors
    /// What is no mapper.
    #[allow(clippy::needless_pass_by_value, reason = "a list can cross in no other form")]
    pub fn remap(&mut self, mappers: Vec<String>) -> Result<(), JsError> {
        Ok(self.run.remap(opening::mappers(&mappers)?)?)
    }
}

impl Laboratory {
    pub(crate) fn of(run: Run) -> Self {
        let mut views = Views::new();
        let shown = MemoryOptions::default();
        for view in all_views(&run) {
            views.make_room(scene(run.session(), view, shown).bounds());
        }
        Self {
            run: Tracked::new(run),
            views,
            shown,
            stance: Stance::Map,
            pointed: None,
            set_off: None,
            canvases: BTreeMap::new(),
            captions: Captions::default(),
            seen: BTreeMap::new(),
        }
    }
}

/// The world, and a memory for each mapper.
fn all_views(run: &Run) -> impl Iterator<Item = View> {
    std::iter::once(View::World).chain(View::MEMORIES.into_iter().take(run.session().mappers().len()))
}
