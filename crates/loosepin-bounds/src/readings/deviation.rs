//! Bounds of the standard deviation where values differ between elements, or from sample to sample within one.
//!
//! With u_e the value in element e, m_e its mass, μ and σ² mean and variance of the response given u,
//!
//! ```text
//! Var = Σ m_e σ²(u_e) + Σ m_e (μ(u_e) - M)²,  M = Σ m_e μ(u_e);      Var = min over c of Σ m_e h_c(u_e),  h_c(u) = σ²(u) + (μ(u) - c)²
//! ```
//!
//! Where u has any distribution within its element, the greatest variance is min over c of Σ m_e max over u of h_c(u) exactly: h is
//! linear in the distributions and convex in c, so that the two extremes may change places (M. Sion, "On general minimax
//! theorems", 1958). Where u is fixed in each element, this is a bound from outside; so is the sum of the greatest variances within
//! elements and of the greatest variance that means within their own bounds can have among them. The lesser of the two is taken.
//! The least variance is the same for both readings.

use super::experiment::{Experiment, Focal};
use super::interval::Modelled;
use crate::data::bound::{Bound, BoundError};
use crate::data::direction::{Direction, range_of};
use crate::data::problem::Reading;
use crate::estimators::estimate::{Confidence, Estimate};
use crate::estimators::moments::{mean, variance};
use crate::estimators::sample::Sample;
use crate::measures::mean::Mean;
use crate::measures::measure::Estimator;
use crate::measures::standard_deviation::StandardDeviation;
use crate::search::target::Target;
use loosepin_terms::Estimation;

/// Steps of the searches along c, and the ratio of golden sections.
const GOLDEN_STEPS: usize = 80;
const GOLDEN: f64 = 0.618_033_988_749_894_9;
/// Values of c among which the least variance is sought before its surroundings are.
const SCANNED: usize = 128;
/// Rounds in which each element is moved to where the variance is greatest.
const ASCENTS: usize = 20;
/// Boxes of means whose corners are all tried, at most.
const MAX_ENUMERATED: usize = 12;

impl Experiment<'_> {
    /// Both ends of the standard deviation of `column` over `elements`.
    pub fn deviations(&self, column: usize, elements: &[Focal<'_>]) -> [Bound; 2] {
        let samples = self.pool.samples(column);
        let confidence = &self.setup.confidence;
        let points = Points::new(&samples, confidence);
        let Some(members) = points.members(elements) else {
            return Direction::BOTH.map(|direction| self.unknown(direction));
        };
        let (mean, deviation) = (Mean.measure(&samples, confidence), StandardDeviation.measure(&samples, confidence));
        let masses: Vec<f64> = elements.iter().map(|element| element.mass).collect();
        let centre = points.minimax_centre(&members, &masses);
        let squares = squares_about(&samples, centre);
        let squares: Vec<&Sample> = squares.iter().collect();
        let square = Mean.measure(&squares, confidence);
        let search = self.search([&mean, &deviation, &square].into_iter());
        let [mean, deviation] = [&mean, &deviation].map(|measure| Modelled::new(&search, measure, &samples));
        let square = Modelled::new(&search, &square, &squares);
        let each = |modelled: &Modelled<'_>, direction| -> Vec<Bound> {
            elements.iter().map(|element| self.bound(modelled, direction, element)).collect()
        };
        let boxes: Vec<[f64; 2]> = each(&mean, Direction::Minimum)
            .iter()
            .zip(each(&mean, Direction::Maximum))
            .map(|(low, high)| [low.widened, high.widened])
            .collect();
        let deviations = Direction::BOTH.map(|direction| each(&deviation, direction));
        let within = |direction: Direction| -> f64 {
            let bounds = deviations[direction.index()].iter().zip(&masses);
            bounds.map(|(bound, mass)| mass * bound.widened * bound.widened).sum()
        };
        // Sampling errors of variances: what the bounds within elements concede to it.
        let sampling = |direction: Direction| -> f64 {
            let of = |bound: &Bound| {
                let moved = (bound.value + direction.sign() * bound.error.sampling).max(0.0);
                (moved * moved - bound.value * bound.value).abs()
            };
            deviations[direction.index()].iter().zip(&masses).map(|(bound, mass)| mass * of(bound)).sum()
        };
        let least = points.least(&members, &masses);
        let lower = within(Direction::Minimum) + least_spread(&boxes, &masses);
        let minimax: f64 =
            each(&square, Direction::Maximum).iter().zip(&masses).map(|(bound, mass)| mass * bound.widened).sum();
        let (greatest, upper) = if self.is_mixed() {
            (points.added(&members, &masses, centre, Direction::Maximum), minimax)
        } else {
            let apart = within(Direction::Maximum) + greatest_spread(&boxes, &masses);
            (points.greatest(&members, &masses, centre), minimax.min(apart))
        };
        [
            self.deviation_bound(least, lower, sampling(Direction::Minimum), Direction::Minimum),
            self.deviation_bound(greatest, upper, sampling(Direction::Maximum), Direction::Maximum),
        ]
    }

    /// The squares of the response about the c of the greatest variance, for all deviations that [`Self::deviations`] bounds: their greatest
    /// means are to be searched.
    pub fn square_targets(&self) -> Vec<(Target, Vec<Direction>)> {
        let confidence = &self.setup.confidence;
        let mut targets = Vec::new();
        for cut in self.setup.structure.cuts.iter().filter(|cut| self.is_mixed() || cut.elements.len() > 1) {
            let elements = self.focal_elements(cut);
            let masses: Vec<f64> = elements.iter().map(|element| element.mass).collect();
            let requests = self.setup.problem.requests.iter();
            for request in requests.filter(|request| request.statistic.estimation() == Some(Estimation::RootOfVariance))
            {
                let samples = self.pool.samples(request.column);
                let points = Points::new(&samples, confidence);
                // An element without a finished run has no bound, wherever one looks.
                let Some(members) = points.members(&elements) else { continue };
                let squares = squares_about(&samples, points.minimax_centre(&members, &masses));
                let measure = Mean.measure(&squares.iter().collect::<Vec<_>>(), confidence);
                targets.extend(measure.into_targets().into_iter().map(|target| (target, vec![Direction::Maximum])));
            }
        }
        targets
    }

    /// A bound of the deviation from an attained and a widened variance.
    fn deviation_bound(&self, attained: f64, widened: f64, sampling: f64, direction: Direction) -> Bound {
        let sign = direction.sign();
        let root = |variance: f64| variance.max(0.0).sqrt();
        let value = root(attained);
        if value.is_nan() {
            return self.unknown(direction);
        }
        let total = if widened.is_nan() { f64::INFINITY } else { (sign * (root(widened) - value)).max(0.0) };
        let sampling = (sign * (root(attained + sign * sampling) - value)).max(0.0).min(total);
        let optimisation = if total.is_finite() { total - sampling } else { total };
        let widened = direction.of((value - total).max(0.0), value + total);
        Bound::without_witness(value, widened, BoundError::of_runs(sampling, optimisation), self.guarantee())
    }

    /// Whether u may have any distribution within an element, or be another one for each sample.
    pub fn is_mixed(&self) -> bool {
        self.setup.problem.reading == Reading::UnknownDistribution || self.setup.structure.is_scattering
    }
}

