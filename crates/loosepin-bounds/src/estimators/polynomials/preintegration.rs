//! The distribution function of a polynomial of the random inputs: exactly along the axis in which it is steepest, by a rule over the
//! others.
//!
//! ```text
//! F(y) = E P(p(T) <= y | all T but one),   the inner probability by the roots of p(·) = y along that axis
//! ```
//!
//! is a mean of something smooth where the polynomial is monotone along the axis (A. Griewank, F. Y. Kuo, H. Leövey and I. H. Sloan,
//! "High dimensional integration of kinks and jumps: smoothing by preintegration", Journal of Computational and Applied Mathematics
//! 344 (2018) 259-274). Two rules of different order tell the error of the rule.

use super::basis::Basis;
use super::orthogonal::{Axis, Univariate};
use loosepin_math::Bracket;
use loosepin_uncertainty::{ScrambledSobol, hash};

/// Nodes of the two Gauss rules along one axis where one or two other axes are integrated over.
const GAUSS_NODES: [[usize; 2]; 3] = [[1, 1], [32, 24], [20, 16]];
/// Over more axes: scrambled replicates, and points in each.
const REPLICATES: u32 = 8;
const POINTS: u32 = 64;
/// Half the width of an interval of the mean of eight replicates, in their standard error: Student's factor at 99 %.
const REPLICATE_FACTOR: f64 = 3.5;
/// Steps in which the extremes of a polynomial along the axis are sought.
const SCAN_STEPS: usize = 40;
/// Halvings and Newton steps of a root, at most.
const ROOT_STEPS: usize = 60;
/// A root is found where Newton's step is smaller, or the values on either side of it are nearer.
const LAST_NEWTON_STEP: f64 = 1e-8;
const MIN_BRACKET: f64 = 1e-13;
/// Separates the stream of random numbers.
const REST: u64 = 0x7265_7374;

/// Nodes over all axes but one.
#[derive(Debug)]
pub(crate) struct Rest {
    axis: usize,
    /// Product of the polynomials of the other axes, node by node, term by term.
    products: Vec<f64>,
    /// Slopes of the polynomials along the axis where extremes are sought, place by place, degree by degree.
    slopes: Vec<f64>,
    /// Groups of nodes with their weights; each group is a rule of its own.
    groups: Vec<Vec<f64>>,
    /// Whether the first group is better than the second, or all are equally good.
    is_gauss: bool,
}

impl Rest {
    /// Nodes for the terms of `basis` over all axes but `axis`.
    pub fn new(basis: &Basis, axis: usize) -> Self {
        let others: Vec<usize> = (0..basis.axes.len()).filter(|&other| other != axis).collect();
        let mut nodes: Vec<Vec<f64>> = Vec::new();
        let mut groups = Vec::new();
        let is_gauss = others.len() < GAUSS_NODES.len();
        if is_gauss {
            for order in GAUSS_NODES[others.len()] {
                let mut grid: Vec<(Vec<f64>, f64)> = vec![(Vec::new(), 1.0)];
                for &other in &others {
                    let rule = basis.axes[other].gauss_rule(order);
                    let extend = |(at, weight): &(Vec<f64>, f64)| {
                        let (at, weight) = (at.clone(), *weight);
                        let next = rule.iter().map(move |(t, w)| ([&at[..], &[*t]].concat(), weight * w));
                        next.collect::<Vec<_>>()
                    };
                    grid = grid.iter().flat_map(extend).collect();
                }
                groups.push(grid.iter().map(|(_, weight)| *weight).collect());
                nodes.extend(grid.into_iter().map(|(at, _)| at));
            }
        } else if let Ok(sobol) = ScrambledSobol::try_new(hash(REST, axis as u64), others.len()) {
            for replicate in 0..REPLICATES {
                for index in 0..POINTS {
                    let mut point = vec![0.0; others.len()];
                    sobol.write_point(replicate, index, &mut point);
                    let coordinate = |(&omega, &other): (&f64, &usize)| basis.axes[other].coordinate(omega);
                    nodes.push(point.iter().zip(&others).map(coordinate).collect());
                }
                groups.push(vec![1.0 / f64::from(POINTS); POINTS as usize]);
            }
        }
        let mut products = Vec::with_capacity(nodes.len() * basis.terms.len());
        for node in &nodes {
            let values: Vec<Vec<f64>> =
                node.iter().zip(&others).map(|(&t, &other)| basis.axes[other].values(t, basis.degree)).collect();
            let product = |term: &Vec<usize>| others.iter().zip(&values).map(|(&o, v)| v[term[o]]).product::<f64>();
            products.extend(basis.terms.iter().map(product));
        }
        let slopes =
            (0..=SCAN_STEPS).flat_map(|step| basis.axes[axis].slopes(scanned(basis.axes[axis], step), basis.degree));
        Self { axis, products, slopes: slopes.collect(), groups, is_gauss }
    }
}

