//! What `cargo bench` times: the laser's raycaster against parry's BVH and
//! against brute force, in generated offices.
//!
//! The same code is timed natively by `benches/raycast.rs` and, built for
//! wasm32, in Node by `node.mjs`, through the few functions of [`exports`].

mod contest;
pub mod exports;
mod office;

pub use contest::{BATCH, Contest, METHODS, POSES, RANGE_MAX, SIZES};
