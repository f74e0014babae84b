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
        let (sin, cos) = trig::sin_cos(self.heading);
        let mut x = Vec::with_capacity(self.beams);
        let mut y = Vec::with_capacity(self.beams);
        x.push(cos);
        y.push(sin);
        let (mut turn_sin, mut turn_cos) = trig::sin_cos(self.spacing);
        while x.len() < self.beams {
            let more = x.len().min(self.beams - x.len());
            for k in 0..more {
                let (from_x, from_y) = (x[k], y[k]);
                x.push(from_x * turn_cos - from_y * turn_sin);
                y.push(from_x * turn_sin + from_y * turn_cos);
            }
            let twice_sin = 2.0 * turn_sin * turn_cos;
            turn_cos = turn_cos * turn_cos - turn_sin * turn_sin;
            turn_sin = twice_sin;
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
