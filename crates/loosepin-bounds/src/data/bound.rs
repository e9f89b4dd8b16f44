//! Bounds and their parts. The shape of a result never depends on its value.

pub use loosepin_terms::{Guarantee, Treatment};

use super::direction::Direction;
use super::table::Purpose;
use loosepin_terms::Statistic;

/// Numerical error of a bound, in its unit, each part >= 0; infinite if the runs do not determine it.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct BoundError {
    /// Because the sample at the witness is finite, at the stated confidence.
    pub sampling: f64,
    /// Because another u may go further than the witness.
    pub optimisation: f64,
    /// Because runs were replaced by a surrogate; 0 in the direct double loop.
    pub surrogate: f64,
}

impl BoundError {
    /// All parts together.
    pub fn total(&self) -> f64 {
        self.sampling + self.optimisation + self.surrogate
    }

    /// `value` moved outwards by all parts: here a bound is widened. What is not known is widened without end.
    pub(crate) fn widen(&self, value: f64, direction: Direction) -> f64 {
        if value.is_nan() { direction.sign() * f64::INFINITY } else { value + direction.sign() * self.total() }
    }

    /// Errors of sampling and of the search.
    pub(crate) fn of_runs(sampling: f64, optimisation: f64) -> Self {
        Self { sampling, optimisation, surrogate: 0.0 }
    }

    /// Each part changed by `of`.
    pub(crate) fn map(self, of: impl Fn(f64) -> f64) -> Self {
        Self { sampling: of(self.sampling), optimisation: of(self.optimisation), surrogate: of(self.surrogate) }
    }

    /// `total` shared out: what exceeds `optimisation` is an error of sampling; all of it where it is infinite.
    pub(crate) fn with_optimisation(total: f64, optimisation: f64) -> Self {
        Self::of_runs(if total.is_finite() { total - optimisation } else { total }, optimisation)
    }
}

/// The point where a bound is attained.
#[derive(Debug, Clone, PartialEq)]
pub struct Witness {
    /// Purpose of the runs at the witness.
    pub purpose: Purpose,
    /// Outer index of those runs.
    pub point: u32,
    /// Values of the epistemic inputs.
    pub epistemic: Vec<f64>,
    /// Values of the random inputs where the bound is attained by a single run, else empty.
    pub random: Vec<f64>,
}

/// One end of a range.
#[derive(Debug, Clone, PartialEq)]
pub struct Bound {
    /// The estimate at the witness: it has been attained. NaN if no run finished or the values
    /// are too large for their sum.
    pub value: f64,
    /// The value moved outwards by its error: what people are shown as the bound.
    pub widened: f64,
    /// The point where the value is attained; `None` if it is not attained at one u (a mixture) or no run finished.
    pub witness: Option<Witness>,
    /// Largest amount by which the value may be too narrow.
    pub error: BoundError,
    /// Guarantee of the bound.
    pub guarantee: Guarantee,
}

/// Bounds of one requested statistic.
#[derive(Debug, Clone, PartialEq)]
pub struct BoundPair {
    /// Column of the response.
    pub column: usize,
    /// The statistic.
    pub statistic: Statistic,
    /// Its least value over the epistemic box.
    pub lower: Bound,
    /// Its greatest value over the epistemic box.
    pub upper: Bound,
    /// Lower end of the confidence interval at every outer point, in the order of the outer index, failed runs taken as low as possible;
    /// NaN if no run finished. Where several focal elements are added, both sums; for probabilities of a random set both ends, and none
    /// where runs failed.
    pub seen: Vec<f64>,
    /// The statistic where every epistemic input is in its middle, lists at their first members, by the estimate that the bounds are made of:
    /// failed runs taken as low as possible, and as high as possible. `None` if no runs were made there, and where masses of several
    /// focal elements add: then no single value of the inputs has all of the mass.
    pub central: Option<[f64; 2]>,
    /// Failed runs of this column among those of the double loop. They are taken as unknown: they widen probabilities and
    /// quantiles in `value` already.
    pub failed_runs: usize,
    /// Whether failed runs leave the statistic without any bound: a mean or deviation is then one over finished runs.
    pub unbounded_by_failures: bool,
}

