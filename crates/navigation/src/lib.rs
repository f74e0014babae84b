//! Go Home (§3.3): from a map and what the robot sees to the next step on the way back.
//!
//! The rooms follow the thesis: [`direction`] decides which way to go (§3.3.2) … One call after each
//! scan, [`Homing::observe`], and one whenever the robot has come to rest, [`Homing::decide`], drive
//! it all; a [`Decision`] says what to do next and why.
//!
//! The robot's belief comes from its [`Mapper`](cogmap_mapping::Mapper), which this crate reads and
//! never writes. Nothing here does I/O, reads a clock, keeps global state or draws random numbers,
//! and it cannot name the simulation: the robot cannot peek at the truth.

mod belief;
mod decision;
mod homing;
mod recommended;
mod retrace;
mod route;
mod steering;
mod strategy;
mod tangent_bug;
mod vigilance;

pub use belief::{Anchored, Atlas, Belief};
pub use decision::{Act, Decision, HomingEvent, Mode, MovementOption};
pub use homing::{Homing, HomingParams};
pub use recommended::{Footing, RecommendedParams, RescueParams};
pub use retrace::RetraceParams;
pub use strategy::StrategySetup;
pub use tangent_bug::TangentBugParams;
pub use vigilance::{Vigilance, VigilanceParams};
