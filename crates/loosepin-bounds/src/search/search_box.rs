//! The search space: a unit box without the inputs that are single numbers, once for every combination of the discrete inputs.

use loosepin_uncertainty::{EpistemicVariable, Interval};

/// How the axes of a unit box end: at faces, or where they begin (an angle over a whole turn).
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Axes {
    pub(super) is_periodic: Vec<bool>,
}

/// Places of the two vertices of a closed axis: with the centre of the box at three equal distances round the circle.
const VERTICES_OF_A_CIRCLE: [f64; 2] = [1.0 / 6.0, 5.0 / 6.0];

impl Axes {
    /// Axes that all end at faces.
    pub fn open(dimensions: usize) -> Self {
        Self { is_periodic: vec![false; dimensions] }
    }

    /// Some of the axes.
    pub fn of(&self, axes: &[usize]) -> Self {
        Self { is_periodic: axes.iter().map(|&axis| self.is_periodic[axis]).collect() }
    }

    /// Number of axes that close.
    pub fn circles(&self) -> usize {
        self.is_periodic.iter().filter(|is_periodic| **is_periodic).count()
    }

    /// Whether `axis` closes.
    pub fn is_periodic(&self, axis: usize) -> bool {
        self.is_periodic[axis]
    }

    /// The coordinates in which models measure distances: those of open axes, then for each closed one 1/2 + cos(2πx)/2π and 1/2 +
    /// sin(2πx)/2π, so that lengths along it are those of the unit box.
    pub fn embed(&self, at: &[f64]) -> Vec<f64> {
        let of = |is_periodic: bool| {
            let own = at.iter().zip(&self.is_periodic).filter(move |(_, own)| **own == is_periodic);
            own.map(|(x, _)| *x)
        };
        let mut seen: Vec<f64> = of(false).collect();
        for x in of(true) {
            let angle = core::f64::consts::TAU * x;
            seen.extend([libm::cos(angle), libm::sin(angle)].map(|y| 0.5 + y / core::f64::consts::TAU));
        }
        seen
    }

    /// How a quantity changes along each axis at `at` that changes so along the coordinates [`Self::embed`].
    pub fn slopes(&self, at: &[f64], of_seen: &[f64]) -> Vec<f64> {
        let (of_open, of_circles) = of_seen.split_at(at.len() - self.circles());
        let (mut of_open, mut of_circles) = (of_open.iter(), of_circles.chunks_exact(2));
        let slope = |(x, is_periodic): (&f64, &bool)| {
            if !is_periodic {
                return of_open.next().copied().unwrap_or(0.0);
            }
            let angle = core::f64::consts::TAU * x;
            of_circles.next().map_or(0.0, |of| libm::cos(angle) * of[1] - libm::sin(angle) * of[0])
        };
        at.iter().zip(&self.is_periodic).map(slope).collect()
    }

    /// `value` brought into the part of `axis` from `lower` to `upper`: to the nearer end, or round the circle.
    pub fn inside(&self, axis: usize, value: f64, [lower, upper]: [f64; 2]) -> f64 {
        if self.is_periodic[axis] { value.rem_euclid(1.0) } else { value.max(lower).min(upper) }
    }

    /// The largest difference along an axis; infinite between different boxes.
    pub fn distance(&self, a: &BoxPoint, b: &BoxPoint) -> f64 {
        if a.combination != b.combination {
            return f64::INFINITY;
        }
        let steps = a.at.iter().zip(&b.at).enumerate().map(|(axis, (x, y))| self.step(axis, *x, *y).abs());
        steps.fold(0.0, f64::max)
    }

    /// How far it is along `axis` from one value to another, the shorter way round a circle.
    pub fn step(&self, axis: usize, from: f64, to: f64) -> f64 {
        let step = to - from;
        if self.is_periodic[axis] { step - step.round() } else { step }
    }

    /// A vertex of the unit box, where axes that close have none: two places of the circle stand for both ends.
    pub fn vertex(&self, mut corner: Vec<f64>) -> Vec<f64> {
        for (x, is_periodic) in corner.iter_mut().zip(&self.is_periodic) {
            if *is_periodic && (*x == 0.0 || *x == 1.0) {
                *x = VERTICES_OF_A_CIRCLE[usize::from(*x == 1.0)];
            }
        }
        corner
    }
}

