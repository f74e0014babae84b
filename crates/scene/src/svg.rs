//! Painter for SVG files.

use std::fmt::Write;

use cogmap_geometry::DVec2;

use crate::{Anchor, Colour, FONT_FAMILY, HALO, Mark, Picture, Scene, Sheet, theme::Stroke};

/// Paints a scene as an SVG document. The same scene gives the same bytes everywhere.
#[must_use]
pub fn paint(scene: &Scene, sheet: &Sheet) -> String {
    document(&Picture::of(scene, sheet), &scene.title, &scene.note)
}

/// Paints a picture as an SVG document with a title and a description for those who cannot see it.
#[must_use]
pub fn document(picture: &Picture, title: &str, description: &str) -> String {
    let (width, height) = (number(picture.width), number(picture.height));
    let mut out = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width}\" height=\"{height}\" viewBox=\"0 0 {width} {height}\" \
         role=\"img\" font-family=\"{FONT_FAMILY}\" stroke-linecap=\"round\" stroke-linejoin=\"round\">\n"
    );
    let _ = writeln!(out, "<title>{}</title>", escaped(title));
    let _ = writeln!(out, "<desc>{}</desc>", escaped(description));
    let _ = writeln!(
        out,
        "<rect width=\"{width}\" height=\"{height}\"{}/>",
        paint_of("fill", Some(picture.paper))
    );
    for mark in &picture.marks {
        write_mark(&mut out, mark);
    }
    out.push_str("</svg>\n");
    out
}

fn write_mark(out: &mut String, mark: &Mark) {
    match mark {
        Mark::Lines { stroke, lines } => {
            let data: String = lines.iter().map(|[a, b]| format!("M{}L{}", pair(*a), pair(*b))).collect();
            let _ = writeln!(out, "<path d=\"{data}\"{}/>", look(None, Some(*stroke)));
        }
        Mark::Path { points, closed, fill, stroke } => {
            let mut data = String::new();
            for (index, point) in points.iter().enumerate() {
                data.push(if index == 0 { 'M' } else { 'L' });
                data.push_str(&pair(*point));
            }
            let end = if *closed { "Z" } else { "" };
            let _ = writeln!(out, "<path d=\"{data}{end}\"{}/>", look(*fill, *stroke));
        }
        Mark::Circles { circles, fill, stroke } => {
            let _ = writeln!(out, "<g{}>", look(*fill, *stroke));
            for (center, radius) in circles {
                let (x, y, r) = (number(center.x), number(center.y), number(*radius));
                let _ = writeln!(out, "<circle cx=\"{x}\" cy=\"{y}\" r=\"{r}\"/>");
            }
            out.push_str("</g>\n");
        }
        Mark::Text { at, text, size, anchor, colour, halo } => {
            let (x, y, size) = (number(at.x), number(at.y), number(*size));
            let anchor = match anchor {
                Anchor::Start => "",
                Anchor::Middle => " text-anchor=\"middle\"",
            };
            let rim = halo.map_or(String::new(), |halo| {
                let stroke = Stroke { colour: halo, width: 2.0 * HALO };
                format!("{} paint-order=\"stroke\"", stroke_of(Some(stroke)))
            });
            let fill = paint_of("fill", Some(*colour));
            let text = escaped(text);
            let _ = writeln!(
                out,
                "<text x=\"{x}\" y=\"{y}\" font-size=\"{size}\"{anchor}{fill}{rim}>{text}</text>"
            );
        }
    }
}

fn look(fill: Option<Colour>, stroke: Option<Stroke>) -> String {
    paint_of("fill", fill) + &stroke_of(stroke)
}

fn stroke_of(stroke: Option<Stroke>) -> String {
    let Some(Stroke { colour, width }) = stroke else { return String::new() };
    format!("{} stroke-width=\"{}\"", paint_of("stroke", Some(colour)), number(width))
}

fn paint_of(what: &str, colour: Option<Colour>) -> String {
    match colour {
        None => format!(" {what}=\"none\""),
        Some(colour) if colour.alpha == 255 => format!(" {what}=\"{}\"", colour.hex()),
        Some(colour) => {
            let opacity = number(f64::from(colour.alpha) / 255.0);
            format!(" {what}=\"{}\" {what}-opacity=\"{opacity}\"", colour.hex())
        }
    }
}

fn pair(point: DVec2) -> String {
    format!("{} {}", number(point.x), number(point.y))
}

/// A number to two decimals, without zeros at its end, the same on every platform.
fn number(value: f64) -> String {
    let hundredths = (value * 100.0).round() as i64;
    let (sign, rest) = (if hundredths < 0 { "-" } else { "" }, hundredths.unsigned_abs());
    match (rest / 100, rest % 100) {
        (whole, 0) => format!("{sign}{whole}"),
        (whole, part) if part % 10 == 0 => format!("{sign}{whole}.{}", part / 10),
        (whole, part) => format!("{sign}{whole}.{part:02}"),
    }
}

/// Text as XML holds it; characters that XML 1.0 does not know are left out.
fn escaped(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for letter in text.chars() {
        match letter {
            '&' => out.push_str("&amp;"),
            '<' => out.push_str("&lt;"),
            '>' => out.push_str("&gt;"),
            '"' => out.push_str("&quot;"),
            '\t' | '\n' | '\r' => out.push(' '),
            '\u{0}'..'\u{20}' | '\u{fffe}' | '\u{ffff}' => {}
            other => out.push(other),
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_short_and_exact() {
        let cases =
            [(0.0, "0"), (-0.001, "0"), (1.5, "1.5"), (-12.345, "-12.35"), (0.07, "0.07"), (640.0, "640")];
        for (value, text) in cases {
            assert_eq!(number(value), text);
        }
    }

    #[test]
    fn a_name_cannot_break_out_of_the_document() {
        let title = "</title><script>alert(\"1\")</script>\u{0}&".to_owned();
        let scene = Scene { title, ..Scene::default() };
        let svg = paint(&scene, &Sheet::new(300.0, 200.0, crate::Theme::Light));
        assert!(!svg.contains("<script"));
        assert!(!svg.contains('\u{0}'));
        assert!(svg.contains("&lt;/title&gt;&lt;script&gt;alert(&quot;1&quot;)&lt;/script&gt;&amp;"));
    }
}
