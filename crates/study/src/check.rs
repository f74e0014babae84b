use serde::Serialize;

use crate::{
    metrics::{Estimate, Rate},
    outcome::share_of,
};

/// Fewer runs have no 95 % interval: the median lies outside all of five values once in 16 times.
const LEAST_RUNS: usize = 6;

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

/// One of the thesis's claims, asked of one form of the theory and one robot.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Claim {
    /// `C1` to `C9`.
    pub id: &'static str,
    /// What is claimed, in our words.
    pub statement: &'static str,
    /// `perceptual`, the thesis's form, or `consensus`, ours.
    pub form: &'static str,
    /// The robot's name.
    pub robot: &'static str,
}

/// A criterion, the figure that it is about, and what the figure says of it.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Check {
    /// Which claim it is part of; several checks may be.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub claim: Option<Claim>,
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
    /// The same as part of a claim.
    #[must_use]
    pub fn of_claim(self, claim: Claim) -> Self {
        Self { claim: Some(claim), ..self }
    }

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
                _ if figure.runs < LEAST_RUNS => Verdict::Undecided,
                (true, true) => Verdict::Supported,
                (false, false) => Verdict::Refuted,
                _ => Verdict::Undecided,
            };
            (value, verdict)
        });
        Self { claim: None, criterion: criterion.into(), bound, share: false, figure, met, verdict }
    }
}

impl Verdict {
    /// A claim is supported if all that it asks for is, and refuted if any of it is.
    #[must_use]
    pub fn of_all<'a>(checks: impl IntoIterator<Item = &'a Check>) -> Self {
        let mut all = None;
        for check in checks {
            all = match (all, check.verdict) {
                (Some(Self::Refuted), _) | (_, Self::Refuted) => Some(Self::Refuted),
                (Some(Self::Undecided), _) | (_, Self::Undecided) => Some(Self::Undecided),
                _ => Some(Self::Supported),
            };
        }
        all.unwrap_or(Self::Undecided)
    }

    /// The word for it.
    #[must_use]
    pub fn word(self) -> &'static str {
        match self {
            Self::Supported => "supported",
            Self::Refuted => "refuted",
            Self::Undecided => "undecided",
        }
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
        assert_eq!((rate(0, 5).met, rate(0, 5).verdict), (false, Verdict::Undecided), "too few runs");
        assert_eq!((rate(0, 0).met, rate(0, 0).verdict), (false, Verdict::Undecided));
    }

    #[test]
    fn a_claim_stands_or_falls_with_its_parts() {
        let [yes, no, open] = [rate(200, 200), rate(150, 200), rate(192, 200)];
        assert_eq!(Verdict::of_all([&yes, &yes]), Verdict::Supported);
        assert_eq!(Verdict::of_all([&yes, &open]), Verdict::Undecided);
        assert_eq!(Verdict::of_all([&no, &open, &yes]), Verdict::Refuted);
        assert_eq!(Verdict::of_all([]), Verdict::Undecided);
    }
}
