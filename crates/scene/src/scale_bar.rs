use cogmap_geometry::DVec2;

use crate::{Camera, Colour, brush::Brush, font::CAP_HEIGHT, theme::Stroke};

/// A round length and how long it is on the screen.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct ScaleBar {
    /// Such as `5 m`.
    text: String,
    /// Pixels.
    length: f64,
}

impl ScaleBar {
    /// Pixels that bar and text may take.
    pub(crate) const ROOM: f64 = LONGEST + 44.0;

    /// The longest bar of 1, 2 or 5 times a power of ten that fits.
    pub(crate) fn of(camera: Camera) -> Self {
        let round = |length: &&(f64, &str)| length.0 * camera.pixels_per_metre <= LONGEST;
        let (metres, text) = LENGTHS.iter().rfind(round).copied().unwrap_or(LENGTHS[0]);
        Self { text: text.to_owned(), length: metres * camera.pixels_per_metre }
    }

    /// Draws it with the middle of its left end at `at`.
    pub(crate) fn draw(&self, brush: &mut Brush, at: DVec2) {
        const SIZE: f64 = 12.0;
        let palette = brush.theme().palette();
        let (left, right) = (at, at + DVec2::new(self.length, 0.0));
        let tick = DVec2::new(0.0, 4.0);
        for (number, width) in [(palette.paper, 5.5), (palette.ink, 1.5)] {
            let stroke = Stroke { colour: Colour::solid(number), width };
            brush.line([left, right], stroke);
            brush.line([left - tick, left + tick], stroke);
            brush.line([right - tick, right + tick], stroke);
        }
        let text = right + DVec2::new(8.0, SIZE * CAP_HEIGHT * 0.5);
        brush.text(text, &self.text, SIZE, palette.ink);
    }
}

/// Pixels.
const LONGEST: f64 = 100.0;
/// Metres and how they are written.
const LENGTHS: [(f64, &str); 14] = [
    (0.01, "1 cm"),
    (0.02, "2 cm"),
    (0.05, "5 cm"),
    (0.1, "10 cm"),
    (0.2, "20 cm"),
    (0.5, "50 cm"),
    (1.0, "1 m"),
    (2.0, "2 m"),
    (5.0, "5 m"),
    (10.0, "10 m"),
    (20.0, "20 m"),
    (50.0, "50 m"),
    (100.0, "100 m"),
    (200.0, "200 m"),
];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_bar_is_readable_at_every_scale() {
        let mut scale = *Camera::SCALES.start();
        while scale <= *Camera::SCALES.end() {
            let bar = ScaleBar::of(Camera { center: DVec2::ZERO, pixels_per_metre: scale });
            assert!((19.9..=LONGEST).contains(&bar.length), "{bar:?} at {scale}");
            scale *= 1.1;
        }
    }

    #[test]
    fn the_bar_is_as_long_as_it_says() {
        let bar = ScaleBar::of(Camera { center: DVec2::ZERO, pixels_per_metre: 30.0 });
        assert_eq!(bar, ScaleBar { text: "2 m".to_owned(), length: 60.0 });
    }
}
