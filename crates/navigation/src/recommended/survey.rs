use cogmap_geometry::DVec2;

use super::{
    footing::Ease,
    tiles::{CELL, Cell},
};

/// What a way is like, for people and for giving up.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Survey {
    /// Metres.
    pub(super) length: f64,
    /// Metres through what was never seen.
    pub(super) unseen: f64,
    /// How firm the firmest wall on it is: 0 where there is none, else one more than it was met.
    pub(super) barrier: u8,
}

impl Survey {
    pub(super) fn of(ease: &Ease, from: DVec2, corners: &[DVec2]) -> Self {
        let mut survey = Self::default();
        let mut last = from;
        for &corner in corners {
            let length = last.distance(corner);
            #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "lengths are short")]
            let pieces = ((length / CELL).ceil() as u32).clamp(1, 100_000);
            for k in 0..pieces {
                let cell = Cell::at(last.lerp(corner, (f64::from(k) + 0.5) / f64::from(pieces)));
                if !ease.floor.spot(cell).is_known_free() {
                    survey.unseen += length / f64::from(pieces);
                }
                survey.barrier = survey.barrier.max(ease.barrier(cell));
            }
            survey.length += length;
            last = corner;
        }
        survey
    }
}
