//! Ends of the columns of recent samples: a sample that comes again with another place of its journals is not closed anew.

use super::ends::Ends;
use loosepin_simulate::RunFailure;
use std::collections::{HashMap, VecDeque};
use std::sync::{Arc, Mutex, PoisonError};

/// Numbers that are held at most: 64 MiB.
const MAX_NUMBERS: usize = 1 << 23;
/// What an entry takes in numbers beyond its inputs and its ends.
const NUMBERS_PER_ENTRY: usize = 16;

/// The ends of the columns of a sample, or why it has none.
pub(super) type EndsOfSample = Result<Arc<[Ends]>, RunFailure>;

/// The most recent samples by the bits of their inputs. When there is no room, the oldest one leaves.
///
/// What is found here has the bits that closing the sample again would give, so that results do not depend on what is held. The plan of a study
/// repeats all its first samples at each place of the journals; where these samples are more than there is room for, each of them is closed again.
#[derive(Debug)]
pub(super) struct RecentEnds {
    capacity: usize,
    held: Mutex<Held>,
}

#[derive(Debug, Default)]
struct Held {
    by_inputs: HashMap<Arc<[u64]>, EndsOfSample>,
    /// Oldest first.
    order: VecDeque<Arc<[u64]>>,
}

impl RecentEnds {
    /// Nothing is held yet of samples with so many inputs and columns.
    pub fn new(inputs: usize, columns: usize) -> Self {
        Self::with_capacity(MAX_NUMBERS / (inputs + 2 * columns + NUMBERS_PER_ENTRY))
    }

    fn with_capacity(capacity: usize) -> Self {
        Self { capacity: capacity.max(1), held: Mutex::default() }
    }

    /// The ends of the sample with these inputs; `close` finds those that are not held. Others do not wait meanwhile.
    ///
    /// # Errors
    /// Those of `close`.
    pub fn of(&self, inputs: impl Iterator<Item = f64>, close: impl FnOnce() -> EndsOfSample) -> EndsOfSample {
        let inputs: Arc<[u64]> = inputs.map(f64::to_bits).collect();
        let lock = || self.held.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some(known) = lock().by_inputs.get(&inputs) {
            return known.clone();
        }
        let found = close();
        let mut held = lock();
        if held.by_inputs.insert(Arc::clone(&inputs), found.clone()).is_none() {
            held.order.push_back(inputs);
        }
        if held.order.len() > self.capacity
            && let Some(oldest) = held.order.pop_front()
        {
            held.by_inputs.remove(&oldest);
        }
        found
    }

    /// How many samples are held.
    #[cfg(test)]
    pub fn len(&self) -> usize {
        self.held.lock().unwrap_or_else(PoisonError::into_inner).order.len()
    }
}

#[cfg(test)]
mod tests {
    use super::{Ends, RecentEnds};
    use loosepin_simulate::RunFailure;
    use std::cell::Cell;

    #[test]
    fn identity_a_sample_is_closed_once_while_there_is_room() {
        let (recent, closed) = (RecentEnds::with_capacity(2), Cell::new(0));
        let of = |input: f64| {
            let found = recent.of([input, 1.0].into_iter(), || {
                closed.set(closed.get() + 1);
                Ok([Ends::of(input)].into())
            });
            found.unwrap()[0].lower
        };
        assert_eq!([of(1.0), of(2.0), of(1.0), of(2.0)], [1.0, 2.0, 1.0, 2.0]);
        assert_eq!(closed.get(), 2);
        // The third one takes the room of the first.
        assert_eq!([of(3.0), of(2.0), of(1.0)], [3.0, 2.0, 1.0]);
        assert_eq!(closed.get(), 4);
        // Zeros of both signs are not the same bits.
        assert_eq!([of(0.0), of(-0.0)], [0.0, 0.0]);
        assert_eq!(closed.get(), 6);
    }

    #[test]
    fn identity_a_sample_without_answer_is_not_tried_again() {
        let (recent, closed) = (RecentEnds::new(1, 1), Cell::new(0));
        let of = || {
            recent.of([1.0].into_iter(), || {
                closed.set(closed.get() + 1);
                Err(RunFailure::NothingIsFree)
            })
        };
        assert_eq!([of().unwrap_err(), of().unwrap_err()], [RunFailure::NothingIsFree, RunFailure::NothingIsFree]);
        assert_eq!(closed.get(), 1);
    }
}
