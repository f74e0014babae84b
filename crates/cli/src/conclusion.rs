use cogmap_formats::carmen::Counts;
use cogmap_formats::run::{Extras, file_name, files, labels};
use cogmap_scene::{MemoryOptions, Scene, Sheet, Theme, memory_scene, png, svg};
use cogmap_simulation::Session;

use crate::failure::Failure;
use crate::homing;
use crate::output::Output;
use crate::records::Records;
use crate::summary;
use crate::terminal;
use crate::timing::Timing;

/// Pixels across a picture.
const WIDTH: f64 = 1600.0;
/// Pixels from top to bottom of a picture, at least and at most.
const HEIGHTS: [f64; 2] = [700.0, 2400.0];
/// Pixels for title and legend.
const FURNITURE: f64 = 200.0;

/// A run that is over, and where its user wants it.
pub(crate) struct Conclusion<'a> {
    /// The run.
    pub(crate) session: &'a Session,
    /// What was done, for people.
    pub(crate) title: &'a str,
    /// Where the files go, if they are wanted.
    pub(crate) output: Option<&'a Output>,
    /// The odometry between the scans.
    pub(crate) records: &'a Records,
    /// What the log's lines were.
    pub(crate) counts: Option<&'a Counts>,
}

impl Conclusion<'_> {
    /// Writes the files and says what came out.
    pub(crate) fn draw(&self, mut timing: Timing) -> Result<(), Failure> {
        let mut said = summary::of(self.title, self.session, timing.total());
        said += &homing::summary(self.session);
        said += &match self.output {
            Some(output) => {
                let mut files = self.texts();
                timing.done("write the map");
                files.extend(self.pictures());
                timing.done("paint");
                output.write_all(&files)?;
                timing.done("store");
                output.write("timing.json", timing.to_json().as_bytes())?;
                summary::of_files(output.directory(), &files)
            }
            None => {
                "\nNothing was kept: add --out DIR for the map, the trajectories and the session.\n".into()
            }
        };
        terminal::say(&said)
    }

    fn texts(&self) -> Vec<(String, Vec<u8>)> {
        let extras = Extras { dense: self.records.list(), log: self.counts };
        files(self.session, extras).into_iter().map(|file| (file.name, file.text.into_bytes())).collect()
    }

    /// The map of each mapper, as SVG and as PNG.
    fn pictures(&self) -> Vec<(String, Vec<u8>)> {
        let mut pictures = Vec::new();
        for (index, label) in labels(self.session.record()).iter().enumerate() {
            let scene = memory_scene(self.session, index, MemoryOptions::default());
            let sheet = sheet_for(&scene);
            pictures.push((file_name("map", label, "svg"), svg::paint(&scene, &sheet).into_bytes()));
            pictures.extend(png::paint(&scene, &sheet, 1.0).map(|png| (file_name("map", label, "png"), png)));
        }
        pictures
    }
}

/// A sheet as high as the map wants it.
fn sheet_for(scene: &Scene) -> Sheet {
    let shape = scene.bounds().map_or(1.0, |bounds| {
        let size = bounds.max - bounds.min;
        if size.x > 0.0 { size.y / size.x } else { 1.0 }
    });
    let height = (WIDTH * shape + FURNITURE).clamp(HEIGHTS[0], HEIGHTS[1]).round();
    Sheet::new(WIDTH, height, Theme::Light)
}
