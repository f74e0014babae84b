//! From a scan to surfaces (§3.1.1).

mod ends;
mod extraction;
mod scan;
mod surface;

pub use extraction::{Extraction, extract};
pub use scan::{Moment, Reading, Scan};
pub use surface::{End, Surface, View};
