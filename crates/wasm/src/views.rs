use std::collections::BTreeMap;

use cogmap_geometry::DVec2;
use cogmap_scene::{Bounds, Camera, Margins};
use serde::{Deserialize, Serialize};
use tsify::Tsify;

/// Room to every side of what there is at first, metres.
const ROOM: f64 = 0.4;
/// Share of its size by which a view that has become too small grows.
const GROWTH: f64 = 0.08;
/// What is shown of a run that has seen nothing, metres to each side.
const EMPTY: f64 = 5.0;
/// Views at least this wide and high have room for their legend, pixels.
const ROOM_FOR_LEGEND: DVec2 = DVec2::new(440.0, 380.0);
/// Pixels kept free around everything, with the scale bar and a legend of three rows below.
const AROUND_LEGEND: Margins = Margins { top: 20.0, bottom: 116.0, side: 20.0 };
/// A view that has room for no more than this many times the scale of the others shows theirs.
const SAME: f64 = 1.15;
/// Pixels kept free between everything and a longer legend.
const ABOVE_LEGEND: f64 = 16.0;
/// Pixels kept free around everything, with the scale bar alone below.
const AROUND: Margins = Margins { top: 12.0, bottom: 44.0, side: 12.0 };

/// A view of the page.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize, Tsify)]
#[serde(rename_all = "snake_case")]
pub enum View {
    /// The truth; for a log, where odometry takes the robot.
    World,
    /// The memory of the first mapper.
    First,
    /// Of the second.
    Second,
    /// Of the third.
    Third,
    /// Of the fourth.
    Fourth,
}

impl View {
    /// The memories, in the order of the mappers.
    pub(crate) const MEMORIES: [Self; 4] = [Self::First, Self::Second, Self::Third, Self::Fourth];

    /// Whose memory it shows.
    pub(crate) fn mapper(self) -> Option<usize> {
        Self::MEMORIES.iter().position(|memory| *memory == self)
    }
}

/// The sizes of the views that are on the page, and the one camera that all look through; a view that is much larger
/// than others looks closer.
#[derive(Clone, Debug)]
pub(crate) struct Views {
    sizes: BTreeMap<View, DVec2>,
    /// What somebody chose to look at; `None` shows everything.
    chosen: Option<Camera>,
    /// What everything is taken to be.
    framed: Option<Bounds>,
    /// The highest strip of scale bar and legend so far, pixels.
    strip: f64,
}

impl Views {
    pub(crate) fn new() -> Self {
        Self { sizes: BTreeMap::new(), chosen: None, framed: None, strip: 0.0 }
    }

    /// The size of a view, pixels.
    pub(crate) fn size(&self, view: View) -> DVec2 {
        self.sizes.get(&view).copied().unwrap_or(DVec2::ONE)
    }

    pub(crate) fn resize(&mut self, view: View, size: DVec2) {
        self.sizes.insert(view, size.max(DVec2::ONE));
        self.strip = 0.0;
    }

    /// Notes that a view has left the page.
    pub(crate) fn close(&mut self, view: View) {
        self.sizes.remove(&view);
    }

    /// Whether a view has room for its legend.
    pub(crate) fn has_legend(&self, view: View) -> bool {
        self.size(view).cmpge(ROOM_FOR_LEGEND).all()
    }

    /// What all views show, at the scale of the smallest.
    pub(crate) fn shared_camera(&self) -> Camera {
        let size = self.sizes.values().copied().reduce(DVec2::min).unwrap_or(DVec2::ONE);
        self.chosen.unwrap_or_else(|| self.fitted(size))
    }

    /// What a view shows.
    pub(crate) fn camera(&self, view: View) -> Camera {
        let (shared, closer) = (self.shared_camera(), self.closer(view));
        let pixels_per_metre =
            (shared.pixels_per_metre * closer).clamp(*Camera::SCALES.start(), *Camera::SCALES.end());
        if self.chosen.is_some() || closer == 1.0 {
            return Camera { pixels_per_metre, ..shared };
        }
        // As far from the middle of everything, in pixels, as the legend pushes it.
        let (own, middle) = (self.fitted(self.size(view)), self.everything().center());
        let center = middle + (own.center - middle) * (own.pixels_per_metre / pixels_per_metre);
        Camera { center, pixels_per_metre }
    }

