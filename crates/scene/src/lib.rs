//! What to draw, in metres, and the painters that draw it.
//!
//! A [`Scene`] is one description of a picture: [`Item`]s of a [`Role`] and a [`Shape`] in metres,
//! and the legend that explains them. [`world_scene`] shows the truth, [`memory_scene`] what a robot
//! makes of it. A [`Sheet`] says how large the picture is, which [`Theme`] it follows and which part
//! of the plane its [`Camera`] shows. [`Picture::of`] lays the one out on the other as [`Mark`]s in
//! pixels, title, scale bar and legend included, and all that is left to a painter is to put marks
//! on the screen: [`svg`] and [`png`](mod@png) here, the browser's canvas in the page's own crate. No
//! painter knows a colour; they all come from the theme. A [`Plate`] lays several scenes out as a figure,
//! with a caption and one legend, and its [`Annotation`]s say what there is to see.
//!
//! ```
//! use cogmap_geometry::{DVec2, Segment};
//! use cogmap_scene::{Item, Role, Scene, Shape, Sheet, Theme, svg};
//!
//! let wall = Segment::new(DVec2::ZERO, DVec2::new(4.0, 3.0));
//! let still = vec![Item::new(Role::Wall, Shape::Segments(vec![wall]))];
//! let scene = Scene { title: "A wall".to_owned(), still, ..Scene::default() };
//! let document = svg::paint(&scene, &Sheet::new(600.0, 400.0, Theme::Light));
//! assert!(document.contains("<title>A wall</title>"));
//! ```
//!
//! Nothing here calls the platform's own trigonometry: the same scene gives the same bytes everywhere.

mod annotation;
mod brush;
mod camera;
mod clip;
mod close_up;
mod colour;
mod font;
mod footer;
mod homing_mark;
mod homing_scene;
mod label;
mod mark;
mod memory_scene;
mod network_scene;
mod palette;
mod picture;
mod place_mark;
mod plan_scene;
mod plate;
#[cfg(feature = "png")]
pub mod png;
mod ramp;
mod role;
mod scale_bar;
mod scene;
mod stage_scene;
mod surfaces;
pub mod svg;
mod theme;
mod things;
mod truth_scene;
mod world_scene;

pub use annotation::Annotation;
pub use camera::{Bounds, Camera, Margins};
pub use colour::Colour;
pub use font::{FONT, FONT_FAMILY};
pub use homing_mark::HomingMark;
pub use homing_scene::{believed_home, decision_in_force};
pub use mark::{Anchor, HALO, Mark};
pub use memory_scene::{MemoryOptions, memory_scene};
pub use network_scene::loops;
pub use picture::{Picture, Sheet};
pub use place_mark::PlaceMark;
pub use plan_scene::plan_scene;
pub use plate::{Panel, Plate};
pub use role::Role;
pub use scene::{Item, LegendEntry, Sample, Scene, Shape};
pub use stage_scene::{Stage, distrusted, narrowest, point_out};
pub use surfaces::Colouring;
pub use theme::{Sign, Stroke, Style, Theme};
pub use things::{Thing, segment_of, set_off, thing_at, things_like};
pub use truth_scene::TruthFit;
pub use world_scene::{WorldOptions, world_scene};