/// A box of intervals; those of no width are held and do not count as dimensions. Inputs that are one of a list do not either:
/// every combination of their members has a box of its own.
#[derive(Debug, Clone)]
pub(crate) struct SearchBox {
    inputs: Vec<EpistemicVariable>,
    wide: Vec<usize>,
    axes: Axes,
}

/// A point of one of the boxes.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct BoxPoint {
    /// Which combination of the discrete inputs, the member of the first one changing fastest.
    pub combination: usize,
    /// Place in the unit box of the intervals.
    pub at: Vec<f64>,
}

/// A part of the unit box of the intervals, the same in every combination of the discrete inputs.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Region {
    /// Lower ends.
    pub lower: Vec<f64>,
    /// Upper ends.
    pub upper: Vec<f64>,
}

/// A place as near to a region as this counts as inside: values and fractions are not exact inverses.
const REGION_TOLERANCE: f64 = 1e-9;

/// A coordinate nearer to a face than this lies on it.
const FACE_THICKNESS: f64 = 1e-6;

impl Region {
    /// The whole box.
    pub fn whole(dimensions: usize) -> Self {
        Self { lower: vec![0.0; dimensions], upper: vec![1.0; dimensions] }
    }

    /// Whether it is the whole box.
    pub fn is_whole(&self) -> bool {
        self.lower.iter().all(|low| *low == 0.0) && self.upper.iter().all(|high| *high == 1.0)
    }

    /// Whether a point of the unit box lies in it.
    pub fn holds(&self, at: &[f64]) -> bool {
        let ends = self.lower.iter().zip(&self.upper);
        at.iter().zip(ends).all(|(x, (low, high))| *x >= low - REGION_TOLERANCE && *x <= high + REGION_TOLERANCE)
    }

    /// How far it is from it to a point of the unit box, along the axis along which it is furthest; 0 inside.
    pub fn distance(&self, axes: &Axes, at: &[f64]) -> f64 {
        let beyond = |axis: usize| {
            let (lower, upper) = (self.lower[axis], self.upper[axis]);
            if at[axis] >= lower && at[axis] <= upper {
                return 0.0;
            }
            axes.step(axis, lower, at[axis]).abs().min(axes.step(axis, upper, at[axis]).abs())
        };
        (0..at.len()).map(beyond).fold(0.0, f64::max)
    }

    /// Which of `places` lie in it.
    pub fn members(&self, places: &[BoxPoint]) -> Vec<usize> {
        (0..places.len()).filter(|&point| self.holds(&places[point].at)).collect()
    }

    /// The axes along which `at` lies on a face of it.
    pub fn faces(&self, axes: &Axes, at: &[f64]) -> Vec<usize> {
        let is_on_face = |&axis: &usize| {
            let is_near = |face: f64| (at[axis] - face).abs() < FACE_THICKNESS;
            !axes.is_periodic(axis) && (is_near(self.lower[axis]) || is_near(self.upper[axis]))
        };
        (0..at.len()).filter(is_on_face).collect()
    }

    /// The point of the region that lies as `fractions` do in the unit box.
    pub fn at(&self, fractions: &[f64]) -> Vec<f64> {
        let ends = self.lower.iter().zip(&self.upper);
        let place = |(x, (low, high)): (&f64, (&f64, &f64))| if *x >= 1.0 { *high } else { low + x * (high - low) };
        fractions.iter().zip(ends).map(place).collect()
    }
}

