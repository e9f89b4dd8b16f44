//! A response whose bounds are known.

use loosepin::bounds::{Failure, Problem, Reading, Request, Response, Sampling, Statistic};
use loosepin::uncertainty::{Distribution, EpistemicParameter, EpistemicVariable, Interval, RandomVariable};
use std::sync::Arc;

/// A response Y = g(X, u) with one column.
pub type Function = Arc<dyn Fn(&[f64], &[f64]) -> f64 + Send + Sync>;

/// A response and the true bounds of some of its statistics.
pub struct KnownCase {
    /// Name in tables.
    pub name: String,
    /// Distributions of X.
    pub random: Vec<Distribution>,
    /// The unknown inputs u.
    pub epistemic: Vec<EpistemicVariable>,
    /// Which of u are parameters of distributions of X.
    pub parameters: Vec<EpistemicParameter>,
    /// Statistics, and their least and greatest value over u.
    pub statistics: Vec<(Statistic, (f64, f64))>,
    /// If u holds fuzzy numbers, the bounds at each degree, the least degree first; else empty.
    pub levels: Vec<Vec<(f64, f64)>>,
    /// g.
    pub function: Function,
    /// Points u, and runs at each.
    pub sampling: [usize; 2],
    /// Columns for which treatments are compared: runs at random u are made for them too.
    pub compared_columns: Vec<usize>,
    /// By this share of their true width bounds may be too wide.
    pub max_excess: f64,
}

/// Share of the true width by which bounds of smooth responses may be too wide: the median of a thousand seeds is below 0.006
/// (`measured/known-bounds.md`).
pub(crate) const DEFAULT_MAX_EXCESS: f64 = 0.03;

/// An interval of a known case.
pub(crate) fn interval((lower, upper): (f64, f64)) -> Interval {
    Interval::try_new(lower, upper).unwrap_or_else(|error| panic!("[{lower}, {upper}]: {error}"))
}

impl KnownCase {
    /// A response of one standard normal number and of inputs in these intervals.
    pub(crate) fn new(
        name: &str,
        intervals: &[(f64, f64)],
        statistics: Vec<(Statistic, (f64, f64))>,
        function: impl Fn(&[f64], &[f64]) -> f64 + Send + Sync + 'static,
    ) -> Self {
        Self {
            name: name.to_owned(),
            random: vec![Distribution::Normal { mean: 0.0, standard_deviation: 1.0 }],
            epistemic: intervals.iter().map(|&ends| interval(ends).into()).collect(),
            parameters: Vec::new(),
            statistics,
            levels: Vec::new(),
            function: Arc::new(function),
            sampling: [64, 256],
            compared_columns: Vec::new(),
            max_excess: DEFAULT_MAX_EXCESS,
        }
    }

    /// The question, for a seed.
    ///
    /// # Panics
    /// If the case itself is wrong.
    pub fn problem(&self, seed: u64) -> Problem {
        let random = self.random.iter().cloned().map(|distribution| match RandomVariable::try_new(distribution) {
            Ok(variable) => variable,
            Err(error) => panic!("{}: {error}", self.name),
        });
        let request = |&(statistic, _): &(Statistic, (f64, f64))| Request { column: 0, statistic };
        Problem {
            random: random.collect(),
            copula: None,
            epistemic: self.epistemic.clone(),
            parameters: self.parameters.clone(),
            reading: Reading::FixedButUnknown,
            readings_beside: Vec::new(),
            columns: 1,
            requests: self.statistics.iter().map(request).collect(),
            compared_columns: self.compared_columns.clone(),
            band_probability: 0.95,
            cut_standard_deviations: 3.0,
            percentiles: Vec::new(),
            sampling: Sampling { outer: self.sampling[0], inner: self.sampling[1], seed, ..Sampling::default() },
        }
    }

    /// The same for programs that know of no angles: those that go round are intervals.
    #[must_use]
    pub fn without_periodic_inputs(self) -> Self {
        let open = |variable: EpistemicVariable| match variable {
            EpistemicVariable::Periodic(turn) => EpistemicVariable::Interval(turn),
            other => other,
        };
        let epistemic = self.epistemic.into_iter().map(open).collect();
        Self { name: format!("{}, cut open", self.name), epistemic, ..self }
    }
}

impl Response for KnownCase {
    fn evaluate(&self, random: &[f64], epistemic: &[f64], columns: &mut [f64]) -> Result<(), Failure> {
        columns[0] = (self.function)(random, epistemic);
        Ok(())
    }
}
