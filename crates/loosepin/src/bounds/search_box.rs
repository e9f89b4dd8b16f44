//! What is searched: a unit box without the inputs that are single numbers, once for every combination of the discrete inputs.

use crate::uncertainty::{EpistemicVariable, Interval};

/// A box of intervals; those of no width are held and do not count as dimensions. Inputs that are one of a list do not either:
/// every combination of their members has a box of its own.
#[derive(Debug, Clone)]
pub(super) struct SearchBox {
    inputs: Vec<EpistemicVariable>,
    wide: Vec<usize>,
}

/// A point of one of the boxes.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Place {
    /// Which combination of the discrete inputs, the member of the first one changing fastest.
    pub combination: usize,
    /// Where in the unit box of the intervals.
    pub at: Vec<f64>,
}

impl Place {
    /// The largest difference along an axis; infinite between different boxes.
    pub fn distance(&self, other: &Self) -> f64 {
        if self.combination != other.combination {
            return f64::INFINITY;
        }
        self.at.iter().zip(&other.at).fold(0.0, |most, (x, y)| f64::max(most, (x - y).abs()))
    }
}

/// A part of the unit box of the intervals, the same in every combination of the discrete inputs.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Region {
    /// Lower ends.
    pub lower: Vec<f64>,
    /// Upper ends.
    pub upper: Vec<f64>,
}

/// A place as near to a region as this counts as inside: values and fractions are not exact inverses.
const REGION_TOLERANCE: f64 = 1e-9;

impl Region {
    /// The whole box.
    pub fn whole(dimensions: usize) -> Self {
        Self { lower: vec![0.0; dimensions], upper: vec![1.0; dimensions] }
    }

    /// Whether a point of the unit box lies in it.
    pub fn holds(&self, at: &[f64]) -> bool {
        let ends = self.lower.iter().zip(&self.upper);
        at.iter().zip(ends).all(|(x, (low, high))| *x >= low - REGION_TOLERANCE && *x <= high + REGION_TOLERANCE)
    }

    /// The point of the region that lies as `fractions` do in the unit box.
    pub fn at(&self, fractions: &[f64]) -> Vec<f64> {
        let ends = self.lower.iter().zip(&self.upper);
        let place = |(x, (low, high)): (&f64, (&f64, &f64))| if *x >= 1.0 { *high } else { low + x * (high - low) };
        fractions.iter().zip(ends).map(place).collect()
    }
}

impl SearchBox {
    /// The part of the unit box in which the inputs lie in `ranges`, one for each; nothing restricts a list.
    pub fn region(&self, ranges: &[Option<Interval>]) -> Region {
        let mut region = Region::whole(self.wide.len());
        for (axis, &input) in self.wide.iter().enumerate() {
            if let (Some(range), Some(own)) = (self.inputs[input].range(), ranges[input]) {
                region.lower[axis] = range.fraction_of(own.lower());
                region.upper[axis] = range.fraction_of(own.upper());
            }
        }
        region
    }

    /// The box of these inputs.
    pub fn new(inputs: Vec<EpistemicVariable>) -> Self {
        let is_wide = |input: &EpistemicVariable| input.range().is_some_and(|range| range.lower() < range.upper());
        let wide = (0..inputs.len()).filter(|&i| is_wide(&inputs[i])).collect();
        Self { inputs, wide }
    }

    /// All inputs.
    pub fn inputs(&self) -> &[EpistemicVariable] {
        &self.inputs
    }

    /// Number of intervals that are wider than a point.
    pub fn dimensions(&self) -> usize {
        self.wide.len()
    }

    /// The axis of input `index` in the unit box; nothing where it has none, as a single number or one of a list.
    pub fn axis_of(&self, index: usize) -> Option<usize> {
        self.wide.iter().position(|&input| input == index)
    }

    /// Number of combinations of the discrete inputs; 1 where there are none.
    pub fn combinations(&self) -> usize {
        self.inputs.iter().fold(1, |combinations: usize, input| combinations.saturating_mul(input.choices()))
    }

