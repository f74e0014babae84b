use cogmap_geometry::DVec2;

use crate::{
    Bounds, Camera, Colour, LegendEntry, Picture, Scene, Sheet, Theme,
    brush::Brush,
    font::{shortened, text_width},
    footer::Footer,
    mark::Mark,
    picture::MARGIN,
    theme::Stroke,
};

/// A figure: scenes side by side at one scale, with a title, a caption and one legend for all.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Plate {
    /// What it is called.
    pub title: String,
    /// What it shows, in a few sentences.
    pub caption: String,
    /// What it was drawn from, in one line.
    pub source: String,
    /// The scenes, row by row.
    pub panels: Vec<Panel>,
    /// How many of them stand in a row.
    pub columns: usize,
    /// Whether they are plots, which no bar of metres measures.
    pub plots: bool,
}

/// A scene of a figure.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Panel {
    /// Stands above it; may be empty.
    pub heading: String,
    /// What it shows; its title and note are not written.
    pub scene: Scene,
    /// What it has room for besides its scene.
    pub room: Option<Bounds>,
}

/// Where a panel stands, pixels.
struct Cell<'a> {
    panel: &'a Panel,
    corner: DVec2,
    size: DVec2,
    center: DVec2,
}

/// Pixels.
const TITLE: f64 = 17.0;
const TEXT: f64 = 12.5;
const LINE: f64 = 18.0;
const SMALL: f64 = 11.0;
const SMALL_LINE: f64 = 16.0;
/// From the upper edge to the title's base line, and from there to the caption's first.
const TITLE_BASE: f64 = 36.0;
const CAPTION_BELOW: f64 = 24.0;
/// Between texts and panels, and between panels.
const GUTTER: f64 = 16.0;
/// Around the scene within its panel.
const PADDING: f64 = 18.0;
/// What a heading takes above its panel.
const HEADING: f64 = 20.0;
/// The line below the legend.
const SOURCE: f64 = 26.0;
/// All panels together are no higher than this share of the width.
const TALLEST: f64 = 0.56;
/// Pixels a metre, at most.
const CLOSEST: f64 = 400.0;

impl Plate {
    /// Lays it out in that width; it is as high as it needs to be.
    #[must_use]
    pub fn picture(&self, width: f64, theme: Theme) -> Picture {
        let room = width - 2.0 * MARGIN;
        let caption = wrapped(&self.caption, TEXT, room);
        let top = TITLE_BASE + CAPTION_BELOW + LINE * caption.len().saturating_sub(1) as f64 + GUTTER;
        let scale = self.scale(room, width * TALLEST);
        let (cells, bottom) = self.cells(DVec2::new(MARGIN, top), room, scale);
        let views = self.panels.iter().map(|panel| panel.scene.views).max().unwrap_or(0);
        let legend = Scene { legend: self.legend(), views, ..Scene::default() };
        let camera = Some(Camera { center: DVec2::ZERO, pixels_per_metre: scale });
        let sheet = Sheet { camera, scale_bar: !self.plots, ..Sheet::new(width, bottom, theme) };
        let footer = Footer::of(&legend, &sheet);
        let sheet = Sheet { height: bottom + GUTTER + footer.height, ..sheet };
        let source = wrapped(&self.source, SMALL, room);
        let height = sheet.height + SOURCE + SMALL_LINE * source.len().saturating_sub(1) as f64;
        let mut brush = Brush::new(&legend, &sheet);
        self.words(&mut brush, &caption);
        footer.draw(&mut brush, &legend);
        lines(&mut brush, (DVec2::new(MARGIN, sheet.height + SMALL), SMALL_LINE), &source, SMALL);
        let mut marks: Vec<Mark> = cells.iter().flat_map(|cell| cell.marks(theme, scale)).collect();
        marks.extend(brush.marks);
        Picture { width, height, paper: theme.paper(), marks }
    }

    fn words(&self, brush: &mut Brush<'_>, caption: &[String]) {
        let ink = brush.theme().palette().ink;
        let room = brush.sheet.width - 2.0 * MARGIN;
        let at = DVec2::new(MARGIN, TITLE_BASE);
        brush.text(at, &shortened(&self.title, TITLE, room), TITLE, ink);
        lines(brush, (at + DVec2::new(0.0, CAPTION_BELOW), LINE), caption, TEXT);
    }

