//! What Node calls: numbers in, numbers out.

use std::cell::RefCell;

use crate::Bench;

thread_local! {
    static LOG: RefCell<Vec<u8>> = const { RefCell::new(Vec::new()) };
    static BENCH: RefCell<Option<Bench>> = const { RefCell::new(None) };
}

/// Takes one more byte of the log.
#[allow(unsafe_code, reason = "a name for Node to call; nothing else has it")]
#[unsafe(no_mangle)]
pub extern "C" fn feed(byte: u32) {
    LOG.with_borrow_mut(|log| log.push(byte.to_le_bytes()[0]));
}

/// See [`Bench::prepare`].
#[allow(unsafe_code, reason = "a name for Node to call; nothing else has it")]
#[unsafe(no_mangle)]
pub extern "C" fn prepare(task: usize) -> usize {
    BENCH.with_borrow_mut(|bench| bench.get_or_insert_with(|| Bench::new(LOG.take())).prepare(task))
}

/// See [`Bench::rewind`].
#[allow(unsafe_code, reason = "a name for Node to call; nothing else has it")]
#[unsafe(no_mangle)]
pub extern "C" fn rewind() {
    BENCH.with_borrow_mut(|bench| bench.iter_mut().for_each(Bench::rewind));
}

/// See [`Bench::run`].
#[allow(unsafe_code, reason = "a name for Node to call; nothing else has it")]
#[unsafe(no_mangle)]
pub extern "C" fn run() -> f64 {
    BENCH.with_borrow_mut(|bench| bench.as_mut().map_or(0.0, Bench::run))
}
