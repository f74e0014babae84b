//! Files packed with gzip.

use std::{borrow::Cow, io::Read};

use flate2::bufread::MultiGzDecoder;

use crate::{FormatError, error::Place};

/// The most that a compressed file may unpack to, bytes; the longest public logs stay under a tenth.
pub const UNPACKED_LIMIT: usize = 512 << 20;

/// The bytes of a file, unpacked if they begin with the mark of gzip.
///
/// # Errors
/// [`FormatError::Gzip`] where they cannot be unpacked, [`FormatError::TooLarge`] beyond [`UNPACKED_LIMIT`].
pub fn unpack<'a>(bytes: &'a [u8], file: &str) -> Result<Cow<'a, [u8]>, FormatError> {
    unpacked(bytes, file, UNPACKED_LIMIT)
}

fn unpacked<'a>(bytes: &'a [u8], file: &str, limit: usize) -> Result<Cow<'a, [u8]>, FormatError> {
    if !bytes.starts_with(&[0x1f, 0x8b]) {
        return Ok(Cow::Borrowed(bytes));
    }
    let mut plain = Vec::new();
    let mut reader = MultiGzDecoder::new(bytes).take(limit as u64 + 1);
    reader
        .read_to_end(&mut plain)
        .map_err(|error| FormatError::Gzip { place: Place::file(file), problem: error.to_string() })?;
    if plain.len() > limit {
        return Err(FormatError::TooLarge { place: Place::file(file), limit, unit: "bytes once unpacked" });
    }
    Ok(Cow::Owned(plain))
}

#[cfg(test)]
mod tests {
    use super::*;
    use flate2::{Compression, write::GzEncoder};
    use std::io::Write;

    fn packed(plain: &[u8]) -> Vec<u8> {
        let mut encoder = GzEncoder::new(Vec::new(), Compression::default());
        encoder.write_all(plain).unwrap();
        encoder.finish().unwrap()
    }

    #[test]
    fn gzip_is_recognised_by_its_first_bytes() {
        assert_eq!(unpacked(&packed(b"ODOM"), "a", 99).unwrap().as_ref(), b"ODOM");
        assert_eq!(unpacked(b"ODOM", "a", 99).unwrap().as_ref(), b"ODOM");
    }

    #[test]
    fn a_bomb_is_stopped_at_the_limit() {
        let bomb = packed(&vec![0; 1 << 20]);
        assert!(matches!(unpacked(&bomb, "a", 1000), Err(FormatError::TooLarge { limit: 1000, .. })));
    }

    #[test]
    fn a_cut_off_file_says_so() {
        let whole = packed(b"ODOM 1 2 3 4 5 6 7 8");
        assert!(matches!(unpacked(&whole[..whole.len() - 9], "a", 99), Err(FormatError::Gzip { .. })));
    }
}
