//! Work that threads share. Each piece gets a thread through one function that knows nothing of what it does, so that it is compiled once:
//! the iterators of rayon are compiled anew wherever they are used.

use rayon::prelude::*;
use std::sync::{Mutex, OnceLock, PoisonError};

/// What `of` makes of each of `items`, in their order.
pub(crate) fn map<T: Sync, R: Send + Sync>(items: &[T], of: impl Fn(&T) -> R + Sync) -> Vec<R> {
    map_indices(items.len(), |index| of(&items[index]))
}

/// All pieces of what `of` makes of each of `items`, in the order of the items.
pub(crate) fn flat_map<T: Sync, I: IntoIterator + Send + Sync>(
    items: &[T],
    of: impl Fn(&T) -> I + Sync,
) -> Vec<I::Item> {
    map(items, of).into_iter().flatten().collect()
}

/// Does `work` to each of `items`.
pub(crate) fn for_each_mut<T: Send>(items: &mut [T], work: impl Fn(&mut T) + Sync) {
    // Each lock is taken once.
    let items: Vec<Mutex<&mut T>> = items.iter_mut().map(Mutex::new).collect();
    for_each_index(items.len(), &|index| work(&mut items[index].lock().unwrap_or_else(PoisonError::into_inner)));
}

/// What `of` makes of each index below `count`, in their order.
pub(crate) fn map_indices<R: Send + Sync>(count: usize, of: impl Fn(usize) -> R + Sync) -> Vec<R> {
    let made: Vec<OnceLock<R>> = (0..count).map(|_| OnceLock::new()).collect();
    for_each_index(count, &|index| {
        let _ = made[index].set(of(index));
    });
    // Nothing is left out: a panic in a thread is one here.
    debug_assert!(made.iter().all(|made| made.get().is_some()));
    made.into_iter().filter_map(OnceLock::into_inner).collect()
}

/// Does `work` for each index below `count`.
pub(crate) fn for_each_index(count: usize, work: &(dyn Fn(usize) + Sync)) {
    (0..count).into_par_iter().for_each(work);
}

#[cfg(test)]
mod tests {
    use super::{flat_map, map, map_indices};

    #[test]
    fn identity_what_threads_make_is_in_the_order_of_what_it_is_of() {
        let numbers: Vec<usize> = (0..10_000).collect();
        assert_eq!(map(&numbers, |number| number * 3), numbers.iter().map(|number| number * 3).collect::<Vec<_>>());
        assert_eq!(map_indices(10_000, |index| index), numbers);
        let repeated = flat_map(&numbers, |number| vec![*number; number % 3]);
        assert_eq!(repeated, numbers.iter().flat_map(|number| vec![*number; number % 3]).collect::<Vec<_>>());
        assert!(map(&[], |number: &usize| *number).is_empty());
    }
}
