use cogmap_geometry::{Pose, Segment};
use cogmap_mapping::perception::Scan;
use rand_core::{Rng, SeedableRng};
use rand_pcg::Pcg64Mcg;

use crate::{Disc, Fan, Hit, LaserParams, RayGrid, chance};

/// What a beam has truly met that met one of the people: no solid has this number.
pub const SOMEBODY: u32 = u32::MAX;
/// The least jump in range from one beam to the next that splits a beam's spot, metres.
const DEPTH_EDGE: f64 = 0.15;
/// How much wider than at normal incidence the noise can become.
const NOISE_SPREAD: f64 = 4.0;

/// A planar range finder with the errors of a real one (§3.1.4): noise that grows on slanted
/// surfaces, a bias of its own, beams lost at grazing incidence, and ranges from between two
/// surfaces where a beam's spot lies on the edge of the nearer one.
#[derive(Clone, Debug, PartialEq)]
pub struct Laser {
    params: LaserParams,
    /// Metres, the same for every beam of a run.
    bias: f64,
    /// Decides which solids can be told apart by sight.
    sights: u64,
}

impl Laser {
    /// A laser whose bias is drawn for this run.
    #[must_use]
    pub fn new(params: &LaserParams, rng: &mut Pcg64Mcg) -> Self {
        Self { params: params.clone(), bias: params.bias * chance::gaussian(rng), sights: rng.next_u64() }
    }

    /// The same laser with so many times its range noise and bias.
    pub(crate) fn noisier(&self, times: f64) -> Self {
        let params = LaserParams { noise: self.params.noise * times, ..self.params.clone() };
        Self { params, bias: self.bias * times, ..*self }
    }

    /// One sweep from where the robot stands, and for each beam the solid that it truly measured;
    /// `None` where it saw nothing, or something between two solids.
    #[must_use]
    pub fn scan(
        &self,
        grid: &RayGrid,
        world_from_robot: Pose,
        rng: &mut Pcg64Mcg,
    ) -> (Scan, Vec<Option<u32>>) {
        self.scan_among((grid, &[], &[]), world_from_robot, rng)
    }

    /// The same where boxes have been set down and people walk: their edges and discs, beside the grid.
    /// A beam that meets somebody has met [`SOMEBODY`].
    #[must_use]
    pub fn scan_among(
        &self,
        (grid, added, people): (&RayGrid, &[Segment], &[Disc]),
        world_from_robot: Pose,
        rng: &mut Pcg64Mcg,
    ) -> (Scan, Vec<Option<u32>>) {
        let still = grid.len() + added.len();
        let robot_from_laser = Pose::new(self.params.forward, 0.0, 0.0);
        let mut scan = self.empty(robot_from_laser);
        let fan = self.fan(world_from_robot * robot_from_laser, &scan);
        let mut hits = Vec::new();
        grid.cast_with(&fan, added, people, &mut hits);
        let mixed = self.mixed_pixels(&hits, rng);
        let mut solids = vec![None; self.params.beams];
        let slots = scan.ranges.iter_mut().zip(&mut solids);
        for ((hit, between), (range, solid)) in hits.into_iter().zip(mixed).zip(slots) {
            let Some(hit) = hit else { continue };
            if let Some(read) = self.measure(&hit, between.unwrap_or(hit.range), rng) {
                *range = read;
                let met = if (hit.solid as usize) < still { hit.solid } else { SOMEBODY };
                *solid = between.is_none().then_some(met);
            }
        }
        if self.params.identity > 0.0 {
            scan.labels =
                solids.iter().map(|solid| solid.filter(|&solid| self.knows_by_sight(solid))).collect();
        }
        (scan, solids)
    }

    fn knows_by_sight(&self, solid: u32) -> bool {
        let mut rng = Pcg64Mcg::seed_from_u64(self.sights ^ u64::from(solid));
        solid != SOMEBODY && chance::uniform(&mut rng) < self.params.identity
    }

    fn empty(&self, robot_from_laser: Pose) -> Scan {
        let field = self.params.field_of_view_deg.to_radians();
        Scan {
            robot_from_laser,
            angle_min: -field / 2.0,
            angle_increment: field / self.params.beams.saturating_sub(1).max(1) as f64,
            range_max: self.params.range_max,
            ranges: vec![f64::INFINITY; self.params.beams],
            labels: Vec::new(),
        }
    }

    fn fan(&self, world_from_laser: Pose, scan: &Scan) -> Fan {
        Fan {
            origin: world_from_laser.position,
            heading: world_from_laser.heading + scan.angle_min,
            spacing: scan.angle_increment,
            beams: self.params.beams,
            range_max: self.params.range_max,
        }
    }

    /// For each beam whose spot lies on two surfaces the range in between, metres.
    fn mixed_pixels(&self, hits: &[Option<Hit>], rng: &mut Pcg64Mcg) -> Vec<Option<f64>> {
        let mut mixed = vec![None; hits.len()];
        for (beam, pair) in hits.windows(2).enumerate() {
            let [Some(first), Some(second)] = pair else { continue };
            let jump = second.range - first.range;
            if jump.abs() > DEPTH_EDGE && chance::uniform(rng) < self.params.mixed_pixels {
                let on_second = usize::from(chance::uniform(rng) < 0.5);
                mixed[beam + on_second] = Some(first.range + jump * chance::uniform(rng));
            }
        }
        mixed
    }

    /// What the laser reports for a true range; `None` where too little light comes back.
    fn measure(&self, hit: &Hit, range: f64, rng: &mut Pcg64Mcg) -> Option<f64> {
        let lost = self.params.grazing_dropout * slant(hit.incidence_cos);
        let survives = chance::uniform(rng) >= lost;
        let spread = (1.0 / hit.incidence_cos.max(1.0 / NOISE_SPREAD)).min(NOISE_SPREAD);
        let error = self.bias + self.params.noise * spread * chance::gaussian(rng);
        let resolution = self.params.resolution;
        let read = (range + error).max(0.0);
        let read = if resolution > 0.0 { (read / resolution).round() * resolution } else { read };
        (survives && read > 0.0 && read < self.params.range_max).then_some(read)
    }
}

/// How much a slanted surface weakens the echo: 0 at normal incidence, 1 at 90°; plain walls are seen
/// well up to about 80°.
fn slant(incidence_cos: f64) -> f64 {
    let mut slant = 1.0 - incidence_cos;
    for _ in 0..4 {
        slant *= slant;
    }
    slant
}

#[cfg(test)]
mod tests;