impl SearchBox {
    /// The part of the unit box in which the inputs lie in `ranges`, one for each; a list is not restricted.
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
        let wide: Vec<usize> = (0..inputs.len()).filter(|&i| is_wide(&inputs[i])).collect();
        let axes = Axes { is_periodic: wide.iter().map(|&input| inputs[input].is_periodic()).collect() };
        Self { inputs, wide, axes }
    }

    /// How the axes of its unit box end.
    pub fn axes(&self) -> &Axes {
        &self.axes
    }

    /// All inputs.
    pub fn inputs(&self) -> &[EpistemicVariable] {
        &self.inputs
    }

    /// Number of intervals that are wider than a point.
    pub fn dimensions(&self) -> usize {
        self.wide.len()
    }

    /// The axis of input `index` in the unit box; `None` if it has none, as a single number or one of a list.
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
    pub fn values_at(&self, place: &BoxPoint) -> Vec<f64> {
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

    /// The first input whose value is none of its list.
    pub fn first_unlisted(&self, values: &[f64]) -> Option<usize> {
        let is_none_of = |(input, value): (&EpistemicVariable, &f64)| matches!(input, EpistemicVariable::OneOf(members) if members.index_of(*value).is_none());
        self.inputs.iter().zip(values).position(is_none_of)
    }

    /// The point of the box at `values` of all inputs; none of them is a [`SearchBox::first_unlisted`].
    pub fn place_of(&self, values: &[f64]) -> BoxPoint {
        let (mut combination, mut weight) = (0, 1);
        let mut at = Vec::with_capacity(self.wide.len());
        for (index, (input, &value)) in self.inputs.iter().zip(values).enumerate() {
            match input {
                EpistemicVariable::OneOf(members) => {
                    combination += weight * members.index_of(value).unwrap_or(0);
                    weight *= members.values().len();
                }
                other => {
                    if let (true, Some(range)) = (self.wide.contains(&index), other.range()) {
                        at.push(range.fraction_of(value));
                    }
                }
            }
        }
        BoxPoint { combination, at }
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
    use super::{Axes, BoxPoint, SearchBox};
    use loosepin_uncertainty::{Interval, Members};

    #[test]
    fn identity_places_and_values_are_inverse_and_points_are_held() {
        let intervals = [(0.5, 2.5), (3.25, 3.25), (-1.0, 0.5)].map(|(a, b)| Interval::try_new(a, b).unwrap().into());
        let search_box = SearchBox::new(intervals.to_vec());
        assert_eq!((search_box.dimensions(), search_box.combinations()), (2, 1));
        let place = BoxPoint { combination: 0, at: vec![0.25, 1.0] };
        assert_eq!(search_box.values_at(&place), [1.0, 3.25, 0.5]);
        assert_eq!(search_box.place_of(&[1.0, 3.25, 0.5]), place);
        assert!(search_box.holds(&[1.0, 3.25]) && !search_box.holds(&[1.0, 3.0]));
    }

    #[test]
    fn analytic_a_closed_axis_has_no_ends() {
        const TOLERANCE: f64 = 1e-15;
        let axes = Axes { is_periodic: vec![false, true] };
        let place = |x: f64, y: f64| BoxPoint { combination: 0, at: vec![x, y] };
        assert!((axes.distance(&place(0.25, 0.95), &place(0.3, 0.05)) - 0.1).abs() < TOLERANCE);
        assert!((axes.distance(&place(0.75, 0.95), &place(0.3, 0.9)) - 0.45).abs() < TOLERANCE);
        let (first, last) = (axes.embed(&[0.25, 0.0]), axes.embed(&[0.25, 1.0]));
        assert!(first.len() == 3 && first.iter().zip(&last).all(|(a, b)| (a - b).abs() < TOLERANCE), "{last:?}");
        assert!((axes.inside(1, -0.125, [0.0, 1.0]) - 0.875).abs() < TOLERANCE);
        assert_eq!((axes.inside(0, -0.125, [0.0, 1.0]), axes.inside(0, 1.125, [0.0, 0.75])), (0.0, 0.75));
        assert_eq!(axes.vertex(vec![1.0, 0.5]), [1.0, 0.5]);
        assert_eq!(axes.vertex(vec![0.0, 1.0]), [0.0, 5.0 / 6.0]);
    }

    #[test]
    fn identity_every_combination_of_members_is_met_once() {
        let members = |values: &[f64]| Members::try_new(values.to_vec()).unwrap().into();
        let interval = Interval::try_new(0.5, 2.5).unwrap().into();
        let search_box = SearchBox::new(vec![members(&[7.0, 3.0, 4.0]), interval, members(&[-1.5, 2.0])]);
        assert_eq!((search_box.dimensions(), search_box.combinations()), (1, 6));
        let mut met: Vec<Vec<f64>> = Vec::new();
        for combination in 0..6 {
            let place = BoxPoint { combination, at: vec![0.25] };
            let values = search_box.values_at(&place);
            assert_eq!(search_box.place_of(&values), place);
            assert!(values[1] == 1.0 && !met.contains(&values), "{values:?}");
            met.push(values);
        }
    }
}