/// (Y - c)² of every run.
fn squares_about(samples: &[&Sample], centre: f64) -> Vec<Sample> {
    samples.iter().map(|sample| sample.mapped(|y| (y - centre) * (y - centre))).collect()
}

/// Mean and variance at every outer point.
struct Points {
    means: Vec<f64>,
    variances: Vec<f64>,
}

/// The points of each element at which both are known.
type Members = Vec<Vec<usize>>;

impl Points {
    fn new(samples: &[&Sample], confidence: &Confidence) -> Self {
        let estimates = |of: fn(&Sample, &Confidence) -> Estimate| -> Vec<f64> {
            samples.iter().map(|sample| of(sample, confidence).value).collect()
        };
        Self { means: estimates(mean), variances: estimates(variance) }
    }

    /// `None` if an element has none.
    fn members(&self, elements: &[Focal<'_>]) -> Option<Members> {
        let known = |point: &usize| self.means[*point].is_finite() && self.variances[*point].is_finite();
        let of_element = |element: &Focal<'_>| element.members.iter().copied().filter(known).collect();
        let members: Members = elements.iter().map(of_element).collect();
        members.iter().all(|points| !points.is_empty()).then_some(members)
    }

    fn square(&self, point: usize, centre: f64) -> f64 {
        let distance = self.means[point] - centre;
        self.variances[point] + distance * distance
    }

    /// The point of `points` at which h_c goes furthest.
    fn furthest(&self, points: &[usize], centre: f64, direction: Direction) -> usize {
        let better = |a: usize, b: usize| {
            if direction.is_beyond(self.square(b, centre), self.square(a, centre)) { b } else { a }
        };
        points.iter().copied().reduce(better).unwrap_or(0)
    }

    fn range(&self, members: &Members) -> (f64, f64) {
        range_of(members.iter().flatten().map(|&point| self.means[point]))
    }

    /// Σ m_e extreme of h_c.
    fn added(&self, members: &Members, masses: &[f64], centre: f64, direction: Direction) -> f64 {
        let of = |points: &Vec<usize>| self.square(self.furthest(points, centre, direction), centre);
        members.iter().zip(masses).map(|(points, mass)| mass * of(points)).sum()
    }

    /// The c at which Σ m_e max h_c is least: the sum is convex in c.
    fn minimax_centre(&self, members: &Members, masses: &[f64]) -> f64 {
        let (low, high) = self.range(members);
        golden_section_minimum(low, high, |centre| self.added(members, masses, centre, Direction::Maximum))
    }

    /// The variance of one point in each element.
    fn variance(&self, chosen: &[usize], masses: &[f64]) -> f64 {
        let mean: f64 = chosen.iter().zip(masses).map(|(&point, mass)| mass * self.means[point]).sum();
        chosen.iter().zip(masses).map(|(&point, mass)| mass * self.square(point, mean)).sum()
    }

    /// The greatest variance of one point in each element, ascended from the points furthest from `centre`.
    fn greatest(&self, members: &Members, masses: &[f64], centre: f64) -> f64 {
        let mut chosen: Vec<usize> =
            members.iter().map(|points| self.furthest(points, centre, Direction::Maximum)).collect();
        let mut best = self.variance(&chosen, masses);
        for _ in 0..ASCENTS {
            let before = best;
            for element in 0..members.len() {
                for &point in &members[element] {
                    let was = std::mem::replace(&mut chosen[element], point);
                    let variance = self.variance(&chosen, masses);
                    if variance > best {
                        best = variance;
                    } else {
                        chosen[element] = was;
                    }
                }
            }
            if best <= before {
                break;
            }
        }
        best
    }

    /// The least variance of one point in each element.
    fn least(&self, members: &Members, masses: &[f64]) -> f64 {
        let (low, high) = self.range(members);
        let of = |centre: f64| self.added(members, masses, centre, Direction::Minimum);
        let step = (high - low) / SCANNED as f64;
        let scanned = (0..=SCANNED).map(|index| low + step * index as f64);
        let best = scanned.reduce(|a, b| if of(b) < of(a) { b } else { a }).unwrap_or(low);
        let centre = golden_section_minimum(best - step, best + step, of);
        let chosen: Vec<usize> =
            members.iter().map(|points| self.furthest(points, centre, Direction::Minimum)).collect();
        self.variance(&chosen, masses)
    }
}

/// The least of a convex function between two ends.
pub(crate) fn golden_section_minimum(mut low: f64, mut high: f64, of: impl Fn(f64) -> f64) -> f64 {
    for _ in 0..GOLDEN_STEPS {
        let width = GOLDEN * (high - low);
        let (left, right) = (high - width, low + width);
        if of(left) <= of(right) { high = right } else { low = left }
    }
    0.5 * (low + high)
}

/// The greatest variance among means that lie in `boxes`, or more.
///
/// It is convex in each mean, so that it is attained at a corner: each mean at one of its ends. Where there are few boxes, all corners are
/// tried. No quick way is known for many (S. Ferson et al., "Computing variance for interval data is NP-hard", 2002); then it is
/// min over c of Σ m_e max (μ_e - c)², which is not less, since no Σ m_e (μ_e - c)² is less than the variance.
fn greatest_spread(boxes: &[[f64; 2]], masses: &[f64]) -> f64 {
    if boxes.iter().flatten().any(|end| !end.is_finite()) {
        return f64::INFINITY;
    }
    if boxes.len() <= MAX_ENUMERATED {
        let spread = |corner: usize| {
            let means = || boxes.iter().enumerate().map(|(k, ends)| ends[corner >> k & 1]).zip(masses);
            let centre: f64 = means().map(|(mean, mass)| mass * mean).sum();
            means().map(|(mean, mass)| mass * (mean - centre) * (mean - centre)).sum::<f64>()
        };
        return (0..1_usize << boxes.len()).map(spread).fold(0.0, f64::max);
    }
    let furthest = |c: f64| {
        let distance = |[low, high]: &[f64; 2]| (c - low).max(high - c);
        boxes.iter().zip(masses).map(|(own, mass)| mass * distance(own) * distance(own)).sum::<f64>()
    };
    let (low, high) = range_of(boxes.iter().flatten().copied());
    furthest(golden_section_minimum(low, high, furthest))
}

/// The least: every mean is as near to c as its box lets it, c where that is least.
fn least_spread(boxes: &[[f64; 2]], masses: &[f64]) -> f64 {
    let spread = |c: f64| {
        let distance = |[low, high]: &[f64; 2]| (low - c).max(c - high).max(0.0);
        boxes.iter().zip(masses).map(|(own, mass)| mass * distance(own) * distance(own)).sum::<f64>()
    };
    let (low, high) = (range_of(boxes.iter().map(|own| own[0])).0, range_of(boxes.iter().map(|own| own[1])).1);
    if low.is_finite() && high.is_finite() { spread(golden_section_minimum(low, high, spread)) } else { 0.0 }
}

#[cfg(test)]
mod tests {
    use super::{greatest_spread, least_spread};
    use loosepin_uncertainty::uniform;