    /// What the panels explain, each thing once.
    fn legend(&self) -> Vec<LegendEntry> {
        let mut legend: Vec<LegendEntry> = Vec::new();
        for entry in self.panels.iter().flat_map(|panel| &panel.scene.legend) {
            if !legend.contains(entry) {
                legend.push(entry.clone());
            }
        }
        legend
    }

    fn rows(&self) -> impl Iterator<Item = &[Panel]> {
        self.panels.chunks(self.columns.max(1))
    }

    /// The largest scale at which all panels fit, pixels a metre.
    fn scale(&self, width: f64, height: f64) -> f64 {
        let (mut widest, mut high) = (CLOSEST, 0.0);
        for row in self.rows() {
            let metres: f64 = row.iter().map(|panel| panel.size().x).sum();
            let free = width - GUTTER * (row.len() - 1) as f64 - 2.0 * PADDING * row.len() as f64;
            widest = f64::min(widest, free / metres);
            high += row.iter().map(|panel| panel.size().y).fold(0.0, f64::max);
        }
        let free = height - (2.0 * PADDING + GUTTER) * self.rows().count() as f64;
        widest.min(free / high).max(0.1)
    }

    /// Where the panels stand, each as wide as its scene with its share of what is left over, and
    /// where they end.
    fn cells(&self, corner: DVec2, width: f64, scale: f64) -> (Vec<Cell<'_>>, f64) {
        let (mut cells, mut at) = (Vec::new(), corner);
        for row in self.rows() {
            let metres: f64 = row.iter().map(|panel| panel.size().x).sum();
            let spare = (width - GUTTER * (row.len() - 1) as f64 - metres * scale) / row.len() as f64;
            let height = row.iter().map(|panel| panel.size().y).fold(0.0, f64::max) * scale + 2.0 * PADDING;
            if row.iter().any(|panel| !panel.heading.is_empty()) {
                at.y += HEADING - 4.0;
            }
            at.x = corner.x;
            for panel in row {
                let size = DVec2::new(panel.size().x * scale + spare, height);
                cells.push(Cell { panel, corner: at, size, center: panel.bounds().center() });
                at.x += size.x + GUTTER;
            }
            at.y += height + GUTTER;
        }
        (cells, at.y - GUTTER)
    }
}

impl Panel {
    fn bounds(&self) -> Bounds {
        let empty = Bounds { min: DVec2::splat(-1.0), max: DVec2::ONE };
        let scene = self.scene.bounds();
        let both = scene.zip(self.room).map(|(scene, room)| scene.union(room));
        both.or(scene).or(self.room).unwrap_or(empty)
    }

    fn size(&self) -> DVec2 {
        let Bounds { min, max } = self.bounds();
        (max - min).max(DVec2::splat(0.1))
    }
}

impl Cell<'_> {
    fn marks(&self, theme: Theme, scale: f64) -> Vec<Mark> {
        let camera = Some(Camera { center: self.center, pixels_per_metre: scale });
        let sheet = Sheet { camera, ..Sheet::new(self.size.x, self.size.y, theme) };
        let scene = &self.panel.scene;
        let mut brush = Brush::new(scene, &sheet);
        let palette = theme.palette();
        let (right, down) = (DVec2::new(self.size.x, 0.0), DVec2::new(0.0, self.size.y));
        let frame = [DVec2::ZERO, right, right + down, down, DVec2::ZERO];
        let stroke = Stroke { colour: Colour::solid(palette.hairline), width: 1.0 };
        for pair in frame.windows(2) {
            brush.line([pair[0], pair[1]], stroke);
        }
        let heading = shortened(&self.panel.heading, TEXT, self.size.x);
        brush.text(DVec2::new(0.0, -7.0), &heading, TEXT, palette.ink);
        let mut marks = brush.marks;
        marks.extend(Picture::still(scene, &sheet));
        marks.extend(Picture::changing(scene, &sheet));
        marks.iter_mut().for_each(|mark| mark.shift(self.corner));
        marks
    }
}

