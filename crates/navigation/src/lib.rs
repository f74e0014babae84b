//! Go Home (§3.3): from a map and what the robot sees to the next step on the way back.
//!
//! The rooms of the strategy `faithful` follow the thesis: `options` and `direction` decide which way to go
//! (§3.3.2), `recent` and `dead_ends` say what is still trusted and what was tried (§3.3.3), `route` and
//! `failsafe` follow the known way (§3.3.4). Ours is in `recommended`. One call after each scan,
//! [`Homing::observe`], and one whenever the robot has come to rest, [`Homing::decide`], drive it all; a
//! [`Decision`] says what to do next and why.
//!
//! The robot's belief comes from its [`Mapper`](cogmap_mapping::Mapper), which this crate reads and
//! never writes. Nothing here does I/O, reads a clock, keeps global state or draws random numbers,
//! and it cannot name the simulation: the robot cannot peek at the truth.

mod belief;
mod dead_ends;
mod decision;
mod deed;
mod direction;
mod failsafe;
mod faithful;
mod homing;
mod options;
mod recent;
mod recommended;
mod retrace;
mod route;
mod steering;
mod strategy;
mod surroundings;
mod tangent_bug;
mod trial;
mod vigilance;

pub use belief::{Anchored, Atlas, Belief};
pub use decision::{Act, Decision, HomingEvent, Mode, MovementOption};
pub use direction::Straightest;
pub use failsafe::FailsafeParams;
pub use faithful::FaithfulParams;
pub use homing::{Homing, HomingParams};
pub use options::OptionsParams;
pub use recent::ForgettingParams;
pub use recommended::{Footing, RecommendedParams, RescueParams};
pub use retrace::RetraceParams;
pub use strategy::StrategySetup;
pub use tangent_bug::TangentBugParams;
pub use vigilance::{Vigilance, VigilanceParams};