    /// The greatest variance of means at the ends of `boxes`, all corners one by one: Σ m_i m_j (μ_i - μ_j)² over the pairs.
    fn greatest_of_corners(boxes: &[[f64; 2]], masses: &[f64]) -> f64 {
        let corner = |number: usize| {
            let mean = |k: usize| boxes[k][number >> k & 1];
            let pairs = (0..boxes.len()).flat_map(|i| (0..i).map(move |j| (i, j)));
            pairs.map(|(i, j)| masses[i] * masses[j] * (mean(i) - mean(j)).powi(2)).sum::<f64>()
        };
        (0..1_usize << boxes.len()).map(corner).fold(0.0, f64::max)
    }

    /// Boxes with masses that add to one: random ones, and boxes that hold one another.
    fn families(count: usize, seed: u64) -> [(Vec<[f64; 2]>, Vec<f64>); 2] {
        let number = |axis: usize| uniform(seed, axis as u64);
        let masses: Vec<f64> = (0..count).map(|k| number(k) + 1e-3).collect();
        let sum: f64 = masses.iter().sum();
        let masses: Vec<f64> = masses.iter().map(|mass| mass / sum).collect();
        let random = (0..count).map(|k| {
            let (a, b) = (2.0 * number(count + k) - 1.0, 2.0 * number(2 * count + k) - 1.0);
            [a.min(b), a.max(b)]
        });
        let nested = (0..count).map(|k| {
            let half = 0.1 * (k + 1) as f64;
            let middle = 0.02 * number(3 * count + k);
            [middle - half, middle + half]
        });
        [(random.collect(), masses.clone()), (nested.collect(), masses)]
    }

