//! Measures of maps, places and rates.

mod asrs;
mod exits;
mod loops;
mod rate;
pub mod relations;

pub use asrs::{Division, Labelled, score_division};
pub use exits::{Doorway, ExitScore, doorways, room_at, score_exits};
pub use loops::{LoopScore, PlaceGraph, Visit, network_edits, score_loops};
pub use rate::{Interval, Rate};
