use cogmap_geometry::{Metric, Pose};
use rand_core::SeedableRng;
use rand_pcg::Pcg64Mcg;
use serde::{Deserialize, Serialize};

use super::annealing::{Annealing, Correction, anneal};
use crate::{
    Cadence, Placement, StepReport,
    memory::{Matching, Memory, Tracked, match_views},
    perception::{Extraction, Reading, Surface, View, extract},
};

/// Every parameter of the traditional mapper.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct TransformParams {
    /// When a scan is a view.
    pub cadence: Cadence,
    /// How points become surfaces.
    pub extraction: Extraction,
    /// When two surfaces match, and how badly.
    pub matching: Matching,
    /// How the movement is corrected.
    pub annealing: Annealing,
}

/// The traditional algorithm (§3.1): the measured turn and travel are corrected until the current
/// view fits the previous one, and the corrected movement puts the view into the map.
#[derive(Clone, Debug)]
pub struct Transform {
    params: TransformParams,
    memory: Memory,
    rng: Pcg64Mcg,
}

impl Transform {
    /// A mapper with an empty memory; its search draws from `seed`.
    #[must_use]
    pub fn new(params: &TransformParams, seed: u64) -> Self {
        Self { params: *params, memory: Memory::default(), rng: Pcg64Mcg::seed_from_u64(seed) }
    }

    /// What it remembers.
    #[must_use]
    pub fn memory(&self) -> &Memory {
        &self.memory
    }

    pub(crate) fn observe(&mut self, reading: &Reading) -> Option<StepReport> {
        self.params.cadence.takes(reading, self.memory.odom_from_last()).then(|| {
            let view = extract(&reading.scan, &self.params.extraction);
            self.integrate(view, reading.t, reading.odom_from_robot)
        })
    }

    /// §3.1.2 and §3.1.3 on the surfaces seen when odometry stood at `odom_from_robot`.
    pub fn integrate(&mut self, view: View, t: f64, odom_from_robot: Pose) -> StepReport {
        let measured = self.memory.moved_to(odom_from_robot);
        let correction = measured.map(|measured| self.correct(&view.surfaces, measured));
        let moved =
            measured.zip(correction.as_ref()).map(|(measured, c)| moved_by(measured, c.turn, c.travel));
        let by = (Placement::Transform, moved);
        let report = self.memory.transform(view, (t, odom_from_robot), by, &self.params.matching);
        StepReport { correction, ..report }
    }

    /// §3.1.3: the changes of turn and travel that let the current view fit the previous one best.
    fn correct(&mut self, current: &[Surface], measured: Pose) -> Correction {
        let previous = self.memory.previous_as_stored();
        let (by, rng) = ((&self.params.matching, self.params.annealing.worst), &mut self.rng);
        let error_of =
            |turn: f64, travel: f64| mean_error(current, &previous, moved_by(measured, turn, travel), by);
        anneal(error_of, &self.params.annealing, rng)
    }
}

/// The measured movement (turn, then travel) with both changed; to the side nothing is corrected.
fn moved_by(measured: Pose, turn: f64, travel: f64) -> Pose {
    let ahead = measured.position.unit().unwrap_or(measured.forward());
    let further = measured.position + ahead * travel;
    Pose::new(0.0, 0.0, turn) * Pose { position: further, heading: measured.heading }
}

/// The mean error of all matching pairs, with a guard (ours) against dropping pairs, which would lower the
/// mean: a surface without a partner counts as a pair at its worst. No pair counts for more, or those
/// that only happen to lie within the gates would decide: the product of Fig. 3.4 grows steeply.
#[allow(clippy::cast_precision_loss, reason = "a view has a few dozen surfaces")]
fn mean_error(
    current: &[Surface],
    previous: &[Tracked],
    moved: Pose,
    (matching, worst): (&Matching, f64),
) -> f64 {
    let matches = match_views(current, previous, moved, matching);
    let paired: f64 = matches.iter().map(|m| m.fit.error.min(worst)).sum();
    let most = current.len().min(previous.len());
    let unpaired = most.saturating_sub(matches.len()) as f64 * worst;
    (paired + unpaired) / most.max(1) as f64
}

#[cfg(test)]
mod tests {
    use cogmap_geometry::{DVec2, Segment};

    use super::*;
    use crate::{memory::SurfaceId, perception::End};

    fn room() -> Vec<Surface> {
        let walls = [
            ((4.0, -3.0), (4.0, 3.0)),
            ((4.0, 3.0), (-1.0, 3.0)),
            ((-1.0, -3.0), (4.0, -3.0)),
            ((2.0, 1.0), (2.6, 1.6)),
        ];
        let surface = |((ax, ay), (bx, by)): ((f64, f64), (f64, f64))| Surface {
            segment: Segment::new(DVec2::new(ax, ay), DVec2::new(bx, by)),
            ends: [End::True; 2],
            beams: [0, 9],
            points: 10,
            residual: 0.0,
            range: 3.0,
            incidence: 0.3,
            label: None,
        };
        walls.into_iter().map(surface).collect()
    }

    /// How far off a movement is; a radian counts as much as a metre.
    fn off(truth: Pose, moved: Pose) -> f64 {
        let error = truth.from_here(moved);
        error.position.length() + error.heading.abs()
    }

    #[test]
    fn the_corrected_movement_is_nearer_to_the_truth_in_95_of_100_steps() {
        let truth = Pose::new(0.5, 0.1, 0.3);
        let tracked = |surface: &Surface| Tracked::seen(surface, Some(SurfaceId(0)));
        let previous: Vec<Tracked> = room().iter().map(tracked).collect();
        let current: Vec<Surface> = room().iter().map(|s| s.seen_from(truth.inverse())).collect();
        let better = (0..400_u32).filter(|&step| {
            // Errors spread evenly over ±0.1 rad and ±0.1 m.
            let (turn, travel) = (f64::from(step % 20), f64::from(step / 20));
            let measured = moved_by(truth, (turn - 9.5) / 95.0, (travel - 9.5) / 95.0);
            let worst = Annealing::default().worst;
            let error_of = |t: f64, x: f64| {
                mean_error(&current, &previous, moved_by(measured, t, x), (&Matching::default(), worst))
            };
            let mut rng = Pcg64Mcg::seed_from_u64(u64::from(step));
            let found = anneal(error_of, &Annealing::default(), &mut rng);
            off(truth, moved_by(measured, found.turn, found.travel)) < off(truth, measured)
        });
        assert!(better.count() >= 380);
    }
}