/// Lines of text one below the other.
fn lines(brush: &mut Brush<'_>, (mut at, below): (DVec2, f64), lines: &[String], size: f64) {
    let muted = brush.theme().palette().muted;
    for line in lines {
        brush.text(at, line, size, muted);
        at.y += below;
    }
}

/// The text in lines no wider than `room` pixels, broken between words, but not before a unit.
fn wrapped(text: &str, size: f64, room: f64) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    for word in unbreakable(text) {
        match lines.last_mut() {
            Some(line)
                if text_width(line, size) + text_width(" ", size) + text_width(&word, size) <= room =>
            {
                line.push(' ');
                line.push_str(&word);
            }
            _ => lines.push(word),
        }
    }
    lines
}

/// The words of a text, units with their numbers.
fn unbreakable(text: &str) -> Vec<String> {
    let mut words: Vec<String> = Vec::new();
    for word in text.split_whitespace() {
        let is_unit = UNITS.contains(&word.trim_end_matches(['.', ',', ';', ':', ')']));
        match words.last_mut() {
            Some(number) if is_unit && number.ends_with(|last: char| last.is_ascii_digit()) => {
                number.push(' ');
                number.push_str(word);
            }
            _ => words.push(word.to_owned()),
        }
    }
    words
}

/// What does not begin a line.
const UNITS: [&str; 3] = ["m", "cm", "m²"];

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Item, Role, Sample, Shape};
    use cogmap_geometry::Segment;
    use proptest::prelude::*;

    fn panel(width: f64, height: f64) -> Panel {
        let wall = Segment::new(DVec2::ZERO, DVec2::new(width, height));
        let legend = vec![LegendEntry::new(Sample::Line(Role::Wall), "wall")];
        let still = vec![Item::new(Role::Wall, Shape::Segments(vec![wall]))];
        let scene = Scene { still, legend, ..Scene::default() };
        Panel { heading: "A wall".to_owned(), scene, room: None }
    }

    proptest! {
        #[test]
        fn every_panel_lies_within_the_picture_and_none_over_another(
            sizes in prop::collection::vec((0.1f64..90.0, 0.1f64..90.0), 1..7), columns in 1usize..4,
        ) {
            let panels = sizes.iter().map(|&(width, height)| panel(width, height)).collect();
            let plate = Plate { panels, columns, ..Plate::default() };
            let scale = plate.scale(752.0, 576.0);
            let (cells, bottom) = plate.cells(DVec2::new(24.0, 80.0), 752.0, scale);
            for (index, cell) in cells.iter().enumerate() {
                let end = cell.corner + cell.size;
                prop_assert!(cell.corner.x >= 24.0 - 1e-6 && end.x <= 776.0 + 1e-6 && end.y <= bottom + 1e-6);
                prop_assert!((cell.panel.size() * scale).cmple(cell.size + 1e-6).all());
                for other in &cells[..index] {
                    let apart = (other.corner + other.size).cmple(cell.corner + 1e-6).any();
                    prop_assert!(apart || cell.corner.y >= other.corner.y + other.size.y - 1e-6);
                }
            }
        }
    }

    #[test]
    fn no_line_of_a_caption_is_too_wide_and_no_word_is_lost() {
        let text =
            "The robot starts in a wide space, goes through a narrow passage and is in a wide space again.";
        let lines = wrapped(text, TEXT, 200.0);
        assert!(lines.len() > 2 && lines.iter().all(|line| text_width(line, TEXT) <= 200.0));
        assert_eq!(lines.join(" "), text);
    }

    #[test]
    fn a_number_keeps_its_unit() {
        let lines = wrapped("The robot believes itself 2.7 m, or more, from where it is.", TEXT, 200.0);
        assert!(
            lines.len() > 1 && lines.iter().all(|line| !line.starts_with("m,") && !line.ends_with("2.7"))
        );
    }

    #[test]
    fn what_two_panels_share_is_explained_once() {
        let plate = Plate { panels: vec![panel(4.0, 3.0); 2], columns: 2, ..Plate::default() };
        assert_eq!(plate.legend().len(), 1);
    }
}
