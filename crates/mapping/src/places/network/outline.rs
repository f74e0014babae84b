use cogmap_geometry::DVec2;

use super::{AsrId, Network};
use crate::{memory::Mfis, places::overlap};

/// Frames farther than this along the links from a space's entrance have no part in its outline, metres.
const REACH: f64 = 30.0;

impl Network {
    /// The outline of a space: the convex hull of its surfaces, counter-clockwise, in the space's
    /// [`frame`](super::Asr::frame), metres; fewer than three corners where nothing is known of it.
    #[must_use]
    pub fn outline(&self, asr: AsrId, mfis: &Mfis) -> Vec<DVec2> {
        let Some(asr) = self.asr(asr) else { return Vec::new() };
        let ways = mfis.ways_from(asr.frame, REACH);
        let surfaces = self.surfaces_of(asr.id).iter().filter_map(|&id| mfis.get(id));
        let placed =
            surfaces.filter_map(|surface| Some(ways.get(&surface.frame)?.here_from_frame * surface.segment));
        overlap::convex_hull(placed.flat_map(|segment| [segment.a, segment.b]).collect())
    }
}