    #[test]
    fn analytic_spread_of_boxes_that_lie_in_one_another() {
        const TOLERANCE: f64 = 1e-12;
        // Equal boxes [-1, 1]: one mean at each end. In the second pair the means are furthest apart at 0.9 and 0: 0.25 * 0.9².
        let of = |boxes: &[[f64; 2]]| greatest_spread(boxes, &[0.5, 0.5]);
        assert!((of(&[[-1.0, 1.0], [-1.0, 1.0]]) - 1.0).abs() < TOLERANCE);
        assert!((of(&[[0.1, 0.9], [0.0, 1.0]]) - 0.2025).abs() < TOLERANCE);
    }

    #[test]
    fn identity_greatest_spread_is_that_of_the_unkindest_corner() {
        const TOLERANCE: f64 = 1e-12;
        for set in 0..1_000 {
            for (boxes, masses) in families(2 + set as usize % 5, set) {
                let (found, corners) = (greatest_spread(&boxes, &masses), greatest_of_corners(&boxes, &masses));
                assert!((found - corners).abs() < TOLERANCE, "{boxes:?} {masses:?}: {found} against {corners}");
            }
        }
    }

    #[test]
    fn identity_greatest_spread_of_many_boxes_is_not_below_that_of_any_corner() {
        const ROUND_OFF: f64 = 1e-12;
        // A bound from outside: how far above it may be on these sets.
        const ABOVE: f64 = 1e-2;
        for (boxes, masses) in (0..10).flat_map(|set| families(14, set)) {
            let (found, corners) = (greatest_spread(&boxes, &masses), greatest_of_corners(&boxes, &masses));
            assert!(
                found > corners * (1.0 - ROUND_OFF) && found < corners * (1.0 + ABOVE),
                "{found} against {corners}"
            );
        }
    }

    #[test]
    fn analytic_spreads_of_two_and_three_boxes() {
        const TOLERANCE: f64 = 1e-9;
        // Two boxes with masses p and 1 - p: p (1 - p) d², d the distance.
        let (boxes, masses) = ([[-0.5, 0.25], [0.75, 2.0]], [0.3, 0.7]);
        assert!((greatest_spread(&boxes, &masses) - 0.21 * 2.5 * 2.5).abs() < TOLERANCE);
        assert!((least_spread(&boxes, &masses) - 0.21 * 0.5 * 0.5).abs() < TOLERANCE);
        assert!(least_spread(&[[-0.5, 0.25], [0.125, 2.0]], &masses) < TOLERANCE);
        // Against all corners of three boxes.
        let (boxes, masses) = ([[-0.5, 1.25], [0.125, 2.0], [-3.0, 0.5]], [0.2, 0.35, 0.45]);
        let mut most = 0.0_f64;
        for corner in 0..8_usize {
            let means: Vec<f64> = (0..3).map(|k| boxes[k][corner >> k & 1]).collect();
            let centre: f64 = means.iter().zip(masses).map(|(mean, mass)| mean * mass).sum();
            most = most.max(means.iter().zip(masses).map(|(mean, mass)| mass * (mean - centre).powi(2)).sum());
        }
        assert!((greatest_spread(&boxes, &masses) - most).abs() < TOLERANCE);
    }
}
