use cogmap_geometry::{DVec2, Segment, trig};
use cogmap_simulation::{Fan, Hit, RayGrid};
use parry2d_f64::{
    partitioning::{Bvh, BvhBuildStrategy},
    query::{Ray, RayCast},
    shape,
};

use crate::office::Office;

/// Scans to take, each from another pose …
const POSES: usize = 256;
/// … but fewer where each takes so long.
const BRUTE_POSES: usize = 16;
/// Metres at which a beam ends.
const RANGE_MAX: f64 = 30.0;

const BEAMS: usize = 361;

/// An office, scans to take in it, and three ways of taking them.
pub(crate) struct Contest {
    segments: Vec<Segment>,
    fans: Vec<Fan>,
    grid: RayGrid,
    shapes: Vec<shape::Segment>,
    bvh: Bvh,
    hits: Vec<Option<Hit>>,
}

impl Contest {
    /// An office of about `segments` segments and [`POSES`] free poses in it.
    pub(crate) fn new(segments: usize) -> Self {
        let mut office = Office::new(segments);
        let fans = (0..POSES).map(|_| {
            let (origin, heading) = office.free_pose();
            Fan { origin, heading, spacing: trig::PI / 360.0, beams: BEAMS, range_max: RANGE_MAX }
        });
        let fans = fans.collect();
        let segments = office.segments;
        let shapes: Vec<_> = segments.iter().map(|s| shape::Segment::new(s.a, s.b)).collect();
        let boxes = shapes.iter().map(shape::Segment::local_aabb).enumerate();
        // The strategy that parry recommends for casting rays.
        let bvh = Bvh::from_iter(BvhBuildStrategy::Ploc, boxes);
        let grid = RayGrid::new(&segments, &[]);
        Self { segments, fans, grid, shapes, bvh, hits: Vec::new() }
    }

    /// How many scans are taken with a method.
    pub(crate) fn scans(method: usize) -> usize {
        if method < 2 { POSES } else { BRUTE_POSES }
    }

    /// Takes the scans with a method; the sum of all ranges, metres.
    pub(crate) fn run(&mut self, method: usize) -> f64 {
        let mut ranges = Vec::new();
        let mut sum = 0.0;
        for scan in 0..Self::scans(method) {
            self.scan(method, scan, &mut ranges);
            sum += ranges.iter().sum::<f64>();
        }
        sum
    }

    /// How many beams of all scans two methods see differently by over a millimetre, and how many there are.
    pub(crate) fn differences(&mut self, methods: [usize; 2]) -> (usize, usize) {
        let mut count = 0;
        for scan in 0..self.fans.len() {
            let [first, second] = methods.map(|method| {
                let mut ranges = Vec::new();
                self.scan(method, scan, &mut ranges);
                ranges
            });
            count += first.iter().zip(&second).filter(|(a, b)| (*a - *b).abs() > 1e-3).count();
        }
        (count, POSES * BEAMS)
    }

    fn scan(&mut self, method: usize, scan: usize, ranges: &mut Vec<f64>) {
        let fan = self.fans[scan];
        ranges.clear();
        match method {
            0 => {
                self.grid.cast(&fan, &mut self.hits);
                ranges.extend(self.hits.iter().map(|hit| hit.map_or(RANGE_MAX, |hit| hit.range)));
            }
            1 => ranges.extend(directions(&fan).map(|direction| self.parry(fan.origin, direction))),
            _ => ranges.extend(directions(&fan).map(|direction| self.brute(fan.origin, direction))),
        }
    }

    fn parry(&self, origin: DVec2, direction: DVec2) -> f64 {
        let ray = Ray::new(origin, direction);
        let segment = |id: u32, best: f64| self.shapes[id as usize].cast_local_ray(&ray, best, false);
        self.bvh.cast_ray(&ray, RANGE_MAX, segment).map_or(RANGE_MAX, |(_, range)| range)
    }

    fn brute(&self, origin: DVec2, direction: DVec2) -> f64 {
        self.segments.iter().fold(RANGE_MAX, |nearest, segment| {
            let (along, to_a) = (segment.b - segment.a, segment.a - origin);
            let per_cross = 1.0 / direction.perp_dot(along);
            let (range, share) = (to_a.perp_dot(along) * per_cross, to_a.perp_dot(direction) * per_cross);
            let meets = ((share - 0.5).abs() <= 0.5) & (range >= 0.0) & (range < nearest);
            if meets { range } else { nearest }
        })
    }
}

/// Unit vectors along a fan's beams, by turning the one before.
fn directions(fan: &Fan) -> impl Iterator<Item = DVec2> + use<> {
    let turn = DVec2::new(trig::cos(fan.spacing), trig::sin(fan.spacing));
    let first = DVec2::new(trig::cos(fan.heading), trig::sin(fan.heading));
    std::iter::successors(Some(first), move |direction| Some(turn.rotate(*direction))).take(fan.beams)
}
