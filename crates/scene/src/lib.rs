//! What to draw, in metres, and the painters that draw it.

mod brush;
mod camera;
mod clip;
mod colour;
mod font;
mod footer;
mod label;
mod mark;
mod memory_scene;
mod palette;
mod picture;
#[cfg(feature = "png")]
pub mod png;
mod ramp;
mod role;
mod scale_bar;
mod scene;
pub mod svg;
mod theme;
mod world_scene;

pub use camera::{Bounds, Camera, Margins};
pub use colour::Colour;
pub use font::{FONT, FONT_FAMILY};
pub use mark::{Anchor, HALO, Mark};
pub use memory_scene::{MemoryOptions, memory_scene};
pub use picture::{Picture, Sheet};
pub use role::Role;
pub use scene::{Item, LegendEntry, Sample, Scene, Shape};
pub use theme::{Sign, Stroke, Style, Theme};
pub use world_scene::{WorldOptions, world_scene};
