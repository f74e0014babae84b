use cogmap_geometry::DVec2;

use crate::{
    Colour, HomingMark, LegendEntry, PlaceMark, Role, Sample, Scene, Sheet,
    brush::Brush,
    font::{CAP_HEIGHT, text_width},
    picture::MARGIN,
    scale_bar::ScaleBar,
    theme::{Stroke, Style},
};

/// The strip below the map: scale bar and legend, in as many rows as they need. Without a legend the
/// scale bar stands on the map.
pub(crate) struct Footer {
    /// Pixels.
    pub(crate) height: f64,
    /// Left end and row of each entry of the legend.
    places: Vec<(f64, usize)>,
}

/// Pixels.
const ROW: f64 = 24.0;
const PADDING: f64 = 10.0;
const SIZE: f64 = 12.0;
const SWATCH: f64 = 24.0;
const RUN_SWATCH: f64 = 68.0;
const ASRS_SWATCH: f64 = 40.0;
const SPACE: f64 = 8.0;
const GAP: f64 = 22.0;

impl Footer {
    /// Where everything goes.
    pub(crate) fn of(scene: &Scene, sheet: &Sheet) -> Self {
        let entries: &[LegendEntry] = if sheet.legend { &scene.legend } else { &[] };
        let bar = if sheet.scale_bar { ScaleBar::ROOM + GAP } else { 0.0 };
        let (mut x, mut row) = (MARGIN + bar, 0);
        let mut places = Vec::with_capacity(entries.len());
        for entry in entries {
            let width = swatch(entry.sample) + SPACE + text_width(&entry.text, SIZE);
            if x > MARGIN && x + width > sheet.width - MARGIN {
                (x, row) = (MARGIN, row + 1);
            }
            places.push((x, row));
            x += width + GAP;
        }
        Self { height: 2.0 * PADDING + ROW * (row + 1) as f64, places }
    }

    /// Draws it over whatever lies there.
    pub(crate) fn draw(&self, brush: &mut Brush, scene: &Scene) {
        let (sheet, palette) = (brush.sheet, brush.theme().palette());
        let top = sheet.height - self.height;
        if !self.places.is_empty() {
            ground(brush, top);
        }
        let middle = |row: usize| top + PADDING + ROW * (row as f64 + 0.5);
        if sheet.scale_bar {
            ScaleBar::of(brush.camera).draw(brush, DVec2::new(MARGIN, middle(0)));
        }
        for (entry, (x, row)) in scene.legend.iter().zip(&self.places) {
            let at = DVec2::new(*x, middle(*row).round());
            draw_sample(brush, entry.sample, at);
            let text = at + DVec2::new(swatch(entry.sample) + SPACE, SIZE * CAP_HEIGHT * 0.5);
            brush.text(text, &entry.text, SIZE, palette.muted);
        }
    }
}

fn swatch(sample: Sample) -> f64 {
    match sample {
        Sample::Run | Sample::Age => RUN_SWATCH,
        Sample::Line(_)
        | Sample::Arrow(_)
        | Sample::Area(_)
        | Sample::Exit
        | Sample::SupposedExit
        | Sample::ClosedLoop => SWATCH,
        Sample::Asrs => ASRS_SWATCH,
        Sample::Sign(Role::Place(PlaceMark::Node(_))) => 18.0,
        Sample::Sign(Role::Homing(HomingMark::Home)) => 20.0,
        Sample::Sign(Role::Person) => 12.0,
        Sample::Sign(_) => 8.0,
        Sample::Robot(_) => 14.0,
        Sample::Node => 18.0,
    }
}

fn ground(brush: &mut Brush, top: f64) {
    let palette = brush.theme().palette();
    let (width, height) = (brush.sheet.width, brush.sheet.height);
    let corners = [(0.0, top), (width, top), (width, height), (0.0, height)].map(DVec2::from);
    let paper = Style { fill: Some(brush.theme().paper()), stroke: None, ..brush.style(Role::Room) };
    brush.path(&corners, paper, true);
    let colour = Colour::solid(palette.hairline);
    let edge = [DVec2::new(0.0, top + 0.5), DVec2::new(width, top + 0.5)];
    brush.line(edge, Stroke { colour, width: 1.0 });
}

/// Draws a sample whose left end's middle is at `at`.
fn draw_sample(brush: &mut Brush, sample: Sample, at: DVec2) {
    let width = swatch(sample);
    let center = at + DVec2::new(width * 0.5, 0.0);
    match sample {
        Sample::Line(role) => draw_line(brush, at, role),
        Sample::Arrow(role) => brush.arrow(&[at, at + DVec2::new(SWATCH, 0.0)], brush.style(role)),
        Sample::Area(role) => {
            let half = DVec2::new(width * 0.5, 6.0);
            let corners = [-half, half * DVec2::new(1.0, -1.0), half, half * DVec2::new(-1.0, 1.0)];
            brush.path(&corners.map(|corner| center + corner), brush.style(role), true);
        }
        Sample::Sign(role) => brush.sign(center, brush.style(role)),
        Sample::Node => brush.sign(center, brush.style(Role::Place(PlaceMark::Node(0)))),
        Sample::Robot(role) => brush.robot(center, DVec2::X, 7.0, brush.style(role)),
        Sample::Run => draw_pieces(brush, at, &|brush, share| brush.theme().of_run(share)),
        Sample::Age => draw_pieces(brush, at, &|brush, share| brush.theme().of_age(share)),
        Sample::Asrs => draw_asrs(brush, at),
        Sample::Exit => draw_exit(brush, at, Role::Place(PlaceMark::Exit)),
        Sample::SupposedExit => draw_exit(brush, at, Role::Place(PlaceMark::SupposedExit)),
        Sample::ClosedLoop => {
            draw_line(brush, at, Role::Place(PlaceMark::ClosedLoop));
            draw_line(brush, at, Role::Place(PlaceMark::ClosedLoopGap));
        }
    }
}

fn draw_line(brush: &mut Brush, at: DVec2, role: Role) {
    let style = brush.style(role);
    if let Some(stroke) = style.stroke {
        let cap = DVec2::new(stroke.width * 0.5, 0.0);
        let ends = [at + cap, at + DVec2::new(SWATCH, 0.0) - cap];
        if style.dashed {
            brush.polyline(&ends, style);
        } else {
            brush.line(ends, stroke);
        }
    }
}

fn draw_exit(brush: &mut Brush, at: DVec2, role: Role) {
    draw_line(brush, at, role);
    for end in [4.0, SWATCH - 4.0] {
        brush.sign(at + DVec2::new(end, 0.0), brush.style(role));
    }
}

fn draw_asrs(brush: &mut Brush, at: DVec2) {
    for number in 0..4 {
        let left = at + DVec2::new(2.0 + 10.0 * f64::from(number), 0.0);
        let colour = brush.theme().of_asr(number);
        brush.line([left, left + DVec2::new(6.0, 0.0)], Stroke { colour, width: 3.0 });
    }
}

fn draw_pieces(brush: &mut Brush, at: DVec2, colour: &dyn Fn(&Brush, f64) -> Colour) {
    const PIECES: u32 = 17;
    const WIDTH: f64 = 8.0;
    for piece in 0..PIECES {
        let length = (RUN_SWATCH - WIDTH) / f64::from(PIECES);
        let end = |piece: u32| at + DVec2::new(0.5 * WIDTH + length * f64::from(piece), 0.0);
        let colour = colour(brush, f64::from(piece) / f64::from(PIECES - 1));
        brush.line([end(piece), end(piece + 1)], Stroke { colour, width: WIDTH });
    }
}
