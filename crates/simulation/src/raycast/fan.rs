use std::ops::Range;

use cogmap_geometry::{
    DVec2, normalize_angle,
    trig::{self, FRAC_PI_2},
};

/// Beams of equal spacing from one point; beam `k` points to
/// `heading + k * spacing`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Fan {
    /// Where all beams start, metres.
    pub origin: DVec2,
    /// Direction of beam 0, radians.
    pub heading: f64,
    /// Radians from a beam to the next, counter-clockwise positive.
    pub spacing: f64,
    /// How many beams.
    pub beams: usize,
    /// Metres at which a beam ends; what lies farther is not met.
    pub range_max: f64,
}

impl Fan {
    /// Whether a beam of this fan can meet anything at all.
    pub(super) fn is_sound(&self) -> bool {
        let finite = self.origin.is_finite() && self.heading.is_finite() && self.spacing.is_finite();
        finite && self.range_max > 0.0
    }

    /// The same beams in counter-clockwise order, and whether that turned them
    /// round.
    pub(super) fn counter_clockwise(self) -> (Self, bool) {
        let (heading, spacing) = (normalize_angle(self.heading), normalize_angle(self.spacing));
        if spacing >= 0.0 {
            return (Self { heading, spacing, ..self }, false);
        }
        let last = normalize_angle(heading + spacing * self.beams.saturating_sub(1) as f64);
        (Self { heading: last, spacing: -spacing, ..self }, true)
    }

    /// Unit vectors along the beams, x and y apart: from the first beam by
    /// doubling, so that two calls of sine and cosine do for all.
    pub(super) fn directions(&self) -> [Vec<f64>; 2] {
        let (mut x, mut y) = (vec![0.0; self.beams], vec![0.0; self.beams]);
        let (sin, cos) = trig::sin_cos(self.heading);
        x.iter_mut().take(1).for_each(|x| *x = cos);
        y.iter_mut().take(1).for_each(|y| *y = sin);
        let (mut sin, mut cos) = trig::sin_cos(self.spacing);
        let mut known = 1;
        while known < self.beams {
            let ((from_x, to_x), (from_y, to_y)) = (x.split_at_mut(known), y.split_at_mut(known));
            let from = from_x.iter().zip(from_y.iter());
            for ((from_x, from_y), (to_x, to_y)) in from.zip(to_x.iter_mut().zip(to_y)) {
                *to_x = from_x * cos - from_y * sin;
                *to_y = from_x * sin + from_y * cos;
            }
            known *= 2;
            (sin, cos) = (2.0 * sin * cos, cos * cos - sin * sin);
        }
        [x, y]
    }

    /// Which of the four quadrants beam `first` belongs to (0 ahead along x, 1
    /// along y, 2 against x, 3 against y; each 90° wide about its axis), and the
    /// beams from there on that share it.
    pub(super) fn quadrant_from(&self, first: usize) -> (u8, Range<usize>) {
        let quarter = ((self.heading + self.spacing * first as f64) / FRAC_PI_2 + 0.5).floor();
        let beyond = (((quarter + 0.5) * FRAC_PI_2 - self.heading) / self.spacing).ceil();
        let end = (beyond as usize).clamp(first + 1, self.beams);
        ((quarter as i64).rem_euclid(4) as u8, first..end)
    }
}
