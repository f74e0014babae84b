//! The mapping core of Cogmap: from a laser scan to a map, as Yeap's theory of perceptual mapping
//! says and as a 2011 thesis programmed it.
//!
//! The rooms follow the thesis: [`perception`] turns a scan into surfaces (§3.1.1), [`memory`]
//! places surfaces relative to recognised ones and never moves what is stored (§3.2.1),
//! [`places`] finds exits and shares the map out among local spaces (§3.2.2), [`traditional`] puts
//! views together by odometry (§3.1.2). One call drives it all:
//! [`Mapper::observe`] takes a [`Reading`](perception::Reading) in and gives a [`StepReport`] out,
//! which says what was recognised, what became the reference, and what was placed.
//!
//! Nothing here does I/O, reads a clock, keeps global state or draws unseeded random numbers, so
//! the crate runs on a real robot as it is. It cannot name the simulation: the robot cannot peek.
//!
//! ```
//! use cogmap_geometry::Pose;
//! use cogmap_mapping::{Mapper, MapperSetup, perception::{Moment, Reading, Scan}};
//!
//! let mut mapper = Mapper::new(&MapperSetup::named("perceptual").unwrap(), 1);
//! let wall_ahead = (0..181).map(|beam| {
//!     let bearing = f64::from(beam - 90).to_radians();
//!     2.0 / cogmap_geometry::trig::cos(bearing).max(1e-9)
//! });
//! let report = mapper.observe(&Reading {
//!     t: 0.0,
//!     odom_from_robot: Pose::IDENTITY,
//!     moment: Moment::StepEnd,
//!     scan: Scan {
//!         robot_from_laser: Pose::IDENTITY,
//!         angle_min: -90_f64.to_radians(),
//!         angle_increment: 1_f64.to_radians(),
//!         range_max: 8.0,
//!         ranges: wall_ahead.collect(),
//!         labels: Vec::new(),
//!     },
//! });
//! assert_eq!(report.unwrap().placed.len(), 1);
//! assert!(mapper.mfis().surfaces()[0].segment.length() > 10.0);
//! ```

mod cadence;
mod fallbacks;
mod mapper;
pub mod memory;
pub mod perception;
pub mod places;
mod report;
mod sentence;
pub mod traditional;

pub use cadence::Cadence;
pub use fallbacks::{FallbackRun, fallback_runs};
pub use mapper::{Mapper, MapperSetup, PathPoint};
pub use report::{Event, Lost, Placement, Recalled, StepReport};
pub use sentence::{Clause, Sentence, say};
