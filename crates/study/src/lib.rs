//! What a map is worth: metrics against the truth, and the thesis's experiments run many times over.
//!
//! [`metrics`] compare what a robot remembers with the building that it was in; the robot's own code
//! never sees them. A [`Study`] is an experiment: it plans [`Condition`]s, each of which is driven
//! with many seeds; every mapper is fed from the same [`Drive`], and what it made of it, a
//! [`Mapping`], is [`score`]d into one [`Row`]. The [`Outcome`] of all rows is judged by [`Check`]s.
//! [`figures`] draw what the thesis drew, from new runs.
//!
//! ```
//! use cogmap_study::{Request, Study};
//! let study = Study::named("small").unwrap();
//! let conditions = (study.plan)(&Request::default()).unwrap();
//! assert_eq!(conditions.len(), 2, "a good robot and a bad one");
//! ```

mod check;
mod condition;
mod drive;
pub mod figures;
#[cfg(not(target_arch = "wasm32"))]
pub mod home;
mod kidnap;
mod mapping;
mod measure;
pub mod metrics;
mod outcome;
#[cfg(not(target_arch = "wasm32"))]
pub mod runner;
pub mod score;
mod studies;
mod study;
mod summary;
mod worlds;

pub use check::{Bound, Check, Claim, Verdict};
pub use condition::{Condition, Course, Ground, Log, Outing, Treatment, Variant};
pub use drive::{Drive, Look, drive};
pub use mapping::Mapping;
pub use measure::{Kind, MEASURES, Measure};
pub use outcome::{Group, Outcome, Row};
pub use study::{Request, Study};
pub use summary::{Seeds, Summary};
pub use worlds::world;
