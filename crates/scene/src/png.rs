//! Painter for PNG files.

use ab_glyph::{Font, FontRef, OutlineCurve};
use cogmap_geometry::DVec2;
use tiny_skia::{
    Color, FillRule, LineCap, LineJoin, Paint, Path, PathBuilder, Pixmap, Stroke as Pen, Transform,
};

use crate::{Anchor, Colour, FONT, HALO, Mark, Picture, Scene, Sheet, theme::Stroke};

/// Paints a scene as a PNG file with `pixel_ratio` pixels of the file to one of the sheet. The same
/// scene gives the same bytes everywhere. `None` where the picture has no pixel or too many.
#[must_use]
pub fn paint(scene: &Scene, sheet: &Sheet, pixel_ratio: f64) -> Option<Vec<u8>> {
    file(&Picture::of(scene, sheet), pixel_ratio)
}

/// Paints a picture as a PNG file in the same way.
#[must_use]
pub fn file(picture: &Picture, pixel_ratio: f64) -> Option<Vec<u8>> {
    let pixels = |length: f64| {
        let pixels = (length * pixel_ratio).round();
        (1.0..=LONGEST).contains(&pixels).then_some(pixels as u32)
    };
    let pixmap = Pixmap::new(pixels(picture.width)?, pixels(picture.height)?)?;
    let font = FontRef::try_from_slice(FONT).ok()?;
    let scale = pixel_ratio as f32;
    let mut canvas = Canvas { pixmap, font, transform: Transform::from_scale(scale, scale) };
    canvas.pixmap.fill(color(picture.paper));
    for mark in &picture.marks {
        canvas.draw(mark);
    }
    canvas.pixmap.encode_png().ok()
}

/// Pixels along either side.
const LONGEST: f64 = 16_384.0;

struct Canvas {
    pixmap: Pixmap,
    font: FontRef<'static>,
    transform: Transform,
}

impl Canvas {
    fn draw(&mut self, mark: &Mark) {
        let mut builder = PathBuilder::new();
        match mark {
            Mark::Lines { stroke, lines } => {
                for [a, b] in lines {
                    builder.move_to(a.x as f32, a.y as f32);
                    builder.line_to(b.x as f32, b.y as f32);
                }
                self.put(builder.finish(), None, Some(*stroke));
            }
            Mark::Path { points, closed, fill, stroke } => {
                trace(&mut builder, points, *closed);
                self.put(builder.finish(), *fill, *stroke);
            }
            Mark::Circles { circles, fill, stroke } => {
                for (center, radius) in circles {
                    builder.push_circle(center.x as f32, center.y as f32, *radius as f32);
                }
                self.put(builder.finish(), *fill, *stroke);
            }
            Mark::Text { at, text, size, anchor, colour, halo } => {
                let path = self.outline(*at, text, *size, *anchor);
                if let Some(halo) = *halo {
                    let rim = Stroke { colour: halo, width: 2.0 * HALO };
                    self.put(path.clone(), None, Some(rim));
                }
                self.put(path, Some(*colour), None);
            }
        }
    }

    fn put(&mut self, path: Option<Path>, fill: Option<Colour>, stroke: Option<Stroke>) {
        let Some(path) = path else { return };
        if let Some(fill) = fill {
            self.pixmap.fill_path(&path, &ink(fill), FillRule::Winding, self.transform, None);
        }
        if let Some(stroke) = stroke {
            self.pixmap.stroke_path(&path, &ink(stroke.colour), &pen(stroke), self.transform, None);
        }
    }

