use cogmap_geometry::DVec2;

use crate::{
    Bounds, Camera, Colour, Item, Margins, Mark, Scene, Theme, brush::Brush, font::text_width, footer::Footer,
};

/// What a scene is painted on.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sheet {
    /// Pixels.
    pub width: f64,
    /// Pixels.
    pub height: f64,
    /// Its ground and colours.
    pub theme: Theme,
    /// What it shows; `None` shows the whole scene.
    pub camera: Option<Camera>,
    /// Whether the scene's title stands above.
    pub title: bool,
    /// Whether the legend stands below; the scale bar is always there.
    pub legend: bool,
}

impl Sheet {
    /// A sheet that shows the whole scene with its title and legend.
    #[must_use]
    pub fn new(width: f64, height: f64, theme: Theme) -> Self {
        Self { width, height, theme, camera: None, title: true, legend: true }
    }

    /// The view that shows `bounds` and leaves room for title and legend.
    #[must_use]
    pub fn fit(&self, scene: &Scene, bounds: Bounds) -> Camera {
        let footer = Footer::of(scene, self);
        let top = if self.title { TITLE_HEIGHT } else { MARGIN };
        let margins = Margins { top, bottom: footer.height + MARGIN, side: MARGIN };
        Camera::fit(bounds, self.width, self.height, margins)
    }

    /// What it shows of a scene.
    #[must_use]
    pub fn camera_for(&self, scene: &Scene) -> Camera {
        let whole = || self.fit(scene, scene.bounds().unwrap_or(EMPTY));
        self.camera.unwrap_or_else(whole)
    }
}

/// What an empty scene shows.
const EMPTY: Bounds = Bounds { min: DVec2::new(-4.0, -3.0), max: DVec2::new(4.0, 3.0) };
/// Pixels around the map.
pub(crate) const MARGIN: f64 = 24.0;
/// Pixels above the map when a title stands there.
const TITLE_HEIGHT: f64 = 76.0;

/// A scene laid out on a sheet: what painters put on the screen, in order.
#[derive(Clone, Debug, PartialEq)]
pub struct Picture {
    /// Pixels.
    pub width: f64,
    /// Pixels.
    pub height: f64,
    /// The ground.
    pub paper: Colour,
    /// From the ground up.
    pub marks: Vec<Mark>,
}

impl Picture {
    /// Lays a scene out on a sheet.
    #[must_use]
    pub fn of(scene: &Scene, sheet: &Sheet) -> Self {
        let mut marks = Self::still(scene, sheet);
        marks.extend(Self::changing(scene, sheet));
        marks.extend(Self::surround(scene, sheet));
        Self { width: sheet.width, height: sheet.height, paper: sheet.theme.paper(), marks }
    }

    /// The lowest part: what stays as it is as long as neither the still items nor the sheet change.
    #[must_use]
    pub fn still(scene: &Scene, sheet: &Sheet) -> Vec<Mark> {
        items(&scene.still, scene, sheet)
    }

    /// What lies above it and changes all the time.
    #[must_use]
    pub fn changing(scene: &Scene, sheet: &Sheet) -> Vec<Mark> {
        items(&scene.changing, scene, sheet)
    }

    /// What surrounds the map: title, scale bar and legend.
    #[must_use]
    pub fn surround(scene: &Scene, sheet: &Sheet) -> Vec<Mark> {
        let mut brush = Brush::new(scene, sheet);
        title(&mut brush, scene, sheet);
        Footer::of(scene, sheet).draw(&mut brush, scene);
        brush.marks
    }
}

fn items(items: &[Item], scene: &Scene, sheet: &Sheet) -> Vec<Mark> {
    let mut brush = Brush::new(scene, sheet);
    for item in items {
        brush.item(item);
    }
    brush.marks
}

fn title(brush: &mut Brush, scene: &Scene, sheet: &Sheet) {
    if sheet.title {
        let palette = sheet.theme.palette();
        let room = sheet.width - 2.0 * MARGIN;
        brush.text(DVec2::new(MARGIN, 38.0), &shortened(&scene.title, 17.0, room), 17.0, palette.ink);
        brush.text(DVec2::new(MARGIN, 58.0), &shortened(&scene.note, 12.0, room), 12.0, palette.muted);
    }
}

/// The text, or its beginning with an ellipsis where it is wider than `room` pixels.
fn shortened(text: &str, size: f64, room: f64) -> String {
    if text_width(text, size) <= room {
        return text.to_owned();
    }
    let mut kept: String = text.to_owned();
    while !kept.is_empty() && text_width(&kept, size) + size > room {
        kept.pop();
    }
    format!("{}…", kept.trim_end())
}
