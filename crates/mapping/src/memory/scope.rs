use cogmap_geometry::{Metric, Pose};
use serde::{Deserialize, Serialize};

use super::{FrameId, Match, Matching, Mfis, Tracked, match_views};
use crate::perception::{Surface, View};

/// What a view is compared with to find common surfaces (§3.2.1).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum MatchScope {
    /// The previous view alone, as in the thesis: a wall that was hidden for a while is new again.
    #[default]
    PreviousView,
    /// Ours: what found no partner there is compared with what is remembered around the robot.
    PreviousViewThenMfis,
}

/// The surfaces of a view that found no partner yet and that the map around the robot knows; one
/// partner each, and none that was taken already.
pub(super) fn match_remembered(
    view: &View,
    matched: &[Match],
    (mfis, map_from_robot): (&Mfis, Pose),
    params: &Matching,
) -> Vec<Match> {
    let open: Vec<usize> =
        (0..view.surfaces.len()).filter(|&seen| matched.iter().all(|m| m.seen != seen)).collect();
    let surfaces: Vec<Surface> = open.iter().map(|&seen| view.surfaces[seen].clone()).collect();
    let farthest = surfaces.iter().map(|s| s.segment.a.norm().max(s.segment.b.norm())).fold(0.0, f64::max);
    let known: Vec<Tracked> = mfis
        .near(FrameId::default(), map_from_robot.position, farthest + params.distance * params.label_reach)
        .filter(|stored| matched.iter().all(|m| m.known != stored.id))
        .map(Tracked::stored)
        .collect();
    let found = match_views(&surfaces, &known, map_from_robot, params).into_iter();
    found.map(|m| Match { seen: open[m.seen], previous: None, ..m }).collect()
}
