//! Measures of maps, places and rates.

mod rate;

pub use rate::{Interval, Rate};
