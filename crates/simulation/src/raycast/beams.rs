use std::ops::Range;

use cogmap_geometry::DVec2;

use super::{Fan, frame::Frame};

/// Beams that are followed or given up together.
const BLOCK: usize = 8;
/// No solid.
const NOTHING: u64 = u64::MAX;

/// The beams of one quadrant, and what each met so far.
///
/// In the quadrant's frame a beam is the line y = slope·x. What it met is kept
/// as a nearness, the inverse of the depth x: along a straight wall nearness is
/// linear in the slope, so that a wall costs a beam one multiplication.
pub(super) struct Beams {
    /// Depth over range: the cosine of the angle between beam and axis.
    depths: Vec<f64>,
    slopes: Vec<f64>,
    /// Range over depth.
    secants: Vec<f64>,
    nearness: Vec<f64>,
    solids: Vec<u64>,
    first_angle: f64,
    per_radian: f64,
}

impl Beams {
    /// Beams of `fan` along these unit vectors, x and y apart.
    pub(super) fn new(fan: &Fan, frame: Frame, [x, y]: [&[f64]; 2]) -> Self {
        let [backwards, rightwards] = frame.mirrored().map(|mirrored| if mirrored { -1.0 } else { 1.0 });
        let (depths, lefts) = if frame.axis() == 0 { (x, y) } else { (y, x) };
        let depths: Vec<_> = depths.iter().map(|depth| backwards * depth).collect();
        let secants: Vec<_> = depths.iter().map(|depth| 1.0 / depth).collect();
        let slopes: Vec<_> =
            lefts.iter().zip(&secants).map(|(left, secant)| rightwards * left * secant).collect();
        let range_end = 1.0 / fan.range_max;
        Self {
            nearness: secants.iter().map(|secant| secant * range_end).collect(),
            solids: vec![NOTHING; slopes.len()],
            first_angle: slopes.first().map_or(0.0, |slope| rough_atan(*slope)),
            per_radian: 1.0 / fan.spacing.max(f64::MIN_POSITIVE),
            depths,
            secants,
            slopes,
        }
    }

    /// All of them.
    pub(super) fn all(&self) -> Range<usize> {
        0..self.slopes.len()
    }

    /// How far right and left these beams spread between two depths, metres.
    pub(super) fn spread(&self, beams: &Range<usize>, [near, far]: [f64; 2]) -> [f64; 2] {
        let (right, left) = (self.slopes[beams.start], self.slopes[beams.end - 1]);
        [right * if right < 0.0 { far } else { near }, left * if left > 0.0 { far } else { near }]
    }

    /// Those of `beams` that met nothing up to `depth` metres, and some of their
    /// neighbours.
    pub(super) fn still_open(&self, beams: &[Range<usize>], depth: f64) -> Vec<Range<usize>> {
        let end = 1.0 / depth;
        let mut open: Vec<Range<usize>> = Vec::with_capacity(beams.len() + 4);
        for run in beams {
            for (block, nearness) in self.nearness[run.clone()].chunks(BLOCK).enumerate() {
                let start = run.start + block * BLOCK;
                if nearness.iter().fold(false, |any, near| any | (*near < end)) {
                    match open.last_mut() {
                        Some(last) if last.end == start => last.end += nearness.len(),
                        _ => open.push(start..start + nearness.len()),
                    }
                }
            }
        }
        open
    }

    /// The beams with slopes from `right` to `left`, both included.
    pub(super) fn between(&self, right: f64, left: f64) -> Range<usize> {
        self.count(right, |slope| slope < right)..self.count(left, |slope| slope <= left)
    }

    /// How many beams, from the first on, satisfy `below`, which holds up to
    /// about `slope`.
    fn count(&self, slope: f64, below: impl Fn(f64) -> bool) -> usize {
        let angle = rough_atan(slope.clamp(-1.0, 1.0)) - self.first_angle;
        let mut count = ((angle * self.per_radian) as usize).min(self.slopes.len());
        while count < self.slopes.len() && below(self.slopes[count]) {
            count += 1;
        }
        while count > 0 && !below(self.slopes[count - 1]) {
            count -= 1;
        }
        count
    }

    /// Lets `beams` meet `solid` where their slope makes it nearer than what they
    /// met before.
    pub(super) fn meet(&mut self, beams: Range<usize>, solid: u32, nearness: impl Fn(f64) -> f64) {
        if beams.is_empty() {
            return;
        }
        let slopes = &self.slopes[beams.clone()];
        let met = self.nearness[beams.clone()].iter_mut().zip(&mut self.solids[beams]);
        for (slope, (best, met)) in slopes.iter().zip(met) {
            let near = nearness(*slope);
            let nearer = near > *best;
            *best = if nearer { near } else { *best };
            *met = if nearer { u64::from(solid) } else { *met };
        }
    }

    /// Neighbouring beams that met the same solid, and which; `None` for nothing.
    pub(super) fn runs(&self) -> impl Iterator<Item = (Range<usize>, Option<u32>)> {
        let mut end = 0;
        self.solids.chunk_by(|solid, next| solid == next).map(move |run| {
            let start = end;
            end += run.len();
            (start..end, run.first().filter(|solid| **solid != NOTHING).map(|solid| *solid as u32))
        })
    }

    /// Where these beams end.
    pub(super) fn ends(&self, beams: Range<usize>) -> impl Iterator<Item = End> {
        let directions = self.depths[beams.clone()].iter().zip(&self.slopes[beams.clone()]);
        let ranges = self.secants[beams.clone()].iter().zip(&self.nearness[beams]);
        directions.zip(ranges).map(|((depth, slope), (secant, nearness))| End {
            range: secant / nearness,
            direction: DVec2::new(*depth, depth * slope),
        })
    }
}

/// Where a beam ends.
pub(super) struct End {
    /// Metres.
    pub(super) range: f64,
    /// Unit vector along the beam, in the quadrant's frame.
    pub(super) direction: DVec2,
}

/// Arc tangent to 2e-5 for slopes of about -1 to 1: near enough to guess a beam.
fn rough_atan(slope: f64) -> f64 {
    let square = slope * slope;
    let tail = -0.085_133_0 + square * 0.020_835_1;
    slope * (0.999_866_0 + square * (-0.330_299_5 + square * (0.180_141_0 + square * tail)))
}