    /// How many times the scale of the smallest view this one has.
    fn closer(&self, view: View) -> f64 {
        let smallest = self.sizes.values().copied().reduce(DVec2::min).unwrap_or(DVec2::ONE);
        let [own, least] = [self.size(view), smallest].map(|size| self.fitted(size).pixels_per_metre);
        (own / least / SAME).max(1.0)
    }

    /// Everything, in a view of that size.
    fn fitted(&self, size: DVec2) -> Camera {
        let bottom = AROUND_LEGEND.bottom.max(self.strip + ABOVE_LEGEND);
        let has_legend = size.cmpge(ROOM_FOR_LEGEND).all();
        let margins = if has_legend { Margins { bottom, ..AROUND_LEGEND } } else { AROUND };
        Camera::fit(self.everything(), size.x, size.y, margins)
    }

    fn everything(&self) -> Bounds {
        self.framed.unwrap_or(Bounds { min: DVec2::splat(-EMPTY), max: DVec2::splat(EMPTY) })
    }

    /// Sees to it that everything has room; it grows in strides, so that the picture stands still
    /// between them.
    pub(crate) fn make_room(&mut self, bounds: Option<Bounds>) {
        let Some(bounds) = bounds else { return };
        self.framed = Some(match self.framed {
            None => Bounds { min: bounds.min - ROOM, max: bounds.max + ROOM },
            Some(framed) if framed.union(bounds) == framed => framed,
            Some(framed) => grown(framed.union(bounds)),
        });
    }

    /// Sees to it that nothing lies below a strip of scale bar and legend so high, pixels.
    pub(crate) fn make_room_for_legend(&mut self, strip: f64) {
        self.strip = self.strip.max(strip);
    }

    /// Moves what all views show by so many pixels of one of them.
    pub(crate) fn drag(&mut self, by: DVec2, view: View) {
        if by.is_finite() {
            let center = self.camera(view).dragged(by).center;
            self.chosen = Some(Camera { center, ..self.shared_camera() });
        }
    }

    /// Zooms by a factor about a pixel of a view, or about its middle.
    pub(crate) fn zoom(&mut self, factor: f64, view: View, pixel: Option<DVec2>) {
        let center = self.camera(view).center;
        let held = pixel.map_or(center, |pixel| self.to_metres(view, pixel));
        if held.is_finite() && factor.is_finite() && factor > 0.0 {
            self.chosen = Some(Camera { center, ..self.shared_camera() }.zoomed(factor, held));
        }
    }

    /// Shows everything again.
    pub(crate) fn fit(&mut self) {
        self.chosen = None;
    }

    /// The pixel of a view at which a point of the plane appears.
    pub(crate) fn to_pixels(&self, view: View, point: DVec2) -> DVec2 {
        let size = self.size(view);
        self.camera(view).to_pixels(point, size.x, size.y)
    }

    /// The point of the plane at a pixel of a view.
    pub(crate) fn to_metres(&self, view: View, pixel: DVec2) -> DVec2 {
        let size = self.size(view);
        self.camera(view).to_metres(pixel, size.x, size.y)
    }
}

fn grown(bounds: Bounds) -> Bounds {
    let by = (bounds.max - bounds.min) * GROWTH;
    Bounds { min: bounds.min - by, max: bounds.max + by }
}

#[cfg(test)]
mod tests {
    use super::*;
    use cogmap_scene::{Item, Role, Scene, Shape};

    fn line_to(point: DVec2) -> Scene {
        let item = Item::new(Role::Path, Shape::Polyline(vec![DVec2::ZERO, point]));
        Scene { still: vec![item], ..Scene::default() }
    }

