use serde::{Deserialize, Serialize};

use super::{footing::Footing, rescue::RescueParams};

/// What [`StrategySetup::Recommended`](crate::StrategySetup::Recommended) goes by.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct RecommendedParams {
    /// What it costs to go somewhere.
    pub footing: Footing,
    /// Another way is taken only where it is cheaper by so many metres …
    pub hysteresis: f64,
    /// … and by this share.
    pub hysteresis_share: f64,
    /// While the way that it has in mind becomes no worse the robot looks for a better one at each so many
    /// decisions.
    pub look_for_better: u32,
    /// Each way that turned out closed makes a metre of unseen floor cost so much more, …
    pub wariness: f64,
    /// … but no more than so many of them.
    pub wary_most: u32,
    /// A wall that was met so often closes a way for good.
    pub closed: u8,
    /// When the fail-safe takes over, and when the robot gives up.
    pub rescue: RescueParams,
}

impl Default for RecommendedParams {
    fn default() -> Self {
        Self {
            footing: Footing::default(),
            hysteresis: 1.0,
            hysteresis_share: 0.05,
            look_for_better: 3,
            wariness: 0.5,
            wary_most: 3,
            closed: 2,
            rescue: RescueParams::default(),
        }
    }
}

impl RecommendedParams {
    /// What it costs to go somewhere for a robot whose ways have turned out closed so often.
    pub(super) fn footing_after(&self, closed_ways: u32) -> Footing {
        let wary = self.wariness * f64::from(closed_ways.min(self.wary_most));
        Footing { unknown: self.footing.unknown + wary, ..self.footing.clone() }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_closed_way_makes_unseen_floor_dearer_up_to_a_limit() {
        let params = RecommendedParams { wariness: 0.5, wary_most: 3, ..RecommendedParams::default() };
        let costs = [0, 1, 3, 9].map(|closed| params.footing_after(closed).unknown - params.footing.unknown);
        assert_eq!(costs, [0.0, 0.5, 1.5, 1.5]);
        assert_eq!(
            Footing { unknown: 0.0, ..params.footing_after(9) },
            Footing { unknown: 0.0, ..params.footing }
        );
    }
}
