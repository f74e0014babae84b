//! Measures of maps, places and rates.
//!
//! All are pure functions of plain data: the command line's studies and the page use the same ones.
//! The thesis judges its maps by eye; every measure here is ours.

mod alignment;
mod asrs;
mod blocked;
mod bootstrap;
mod closing;
mod displacement;
mod duplicates;
mod exits;
mod growth;
mod loops;
mod paired;
mod rate;
mod rectangle;
pub mod relations;
mod shape;
mod walls;

pub use alignment::{Sample, by_first_view, by_whole_way};
pub use asrs::{Division, Labelled, score_division};
pub use blocked::blocked_steps;
pub use bootstrap::{Estimate, estimate, median, median_estimate, ratio_estimate, share_estimate};
pub use closing::{Closing, closing};
pub use displacement::{Displacement, displacement};
pub use duplicates::{Duplicates, duplicates};
pub use exits::{Doorway, ExitScore, doorways, room_at, score_exits};
pub use growth::{error_over, growth_exponent};
pub use loops::{LoopScore, PlaceGraph, Visit, network_edits, score_loops};
pub use paired::{Paired, paired};
pub use rate::{Interval, Rate};
pub use rectangle::{RectangleFit, rectangle_fit};
pub use shape::{Shape, length, shape, side_angles};
pub use walls::{LONG, Mapped, Walls};
