use rand_core::SeedableRng;
use rand_pcg::Pcg64Mcg;

use crate::chance::uniform;

/// The one source of chance of something that is made up from a seed.
pub(crate) struct Dice(Pcg64Mcg);

impl Dice {
    pub(crate) fn new(seed: u64) -> Self {
        Self(Pcg64Mcg::seed_from_u64(seed))
    }

    /// A whole number, both ends included; `low` where there is nothing between.
    pub(crate) fn between(&mut self, low: i32, high: i32) -> i32 {
        let range = f64::from((high - low).max(0)) + 1.0;
        low + (uniform(&mut self.0) * range) as i32
    }

    /// A number from an interval.
    pub(crate) fn within(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * uniform(&mut self.0)
    }

    /// `true` in so many of 100 cases.
    pub(crate) fn falls(&mut self, per_cent: i32) -> bool {
        self.between(1, 100) <= per_cent
    }

    /// One of a list; `None` of an empty one.
    pub(crate) fn pick<T: Copy>(&mut self, list: &[T]) -> Option<T> {
        list.get(self.between(0, list.len() as i32 - 1) as usize).copied()
    }

    /// The list in another order (Fisher and Yates).
    pub(crate) fn shuffled<T>(&mut self, mut list: Vec<T>) -> Vec<T> {
        for last in (1..list.len()).rev() {
            list.swap(last, self.between(0, last as i32) as usize);
        }
        list
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_number_of_a_range_comes_and_no_other() {
        let mut dice = Dice::new(1);
        let mut seen = [0; 5];
        for _ in 0..500 {
            seen[(dice.between(3, 7) - 3) as usize] += 1;
        }
        assert!(seen.iter().all(|&times| times > 60), "{seen:?}");
        assert_eq!((dice.between(4, 4), dice.pick::<u8>(&[])), (4, None));
    }

    #[test]
    fn shuffling_keeps_everything() {
        let mut list = Dice::new(2).shuffled((0..20).collect::<Vec<_>>());
        assert_ne!(list, (0..20).collect::<Vec<_>>());
        list.sort_unstable();
        assert_eq!(list, (0..20).collect::<Vec<_>>());
    }
}
