//! The figures of the thesis's second and third chapters, drawn anew from real runs.
//!
//! None is a copy: each is a new run that shows what the figure of that number shows, made by the very
//! code that maps. Where a run does not show what the thesis saw, its caption says so. The [`curve`] of a
//! study that varies something is drawn in the same language.

mod corner;
mod corridor;
mod courses;
mod curve;
mod dead_ends;
mod draw;
mod environments;
mod exits;
mod forgetting;
mod maps;
mod matching;
mod mind;
mod movement;
mod network;
mod options;
mod outings;
mod placement;
mod plot;
mod propagation;
mod reference;
mod registry;
mod remembered;
mod route;
mod runs;
mod scan;
mod sight;
mod stage;
mod traditional;

pub use curve::curve;
pub use runs::Runs;

use cogmap_scene::{Panel, Plate};

/// A figure by its number in the thesis.
pub struct Figure {
    /// Its number, such as `3.14`.
    pub id: &'static str,
    /// What it is called.
    pub title: &'static str,
    /// What it shows, in a sentence or two.
    pub shows: &'static str,
    make: fn(&mut Runs) -> Result<Drawing, String>,
}

/// What a run gave for a figure.
struct Drawing {
    panels: Vec<Panel>,
    columns: usize,
    /// What came out in this run; stands behind what the figure shows.
    outcome: String,
    /// What was run.
    source: String,
}

impl Figure {
    /// Every figure, in the order of the thesis.
    pub fn all() -> impl Iterator<Item = &'static Self> {
        registry::FIGURES.into_iter().flatten()
    }

    /// The figure of that number.
    #[must_use]
    pub fn of(id: &str) -> Option<&'static Self> {
        Self::all().find(|figure| figure.id == id)
    }

    /// Makes the runs that it needs, unless another figure has made them, and draws it.
    ///
    /// # Errors
    /// Why a run did not come about.
    pub fn draw(&self, runs: &mut Runs) -> Result<Plate, String> {
        let drawing = (self.make)(runs)?;
        let caption = format!("{} {}", self.shows, drawing.outcome);
        Ok(Plate {
            title: format!("{}  {}", self.id, self.title),
            caption: caption.trim_end().to_owned(),
            source: format!(
                "A new run that shows what Fig. {} of the thesis shows: {}",
                self.id, drawing.source
            ),
            panels: drawing.panels,
            columns: drawing.columns,
            plots: false,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_unique_and_in_the_order_of_the_thesis() {
        let number =
            |figure: &Figure| -> Vec<u32> { figure.id.split('.').map(|n| n.parse().unwrap()).collect() };
        let numbers: Vec<_> = Figure::all().map(number).collect();
        assert!(numbers.is_sorted_by(|one, next| one < next));
    }

    #[test]
    fn every_figure_says_in_a_sentence_what_it_shows() {
        for figure in Figure::all() {
            assert!(figure.shows.ends_with('.') && !figure.shows.contains("  "), "{}", figure.id);
            assert!(!figure.title.ends_with('.'), "{}", figure.id);
        }
    }
}
