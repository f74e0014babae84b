use sha2::{Digest, Sha256};

/// SHA-256 of some bytes, in hexadecimal: how a session names the log that it was made from.
///
/// ```
/// let digest = cogmap_formats::sha256_hex(b"abc");
/// assert!(digest.starts_with("ba7816bf") && digest.len() == 64);
/// ```
#[must_use]
pub fn sha256_hex(bytes: &[u8]) -> String {
    Sha256::digest(bytes).iter().map(|byte| format!("{byte:02x}")).collect()
}
