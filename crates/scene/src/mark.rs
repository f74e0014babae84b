use cogmap_geometry::DVec2;

use crate::{Colour, theme::Stroke};

/// Something to put on the screen, in pixels from the upper left corner, y down.
#[derive(Clone, Debug, PartialEq)]
pub enum Mark {
    /// Lines that do not hang together.
    Lines {
        /// How they are drawn.
        stroke: Stroke,
        /// Both ends of each.
        lines: Vec<[DVec2; 2]>,
    },
    /// A line through points, or the area within.
    Path {
        /// Its corners.
        points: Vec<DVec2>,
        /// Whether the last point leads back to the first.
        closed: bool,
        /// What is within.
        fill: Option<Colour>,
        /// What goes along it.
        stroke: Option<Stroke>,
    },
    /// Round areas that look alike.
    Circles {
        /// Centre and radius of each.
        circles: Vec<(DVec2, f64)>,
        /// What is within.
        fill: Option<Colour>,
        /// What goes around.
        stroke: Option<Stroke>,
    },
    /// A line of text.
    Text {
        /// Left end of its base line, or the middle or right end as `anchor` says.
        at: DVec2,
        /// What it says.
        text: String,
        /// Height of the font, pixels.
        size: f64,
        /// Which part of the text `at` means.
        anchor: Anchor,
        /// Its colour.
        colour: Colour,
        /// A rim of that colour that sets it off from what lies beneath.
        halo: Option<Colour>,
    },
}

impl Mark {
    /// Moves it by so many pixels.
    pub(crate) fn shift(&mut self, by: DVec2) {
        match self {
            Self::Lines { lines, .. } => lines.iter_mut().flatten().for_each(|point| *point += by),
            Self::Path { points, .. } => points.iter_mut().for_each(|point| *point += by),
            Self::Circles { circles, .. } => circles.iter_mut().for_each(|(center, _)| *center += by),
            Self::Text { at, .. } => *at += by,
        }
    }
}

/// Which part of a text stands at its place.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Anchor {
    /// Its left end.
    Start,
    /// Its middle.
    Middle,
}

/// Width of the rim around text with a halo, pixels to each side.
pub const HALO: f64 = 2.0;
