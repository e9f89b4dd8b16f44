//! Work that may take so long, and no longer.

use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Condvar, Mutex, PoisonError};
use std::thread;
use std::time::{Duration, Instant};

/// Time for one look at the texts of the page.
pub const LONGEST_LOOK: Duration = Duration::from_secs(2);

/// Result of `work` within `limit`. After that the flag it is given is set, `late` is called at once, and what the work gives when it comes
/// to its end is dropped.
pub fn within<T>(limit: Duration, late: impl FnOnce() + Send, work: impl FnOnce(&AtomicBool) -> T) -> Option<T> {
    let stop = AtomicBool::new(false);
    let (is_done, done) = (Mutex::new(false), Condvar::new());
    thread::scope(|scope| {
        scope.spawn(|| {
            let end = Instant::now() + limit;
            let mut state = is_done.lock().unwrap_or_else(PoisonError::into_inner);
            while !*state {
                let left = end.saturating_duration_since(Instant::now());
                if left.is_zero() {
                    stop.store(true, Ordering::Relaxed);
                    late();
                    return;
                }
                (state, _) = done.wait_timeout(state, left).unwrap_or_else(PoisonError::into_inner);
            }
        });
        let result = work(&stop);
        *is_done.lock().unwrap_or_else(PoisonError::into_inner) = true;
        done.notify_one();
        // Set under the lock that the end of the work takes as well: it is late, or it is not.
        (!stop.load(Ordering::Relaxed)).then_some(result)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn work_that_is_done_in_time_is_not_stopped() {
        let found = within(Duration::from_secs(60), || panic!("not late"), |stop| !stop.load(Ordering::Relaxed));
        assert_eq!(found, Some(true));
    }

    #[test]
    fn work_that_takes_longer_is_stopped_and_told_at_once() {
        let told = AtomicBool::new(false);
        let work = |stop: &AtomicBool| {
            // Goes on until it is stopped, as an analysis does, and then takes its time to end.
            while !stop.load(Ordering::Relaxed) {
                thread::sleep(Duration::from_millis(1));
            }
            while !told.load(Ordering::Relaxed) {
                thread::sleep(Duration::from_millis(1));
            }
            7
        };
        assert_eq!(within(Duration::from_millis(20), || told.store(true, Ordering::Relaxed), work), None);
        assert!(told.load(Ordering::Relaxed));
    }
}
