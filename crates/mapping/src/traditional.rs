//! The traditional algorithm (§3.1): the map is what the robot's movement makes of the views.
//!
//! [`Odometry`] believes the wheels (§3.1.2); [`Transform`] corrects them by a simple annealing
//! (§3.1.3).

mod annealing;
mod odometry;
mod transform;

pub use annealing::{Annealing, Correction, anneal};
pub use odometry::{Odometry, OdometryParams};
pub use transform::{Transform, TransformParams};
