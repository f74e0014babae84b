use core::ops::Mul;

use glam::DVec2;
use serde::{Deserialize, Serialize};

use crate::{Segment, normalize_angle, trig};

/// A rigid motion of the plane: where a frame lies in another one.
///
/// `map_from_robot * point` takes a point from the robot's frame to the map's;
/// `map_from_robot * robot_from_laser` chains two frames.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Pose {
    /// The origin of the inner frame in the outer one, metres.
    pub position: DVec2,
    /// The direction of the inner x axis in the outer frame, radians in `(-π, π]`.
    pub heading: f64,
}

impl Pose {
    /// The motion that changes nothing.
    pub const IDENTITY: Self = Self { position: DVec2::ZERO, heading: 0.0 };

    /// A pose at `(x, y)` metres, heading in radians.
    #[must_use]
    pub fn new(x: f64, y: f64, heading: f64) -> Self {
        Self { position: DVec2::new(x, y), heading: normalize_angle(heading) }
    }

    /// The pose whose frame is the outer one seen from the inner one.
    #[must_use]
    pub fn inverse(self) -> Self {
        let turned = rotate(-self.position, -self.heading);
        Self::new(turned.x, turned.y, -self.heading)
    }

    /// Where `other` lies seen from this pose: `self.inverse() * other`.
    #[must_use]
    pub fn from_here(self, other: Self) -> Self {
        self.inverse() * other
    }

    /// Turns `vector` from the inner frame's axes to the outer frame's.
    #[must_use]
    pub fn rotate(self, vector: DVec2) -> DVec2 {
        rotate(vector, self.heading)
    }

    /// The x axis of the inner frame, as a unit vector of the outer one.
    #[must_use]
    pub fn forward(self) -> DVec2 {
        let (sin, cos) = trig::sin_cos(self.heading);
        DVec2::new(cos, sin)
    }
}

fn rotate(vector: DVec2, angle: f64) -> DVec2 {
    let (sin, cos) = trig::sin_cos(angle);
    DVec2::new(cos * vector.x - sin * vector.y, sin * vector.x + cos * vector.y)
}

impl Mul for Pose {
    type Output = Self;

    fn mul(self, inner: Self) -> Self {
        let position = self * inner.position;
        Self::new(position.x, position.y, self.heading + inner.heading)
    }
}

#[allow(clippy::suspicious_arithmetic_impl, reason = "a rigid motion turns, then shifts")]
impl Mul<DVec2> for Pose {
    type Output = DVec2;

    fn mul(self, point: DVec2) -> DVec2 {
        self.position + rotate(point, self.heading)
    }
}

impl Mul<Segment> for Pose {
    type Output = Segment;

    fn mul(self, segment: Segment) -> Segment {
        Segment::new(self * segment.a, self * segment.b)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    prop_compose! {
        fn any_pose()(x in -50.0f64..50.0, y in -50.0f64..50.0, h in -4.0f64..4.0) -> Pose {
            Pose::new(x, y, h)
        }
    }

    fn close(a: Pose, b: Pose) -> bool {
        (a.position - b.position).length() < 1e-9 && normalize_angle(a.heading - b.heading).abs() < 1e-9
    }

    proptest! {
        #[test]
        fn a_pose_undoes_its_inverse(a in any_pose()) {
            prop_assert!(close(a * a.inverse(), Pose::IDENTITY));
            prop_assert!(close(a.inverse() * a, Pose::IDENTITY));
        }

        #[test]
        fn chaining_is_associative(a in any_pose(), b in any_pose(), c in any_pose()) {
            prop_assert!(close((a * b) * c, a * (b * c)));
        }

        #[test]
        fn from_here_is_undone_by_chaining(a in any_pose(), b in any_pose()) {
            prop_assert!(close(a * a.from_here(b), b));
        }

        #[test]
        fn lengths_survive(a in any_pose(), b in any_pose(), c in any_pose()) {
            let before = b.position.distance(c.position);
            let after = (a * b.position).distance(a * c.position);
            prop_assert!((before - after).abs() < 1e-9);
        }
    }
}
