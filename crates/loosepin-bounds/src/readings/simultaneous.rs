//! Bands that whole curves stay in, not only each of their points by itself.
//!
//! A curve is a list of columns Y_k; around centres m_k with half-widths a_k, its largest excess is a number of each run,
//!
//! ```text
//! M = max over k of |Y_k - m_k|/a_k,    q = max over u of the quantile of M at the stated share
//! ```
//!
//! and for every u at least that share of the runs stays within m_k ± q a_k at all k together. M is a response like any other: its
//! quantile has bounds over u by the same runs, with the same errors and the same readings of intervals. How m_k and a_k were found does
//! not matter for that; bands whose half-widths go with the pointwise ones are the narrowest at every k alike.

use super::added_quantile::QuantileJob;
use super::experiment::Experiment;
use super::interval::Modelled;
use super::random_set::RandomSet;
use crate::data::bound::{Bound, Guarantee};
use crate::data::direction::Direction;
use crate::data::problem::Reading;
use crate::data::table::SampleTable;
use crate::measures::measure::Estimator;
use crate::measures::quantile::Quantile;

/// A half-width below this share of the largest is made as wide, so that round-off where a curve does not scatter is no excess.
const MIN_HALF_WIDTH: f64 = 1e-3;

/// A band for a whole curve, with its parts.
#[derive(Debug, Clone, PartialEq)]
pub struct SimultaneousBand {
    /// Share of the runs that stay inside for every u, in (0, 1).
    pub share: f64,
    /// m_k.
    pub centres: Vec<f64>,
    /// a_k > 0.
    pub half_widths: Vec<f64>,
    /// q, its errors and where it is attained.
    pub factor: Bound,
    /// Runs in which a point of the curve is missing; they are taken as outside.
    pub failed_runs: usize,
}

impl SimultaneousBand {
    /// The band in which at least `share` of the runs stay at all columns of the curve together; its form is that of `shape`.
    pub(crate) fn new(experiment: &Experiment<'_>, shape: BandShape, share: f64) -> Self {
        let factor = experiment.greatest_quantile(share);
        let BandShape { centres, half_widths } = shape;
        Self { share, centres, half_widths, factor, failed_runs: experiment.failed_runs(0) }
    }

    /// Both ends of the band at column `place` of the curve. Where at every u a share larger than stated stays inside the shape itself,
    /// the band is the shape: it is never narrower than what each point needs by itself.
    pub fn ends(&self, place: usize) -> [Bound; 2] {
        let (centre, half_width) = (self.centres[place], self.half_widths[place]);
        let (value, widened) = (self.factor.value.max(1.0), self.factor.widened.max(1.0));
        let total = self.factor.error.total();
        // What the shape makes up for is no error.
        let kept = if total > 0.0 && total.is_finite() { ((widened - value) / total).clamp(0.0, 1.0) } else { 1.0 };
        let scaled = |error: f64| if error > 0.0 { kept * half_width * error } else { 0.0 };
        let error = self.factor.error.map(scaled);
        Direction::BOTH.map(|direction| Bound {
            value: centre + direction.sign() * half_width * value,
            widened: centre + direction.sign() * half_width * widened,
            error,
            ..self.factor.clone()
        })
    }

    /// Centres and half-widths.
    pub(crate) fn shape(&self) -> BandShape {
        BandShape { centres: self.centres.clone(), half_widths: self.half_widths.clone() }
    }

    /// Guarantee of the band.
    pub fn guarantee(&self) -> Guarantee {
        self.factor.guarantee
    }
}

/// Centres and half-widths of a band, column by column.
pub(crate) struct BandShape {
    centres: Vec<f64>,
    half_widths: Vec<f64>,
}

impl BandShape {
    /// The shape with these lower and upper ends; `None` if they are not finite or nowhere apart.
    pub fn new(ends: &[[f64; 2]]) -> Option<Self> {
        let centres: Vec<f64> = ends.iter().map(|[lower, upper]| 0.5 * (lower + upper)).collect();
        let widest = ends.iter().fold(0.0, |widest: f64, [lower, upper]| widest.max(0.5 * (upper - lower)));
        let is_finite = centres.iter().all(|centre| centre.is_finite()) && widest.is_finite();
        if !is_finite || widest <= 0.0 {
            return None;
        }
        let half_width = |[lower, upper]: &[f64; 2]| (0.5 * (upper - lower)).max(MIN_HALF_WIDTH * widest);
        Some(Self { half_widths: ends.iter().map(half_width).collect(), centres })
    }

    /// M of a run with these `values` of all columns.
    pub fn excess(&self, values: &[f64], columns: &[usize]) -> f64 {
        let each = columns.iter().zip(self.centres.iter().zip(&self.half_widths));
        let each = each.map(|(&column, (centre, half_width))| (values[column] - centre).abs() / half_width);
        // A point that is missing leaves the excess unknown.
        each.fold(0.0, |most: f64, own| if own.is_nan() || most.is_nan() { f64::NAN } else { most.max(own) })
    }

    /// M of every run in `table`, as a table of one column; `columns` are those of the curve.
    pub fn excesses(&self, table: &SampleTable, columns: &[usize]) -> SampleTable {
        table.with_one_column(|values| self.excess(values, columns))
    }
}

impl Experiment<'_> {
    /// The greatest quantile of the only column over all that is possible.
    fn greatest_quantile(&self, probability: f64) -> Bound {
        const DIRECTION: Direction = Direction::Maximum;
        let elements = self.focal_elements(self.setup.structure.widest());
        if self.setup.problem.reading == Reading::RandomSet {
            return RandomSet::new(self, &elements, 0).quantile(self, probability, DIRECTION);
        }
        let [whole] = &elements[..] else {
            let jobs = [QuantileJob { column: 0, probability, direction: DIRECTION }];
            return self.quantiles(&jobs, &elements).swap_remove(0);
        };
        let samples = self.pool.samples(0);
        let measure = Quantile(probability).measure(&samples, &self.setup.confidence);
        let search = self.search([&measure].into_iter());
        self.bound(&Modelled::new(&search, &measure, &samples), DIRECTION, whole)
    }
}