    fn views_of(scene: &Scene) -> Views {
        let mut views = Views::new();
        views.resize(View::World, DVec2::new(640.0, 480.0));
        views.resize(View::First, DVec2::new(640.0, 480.0));
        views.make_room(scene.bounds());
        views
    }

    #[test]
    fn everything_is_in_view_until_somebody_looks_elsewhere() {
        let far = DVec2::new(30.0, 20.0);
        let mut views = views_of(&line_to(DVec2::new(3.0, 2.0)));
        views.make_room(line_to(far).bounds());
        let pixel = views.camera(View::World).to_pixels(far, 640.0, 480.0);
        assert!((0.0..=640.0).contains(&pixel.x) && (0.0..=480.0).contains(&pixel.y));
        views.drag(DVec2::new(10.0, 0.0), View::World);
        let chosen = views.camera(View::World);
        views.make_room(line_to(far * 5.0).bounds());
        assert_eq!(views.camera(View::World), chosen);
        views.fit();
        assert_ne!(views.camera(View::World), chosen);
    }

    #[test]
    fn the_picture_stands_still_while_there_is_room() {
        let mut views = views_of(&line_to(DVec2::new(3.0, 2.0)));
        views.make_room(line_to(DVec2::new(6.0, 4.0)).bounds());
        let before = views.camera(View::World);
        views.make_room(line_to(DVec2::new(6.1, 4.1)).bounds());
        assert_eq!(views.camera(View::World), before);
    }

    #[test]
    fn a_long_legend_covers_nothing() {
        let far = DVec2::new(3.0, -12.0);
        let mut views = views_of(&line_to(far));
        let lowest = |views: &Views| views.camera(View::World).to_pixels(far, 640.0, 480.0).y;
        assert!(lowest(&views) > 300.0);
        views.make_room_for_legend(180.0);
        assert!(lowest(&views) <= 300.0);
    }

    #[test]
    fn zooming_holds_the_point_under_the_finger() {
        let mut views = views_of(&line_to(DVec2::new(3.0, 2.0)));
        let pixel = DVec2::new(100.0, 70.0);
        let held = views.to_metres(View::First, pixel);
        views.zoom(1.7, View::First, Some(pixel));
        assert!(views.to_metres(View::First, pixel).distance(held) < 1e-9);
    }

    #[test]
    fn nothing_that_a_page_sends_loses_the_picture() {
        let mut views = views_of(&line_to(DVec2::new(3.0, 2.0)));
        let before = views.camera(View::World);
        views.drag(DVec2::NAN, View::First);
        views.zoom(f64::NAN, View::World, None);
        views.zoom(-1.0, View::World, None);
        views.zoom(2.0, View::World, Some(DVec2::splat(f64::INFINITY)));
        assert_eq!(views.camera(View::World), before);
    }

    #[test]
    fn a_view_that_is_given_much_more_room_looks_closer_and_is_dragged_as_far() {
        let mut views = views_of(&line_to(DVec2::new(30.0, 2.0)));
        let scale = |views: &Views, view| views.camera(view).pixels_per_metre;
        assert_eq!(views.camera(View::World), views.camera(View::First));
        views.resize(View::World, DVec2::new(700.0, 480.0));
        assert_eq!(scale(&views, View::World), scale(&views, View::First), "little more room");
        views.resize(View::World, DVec2::new(1280.0, 480.0));
        let times = scale(&views, View::World) / scale(&views, View::First);
        assert!((1.6..1.9).contains(&times), "{times}");
        let pixel = DVec2::new(900.0, 200.0);
        let held = views.to_metres(View::World, pixel);
        views.drag(DVec2::new(40.0, -10.0), View::World);
        assert!(views.to_metres(View::World, pixel + DVec2::new(40.0, -10.0)).distance(held) < 1e-9);
        views.zoom(2.0, View::World, Some(pixel));
        let now = scale(&views, View::World) / scale(&views, View::First);
        assert!((now - times).abs() < 1e-9, "{now} is not {times}");
    }
}
