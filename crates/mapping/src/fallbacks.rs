use serde::{Deserialize, Serialize};

use crate::{Placement, StepReport};

/// A stretch in which nothing told the robot where it is and odometry placed its views (§3.2.3).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct FallbackRun {
    /// The first view that odometry placed.
    pub from: usize,
    /// How many in a row it placed.
    pub views: usize,
    /// The view in which the robot knew again where it is; `None` where the run ended before.
    pub recovered: Option<usize>,
}

/// The log of fallbacks, in order: every stretch of views that odometry placed.
#[must_use]
pub fn fallback_runs(reports: &[StepReport]) -> Vec<FallbackRun> {
    let by_odometry = |report: &StepReport| report.placement == Placement::Odometry;
    let mut runs = Vec::new();
    let mut first = 0;
    for stretch in reports.chunk_by(|a, b| by_odometry(a) == by_odometry(b)) {
        let next = first + stretch.len();
        if by_odometry(&stretch[0]) {
            let recovered = reports.get(next).map(|report| report.step);
            runs.push(FallbackRun { from: stretch[0].step, views: stretch.len(), recovered });
        }
        first = next;
    }
    runs
}

#[cfg(test)]
mod tests {
    use cogmap_geometry::Pose;

    use super::*;
    use crate::perception::View;

    #[test]
    fn every_stretch_by_odometry_is_listed_with_its_length_and_its_end() {
        use Placement::{First, Odometry, Reference, WeakReference};
        let reports: Vec<StepReport> =
            [First, Odometry, Odometry, WeakReference, Odometry, Reference, Odometry]
                .into_iter()
                .enumerate()
                .map(|(step, by)| StepReport::new((step, 0.0), View::default(), by, Pose::IDENTITY))
                .collect();
        let run = |from, views, recovered| FallbackRun { from, views, recovered };
        assert_eq!(fallback_runs(&reports), [run(1, 2, Some(3)), run(4, 1, Some(5)), run(6, 1, None)]);
        assert_eq!(fallback_runs(&[]), []);
    }
}
