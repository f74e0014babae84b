//! Every file that Cogmap reads or writes.
//!
//! | file | read | written |
//! |---|---|---|
//! | world, `NAME.world.json` | [`world::read`] | [`world::write`], [`world::schema`] |
//! | floor plan, ROS `map_server` YAML, PNG, PGM | [`plan::Plan::trace`] | |
//! | session, `session.json` | [`session::read`] | [`session::write`] |
//! | situation, in links of the page | [`situation::read`] | [`situation::write`] |
//! | CARMEN log | [`carmen::read`] | |
//! | trajectory, `*.tum` | [`tum::read`] | [`tum::write`] |
//! | hand-matched relations, `*.relations` | [`relations::read`] | |
//! | what a run leaves | | [`run::files`] |
//!
//! Whatever a file contains, reading it ends in a value or in a [`FormatError`] that names the place
//! and the way out; it neither panics nor takes memory without bound. Writing gives the same bytes
//! for the same value everywhere.

pub mod carmen;
mod digest;
mod error;
pub mod gzip;
mod json;
mod kind;
pub mod plan;
pub mod relations;
pub mod run;
pub mod session;
pub mod situation;
pub mod tum;
pub mod world;

pub use digest::sha256_hex;
pub use error::{Complaint, FormatError, Place};
pub use kind::Kind;
