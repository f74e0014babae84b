/// A colour of the screen (sRGB) with its opacity.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Colour {
    /// Red, green and blue.
    pub rgb: [u8; 3],
    /// 0 is clear, 255 is solid.
    pub alpha: u8,
}

impl Colour {
    /// The solid colour of a number such as `0xff8800`.
    #[must_use]
    pub const fn solid(number: u32) -> Self {
        let [_, r, g, b] = number.to_be_bytes();
        Self { rgb: [r, g, b], alpha: 255 }
    }

    /// The same colour, letting through what lies beneath.
    #[must_use]
    pub const fn with_alpha(self, alpha: u8) -> Self {
        Self { alpha, ..self }
    }

    /// The colour a share of the way to another one; 0 is this one, 1 the other.
    #[must_use]
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a mean of bytes is a byte")]
    pub fn towards(self, other: Self, share: f64) -> Self {
        let mix = |from: u8, to: u8| {
            let (from, to) = (f64::from(from), f64::from(to));
            (from + (to - from) * share.clamp(0.0, 1.0)).round() as u8
        };
        let [r, g, b] = self.rgb;
        let [to_r, to_g, to_b] = other.rgb;
        Self { rgb: [mix(r, to_r), mix(g, to_g), mix(b, to_b)], alpha: mix(self.alpha, other.alpha) }
    }

    /// As style sheets and SVG write it without its opacity, such as `#ff8800`.
    #[must_use]
    pub fn hex(self) -> String {
        let [r, g, b] = self.rgb;
        format!("#{r:02x}{g:02x}{b:02x}")
    }

    /// As a canvas takes it, opacity included, such as `#ff880080`.
    #[must_use]
    pub fn css(self) -> String {
        if self.alpha == 255 { self.hex() } else { format!("{}{:02x}", self.hex(), self.alpha) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_colour_is_written_as_browsers_read_it() {
        let orange = Colour::solid(0xff_88_00);
        assert_eq!(orange.css(), "#ff8800");
        assert_eq!(orange.with_alpha(128).css(), "#ff880080");
        assert_eq!(orange.with_alpha(128).hex(), "#ff8800");
    }

    #[test]
    fn mixing_begins_at_one_colour_and_ends_at_the_other() {
        let (black, white) = (Colour::solid(0), Colour::solid(0xff_ff_ff));
        assert_eq!(black.towards(white, 0.0), black);
        assert_eq!(black.towards(white, 1.0), white);
        assert_eq!(black.towards(white, 0.5).rgb, [128; 3]);
        assert_eq!(black.towards(white, 7.0), white);
    }
}
