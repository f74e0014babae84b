//! End-to-end tests of Cogmap, in one binary.
#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::panic,
    reason = "in a test, a panic is how a broken promise shows"
)]

// The crates depend on each other in one direction only, and the robot cannot peek at the truth.
mod architecture;

// Whatever is wrong with a file or an argument, the message names the place and the way out.
mod bad_input;

// Going home as the thesis does it: its experiments, its flaws.
mod faithful;

// The figures are made anew and compared byte by byte with those in `tests/goldens/figures/`.
mod figures;

// Pictures are compared byte by byte with those in `tests/goldens/`.
mod goldens;

// A robot finds home in designed worlds, whoever finds the way, and its session replays it.
mod homing;

// One session gives the same map natively, in Node and in a browser.
mod same_bytes;

// Short ways home end as the page's soak test expects them to end.
mod soak;

// What is stored stays as it is, whatever the mapper.
mod stable_memory;
