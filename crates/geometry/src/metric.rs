use glam::DVec2;

/// Lengths with the processor's own square root. glam takes its root from `libm`, which has to compute it step by
/// step where it is built for wasm; a root is rounded alike everywhere, so both give the same bits.
pub trait Metric: Sized {
    /// The length, metres.
    #[must_use]
    fn norm(self) -> f64;

    /// The distance to another point, metres.
    #[must_use]
    fn distance_from(self, other: Self) -> f64;

    /// The unit vector of the same direction; `None` where there is none.
    #[must_use]
    fn unit(self) -> Option<Self>;

    /// The unit vector of the same direction; zero where there is none.
    #[must_use]
    fn unit_or_zero(self) -> Self;
}

impl Metric for DVec2 {
    #[inline]
    fn norm(self) -> f64 {
        self.length_squared().sqrt()
    }

    #[inline]
    fn distance_from(self, other: Self) -> f64 {
        (self - other).norm()
    }

    #[inline]
    fn unit(self) -> Option<Self> {
        let share = 1.0 / self.norm();
        (share.is_finite() && share > 0.0).then(|| self * share)
    }

    #[inline]
    fn unit_or_zero(self) -> Self {
        self.unit().unwrap_or(Self::ZERO)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn bits(point: DVec2) -> [u64; 2] {
        point.to_array().map(f64::to_bits)
    }

    proptest! {
        #[test]
        fn lengths_are_those_of_glam_bit_for_bit(
            (x, y, u, v) in (-50.0f64..50.0, -50.0f64..50.0, -50.0f64..50.0, -50.0f64..50.0),
        ) {
            let (a, b) = (DVec2::new(x, y), DVec2::new(u, v));
            prop_assert_eq!(a.norm().to_bits(), a.length().to_bits());
            prop_assert_eq!(a.distance_from(b).to_bits(), a.distance(b).to_bits());
            prop_assert_eq!(a.unit().map(bits), a.try_normalize().map(bits));
            prop_assert_eq!(bits(a.unit_or_zero()), bits(a.normalize_or_zero()));
        }
    }

    #[test]
    fn what_has_no_direction_has_no_unit_vector() {
        for none in [DVec2::ZERO, DVec2::NAN, DVec2::splat(f64::INFINITY)] {
            assert_eq!((none.unit(), none.unit_or_zero()), (None, DVec2::ZERO));
        }
    }
}
