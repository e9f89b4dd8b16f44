//! Bounds and what stands behind them. The shape of a result never depends on its value.

pub use loosepin_terms::{Guarantee, Reading, Treatment};

use super::probability_box::ProbabilityBox;
use super::search::Direction;
use super::second_order::StatisticPercentiles;
use super::statistic::Statistic;
use super::table::Purpose;
use super::treatment::TreatmentComparison;

/// Numerical error of a bound, in its own unit, each part >= 0; infinite where the runs do not tell.
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
}

/// Where a bound is attained.
#[derive(Debug, Clone, PartialEq)]
pub struct Witness {
    /// What the runs at the witness were for.
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
    /// The estimate at the witness: it has been attained. Not a number where no run finished or the values
    /// are too large for their sum.
    pub value: f64,
    /// The value moved outwards by its error: what people are shown as the bound.
    pub widened: f64,
    /// Where the value is attained; nothing where it is not attained at one u (a mixture) or nothing finished.
    pub witness: Option<Witness>,
    /// By how much the value may be too narrow.
    pub error: BoundError,
    /// What the bound promises.
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
    /// The estimate at every outer point, in the order of the outer index, failed runs taken as low as possible; not a
    /// number where no run finished. Where several focal elements are added, both sums; for a random set both ends, and none
    /// where runs failed.
    pub estimates: Vec<f64>,
    /// Failed runs of this column among those of the double loop. They are taken as unknown: they widen probabilities and
    /// quantiles in `value` already.
    pub failed_runs: usize,
    /// Whether failed runs leave the statistic without any bound: a mean or deviation is then one over finished runs.
    pub unbounded_by_failures: bool,
}

impl BoundPair {
    /// What stands behind both ends: failed runs may have had any response, so that of means and deviations no bound exists then.
    pub fn guarantee(&self) -> Guarantee {
        if self.unbounded_by_failures { Guarantee::Inner } else { self.lower.guarantee.weaker(self.upper.guarantee) }
    }
}

/// Bounds over what is possible to at least some degree.
#[derive(Debug, Clone, PartialEq)]
pub struct LevelBounds {
    /// The degree; nothing where no input is a fuzzy number.
    pub alpha: Option<f64>,
    /// One entry for each request but those for a whole distribution function, in their order.
    pub pairs: Vec<BoundPair>,
}

impl Bound {
    /// Moves the widened end outwards to `widened` where it lies further in; the difference is an error of the search.
    pub(super) fn widen_to(&mut self, widened: f64, direction: Direction) {
        if direction.is_beyond(widened, self.widened) {
            self.error.optimisation += (widened - self.widened).abs();
            self.widened = widened;
        }
    }
}

/// Everything that the runs of a problem say.
#[derive(Debug, Clone, PartialEq)]
pub struct Bounds {
    /// How the epistemic intervals are read.
    pub reading: Reading,
    /// One entry for each request but those for a whole distribution function, in their order.
    pub pairs: Vec<BoundPair>,
    /// Where an input is a fuzzy number: the same for every degree, increasing; else nothing.
    pub levels: Vec<LevelBounds>,
    /// Where a parameter of a distribution has a distribution itself: one entry for each of `pairs`; else nothing.
    pub percentiles: Vec<StatisticPercentiles>,
    /// One entry for each request for a whole distribution function, in their order.
    pub boxes: Vec<ProbabilityBox>,
    /// One entry for each compared column, in their order.
    pub comparisons: Vec<TreatmentComparison>,
    /// Values of the epistemic inputs at every outer point, in the order of the outer index.
    pub outer_points: Vec<Vec<f64>>,
    /// Outer index of the centre of the epistemic box, discrete inputs at their first members.
    pub centre_point: u32,
    /// Runs in the table.
    pub runs: usize,
    /// Failed runs in the table.
    pub failed_runs: usize,
    /// Rounds that the runs were made in.
    pub rounds: u32,
}
