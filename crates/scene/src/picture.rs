use cogmap_geometry::DVec2;

use crate::{
    Bounds, Camera, Colour, Item, Margins, Mark, Scene, Theme, brush::Brush, font::shortened, footer::Footer,
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
    /// Whether the legend stands below.
    pub legend: bool,
    /// Whether a bar says how long a metre is.
    pub scale_bar: bool,
}

impl Sheet {
    /// A sheet that shows the whole scene with its title and legend.
    #[must_use]
    pub fn new(width: f64, height: f64, theme: Theme) -> Self {
        Self { width, height, theme, camera: None, title: true, legend: true, scale_bar: true }
    }

    /// The view that shows `bounds` and leaves room for title and legend.
    #[must_use]
    pub fn fit(&self, scene: &Scene, bounds: Bounds) -> Camera {
        let top = if self.title { TITLE_HEIGHT } else { MARGIN };
        let margins = Margins { top, bottom: self.strip(scene) + MARGIN, side: MARGIN };
        Camera::fit(bounds, self.width, self.height, margins)
    }

    /// How high the strip below the map is that scale bar and legend take, pixels.
    #[must_use]
    pub fn strip(&self, scene: &Scene) -> f64 {
        Footer::of(scene, self).height
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
        let sheet = &Sheet { camera: Some(sheet.camera_for(scene)), ..*sheet };
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{LegendEntry, Role, Sample, Shape};
    use cogmap_geometry::{Pose, Segment};
    use proptest::{num::f64::ANY, prelude::*};

    prop_compose! {
        fn any_point()(x in ANY, y in ANY) -> DVec2 { DVec2::new(x, y) }
    }

    fn numbers(mark: &Mark) -> Vec<f64> {
        let points: Vec<DVec2> = match mark {
            Mark::Lines { lines, .. } => lines.iter().flatten().copied().collect(),
            Mark::Path { points, .. } => points.clone(),
            Mark::Circles { circles, .. } => circles.iter().map(|(center, _)| *center).collect(),
            Mark::Text { at, .. } => vec![*at],
        };
        points.iter().flat_map(|point| [point.x, point.y]).collect()
    }

    proptest! {
        #[test]
        fn nothing_that_is_not_a_number_reaches_a_painter(a in any_point(), b in any_point(), radius in ANY) {
            let label = Shape::Label { at: b, text: "here".to_owned(), room: radius };
            let shapes = [
                Shape::Segments(vec![Segment::new(a, b)]),
                Shape::Polyline(vec![a, b, DVec2::ONE]),
                Shape::Polygon(vec![a, b, DVec2::ONE]),
                Shape::Disc(a, radius),
                Shape::Signs(vec![a, b]),
                Shape::Robot(Pose { position: a, heading: b.x }, radius),
                label,
            ];
            let roles = [Role::Wall, Role::Furniture, Role::PathStep, Role::FallbackPlacement, Role::Robot];
            let items = roles.iter().flat_map(|role| shapes.iter().map(|shape| Item::new(*role, shape.clone())));
            let scene = Scene { still: items.collect(), ..Scene::default() };
            let picture = Picture::of(&scene, &Sheet::new(640.0, 480.0, Theme::Light));
            prop_assert!(picture.marks.iter().flat_map(numbers).all(f64::is_finite));
        }
    }

    #[test]
    fn room_names_never_cover_each_other() {
        let label = |x: f64| Shape::Label { at: DVec2::new(x, 0.0), text: "Storeroom".to_owned(), room: 9.0 };
        let still = [0.0, 0.3, 4.0].map(|x| Item::new(Role::RoomLabel, label(x))).to_vec();
        let scene = Scene { still, ..Scene::default() };
        let sheet = Sheet { title: false, ..Sheet::new(640.0, 480.0, Theme::Light) };
        let is_label = |mark: &&Mark| matches!(mark, Mark::Text { text, .. } if text == "Storeroom");
        assert_eq!(Picture::of(&scene, &sheet).marks.iter().filter(is_label).count(), 2);
    }

    #[test]
    fn a_fitted_map_is_not_covered_by_its_legend() {
        let wall = Segment::new(DVec2::ZERO, DVec2::new(10.0, 10.0));
        let still = vec![Item::new(Role::Wall, Shape::Segments(vec![wall]))];
        let entry = LegendEntry::new(Sample::Line(Role::Wall), "a wall with a long explanation");
        let scene = Scene { still, legend: vec![entry; 7], ..Scene::default() };
        let sheet = Sheet::new(390.0, 600.0, Theme::Light);
        let lowest = sheet.camera_for(&scene).to_pixels(wall.a, 390.0, 600.0).y;
        assert!(lowest <= 600.0 - Footer::of(&scene, &sheet).height);
    }
}