impl BoundPair {
    /// Bounds without the values seen at single points.
    pub(crate) fn new(column: usize, statistic: Statistic, [lower, upper]: [Bound; 2], failed_runs: usize) -> Self {
        let unbounded_by_failures = !statistic.is_by_shares() && failed_runs > 0;
        Self { column, statistic, lower, upper, seen: Vec::new(), central: None, failed_runs, unbounded_by_failures }
    }

    /// Weaker guarantee of the two ends: failed runs may have had any response, so that of means and deviations no bound exists then.
    pub fn guarantee(&self) -> Guarantee {
        let of_ends = self.lower.guarantee.weaker(self.upper.guarantee);
        if self.unbounded_by_failures { of_ends.weaker(Guarantee::of_finished_runs()) } else { of_ends }
    }

    /// Both ends as they are shown and stored. Where failed runs leave no bound, the widened ends are without end; values and errors stay those
    /// of the finished runs.
    pub fn ends(&self) -> [Bound; 2] {
        let end = |bound: &Bound, direction: Direction| match self.unbounded_by_failures {
            true => Bound { widened: direction.sign() * f64::INFINITY, ..bound.clone() },
            false => bound.clone(),
        };
        [end(&self.lower, Direction::Minimum), end(&self.upper, Direction::Maximum)]
    }
}

/// Bounds over what is possible to at least some degree.
#[derive(Debug, Clone, PartialEq)]
pub struct CutBounds {
    /// The degree; `None` if no input is a fuzzy number.
    pub alpha: Option<f64>,
    /// One entry for each request but those for a whole distribution function, in their order.
    pub pairs: Vec<BoundPair>,
}

impl Bound {
    /// The bound that says nothing.
    pub(crate) fn unknown(direction: Direction, guarantee: Guarantee) -> Self {
        let error = BoundError { sampling: f64::INFINITY, ..BoundError::default() };
        Self { value: f64::NAN, widened: direction.sign() * f64::INFINITY, witness: None, error, guarantee }
    }

    /// Attained at no single u, widened to `widened`.
    pub(crate) fn without_witness(value: f64, widened: f64, error: BoundError, guarantee: Guarantee) -> Self {
        Self { value, widened, witness: None, error, guarantee }
    }

    /// Moves the widened end outwards to `widened` where it lies further in; the difference is an error of the search.
    pub(crate) fn widen_to(&mut self, widened: f64, direction: Direction) {
        if direction.is_beyond(widened, self.widened) {
            self.error.optimisation += (widened - self.widened).abs();
            self.widened = widened;
        }
    }

    /// Sum of bounds times masses; attained at a u in each element, so at no single one.
    pub(crate) fn sum(parts: impl IntoIterator<Item = (f64, Self)>) -> Option<Self> {
        parts.into_iter().map(|(mass, bound)| bound.times(mass)).reduce(|a, b| Self {
            value: a.value + b.value,
            widened: a.widened + b.widened,
            witness: None,
            error: BoundError {
                sampling: a.error.sampling + b.error.sampling,
                optimisation: a.error.optimisation + b.error.optimisation,
                surrogate: a.error.surrogate + b.error.surrogate,
            },
            guarantee: a.guarantee.weaker(b.guarantee),
        })
    }

    fn times(self, mass: f64) -> Self {
        let error = self.error.map(|error| mass * error);
        Self { value: mass * self.value, widened: mass * self.widened, error, ..self }
    }
}

#[cfg(test)]
mod tests {
    use super::{BoundError, Direction};

    #[test]
    fn analytic_all_parts_of_an_error_widen_a_bound_and_what_is_unknown_has_no_end() {
        let error = BoundError { sampling: 0.25, optimisation: 0.5, surrogate: 0.125 };
        assert_eq!(Direction::BOTH.map(|direction| error.widen(3.0, direction)), [2.125, 3.875]);
        let ends = Direction::BOTH.map(|direction| error.widen(f64::NAN, direction));
        assert_eq!(ends, [f64::NEG_INFINITY, f64::INFINITY]);
    }
}
