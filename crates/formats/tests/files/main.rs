//! What the readers make of real logs, of damaged ones, and of the schema.
#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::panic,
    clippy::print_stdout,
    reason = "in a test, a panic is how a broken promise shows, and a skipped one has to say so"
)]

// No bytes, however damaged, break a reader.
mod hostile;
// The floor plans of real buildings become worlds.
mod plans;
// The logs of two real robots are read whole.
mod recorded;
// The published schema is the one that the types have.
mod schema;
// The worlds that come with the project are good ones.
mod worlds;
