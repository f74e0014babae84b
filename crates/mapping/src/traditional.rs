//! Integrating views by transformation (§3.1.2): the map is what odometry makes of the views.

mod odometry;

pub use odometry::{Odometry, OdometryParams};
