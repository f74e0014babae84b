use super::picture::{Picture, pixels};

/// Reads a PGM picture, plain (P2) or binary (P5), of 8 or 16 bits. An error says what is wrong.
pub(super) fn read(bytes: &[u8]) -> Result<Picture, String> {
    let binary = bytes.starts_with(b"P5");
    let mut text = Words { bytes: bytes.get(2..).unwrap_or_default() };
    let width = text.number("the width")?;
    let height = text.number("the height")?;
    let count = pixels(width, height)?;
    let white = text.number("the brightest value")?;
    if !(1..=65_535).contains(&white) {
        return Err(format!("its brightest value is {white}, expected 1 to 65535"));
    }
    let scaled = |value: u64| (value.min(white) * 255 / white) as u8;
    let brightness: Vec<u8> = if binary {
        let samples = text.bytes.get(1..).unwrap_or_default();
        if white < 256 {
            samples.iter().take(count).map(|&byte| scaled(byte.into())).collect()
        } else {
            let pairs = samples.as_chunks::<2>().0.iter().take(count);
            pairs.map(|&pair| scaled(u16::from_be_bytes(pair).into())).collect()
        }
    } else {
        // A pixel takes two bytes at least, so that no more are believed than the file can hold.
        let there = count.min(text.bytes.len());
        (0..there).map(|_| text.number("a pixel").map(scaled)).collect::<Result<_, _>>()?
    };
    if brightness.len() < count {
        return Err(format!("it ends after {} of {count} pixels", brightness.len()));
    }
    Ok(Picture { width: width as usize, height: height as usize, brightness })
}

/// Numbers between white space and comments.
struct Words<'a> {
    bytes: &'a [u8],
}

impl Words<'_> {
    fn number(&mut self, what: &str) -> Result<u64, String> {
        while let [first, rest @ ..] = self.bytes {
            match first {
                b'#' => {
                    let end = rest.iter().position(|byte| *byte == b'\n').unwrap_or(rest.len());
                    self.bytes = &rest[end..];
                }
                byte if byte.is_ascii_whitespace() => self.bytes = rest,
                _ => break,
            }
        }
        let digits = self.bytes.iter().take_while(|byte| byte.is_ascii_digit()).count();
        let (number, rest) = self.bytes.split_at(digits);
        self.bytes = rest;
        let number = std::str::from_utf8(number).ok().and_then(|text| text.parse().ok());
        number.ok_or_else(|| format!("expected {what} as a number"))
    }
}
