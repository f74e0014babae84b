use serde::{Deserialize, Serialize};

/// The 0.975 quantile of the normal distribution: what a 95 % interval reaches to either side.
const Z: f64 = 1.959_963_984_540_054;

/// From and to.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Interval {
    /// The lower end.
    pub low: f64,
    /// The upper end.
    pub high: f64,
}

/// How often something happened among how many runs.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct Rate {
    /// Times that it happened.
    pub hits: u64,
    /// Times that it could have happened.
    pub runs: u64,
}

impl Rate {
    /// Counts one more run.
    pub fn count(&mut self, hit: bool) {
        self.hits += u64::from(hit);
        self.runs += 1;
    }

    /// The share of hits; `None` of no runs.
    #[must_use]
    #[allow(clippy::cast_precision_loss, reason = "nobody runs 2^53 seeds")]
    pub fn share(&self) -> Option<f64> {
        (self.runs > 0).then(|| self.hits as f64 / self.runs as f64)
    }

    /// Wilson's 95 % score interval of the true share; `None` of no runs.
    ///
    /// ```
    /// use cogmap_study::metrics::Rate;
    /// let never = Rate { hits: 0, runs: 300 }.wilson().unwrap();
    /// assert_eq!(never.low, 0.0);
    /// assert!((never.high - 0.0126).abs() < 1e-4);
    /// ```
    #[must_use]
    #[allow(clippy::cast_precision_loss, reason = "nobody runs 2^53 seeds")]
    pub fn wilson(&self) -> Option<Interval> {
        let (share, n) = (self.share()?, self.runs as f64);
        let spread = Z * Z / n;
        let middle = share + spread / 2.0;
        let reach = (spread * (share * (1.0 - share) + spread / 4.0)).sqrt();
        let end = |value: f64| (value / (1.0 + spread)).clamp(0.0, 1.0);
        Some(Interval { low: end(middle - reach), high: end(middle + reach) })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn the_interval_holds_the_share_and_stays_within_bounds(hits in 0u64..500, more in 0u64..500) {
            let rate = Rate { hits, runs: (hits + more).max(1) };
            let (share, Interval { low, high }) = (rate.share().unwrap(), rate.wilson().unwrap());
            prop_assert!(0.0 <= low && low <= share + 1e-12 && share <= high + 1e-12 && high <= 1.0);
        }
    }

    #[test]
    fn half_of_ten_is_known_from_24_to_76_percent() {
        let Interval { low, high } = Rate { hits: 5, runs: 10 }.wilson().unwrap();
        assert!((low - 0.2366).abs() < 1e-4 && (high - 0.7634).abs() < 1e-4);
    }

    #[test]
    fn nothing_is_known_of_no_runs() {
        assert_eq!((Rate::default().share(), Rate::default().wilson()), (None, None));
    }
}