    /// Which member of input `index`, one of a list, stands in `combination`; 0 for an interval.
    pub fn member_of(&self, combination: usize, index: usize) -> usize {
        let weight: usize = self.inputs[..index].iter().map(EpistemicVariable::choices).product();
        combination / weight % self.inputs[index].choices()
    }

    /// Whether there is one value of the inputs and no other.
    pub fn is_a_point(&self) -> bool {
        self.dimensions() == 0 && self.combinations() == 1
    }

    /// Values of all inputs at `place`.
    pub fn values_at(&self, place: &Place) -> Vec<f64> {
        let mut rest = place.combination;
        let mut values: Vec<f64> = self
            .inputs
            .iter()
            .map(|input| match input {
                EpistemicVariable::OneOf(members) => {
                    let value = members.values()[rest % members.values().len()];
                    rest /= members.values().len();
                    value
                }
                other => other.ends()[0],
            })
            .collect();
        for (&input, &fraction) in self.wide.iter().zip(&place.at) {
            if let Some(range) = self.inputs[input].range() {
                values[input] = range.at(fraction);
            }
        }
        values
    }

    /// Where `values` of all inputs lie.
    pub fn place_of(&self, values: &[f64]) -> Place {
        let (mut combination, mut weight) = (0, 1);
        let mut at = Vec::with_capacity(self.wide.len());
        for (index, (input, &value)) in self.inputs.iter().zip(values).enumerate() {
            match input {
                EpistemicVariable::OneOf(members) => {
                    combination += weight * members.index_of(value);
                    weight *= members.values().len();
                }
                other => {
                    if let (true, Some(range)) = (self.wide.contains(&index), other.range()) {
                        at.push(range.fraction_of(value));
                    }
                }
            }
        }
        Place { combination, at }
    }

    /// Whether the first inputs lie within their ends.
    pub fn holds(&self, values: &[f64]) -> bool {
        values.iter().zip(&self.inputs).all(|(&value, input)| {
            let [lower, upper] = input.ends();
            value >= lower && value <= upper
        })
    }
}

#[cfg(test)]
mod tests {
    use super::{Place, SearchBox};
    use crate::uncertainty::{Interval, Members};

    #[test]
    fn identity_places_and_values_are_inverse_and_points_are_held() {
        let intervals = [(0.5, 2.5), (3.25, 3.25), (-1.0, 0.5)].map(|(a, b)| Interval::try_new(a, b).unwrap().into());
        let search_box = SearchBox::new(intervals.to_vec());
        assert_eq!((search_box.dimensions(), search_box.combinations()), (2, 1));
        let place = Place { combination: 0, at: vec![0.25, 1.0] };
        assert_eq!(search_box.values_at(&place), [1.0, 3.25, 0.5]);
        assert_eq!(search_box.place_of(&[1.0, 3.25, 0.5]), place);
        assert!(search_box.holds(&[1.0, 3.25]) && !search_box.holds(&[1.0, 3.0]));
    }

    #[test]
    fn identity_every_combination_of_members_is_met_once() {
        let members = |values: &[f64]| Members::try_new(values.to_vec()).unwrap().into();
        let interval = Interval::try_new(0.5, 2.5).unwrap().into();
        let search_box = SearchBox::new(vec![members(&[7.0, 3.0, 4.0]), interval, members(&[-1.5, 2.0])]);
        assert_eq!((search_box.dimensions(), search_box.combinations()), (1, 6));
        let mut met: Vec<Vec<f64>> = Vec::new();
        for combination in 0..6 {
            let place = Place { combination, at: vec![0.25] };
            let values = search_box.values_at(&place);
            assert_eq!(search_box.place_of(&values), place);
            assert!(values[1] == 1.0 && !met.contains(&values), "{values:?}");
            met.push(values);
        }
    }
}
