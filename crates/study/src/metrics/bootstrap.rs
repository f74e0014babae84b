use rand_core::{Rng, SeedableRng};
use rand_pcg::Pcg64Mcg;
use serde::{Deserialize, Serialize};

use super::{Interval, Rate};

/// How many times the runs are drawn anew.
const RESAMPLES: usize = 1000;
/// The generator's seed: the same runs always give the same interval.
const SEED: u64 = 0x00b0_0757;

/// A figure of many runs with its bootstrap 95 % interval.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Estimate {
    /// The figure of the runs as they are.
    pub value: f64,
    /// What it would be in 95 of 100 such sets of runs.
    #[serde(flatten)]
    pub interval: Interval,
    /// Runs that it rests on.
    pub runs: usize,
}

/// The median of values; of an even number the mean of the middle two. `None` of none.
#[must_use]
pub fn median(values: &[f64]) -> Option<f64> {
    let mut sorted = values.to_vec();
    sorted.sort_by(f64::total_cmp);
    let half = sorted.len() / 2;
    let upper = *sorted.get(half)?;
    Some(if sorted.len().is_multiple_of(2) { f64::midpoint(sorted[half - 1], upper) } else { upper })
}

/// The median with its interval (percentile bootstrap).
#[must_use]
pub fn median_estimate(values: &[f64]) -> Option<Estimate> {
    let mut sorted = values.to_vec();
    sorted.sort_by(f64::total_cmp);
    estimate(sorted.len(), |drawn| {
        // The values are sorted, so how often each was drawn is all that the median needs.
        let mut times = vec![0_u32; sorted.len()];
        drawn.iter().for_each(|&index| times[index] += 1);
        let at = |rank: usize| {
            let mut left = rank;
            times.iter().zip(&sorted).find_map(|(&times, &value)| {
                let times = times as usize;
                if left < times {
                    Some(value)
                } else {
                    left -= times;
                    None
                }
            })
        };
        let half = drawn.len() / 2;
        if drawn.len().is_multiple_of(2) { Some(f64::midpoint(at(half - 1)?, at(half)?)) } else { at(half) }
    })
}

/// A share of sums over runs, as of `(hits, chances)`, with its interval: the runs are drawn, not
/// the single events, because those of one run are not independent. Where it never happened, or
/// always, drawing tells nothing; then it is Wilson's interval as if each run were one event.
#[must_use]
pub fn share_estimate(parts: &[(f64, f64)]) -> Option<Estimate> {
    let drawn = ratio_estimate(parts)?;
    let all = Rate { hits: parts.len() as u64, runs: parts.len() as u64 };
    let interval = match drawn.value {
        value if value <= 0.0 => Rate { hits: 0, ..all }.wilson()?,
        value if value >= 1.0 => all.wilson()?,
        _ => drawn.interval,
    };
    Some(Estimate { interval, ..drawn })
}

/// A ratio of sums over runs with its interval.
#[must_use]
pub fn ratio_estimate(parts: &[(f64, f64)]) -> Option<Estimate> {
    estimate(parts.len(), |drawn| {
        let sum = drawn.iter().fold((0.0, 0.0), |sum, &k| (sum.0 + parts[k].0, sum.1 + parts[k].1));
        (sum.1 > 0.0).then(|| sum.0 / sum.1)
    })
}

/// Any statistic of runs with its interval; it is handed the numbers of the runs that were drawn.
pub fn estimate(runs: usize, statistic: impl Fn(&[usize]) -> Option<f64>) -> Option<Estimate> {
    let mut drawn: Vec<usize> = (0..runs).collect();
    if runs == 0 {
        return None;
    }
    let value = statistic(&drawn)?;
    let mut rng = Pcg64Mcg::seed_from_u64(SEED);
    let mut found: Vec<f64> = (0..RESAMPLES)
        .filter_map(|_| {
            drawn.iter_mut().for_each(|index| *index = below(runs, &mut rng));
            statistic(&drawn)
        })
        .collect();
    found.sort_by(f64::total_cmp);
    let end = |per_mille: usize| found.get(found.len().saturating_sub(1) * per_mille / 1000).copied();
    let interval = Interval { low: end(25).unwrap_or(value), high: end(975).unwrap_or(value) };
    Some(Estimate { value, interval, runs })
}

/// A number from 0 to `runs` - 1, all alike.
#[allow(clippy::cast_possible_truncation, reason = "the product's upper half is below `runs`")]
fn below(runs: usize, rng: &mut Pcg64Mcg) -> usize {
    ((u128::from(rng.next_u64()) * runs as u128) >> 64) as usize
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    proptest! {
        #[test]
        fn the_interval_lies_within_the_values_and_the_median_within_it(
            values in prop::collection::vec(-9.0f64..9.0, 5..40),
        ) {
            let found = median_estimate(&values).unwrap();
            prop_assert_eq!(Some(found.value), median(&values));
            prop_assert!(found.interval.low <= found.value && found.value <= found.interval.high);
            prop_assert!(values.iter().any(|value| *value <= found.interval.low));
            prop_assert!(values.iter().any(|value| *value >= found.interval.high));
        }
    }

    /// Of 1 to 99 the ranks 41 and 59 bound the median at 95 % (binomial, n = 99: 50 ± 1.96 √(99/4)).
    #[test]
    fn the_median_of_99_values_is_known_to_ten_ranks() {
        let values: Vec<f64> = (1..100).map(f64::from).collect();
        let found = median_estimate(&values).unwrap();
        assert_eq!((found.value, found.runs), (50.0, 99));
        assert!((found.interval.low - 40.0).abs() <= 2.0 && (found.interval.high - 60.0).abs() <= 2.0);
    }

    #[test]
    fn a_share_is_of_the_sums_not_the_mean_of_shares() {
        let found = share_estimate(&[(1.0, 1.0), (0.0, 9.0)]).unwrap();
        assert!((found.value - 0.1).abs() < 1e-12);
        assert!(found.interval.low == 0.0 && found.interval.high == 1.0);
        assert_eq!(share_estimate(&[(0.0, 0.0)]), None);
    }

    #[test]
    fn what_never_happened_in_300_runs_may_still_happen_in_one_of_a_hundred() {
        let never = share_estimate(&[(0.0, 8.0); 300]).unwrap();
        assert!(never.value == 0.0 && (never.interval.high - 0.0126).abs() < 1e-4);
        let always = share_estimate(&[(8.0, 8.0); 300]).unwrap();
        assert!(always.value == 1.0 && (always.interval.low - 0.9874).abs() < 1e-4);
    }

    #[test]
    fn nothing_is_known_of_no_values() {
        assert_eq!((median(&[]), median_estimate(&[])), (None, None));
    }
}
