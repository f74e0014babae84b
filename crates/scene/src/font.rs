/// What pictures that carry no font of their own ask for.
pub const FONT_FAMILY: &str = "Inter, 'Helvetica Neue', Arial, 'Liberation Sans', sans-serif";

/// A subset of Inter Regular as OpenType (licence beside it in `font/OFL.txt`), so that a picture looks
/// the same wherever it is painted.
pub const FONT: &[u8] = include_bytes!("../font/Inter-Regular-subset.otf");

/// Height of a capital letter as a share of the size.
pub(crate) const CAP_HEIGHT: f64 = 2048.0 / UNITS;

const UNITS: f64 = 2816.0;

/// Advance widths from the space to the tilde, in units of the font.
const ADVANCES: [u16; 95] = [
    792, 784, 1136, 1776, 1796, 2288, 1800, 624, 1020, 1020, 1408, 1856, 788, 1296, 776, 1004, 1760, 1308,
    1704, 1792, 1808, 1712, 1756, 1608, 1736, 1756, 776, 788, 1856, 1856, 1856, 1428, 2636, 1904, 1832, 2048,
    2024, 1684, 1652, 2092, 2084, 744, 1528, 1836, 1584, 2504, 2120, 2144, 1788, 2144, 1800, 1796, 1808,
    2088, 1904, 2672, 1808, 1872, 1760, 1020, 1004, 1020, 1320, 1272, 1400, 1588, 1748, 1572, 1748, 1640,
    1016, 1716, 1664, 668, 668, 1532, 668, 2448, 1648, 1680, 1716, 1716, 1048, 1472, 1024, 1636, 1568, 2288,
    1520, 1568, 1524, 1020, 920, 1020, 1856,
];

/// What a letter beyond ASCII is taken to advance.
const OTHER: u16 = 1760;

/// Pixels that a line of text takes at a size in pixels; exact for ASCII, close for the rest.
pub(crate) fn text_width(text: &str, size: f64) -> f64 {
    let advance = |letter: char| {
        let index = (letter as usize).checked_sub(' ' as usize);
        index.and_then(|index| ADVANCES.get(index)).copied().unwrap_or(OTHER)
    };
    let units: u64 = text.chars().map(|letter| u64::from(advance(letter))).sum();
    units as f64 / UNITS * size
}

/// The text, or its beginning with an ellipsis where it is wider than `room` pixels.
pub(crate) fn shortened(text: &str, size: f64, room: f64) -> String {
    if text_width(text, size) <= room {
        return text.to_owned();
    }
    let mut kept: String = text.to_owned();
    while !kept.is_empty() && text_width(&kept, size) + size > room {
        kept.pop();
    }
    format!("{}…", kept.trim_end())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn long_titles_end_in_an_ellipsis() {
        assert_eq!(shortened("Office", 17.0, 300.0), "Office");
        let short = shortened("An office with far too long a name", 17.0, 120.0);
        assert!(short.ends_with('…') && text_width(&short, 17.0) <= 120.0, "{short}");
    }
}
