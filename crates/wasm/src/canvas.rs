//! The painter for the browser's canvas.

use std::rc::Rc;

use cogmap_geometry::{DVec2, trig::TAU};
use cogmap_scene::{Anchor, Colour, FONT_FAMILY, HALO, Mark, Picture, Scene, Sheet, Stroke};
use wasm_bindgen::{JsCast, JsValue, intern};
use web_sys::{OffscreenCanvas, OffscreenCanvasRenderingContext2d as Context};

mod hair;

use hair::{along, hairs};

/// Half the side of a square as large as a circle, in radii: √π / 2.
const DOT: f64 = 0.886;

/// Where on a canvas a sheet lies.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Place {
    /// Upper left corner, in pixels of the page.
    pub(crate) corner: DVec2,
    /// Pixels of the canvas to one of the page.
    pub(crate) density: f64,
}

/// Paints scenes, and keeps what of them has not changed since the last time.
#[derive(Debug, Default)]
pub(crate) struct Canvas {
    /// The still part that was painted last.
    last: Option<Still>,
    /// The still part that was painted more than once.
    kept: Option<(Still, OffscreenCanvas)>,
}

/// The still part of a picture: everything that it depends on.
#[derive(Debug)]
struct Still {
    scene: Rc<Scene>,
    sheet: Sheet,
    density: f64,
}

impl Canvas {
    /// Paints a scene at its place on a canvas.
    ///
    /// # Errors
    /// What the browser has against it, such as a canvas that is too large.
    pub(crate) fn paint(
        &mut self,
        context: &Context,
        scene: &Rc<Scene>,
        sheet: &Sheet,
        place: Place,
    ) -> Result<(), JsValue> {
        let sheet = Sheet { camera: Some(sheet.camera_for(scene)), ..*sheet };
        let Place { corner, density } = place;
        self.keep(scene, &sheet, density)?;
        context.save();
        context.set_transform(density, 0.0, 0.0, density, corner.x * density, corner.y * density)?;
        context.begin_path();
        context.rect(0.0, 0.0, sheet.width, sheet.height);
        context.clip();
        match &self.kept {
            Some((_, still)) => context.draw_image_with_offscreen_canvas_and_dw_and_dh(
                still,
                0.0,
                0.0,
                sheet.width,
                sheet.height,
            )?,
            None => paint_still(context, scene, &sheet, density)?,
        }
        let moving = Picture::changing(scene, &sheet);
        let painted = draw(context, moving.iter().chain(&Picture::surround(scene, &sheet)), density);
        context.restore();
        painted
    }

    /// Keeps the still part as a picture if it is the same as the last time: while somebody moves the map about, or
    /// it grows in every frame, a picture of it would be made for nothing.
    fn keep(&mut self, scene: &Rc<Scene>, sheet: &Sheet, density: f64) -> Result<(), JsValue> {
        let shows = |still: &Still| still.shows(scene, sheet, density);
        self.kept.take_if(|(still, _)| !shows(still));
        if self.kept.is_some() {
            return Ok(());
        }
        match self.last.take().filter(shows) {
            Some(still) => {
                let canvas = picture(scene, sheet, density)?;
                self.kept = Some((still, canvas));
            }
            None => self.last = Some(Still { scene: scene.clone(), sheet: *sheet, density }),
        }
        Ok(())
    }
}

impl Still {
    fn shows(&self, scene: &Rc<Scene>, sheet: &Sheet, density: f64) -> bool {
        let same = |scene: &Scene| self.scene.views == scene.views && self.scene.still == scene.still;
        self.density == density && self.sheet == *sheet && (Rc::ptr_eq(&self.scene, scene) || same(scene))
    }
}

/// A picture of the still part.
fn picture(scene: &Scene, sheet: &Sheet, density: f64) -> Result<OffscreenCanvas, JsValue> {
    let pixels = |length: f64| (length * density).round().max(1.0) as u32;
    let canvas = OffscreenCanvas::new(pixels(sheet.width), pixels(sheet.height))?;
    let context = canvas.get_context("2d")?.ok_or("this browser has no more room to draw in")?;
    let context: Context = context.unchecked_into();
    context.scale(density, density)?;
    paint_still(&context, scene, sheet, density)?;
    Ok(canvas)
}

fn paint_still(context: &Context, scene: &Scene, sheet: &Sheet, density: f64) -> Result<(), JsValue> {
    fill_with(context, sheet.theme.paper());
    context.fill_rect(0.0, 0.0, sheet.width, sheet.height);
    draw(context, &Picture::still(scene, sheet), density)
}

