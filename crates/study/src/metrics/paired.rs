use serde::{Deserialize, Serialize};

use super::{Estimate, Interval, Rate, bootstrap::median_estimate};

/// How one way of mapping compares with another on the same runs; less is better.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Paired {
    /// In how many runs the first has the lower value.
    pub lower: Rate,
    /// The same as a share, with Wilson's 95 % interval.
    pub share: f64,
    /// Wilson's 95 % interval of that share.
    pub interval: Interval,
    /// The median over the runs of the second's value over the first's.
    pub ratio: Option<Estimate>,
}

/// Compares two ways by their values on the same runs, in the same order.
#[must_use]
pub fn paired(pairs: &[(f64, f64)]) -> Option<Paired> {
    let mut lower = Rate::default();
    for (first, second) in pairs {
        lower.count(first < second);
    }
    let ratios: Vec<f64> = pairs.iter().filter(|pair| pair.0 > 0.0).map(|pair| pair.1 / pair.0).collect();
    Some(Paired { lower, share: lower.share()?, interval: lower.wilson()?, ratio: median_estimate(&ratios) })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn three_of_four_runs_are_lower_and_the_middle_ratio_is_three() {
        let found = paired(&[(1.0, 2.0), (1.0, 3.0), (1.0, 4.0), (2.0, 1.0), (1.0, 3.0)]).unwrap();
        assert_eq!(found.lower, Rate { hits: 4, runs: 5 });
        assert!((found.ratio.unwrap().value - 3.0).abs() < 1e-12);
        assert_eq!(paired(&[]), None);
    }

    #[test]
    fn equal_values_are_not_lower() {
        assert_eq!(paired(&[(1.0, 1.0)]).unwrap().lower.hits, 0);
    }
}
