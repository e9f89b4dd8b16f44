//! Order statistics of a sample around a quantile.

use super::ordered::Ordered;
use loosepin_math::{number_of_key, order_key};

/// Those within so many standard deviations of the count below a quantile, and so many more, are put in order at once.
const DEVIATIONS: f64 = 4.0;
const MORE: f64 = 3.0;

/// The values of a sample, in increasing order where they are asked for: a quantile needs few of them.
pub(crate) enum OrderStatistics<'a> {
    /// All of them are in order.
    Whole(&'a [f64]),
    PartlySorted(PartlySorted),
}

/// Values of which some are in order.
pub(crate) struct PartlySorted {
    keys: Vec<i64>,
    /// First of those that are in order, and the one behind the last.
    first: usize,
    behind: usize,
}

impl<'a> OrderStatistics<'a> {
    /// The order statistics of the finished runs around the quantile at `probability`.
    pub fn new(ordered: &'a Ordered<'_>, probability: f64) -> Self {
        if let Some(sorted) = ordered.known_order() {
            return Self::Whole(sorted);
        }
        let sample = ordered.sample;
        let mut keys: Vec<i64> = sample.values().iter().map(|&value| order_key(value)).collect();
        let (runs, finished) = (sample.runs() as f64, keys.len() as f64);
        let reach = DEVIATIONS * (runs * probability * (1.0 - probability)).sqrt() + MORE;
        // Failed runs may all lie below.
        let first = (probability * runs - sample.failed() as f64 - reach).clamp(0.0, finished) as usize;
        let behind = (probability * runs + reach).clamp(0.0, finished) as usize;
        if first > 0 && first < keys.len() {
            keys.select_nth_unstable(first);
        }
        if behind < keys.len() && behind > first {
            keys[first..].select_nth_unstable(behind - first);
        }
        keys[first..behind].sort_unstable();
        Self::PartlySorted(PartlySorted { keys, first, behind })
    }

    /// Number of all values.
    pub fn count(&self) -> usize {
        match self {
            Self::Whole(sorted) => sorted.len(),
            Self::PartlySorted(part) => part.keys.len(),
        }
    }

    /// The value with `index` others below it.
    pub fn at(&mut self, index: usize) -> f64 {
        match self {
            Self::Whole(sorted) => sorted[index],
            Self::PartlySorted(part) => part.at(index),
        }
    }
}

impl PartlySorted {
    fn at(&mut self, index: usize) -> f64 {
        if index < self.first || index >= self.behind {
            self.keys.sort_unstable();
            (self.first, self.behind) = (0, self.keys.len());
        }
        number_of_key(self.keys[index])
    }
}

#[cfg(test)]
mod tests {
    use super::super::ordered::Ordered;
    use super::super::sample::Sample;
    use super::OrderStatistics;
    use loosepin_uncertainty::hash;

    #[test]
    fn identity_every_value_is_that_of_the_whole_order_whichever_is_asked_first() {
        for count in [1, 2, 5, 64, 256] {
            // Every third value comes twice.
            let values: Vec<f64> = (0..count).map(|i| (hash(7, i - u64::from(i % 3 == 2)) >> 40) as f64).collect();
            let sample = Sample::new([values.iter().copied()].into_iter());
            let mut sorted = values.clone();
            sorted.sort_unstable_by(f64::total_cmp);
            for probability in [0.0, 0.025, 0.5, 0.975, 1.0] {
                for first in 0..count as usize {
                    let (plain, in_order) = (Ordered::new(&sample), Ordered::new(&sample));
                    in_order.sorted();
                    for ordered in [plain, in_order] {
                        let mut asked = OrderStatistics::new(&ordered, probability);
                        assert_eq!(asked.count(), values.len());
                        for index in [first, 0, count as usize - 1] {
                            assert_eq!(asked.at(index), sorted[index], "{index} of {count} around {probability}");
                        }
                    }
                }
            }
        }
    }
}
