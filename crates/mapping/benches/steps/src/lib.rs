//! What `cargo bench` times: extraction and each mapper's step on a recorded log, and how a step of
//! the recommended mapper grows with the map.
//!
//! The same code is timed natively by `benches/steps` and, built for wasm32, in Node by `node.mjs`,
//! through the few functions of [`exports`].

pub mod exports;
mod gallery;
mod task;

pub use task::{Prepared, SIZES, TASKS};
