use std::io::Cursor;

use png::{ColorType, Decoder, Limits, Transformations};

use super::{graymap, unusable};
use crate::FormatError;

/// The most pixels of a plan: 200 m by 200 m at 5 cm each.
pub(super) const PIXELS_MAX: u64 = 16_000_000;
/// Bytes that unpacking may take besides the picture itself.
const WORKSPACE: usize = 64 << 20;

/// A picture as far as a plan needs it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Picture {
    /// Pixels.
    pub width: usize,
    /// Pixels.
    pub height: usize,
    /// From 0, black, to 255, row by row from the top; what is transparent is as bright as paper.
    pub brightness: Vec<u8>,
}

impl Picture {
    /// Reads a PNG or PGM picture of at most 16 million pixels. `file` is its name for messages.
    ///
    /// # Errors
    /// [`FormatError`] where it is neither, is broken or is too large.
    pub fn read(bytes: &[u8], file: &str) -> Result<Self, FormatError> {
        if bytes.starts_with(b"\x89PNG") {
            return png(bytes, file);
        }
        if matches!(bytes, [b'P', b'2' | b'5', ..]) {
            return graymap::read(bytes).map_err(|problem| {
                unusable(file, format!("broken PGM picture: {problem}"), "save the picture again, or as PNG")
            });
        }
        Err(unusable(file, "neither a PNG nor a PGM picture", "save the plan as PNG"))
    }

    /// The same picture at most so many pixels wide and high: each of its pixels is as dark as the darkest that it
    /// stands for, so that thin walls stay in sight.
    #[must_use]
    pub fn at_most(&self, side: usize) -> Self {
        let step = self.width.max(self.height).div_ceil(side.max(1)).max(1);
        let (width, height) = (self.width.div_ceil(step), self.height.div_ceil(step));
        let mut brightness = vec![u8::MAX; width * height];
        for (row, pixels) in self.brightness.chunks_exact(self.width).enumerate() {
            let shades = &mut brightness[row / step * width..][..width];
            for (shade, block) in shades.iter_mut().zip(pixels.chunks(step)) {
                *shade = block.iter().copied().fold(*shade, u8::min);
            }
        }
        Self { width, height, brightness }
    }
}

/// Whether a picture of this size is small enough; a message where it is not.
pub(super) fn pixels(width: u64, height: u64) -> Result<usize, String> {
    let pixels = width.saturating_mul(height);
    match usize::try_from(pixels) {
        Ok(0) => Err("it has no pixels".to_owned()),
        Ok(count) if pixels <= PIXELS_MAX => Ok(count),
        _ => Err(format!("{width} by {height} pixels are more than {PIXELS_MAX}")),
    }
}

fn png(bytes: &[u8], file: &str) -> Result<Picture, FormatError> {
    let broken = |error: png::DecodingError| {
        unusable(file, format!("broken PNG picture: {error}"), "fetch the file again, or save it again")
    };
    let mut decoder = Decoder::new_with_limits(Cursor::new(bytes), Limits { bytes: WORKSPACE });
    decoder.set_transformations(Transformations::normalize_to_color8());
    let mut reader = decoder.read_info().map_err(broken)?;
    let (width, height) = reader.info().size();
    let too_large = |problem| unusable(file, problem, "make the picture smaller and the resolution larger");
    let count = pixels(width.into(), height.into()).map_err(too_large)?;
    let mut samples = vec![0; reader.output_buffer_size().unwrap_or(0)];
    let frame = reader.next_frame(&mut samples).map_err(broken)?;
    let brightness = match frame.color_type {
        ColorType::Rgb => gray::<3>(&samples, |&[r, g, b]| mean(r, g, b)),
        ColorType::Rgba => gray::<4>(&samples, |&[r, g, b, alpha]| on_paper(mean(r, g, b), alpha)),
        ColorType::GrayscaleAlpha => gray::<2>(&samples, |&[shade, alpha]| on_paper(shade, alpha)),
        ColorType::Grayscale | ColorType::Indexed => samples,
    };
    if brightness.len() < count {
        return Err(unusable(file, "the picture ends too early", "fetch the file again, or save it again"));
    }
    Ok(Picture { width: width as usize, height: height as usize, brightness })
}

fn gray<const N: usize>(samples: &[u8], shade: impl Fn(&[u8; N]) -> u8) -> Vec<u8> {
    samples.as_chunks::<N>().0.iter().map(shade).collect()
}

fn mean(red: u8, green: u8, blue: u8) -> u8 {
    ((u16::from(red) + u16::from(green) + u16::from(blue)) / 3) as u8
}

fn on_paper(shade: u8, alpha: u8) -> u8 {
    let covered = (255 - u16::from(shade)) * u16::from(alpha) / 255;
    255 - covered as u8
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_smaller_picture_keeps_thin_walls() {
        let mut picture = Picture { width: 7, height: 5, brightness: vec![255; 35] };
        picture.brightness[4 * 7 + 6] = 3;
        let small = picture.at_most(3);
        assert_eq!((small.width, small.height), (3, 2));
        assert_eq!(small.brightness, [255, 255, 255, 255, 255, 3]);
        assert_eq!(picture.at_most(7), picture);
        assert_eq!(picture.at_most(0).brightness, [3]);
    }
}
