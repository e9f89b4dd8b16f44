//! Counts of work that tests hold against the length of a text: bytes, names and entries that were looked at, operations that were
//! evaluated. Seconds would tell more of the machine than of the work.

use std::cell::Cell;

thread_local! {
    static COUNT: Cell<u64> = const { Cell::new(0) };
}

/// Adds bytes, names, entries or operations to the count of this thread. Builds without debug assertions count nothing.
#[inline]
pub fn add(count: usize) {
    if cfg!(debug_assertions) {
        COUNT.set(COUNT.get().wrapping_add(count as u64));
    }
}

/// The count of this thread so far; 0 in builds without debug assertions.
pub fn count() -> u64 {
    COUNT.get()
}

#[cfg(test)]
mod tests {
    use super::{add, count};
    use crate::diagnostics::Source;

    #[test]
    fn each_thread_counts_what_it_looks_at() {
        let before = count();
        let elsewhere = std::thread::spawn(|| {
            add(7);
            count()
        });
        assert_eq!(elsewhere.join().ok(), Some(7));
        assert_eq!(count(), before);
        // A position is looked for from a place near it: the text is gone through once for all of them.
        let source = Source::new("model.toml", "x".repeat(100_000));
        (0..1000).for_each(|_| assert_eq!(source.utf16_units(99_999), 99_999));
        let looked_at = count() - before;
        assert!((100_000..700_000).contains(&looked_at), "{looked_at} bytes for 1000 positions in 100000");
    }
}
