//! A sample together with its values in increasing order.

use std::cell::OnceCell;

use super::sample::Sample;

/// A sample whose values are sorted once, when they are first asked for, for all that is estimated of it.
pub(crate) struct Ordered<'a> {
    pub sample: &'a Sample,
    sorted: OnceCell<Vec<f64>>,
}

impl<'a> Ordered<'a> {
    pub fn new(sample: &'a Sample) -> Self {
        Self { sample, sorted: OnceCell::new() }
    }

    /// The finished values in increasing order.
    pub fn sorted(&self) -> &[f64] {
        self.sorted.get_or_init(|| self.sample.sorted())
    }

    /// The same where they have been sorted already.
    pub fn known_order(&self) -> Option<&[f64]> {
        self.sorted.get().map(Vec::as_slice)
    }

    /// The distances of the finished values from `centre` in increasing order: those of the values below and above are in order each.
    pub fn distances(&self, centre: f64) -> Vec<f64> {
        let sorted = self.sorted();
        let (below, above) = sorted.split_at(sorted.partition_point(|&value| value < centre));
        let mut below = below.iter().rev().map(|value| (value - centre).abs()).peekable();
        let mut above = above.iter().map(|value| (value - centre).abs()).peekable();
        let mut distances = Vec::with_capacity(sorted.len());
        while let Some(next) = match (below.peek(), above.peek()) {
            (Some(low), Some(high)) if high < low => above.next(),
            (Some(_), _) => below.next(),
            (None, _) => above.next(),
        } {
            distances.push(next);
        }
        distances
    }
}

#[cfg(test)]
mod tests {
    use super::super::sample::Sample;
    use super::Ordered;
    use loosepin_math::in_order;
    use loosepin_uncertainty::hash;

    #[test]
    fn identity_distances_are_those_that_are_sorted_afterwards() {
        for count in [1, 2, 5, 256] {
            // Every third value comes twice; a centre is above all, below all, among them, and one of them.
            let values: Vec<f64> = (0..count).map(|i| (hash(9, i - u64::from(i % 3 == 2)) >> 40) as f64).collect();
            let sample = Sample::new([values.iter().copied()].into_iter());
            for centre in [-1.0, 1e9, 8e6, values[0]] {
                let expected = in_order(values.iter().map(|value| (value - centre).abs()));
                assert_eq!(Ordered::new(&sample).distances(centre), expected);
            }
        }
    }
}