/// Scanning points for extremes along `axis`.
fn scanned(axis: Axis, step: usize) -> f64 {
    let (low, high) = axis.ends();
    low + (high - low) * step as f64 / SCAN_STEPS as f64
}

/// F, its density, and the error of F.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct AtValue {
    pub cdf: f64,
    pub density: f64,
    pub error: f64,
}

/// The polynomial along the axis at every node.
#[derive(Debug)]
pub(crate) struct Conditional {
    axis: Axis,
    lines: Vec<Line>,
    groups: Vec<Vec<f64>>,
    is_gauss: bool,
}

/// The polynomial along the axis at one node.
#[derive(Debug)]
struct Line {
    value: Univariate,
    /// The terms of the two highest degrees: the size of the truncation.
    last_terms: Univariate,
    /// Ends of the axis and extremes: between them it is monotone.
    turns: Vec<Turn>,
}

/// An end or an extreme of a line.
#[derive(Debug, Clone, Copy)]
struct Turn {
    at: f64,
    value: f64,
    /// The distribution function of the input.
    cdf: f64,
}

impl Conditional {
    /// The polynomial with `coefficients` along the axis of `rest`.
    pub fn new(basis: &Basis, rest: &Rest, coefficients: &[f64]) -> Self {
        let axis = basis.axes[rest.axis];
        let size = basis.terms.len();
        let lines = rest.products.chunks(size).map(|products| {
            let mut value = Univariate { axis, coefficients: vec![0.0; basis.degree + 1] };
            let mut last_terms = value.clone();
            for ((term, product), coefficient) in basis.terms.iter().zip(products).zip(coefficients) {
                let part = product * coefficient;
                value.coefficients[term[rest.axis]] += part;
                let order = term.iter().sum::<usize>();
                // Linear terms are never what is left out: their remainder is seen at the runs.
                if order > 1 && order + 2 > basis.degree {
                    last_terms.coefficients[term[rest.axis]] += part;
                }
            }
            let turns = turns(&value, &rest.slopes);
            Line { value, last_terms, turns }
        });
        Self { axis, lines: lines.collect(), groups: rest.groups.clone(), is_gauss: rest.is_gauss }
    }

    /// Roots from which [`Self::near`] begins, none known yet.
    pub fn no_roots(&self) -> Vec<f64> {
        vec![f64::NAN; self.lines.len()]
    }

    /// F at `y`, where the response differs from the polynomial by its last terms and by `residual`.
    pub fn at(&self, y: f64, residual: f64) -> AtValue {
        self.near(y, residual, &mut self.no_roots())
    }

    /// [`Self::at`]; `roots` are those of a value near `y`, and become those of `y`.
    pub fn near(&self, y: f64, residual: f64, roots: &mut [f64]) -> AtValue {
        debug_assert_eq!(roots.len(), self.lines.len(), "a root for each line");
        let mut lines = self.lines.iter().zip(roots);
        let of_group = |weights: &Vec<f64>| {
            let mut sum = AtValue::default();
            for (&weight, (line, root)) in weights.iter().zip(lines.by_ref()) {
                let at = line.at(self.axis, y, residual, root);
                sum.cdf += weight * at.cdf;
                sum.density += weight * at.density;
                sum.error += weight * at.error;
            }
            sum
        };
        let groups: Vec<AtValue> = self.groups.iter().map(of_group).collect();
        let outside = self.axis.outside();
        if self.is_gauss {
            let between = (groups[0].cdf - groups[1].cdf).abs();
            return AtValue { error: groups[0].error + between + outside, ..groups[0] };
        }
        let count = groups.len() as f64;
        let mean = |of: fn(&AtValue) -> f64| groups.iter().map(of).sum::<f64>() / count;
        let cdf = mean(|at| at.cdf);
        let square: f64 = groups.iter().map(|at| (at.cdf - cdf) * (at.cdf - cdf)).sum();
        let spread = REPLICATE_FACTOR * (square / (count * (count - 1.0))).sqrt();
        AtValue { cdf, density: mean(|at| at.density), error: mean(|at| at.error) + spread + outside }
    }
}

