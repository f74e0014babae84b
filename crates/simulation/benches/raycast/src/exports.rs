//! What Node calls: numbers in, numbers out.

use std::cell::RefCell;

use crate::{Contest, SIZES};

thread_local! {
    static CONTEST: RefCell<Option<Contest>> = const { RefCell::new(None) };
}

/// Builds the office of that size; how many segments it has.
#[allow(unsafe_code, reason = "a name for Node to call; nothing else has it")]
#[unsafe(no_mangle)]
pub extern "C" fn prepare(size: usize) -> usize {
    let contest = SIZES.get(size).map(|segments| Contest::new(*segments));
    let segments = contest.as_ref().map_or(0, Contest::segments);
    CONTEST.set(contest);
    segments
}

/// Takes a batch of scans, from the one numbered `first` on, in the office built
/// last; the sum of all ranges.
#[allow(unsafe_code, reason = "a name for Node to call; nothing else has it")]
#[unsafe(no_mangle)]
pub extern "C" fn run(method: usize, first: usize) -> f64 {
    CONTEST.with_borrow_mut(|contest| contest.as_mut().map_or(0.0, |contest| contest.run(method, first)))
}
