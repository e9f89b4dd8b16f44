//! The box that is searched, as a unit box without the inputs that are single numbers.

use crate::uncertainty::Interval;

/// A box of intervals; those of no width are held and do not count as dimensions.
#[derive(Debug, Clone)]
pub(super) struct SearchBox {
    intervals: Vec<Interval>,
    wide: Vec<usize>,
}

impl SearchBox {
    /// The box of these intervals.
    pub fn new(intervals: Vec<Interval>) -> Self {
        let wide = (0..intervals.len()).filter(|&i| intervals[i].lower() < intervals[i].upper()).collect();
        Self { intervals, wide }
    }

    /// All intervals.
    pub fn intervals(&self) -> &[Interval] {
        &self.intervals
    }

    /// Number of intervals that are wider than a point.
    pub fn dimensions(&self) -> usize {
        self.wide.len()
    }

    /// Values of all inputs at `place` in the unit box.
    pub fn values_at(&self, place: &[f64]) -> Vec<f64> {
        let mut values: Vec<f64> = self.intervals.iter().map(Interval::lower).collect();
        for (&input, &fraction) in self.wide.iter().zip(place) {
            values[input] = self.intervals[input].at(fraction);
        }
        values
    }

    /// Where `values` of all inputs lie in the unit box.
    pub fn place_of(&self, values: &[f64]) -> Vec<f64> {
        self.wide.iter().map(|&input| self.intervals[input].fraction_of(values[input])).collect()
    }

    /// Whether the first inputs lie within their intervals.
    pub fn holds(&self, values: &[f64]) -> bool {
        values
            .iter()
            .zip(&self.intervals)
            .all(|(&value, interval)| value >= interval.lower() && value <= interval.upper())
    }
}

#[cfg(test)]
mod tests {
    use super::SearchBox;
    use crate::uncertainty::Interval;

    #[test]
    fn identity_places_and_values_are_inverse_and_points_are_held() {
        let intervals = [(0.5, 2.5), (3.25, 3.25), (-1.0, 0.5)].map(|(a, b)| Interval::try_new(a, b).unwrap());
        let search_box = SearchBox::new(intervals.to_vec());
        assert_eq!(search_box.dimensions(), 2);
        assert_eq!(search_box.values_at(&[0.25, 1.0]), [1.0, 3.25, 0.5]);
        assert_eq!(search_box.place_of(&[1.0, 3.25, 0.5]), [0.25, 1.0]);
        assert!(search_box.holds(&[1.0, 3.25]) && !search_box.holds(&[1.0, 3.0]));
    }
}