impl Line {
    /// F along the line; `near` is a root for a value near `y`, or NaN, and becomes the last root found.
    fn at(&self, axis: Axis, y: f64, residual: f64, near: &mut f64) -> AtValue {
        let (first, last) = (self.turns[0], self.turns[self.turns.len() - 1]);
        let mut at = AtValue { cdf: if first.value <= y { first.cdf } else { 0.0 }, ..AtValue::default() };
        for piece in self.turns.windows(2) {
            let (low, high) = (piece[0], piece[1]);
            let (starts_below, ends_below) = (low.value <= y, high.value <= y);
            if starts_below && ends_below {
                at.cdf += high.cdf - low.cdf;
            }
            if starts_below == ends_below {
                continue;
            }
            let (root, slope) = self.root(y, low, high, *near);
            *near = root;
            at.cdf += if starts_below { axis.cdf(root) - low.cdf } else { high.cdf - axis.cdf(root) };
            let density = axis.density(root) / slope.abs().max(f64::MIN_POSITIVE);
            at.density += density;
            at.error += (density * (residual + 2.0 * self.last_terms.at(root).0.abs())).min(1.0);
        }
        if last.value <= y {
            at.cdf += 1.0 - last.cdf;
        }
        at
    }

    /// The root of the polynomial less `y` between two places on either side of it, and the slope there; sought from `near` if that lies
    /// between them.
    fn root(&self, y: f64, first: Turn, second: Turn, near: f64) -> (f64, f64) {
        let rises = second.value > first.value;
        let (mut low, mut high) = (first.at, second.at);
        let mut t = if near > low && near < high {
            near
        } else {
            low + (high - low) * ((y - first.value) / (second.value - first.value)).clamp(0.0, 1.0)
        };
        let mut slope = 0.0;
        for _ in 0..ROOT_STEPS {
            let (value, slope_here) = self.value.at(t);
            slope = slope_here;
            if (value <= y) == rises {
                low = t
            } else {
                high = t
            }
            let newton = t - (value - y) / slope;
            if (newton - t).abs() < LAST_NEWTON_STEP {
                // Newton's method leaves an error of the order of the square of its last step.
                t = newton.clamp(first.at, second.at);
                break;
            }
            t = if newton > low && newton < high { newton } else { 0.5 * (low + high) };
            if high - low < MIN_BRACKET {
                break;
            }
        }
        (t, slope)
    }
}

/// Ends of the axis and extremes of the polynomial between them; `slopes`: those of [`Rest`].
fn turns(of: &Univariate, slopes: &[f64]) -> Vec<Turn> {
    let turn = |at: f64| Turn { at, value: of.at(at).0, cdf: of.axis.cdf(at) };
    let (low, high) = of.axis.ends();
    let mut turns = vec![turn(low)];
    let mut before = f64::NAN;
    for (step, slopes) in slopes.chunks(of.coefficients.len()).enumerate() {
        let slope: f64 = slopes.iter().zip(&of.coefficients).map(|(slope, coefficient)| slope * coefficient).sum();
        if step > 0 && (slope > 0.0) != (before > 0.0) {
            let places = [step - 1, step].map(|step| scanned(of.axis, step));
            turns.push(turn(extreme(of, places, [before, slope])));
        }
        before = slope;
    }
    turns.push(turn(high));
    turns
}

/// The point where the slope vanishes between two places with the slopes `slopes`. The value is flat there, so that it is known far better
/// than the place.
fn extreme(of: &Univariate, places: [f64; 2], slopes: [f64; 2]) -> f64 {
    let (mut found, mut bracket) = (places[0], Bracket::new(places, slopes));
    // Where the slope at an end is next to nothing the first steps are short, and say nothing of how near the extreme is.
    let mut has_moved = [false; 2];
    for _ in 0..ROOT_STEPS {
        let next = bracket.next();
        let slope = of.at(next).1;
        has_moved[usize::from(bracket.take(next, slope))] = true;
        if slope == 0.0 || (has_moved == [true; 2] && (next - found).abs() < LAST_NEWTON_STEP) {
            return next;
        }
        found = next;
    }
    found
}

#[cfg(test)]
mod tests {
    use super::extreme;
    use crate::estimators::polynomials::orthogonal::{Axis, Univariate};

    #[test]
    fn analytic_an_extreme_beside_a_slope_of_round_off_is_found() {
        // p = p_4 - c p_2 with the slope 4 t (t² - r²)/√24 of its extremes at 0 and r, and a slope of -1e-17 at 0.
        let place: f64 = 0.17;
        let [fourth, second] = [24.0_f64.sqrt(), 2.0_f64.sqrt()];
        let coefficients = vec![0.0, -1e-17, (6.0 - 2.0 * place * place) * second / fourth, 0.0, 1.0];
        let line = Univariate { axis: Axis::Hermite, coefficients };
        let slopes = [line.at(0.0).1, line.at(0.25).1];
        assert!(slopes[0] < 0.0 && slopes[0] > -1e-15 && slopes[1] > 0.0, "{slopes:?}");
        let found = extreme(&line, [0.0, 0.25], slopes);
        assert!((found - place).abs() < 1e-7, "{found}");
    }
}