/// Paints a scene over a whole canvas, where nothing of it is worth keeping for the next time.
///
/// # Errors
/// What the browser has against it.
pub(crate) fn paint_once(
    context: &Context,
    scene: &Scene,
    sheet: &Sheet,
    density: f64,
) -> Result<(), JsValue> {
    let picture = Picture::of(scene, sheet);
    context.save();
    context.set_transform(density, 0.0, 0.0, density, 0.0, 0.0)?;
    fill_with(context, picture.paper);
    context.fill_rect(0.0, 0.0, picture.width, picture.height);
    let painted = draw(context, &picture.marks, density);
    context.restore();
    painted
}

fn draw<'a>(
    context: &Context,
    marks: impl IntoIterator<Item = &'a Mark>,
    density: f64,
) -> Result<(), JsValue> {
    context.set_line_cap("round");
    context.set_line_join("round");
    for mark in marks {
        match mark {
            Mark::Lines { stroke, lines } => draw_lines(context, *stroke, lines, density),
            Mark::Path { points, closed, fill, stroke } => {
                trace(context, points, *closed);
                put(context, *fill, *stroke);
            }
            Mark::Circles { circles, fill, stroke } => {
                context.begin_path();
                for &(center, radius) in circles {
                    add_circle(context, center, radius, density)?;
                }
                put(context, *fill, *stroke);
            }
            Mark::Text { at, text, size, anchor, colour, halo } => {
                context.set_font(intern(&format!("{size}px {FONT_FAMILY}")));
                context.set_text_align(match anchor {
                    Anchor::Start => "left",
                    Anchor::Middle => "center",
                });
                write(context, *at, text, *colour, *halo)?;
            }
        }
    }
    Ok(())
}

fn draw_lines(context: &Context, stroke: Stroke, lines: &[[DVec2; 2]], density: f64) {
    let hairs = hairs(stroke, density);
    let drawn = if hairs.is_empty() { stroke } else { Stroke { width: 1.0 / density, ..stroke } };
    set_pen(context, drawn);
    let together = !hairs.is_empty() || stroke.width * density <= 1.0 || stroke.colour.alpha < u8::MAX;
    context.begin_path();
    for &line in lines {
        if !together {
            context.begin_path();
        }
        if hairs.is_empty() {
            add(context, line);
        } else {
            let along = along(line);
            hairs.iter().for_each(|hair| add(context, hair.beside(line, along)));
        }
        if !together {
            context.stroke();
        }
    }
    if together {
        context.stroke();
    }
}

fn add(context: &Context, [a, b]: [DVec2; 2]) {
    context.move_to(a.x, a.y);
    context.line_to(b.x, b.y);
}

/// Adds a circle to a path; one that is hardly a pixel large looks the same as a square, which is drawn faster.
fn add_circle(context: &Context, center: DVec2, radius: f64, density: f64) -> Result<(), JsValue> {
    if radius * density > 1.0 {
        context.move_to(center.x + radius, center.y);
        return context.arc(center.x, center.y, radius, 0.0, TAU);
    }
    let half = radius * DOT;
    context.rect(center.x - half, center.y - half, 2.0 * half, 2.0 * half);
    Ok(())
}

fn trace(context: &Context, points: &[DVec2], closed: bool) {
    context.begin_path();
    for (index, point) in points.iter().enumerate() {
        if index == 0 {
            context.move_to(point.x, point.y);
        } else {
            context.line_to(point.x, point.y);
        }
    }
    if closed {
        context.close_path();
    }
}

fn put(context: &Context, fill: Option<Colour>, stroke: Option<Stroke>) {
    if let Some(fill) = fill {
        fill_with(context, fill);
        context.fill();
    }
    if let Some(stroke) = stroke {
        set_pen(context, stroke);
        context.stroke();
    }
}

fn write(
    context: &Context,
    at: DVec2,
    text: &str,
    colour: Colour,
    halo: Option<Colour>,
) -> Result<(), JsValue> {
    if let Some(colour) = halo {
        set_pen(context, Stroke { colour, width: 2.0 * HALO });
        context.stroke_text(text, at.x, at.y)?;
    }
    fill_with(context, colour);
    context.fill_text(text, at.x, at.y)
}

/// The colours of a theme are few: the browser is given each of them once, and reads it once.
fn fill_with(context: &Context, colour: Colour) {
    context.set_fill_style_str(intern(&colour.css()));
}

fn set_pen(context: &Context, stroke: Stroke) {
    context.set_stroke_style_str(intern(&stroke.colour.css()));
    context.set_line_width(stroke.width);
}
