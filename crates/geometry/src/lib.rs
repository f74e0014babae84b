//! Poses, segments and angles: the plane geometry under everything else.
//!
//! All lengths are metres, all angles radians, counter-clockwise positive, x
//! forward and y left (REP-103). Every transcendental function goes through
//! [`trig`], so that the same input gives the same bits on Linux, in Node and in
//! a browser.
//!
//! Transforms carry both frames in their name, target first:
//!
//! ```
//! use cogmap_geometry::{DVec2, Pose, trig::FRAC_PI_2};
//!
//! let map_from_robot = Pose::new(2.0, 1.0, FRAC_PI_2);
//! let seen_ahead = DVec2::new(3.0, 0.0);
//! let in_map = map_from_robot * seen_ahead;
//! assert!((in_map - DVec2::new(2.0, 4.0)).length() < 1e-12);
//! ```

mod angle;
mod line;
mod metric;
mod motion;
mod outline;
mod pose;
mod segment;
pub mod trig;

pub use angle::{line_angle_between, normalize_angle};
pub use glam::DVec2;
pub use line::{LineFit, fit_line};
pub use metric::Metric;
pub use motion::fit_motion;
pub use outline::is_inside;
pub use pose::Pose;
pub use segment::Segment;
