//! What Node calls: numbers in, numbers out.

use std::cell::RefCell;

use cogmap_mapping::Mapper;

use crate::Prepared;

thread_local! {
    static LOG: RefCell<Vec<u8>> = const { RefCell::new(Vec::new()) };
    static PREPARED: RefCell<Option<Prepared>> = const { RefCell::new(None) };
    static START: RefCell<Option<Mapper>> = const { RefCell::new(None) };
}

/// Takes one more byte of the log.
#[allow(unsafe_code, reason = "a name for Node to call; nothing else has it")]
#[unsafe(no_mangle)]
pub extern "C" fn feed(byte: u32) {
    LOG.with_borrow_mut(|log| log.push(byte.to_le_bytes()[0]));
}

/// Makes everything ready for a task; how many steps a run of it takes.
#[allow(unsafe_code, reason = "a name for Node to call; nothing else has it")]
#[unsafe(no_mangle)]
pub extern "C" fn prepare(task: usize) -> usize {
    let prepared = LOG.with_borrow(|log| Prepared::new(task, log));
    let steps = prepared.as_ref().map_or(0, Prepared::steps);
    PREPARED.set(prepared);
    steps
}

/// Copies what a run begins with.
#[allow(unsafe_code, reason = "a name for Node to call; nothing else has it")]
#[unsafe(no_mangle)]
pub extern "C" fn rewind() {
    START.set(PREPARED.with_borrow(|prepared| prepared.as_ref().and_then(Prepared::start)));
}

/// Runs the task prepared last; a number that is the same wherever it runs.
#[allow(unsafe_code, reason = "a name for Node to call; nothing else has it")]
#[unsafe(no_mangle)]
pub extern "C" fn run() -> f64 {
    let start = START.take();
    PREPARED.with_borrow(|prepared| prepared.as_ref().map_or(0.0, |prepared| prepared.run(start)))
}
