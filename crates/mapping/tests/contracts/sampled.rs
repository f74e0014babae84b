use cogmap_geometry::{DVec2, Pose, Segment, trig};
use cogmap_mapping::perception::{Moment, Reading, Scan};
use rand_core::Rng;
use rand_pcg::Pcg64Mcg;

/// A laser of 361 beams over the half circle ahead.
pub(crate) struct Laser<'a> {
    pub(crate) walls: &'a [Segment],
    /// Metres.
    pub(crate) range_max: f64,
    /// Along the beam, metres (1 σ).
    pub(crate) noise: f64,
}

impl Laser<'_> {
    /// What it sees from there, and which wall each beam hit.
    pub(crate) fn scan(&self, world_from_robot: Pose, rng: &mut Pcg64Mcg) -> (Scan, Vec<Option<u32>>) {
        let (angle_min, angle_increment) = (-90.0_f64.to_radians(), 0.5_f64.to_radians());
        let mut ranges = Vec::new();
        let mut walls = Vec::new();
        for beam in 0..361 {
            let bearing = world_from_robot.heading + angle_min + angle_increment * f64::from(beam);
            let hit = self.first_hit(world_from_robot.position, bearing);
            let error = self.noise * gaussian(rng);
            ranges.push(hit.map_or(f64::INFINITY, |(range, _)| range + error));
            walls.push(hit.map(|(_, wall)| wall));
        }
        let (range_max, labels) = (self.range_max, Vec::new());
        let scan =
            Scan { robot_from_laser: Pose::IDENTITY, angle_min, angle_increment, range_max, ranges, labels };
        (scan, walls)
    }

    fn first_hit(&self, from: DVec2, bearing: f64) -> Option<(f64, u32)> {
        let (sin, cos) = trig::sin_cos(bearing);
        let ray = Segment::new(from, from + DVec2::new(cos, sin) * self.range_max);
        let range = |wall: &Segment| Some(ray.crossing(*wall)?.distance(from));
        (0..)
            .zip(self.walls)
            .filter_map(|(id, wall)| Some((range(wall)?, id)))
            .min_by(|a, b| a.0.total_cmp(&b.0))
    }
}

/// A scan at the end of a step.
pub(crate) fn reading(scan: Scan, odom_from_robot: Pose) -> Reading {
    Reading { t: 0.0, odom_from_robot, moment: Moment::StepEnd, scan }
}

/// A number from the normal distribution (nearly: the sum of twelve even ones).
pub(crate) fn gaussian(rng: &mut Pcg64Mcg) -> f64 {
    (0..12).map(|_| uniform(rng)).sum::<f64>() - 6.0
}

/// A number from `[0, 1)`.
#[allow(clippy::cast_precision_loss, reason = "53 bits fit exactly")]
pub(crate) fn uniform(rng: &mut Pcg64Mcg) -> f64 {
    (rng.next_u64() >> 11) as f64 / (1_u64 << 53) as f64
}
