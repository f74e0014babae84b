use std::ops::{Deref, DerefMut};

/// A value that counts how often somebody took hold of it to change it, so that what is made from it need not be
/// made again while nobody did.
#[derive(Debug)]
pub(crate) struct Tracked<T> {
    value: T,
    changes: u64,
}

impl<T> Tracked<T> {
    pub(crate) fn new(value: T) -> Self {
        Self { value, changes: 0 }
    }

    /// How often it may have changed.
    pub(crate) fn changes(&self) -> u64 {
        self.changes
    }

    /// To change in it what nothing is made from, such as what it keeps to answer faster.
    pub(crate) fn behind_the_scenes(&mut self) -> &mut T {
        &mut self.value
    }
}

impl<T> Deref for Tracked<T> {
    type Target = T;

    fn deref(&self) -> &T {
        &self.value
    }
}

impl<T> DerefMut for Tracked<T> {
    fn deref_mut(&mut self) -> &mut T {
        self.changes += 1;
        &mut self.value
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_a_hold_that_may_change_it_counts() {
        let mut numbers = Tracked::new(vec![1]);
        assert_eq!((numbers.len(), numbers.changes()), (1, 0));
        numbers.behind_the_scenes().reserve(8);
        assert_eq!(numbers.changes(), 0);
        numbers.push(2);
        assert_eq!((numbers.len(), numbers.changes()), (2, 1));
    }
}
