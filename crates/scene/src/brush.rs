use cogmap_geometry::{DVec2, Pose, Segment};

use crate::{
    Anchor, Camera, Colour, Item, Mark, Role, Scene, Shape, Sheet, Theme,
    clip::clip,
    font::{CAP_HEIGHT, text_width},
    theme::{Sign, Stroke, Style},
};

/// Turns items in metres into marks in pixels.
pub(crate) struct Brush<'a> {
    pub(crate) marks: Vec<Mark>,
    pub(crate) camera: Camera,
    pub(crate) sheet: &'a Sheet,
    views: usize,
    labels: Vec<[DVec2; 2]>,
}

impl<'a> Brush<'a> {
    pub(crate) fn new(scene: &Scene, sheet: &'a Sheet) -> Self {
        let camera = sheet.camera_for(scene);
        Self { marks: Vec::new(), camera, sheet, views: scene.views, labels: Vec::new() }
    }

    pub(crate) fn theme(&self) -> Theme {
        self.sheet.theme
    }

    pub(crate) fn style(&self, role: Role) -> Style {
        self.theme().style(role, self.views, self.camera.pixels_per_metre)
    }

    pub(crate) fn item(&mut self, item: &Item) {
        let style = self.style(item.role);
        match &item.shape {
            Shape::Segments(segments) => self.segments(segments, style),
            Shape::Polyline(points) => self.polyline(&self.project(points), style),
            Shape::Arrow(points) => self.arrow(&self.project(points), style),
            Shape::Polygon(points) => self.path(&self.project(points), style, true),
            Shape::Disc(center, radius) => {
                let radius = (radius * self.camera.pixels_per_metre).max(0.75);
                self.circle(self.to_pixels(*center), radius, style);
            }
            Shape::Signs(places) => self.signs(places, style),
            Shape::Robot(pose, radius) => self.robot_in_metres(*pose, *radius, style),
            Shape::Label { at, text, room } => self.label(*at, text, *room, style),
        }
    }

    pub(crate) fn line(&mut self, line: [DVec2; 2], stroke: Stroke) {
        if let Some(Mark::Lines { stroke: last, lines }) = self.marks.last_mut()
            && *last == stroke
        {
            lines.push(line);
        } else {
            self.marks.push(Mark::Lines { stroke, lines: vec![line] });
        }
    }

    /// A line through pixels, in dashes where its style says so.
    pub(crate) fn polyline(&mut self, points: &[DVec2], style: Style) {
        match style.stroke {
            Some(stroke) if style.dashed => self.dashes(points, stroke),
            _ => self.path(points, style, false),
        }
    }

    fn dashes(&mut self, points: &[DVec2], stroke: Stroke) {
        let size = DVec2::new(self.sheet.width, self.sheet.height);
        for pair in points.windows(2) {
            let Some([from, to]) = clip([pair[0], pair[1]], size, stroke.width) else { continue };
            let (length, ahead) = (from.distance(to), (to - from).normalize_or_zero());
            let begins = (0..).map(|k| f64::from(k) * (DASH + DASH_GAP)).take_while(|&begin| begin < length);
            for begin in begins {
                let ends = [begin, (begin + DASH).min(length)];
                self.line(ends.map(|end| from + ahead * end), stroke);
            }
        }
    }

    pub(crate) fn arrow(&mut self, points: &[DVec2], style: Style) {
        self.path(points, style, false);
        let [.., from, to] = points else { return };
        let ahead = (*to - *from).normalize_or_zero();
        let corners = ARROWHEAD.map(|[x, y]| *to + ahead * x + ahead.perp() * y);
        let fill = style.stroke.map(|stroke| stroke.colour);
        self.path(&corners, Style { fill, ..style }, true);
    }

    pub(crate) fn path(&mut self, points: &[DVec2], style: Style, closed: bool) {
        let drawable = |point: &DVec2| point.is_finite() && point.abs().max_element() < FARTHEST;
        let points: Vec<_> = points.iter().copied().filter(drawable).collect();
        if points.len() >= 2 {
            let fill = style.fill.filter(|_| closed);
            self.marks.push(Mark::Path { points, closed, fill, stroke: style.stroke });
        }
    }

    /// The sign of a style around a pixel.
    pub(crate) fn sign(&mut self, at: DVec2, style: Style) {
        let corners = |offsets: &[[f64; 2]], size: f64| -> Vec<DVec2> {
            offsets.iter().map(|offset| at + DVec2::from(*offset) * size).collect()
        };
        match style.sign {
            Sign::Dot(radius) => self.circle(at, radius, style),
            Sign::Diamond(size) => self.path(&corners(&DIAMOND, size), style, true),
            Sign::Triangle(size) => self.path(&corners(&TRIANGLE, size), style, true),
            Sign::Square(size) => self.path(&corners(&SQUARE, size), style, true),
            Sign::House(size) => self.path(&corners(&HOUSE, size), style, true),
        }
    }

    /// A robot of that radius in pixels; it looks along `ahead`, a unit vector.
    pub(crate) fn robot(&mut self, at: DVec2, ahead: DVec2, radius: f64, style: Style) {
        self.circle(at, radius, style);
        let arrow = ARROW.map(|[x, y]| at + (ahead * x + ahead.perp() * y) * radius);
        let fill = style.stroke.map(|stroke| stroke.colour);
        self.path(&arrow, Style { fill, stroke: None, ..style }, true);
    }