    /// The outlines of a line of text.
    fn outline(&self, at: DVec2, text: &str, size: f64, anchor: Anchor) -> Option<Path> {
        let scale = size as f32 / self.font.units_per_em()?;
        let glyphs: Vec<_> = text.chars().map(|letter| self.font.glyph_id(letter)).collect();
        let width: f32 = glyphs.iter().map(|glyph| self.font.h_advance_unscaled(*glyph)).sum();
        let mut x = match anchor {
            Anchor::Start => at.x as f32,
            Anchor::Middle => at.x as f32 - width * scale * 0.5,
        };
        let mut builder = PathBuilder::new();
        for glyph in glyphs {
            if let Some(outline) = self.font.outline(glyph) {
                trace_glyph(&mut builder, &outline.curves, [x, at.y as f32], scale);
            }
            x += self.font.h_advance_unscaled(glyph) * scale;
        }
        builder.finish()
    }
}

fn trace(builder: &mut PathBuilder, points: &[DVec2], closed: bool) {
    for (index, point) in points.iter().enumerate() {
        let (x, y) = (point.x as f32, point.y as f32);
        if index == 0 { builder.move_to(x, y) } else { builder.line_to(x, y) }
    }
    if closed {
        builder.close();
    }
}

/// Adds a glyph whose origin is at `at`.
fn trace_glyph(builder: &mut PathBuilder, curves: &[OutlineCurve], at: [f32; 2], scale: f32) {
    let place = |point: ab_glyph::Point| (at[0] + point.x * scale, at[1] - point.y * scale);
    let mut last = None;
    for curve in curves {
        let (OutlineCurve::Line(start, end)
        | OutlineCurve::Quad(start, _, end)
        | OutlineCurve::Cubic(start, _, _, end)) = curve;
        if last != Some(*start) {
            let (x, y) = place(*start);
            builder.move_to(x, y);
        }
        last = Some(*end);
        let (x, y) = place(*end);
        match curve {
            OutlineCurve::Line(..) => builder.line_to(x, y),
            OutlineCurve::Quad(_, control, _) => {
                let (cx, cy) = place(*control);
                builder.quad_to(cx, cy, x, y);
            }
            OutlineCurve::Cubic(_, first, second, _) => {
                let ((ax, ay), (bx, by)) = (place(*first), place(*second));
                builder.cubic_to(ax, ay, bx, by, x, y);
            }
        }
    }
}

fn color(colour: Colour) -> Color {
    let [r, g, b] = colour.rgb;
    Color::from_rgba8(r, g, b, colour.alpha)
}

fn ink(colour: Colour) -> Paint<'static> {
    let mut paint = Paint::default();
    paint.set_color(color(colour));
    paint
}

fn pen(stroke: Stroke) -> Pen {
    let (line_cap, line_join) = (LineCap::Round, LineJoin::Round);
    Pen { width: stroke.width as f32, line_cap, line_join, ..Pen::default() }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Theme, font::text_width};

    #[test]
    fn the_table_of_widths_is_the_fonts() {
        let font = FontRef::try_from_slice(FONT).unwrap();
        let units = f64::from(font.units_per_em().unwrap());
        for letter in ' '..='~' {
            let advance = f64::from(font.h_advance_unscaled(font.glyph_id(letter)));
            assert!((text_width(&letter.to_string(), 1.0) - advance / units).abs() < 1e-6, "{letter}");
        }
    }

    #[test]
    fn the_font_holds_every_sign_that_labels_use() {
        let font = FontRef::try_from_slice(FONT).unwrap();
        for letter in "äöüÄÖÜßéèêàçñåøæœšžłÉ°±×−·–—…→←≈≤≥²µ„“‘’".chars()
        {
            assert_ne!(font.glyph_id(letter).0, 0, "{letter}");
        }
    }

    #[test]
    fn a_picture_without_pixels_is_none() {
        let scene = Scene::default();
        for (width, ratio) in [(0.0, 1.0), (-5.0, 1.0), (f64::NAN, 1.0), (1e9, 1.0), (300.0, 0.0)] {
            assert_eq!(paint(&scene, &Sheet::new(width, 200.0, Theme::Light), ratio), None);
        }
        assert!(paint(&scene, &Sheet::new(300.0, 200.0, Theme::Dark), 2.0).is_some());
    }
}
