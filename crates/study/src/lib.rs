//! What a map is worth: metrics against the truth, and the thesis's experiments run many times over.
//!
//! [`metrics`] compare what a robot remembers with the building that it was in; the robot's own code
//! never sees them.

pub mod metrics;