    /// Text that begins at `at`, on its base line.
    pub(crate) fn text(&mut self, at: DVec2, text: &str, size: f64, colour: u32) {
        let (text, colour) = (text.to_owned(), Colour::solid(colour));
        self.marks.push(Mark::Text { at, text, size, anchor: Anchor::Start, colour, halo: None });
    }

    fn circle(&mut self, center: DVec2, radius: f64, style: Style) {
        if !self.near(center, radius) {
            return;
        }
        if let Some(Mark::Circles { circles, fill, stroke }) = self.marks.last_mut()
            && (*fill, *stroke) == (style.fill, style.stroke)
        {
            circles.push((center, radius));
        } else {
            let circles = vec![(center, radius)];
            self.marks.push(Mark::Circles { circles, fill: style.fill, stroke: style.stroke });
        }
    }

    fn segments(&mut self, segments: &[Segment], style: Style) {
        let Some(stroke) = style.stroke else { return };
        let size = DVec2::new(self.sheet.width, self.sheet.height);
        for segment in segments {
            let line = [self.to_pixels(segment.a), self.to_pixels(segment.b)];
            if let Some(line) = clip(line, size, stroke.width) {
                self.line(line, stroke);
            }
        }
    }

    /// Signs that would lie on the one before are left out.
    fn signs(&mut self, places: &[DVec2], style: Style) {
        let (Sign::Dot(size)
        | Sign::Diamond(size)
        | Sign::Triangle(size)
        | Sign::Square(size)
        | Sign::House(size)) = style.sign;
        let mut last: Option<DVec2> = None;
        for place in self.project(places) {
            let free = last.is_none_or(|last| last.distance(place) >= 2.0 * size);
            if free && self.near(place, size) {
                self.sign(place, style);
                last = Some(place);
            }
        }
    }

    fn robot_in_metres(&mut self, pose: Pose, radius: f64, style: Style) {
        let forward = pose.forward();
        let at = self.to_pixels(pose.position);
        let radius = (radius * self.camera.pixels_per_metre).max(SMALLEST_ROBOT);
        if self.near(at, radius) {
            self.robot(at, DVec2::new(forward.x, -forward.y), radius, style);
        }
    }

    /// A label with nothing else written in its place, else nothing.
    fn label(&mut self, at: DVec2, text: &str, room: f64, style: Style) {
        let at = self.to_pixels(at);
        let half = DVec2::new(text_width(text, LABEL_SIZE) * 0.5, LABEL_SIZE * 0.5);
        let bounds = [at - half, at + half];
        let fits = 2.0 * half.x <= room * self.camera.pixels_per_metre && self.near(at, half.x);
        let [low, high] = bounds;
        let free = self.labels.iter().all(|[min, max]| low.cmpgt(*max).any() || high.cmplt(*min).any());
        if let (true, true, Some(colour)) = (fits, free, style.fill) {
            self.labels.push(bounds);
            let at = at + DVec2::new(0.0, LABEL_SIZE * CAP_HEIGHT * 0.5);
            let (text, halo) = (text.to_owned(), Some(Colour::solid(self.theme().palette().room)));
            self.marks.push(Mark::Text { at, text, size: LABEL_SIZE, anchor: Anchor::Middle, colour, halo });
        }
    }

    fn to_pixels(&self, point: DVec2) -> DVec2 {
        self.camera.to_pixels(point, self.sheet.width, self.sheet.height)
    }

    fn project(&self, points: &[DVec2]) -> Vec<DVec2> {
        points.iter().map(|point| self.to_pixels(*point)).collect()
    }

    /// Whether a circle around a pixel reaches into the picture.
    fn near(&self, at: DVec2, radius: f64) -> bool {
        let size = DVec2::new(self.sheet.width, self.sheet.height);
        let reach = radius + 4.0;
        at.is_finite() && at.cmpge(DVec2::splat(-reach)).all() && at.cmple(size + reach).all()
    }
}

/// Pixels that a dash is long …
const DASH: f64 = 6.0;
/// … and pixels to the next.
const DASH_GAP: f64 = 5.0;
/// Corners of an arrowhead in pixels, ahead and across.
const ARROWHEAD: [[f64; 2]; 3] = [[0.0, 0.0], [-9.0, 4.5], [-9.0, -4.5]];
/// Pixels from the corner; corners beyond, and those that are not numbers, are left out.
const FARTHEST: f64 = 1e6;
/// Pixels; a robot is not drawn smaller.
const SMALLEST_ROBOT: f64 = 7.0;
/// Pixels.
const LABEL_SIZE: f64 = 12.0;
/// Corners as shares of the size, y down.
const DIAMOND: [[f64; 2]; 4] = [[0.0, -1.2], [1.2, 0.0], [0.0, 1.2], [-1.2, 0.0]];
const SQUARE: [[f64; 2]; 4] = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]];
const TRIANGLE: [[f64; 2]; 3] = [[0.0, -1.2], [1.1, 0.8], [-1.1, 0.8]];
const HOUSE: [[f64; 2]; 7] =
    [[0.0, -1.2], [1.3, 0.0], [0.85, 0.0], [0.85, 1.1], [-0.85, 1.1], [-0.85, 0.0], [-1.3, 0.0]];
/// Corners as shares of the radius, ahead and across.
const ARROW: [[f64; 2]; 4] = [[0.66, 0.0], [-0.4, 0.46], [-0.18, 0.0], [-0.4, -0.46]];
