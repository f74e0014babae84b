use cogmap_formats::{
    run::{Extras, files, map, table},
    session,
};
use cogmap_scene::{Panel, Plate, svg};
use serde::Serialize;
use tsify::{Ts, Tsify};
use wasm_bindgen::{JsError, prelude::wasm_bindgen};

use super::{Laboratory, all_views};
use crate::{look::Look, scenes::scene, views::View};

/// A drawing is so wide for each of its views, in pixels of a page.
const WIDTH: f64 = 800.0;

/// A text file that somebody saves.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Tsify)]
pub struct TextFile {
    /// What it is called.
    pub name: String,
    /// What it holds.
    pub text: String,
}

/// What can be taken away from a run at this moment.
#[wasm_bindgen]
impl Laboratory {
    /// The session as a file: opening it gives this run again, to the last bit.
    #[must_use]
    pub fn save_session(&self) -> String {
        session::write(self.run.session().record())
    }

    /// The map of one of the mappers, counted from 0, as a file; empty where there is no such mapper.
    #[must_use]
    pub fn map_json(&self, mapper: usize) -> String {
        map(self.run.session(), mapper)
    }

    /// Where the robot was and where it and its mappers believed to be, as CSV.
    #[must_use]
    pub fn table(&self) -> String {
        table(self.run.session())
    }

    /// The world and every memory as one SVG document, with titles and a legend.
    ///
    /// # Errors
    /// What is no look.
    pub fn drawing(&self, look: &Ts<Look>) -> Result<String, JsError> {
        Ok(self.drawn(look.to_rust()?))
    }

    /// The text files that the command line keeps of a run, and the table.
    ///
    /// # Errors
    /// None that a page could cause.
    pub fn text_files(&self) -> Result<Vec<Ts<TextFile>>, JsError> {
        Ok(self.texts().iter().map(Tsify::into_ts).collect::<Result<_, _>>()?)
    }
}

impl Laboratory {
    fn texts(&self) -> Vec<TextFile> {
        let session = self.run.session();
        let kept = files(session, Extras::default()).into_iter();
        let mut texts: Vec<TextFile> =
            kept.map(|file| TextFile { name: file.name, text: file.text }).collect();
        texts.push(TextFile { name: "table.csv".to_owned(), text: self.table() });
        texts
    }

    fn drawn(&self, look: Look) -> String {
        let panel = |view: View| {
            let scene = scene(self.run.session(), view, self.shown);
            let heading = view.mapper().map_or("The world".to_owned(), |_| scene.title.clone());
            Panel { heading, scene, room: None }
        };
        let panels: Vec<Panel> = all_views(&self.run).map(panel).collect();
        let status = self.run.status();
        let robot =
            status.robot.map_or(String::new(), |robot| format!("The {robot} robot, seed {}, ", status.seed));
        let plate = Plate {
            title: status.name,
            caption: format!("{robot}{:.0} s after the beginning.", status.time),
            columns: panels.len(),
            panels,
            ..Plate::default()
        };
        let picture = plate.picture(WIDTH * plate.columns as f64, look.into());
        svg::document(&picture, &plate.title, &plate.caption)
    }
}
