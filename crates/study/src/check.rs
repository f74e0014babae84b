use serde::Serialize;

use crate::{
    metrics::{Estimate, Rate},
    outcome::share_of,
};

/// What the runs say of a criterion.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Verdict {
    /// The whole 95 % interval lies where the criterion wants it.
    Supported,
    /// The whole 95 % interval lies on the other side.
    Refuted,
    /// The interval reaches to both sides: these runs cannot tell.
    Undecided,
}

/// Where a figure should lie.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Bound {
    /// Not below.
    AtLeast(f64),
    /// Not above.
    AtMost(f64),
}

/// A criterion, the figure that it is about, and what the figure says of it.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Check {
    /// What is claimed, with its criterion, for people.
    pub criterion: String,
    /// Where the figure should lie.
    pub bound: Bound,
    /// Whether the figure is a share, to be written as per cent.
    pub share: bool,
    /// The figure; `None` where no run could tell.
    pub figure: Option<Estimate>,
    /// Whether the figure itself lies there.
    pub met: bool,
    /// Whether its whole interval does.
    pub verdict: Verdict,
}

impl Check {
    /// Something must be true of a share of the runs.
    #[must_use]
    pub fn rate(criterion: impl Into<String>, rate: Rate, bound: Bound) -> Self {
        Self { share: true, ..Self::figure(criterion, share_of(rate), bound) }
    }

    /// A share must lie there.
    #[must_use]
    pub fn share(criterion: impl Into<String>, figure: Option<Estimate>, bound: Bound) -> Self {
        Self { share: true, ..Self::figure(criterion, figure, bound) }
    }

    /// A figure must lie there.
    #[must_use]
    pub fn figure(criterion: impl Into<String>, figure: Option<Estimate>, bound: Bound) -> Self {
        let (met, verdict) = figure.map_or((false, Verdict::Undecided), |figure| {
            let [value, low, high] =
                [figure.value, figure.interval.low, figure.interval.high].map(|value| bound.holds(value));
            let verdict = match (low, high) {
                (true, true) => Verdict::Supported,
                (false, false) => Verdict::Refuted,
                _ => Verdict::Undecided,
            };
            (value, verdict)
        });
        Self { criterion: criterion.into(), bound, share: false, figure, met, verdict }
    }
}

impl Bound {
    /// Whether a value lies where it should.
    #[must_use]
    pub fn holds(self, value: f64) -> bool {
        match self {
            Self::AtLeast(least) => value >= least,
            Self::AtMost(most) => value <= most,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn rate(hits: u64, runs: u64) -> Check {
        Check::rate("at least 95 %", Rate { hits, runs }, Bound::AtLeast(0.95))
    }

    #[test]
    fn a_verdict_needs_the_whole_interval_on_one_side() {
        assert_eq!((rate(200, 200).met, rate(200, 200).verdict), (true, Verdict::Supported));
        assert_eq!((rate(192, 200).met, rate(192, 200).verdict), (true, Verdict::Undecided));
        assert_eq!((rate(188, 200).met, rate(188, 200).verdict), (false, Verdict::Undecided));
        assert_eq!((rate(150, 200).met, rate(150, 200).verdict), (false, Verdict::Refuted));
        assert_eq!((rate(0, 0).met, rate(0, 0).verdict), (false, Verdict::Undecided));
    }
}
