//! The question: inputs, requests, and how many runs may be spent.

pub use loosepin_terms::Reading;

use loosepin_terms::Statistic;
use loosepin_uncertainty::{Copula, EpistemicParameter, EpistemicVariable, RandomVariable};

/// One statistic of one column of the response.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Request {
    /// Column of the response, counted from 0.
    pub column: usize,
    /// The statistic whose bounds are asked for.
    pub statistic: Statistic,
}

/// How many runs are spent, and on what.
///
/// The runs are at most `outer * inner + mixture + extreme`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sampling {
    /// Points u at which statistics are estimated. Default: 64.
    pub outer: usize,
    /// Runs for each u; a multiple of `replicates`, best `replicates` times a power of two. Default: 256.
    pub inner: usize,
    /// Independent scramblings that the inner points are split into, >= 2, for the sampling error. Default: 8.
    pub replicates: usize,
    /// Runs of the probability-only treatment (X and u drawn together); a multiple of `replicates`. Default: 1024.
    pub mixture: usize,
    /// Runs of the interval-only treatment (extremes over the joint box). Default: 128.
    pub extreme: usize,
    /// Seed of every random number. Default: 1.
    pub seed: u64,
    /// Confidence of each sampling error, in (0, 1). Default: 0.99.
    pub confidence: f64,
}

/// The inputs of a response, and the statistics to bound.
#[derive(Debug, Clone)]
pub struct Problem {
    /// Distributions of the random inputs one by one.
    pub random: Vec<RandomVariable>,
    /// How they depend on each other; `None` if they are independent. The interval-only treatment knows no correlation: its
    /// box holds every combination of the cut inputs.
    pub copula: Option<Copula>,
    /// Knowledge of the epistemic inputs.
    pub epistemic: Vec<EpistemicVariable>,
    /// Parameters of distributions that are epistemic inputs. The response is given their values and need not look at them.
    pub parameters: Vec<EpistemicParameter>,
    /// How an epistemic interval is read.
    pub reading: Reading,
    /// Other readings that the same runs are to answer ([`crate::DoubleLoop::read_as`]).
    pub readings_beside: Vec<Reading>,
    /// Number of columns of the response.
    pub columns: usize,
    /// Statistics whose bounds are asked for.
    pub requests: Vec<Request>,
    /// Columns for which the three treatments are compared.
    pub compared_columns: Vec<usize>,
    /// Probability of the central band that the treatments are compared by, in (0, 1); 0.95 is usual.
    pub band_probability: f64,
    /// In the interval-only treatment each random input is cut to its quantiles at Φ(-k) and Φ(k), k = this; 3 is usual.
    pub cut_standard_deviations: f64,
    /// Percentiles of statistics that are wanted where a parameter of a distribution has a distribution itself, each in (0, 1);
    /// 0.05, 0.5 and 0.95 are usual.
    pub percentiles: Vec<f64>,
    /// How many runs are spent.
    pub sampling: Sampling,
}

impl Problem {
    /// The `requests` of a response with these inputs, all of them independent, with the usual numbers for all else: intervals are fixed but
    /// unknown, nothing is compared, a central band holds 95 %, random inputs are cut at three standard deviations.
    pub fn new(random: Vec<RandomVariable>, epistemic: Vec<EpistemicVariable>, requests: Vec<Request>) -> Self {
        Self {
            random,
            copula: None,
            epistemic,
            parameters: Vec::new(),
            reading: Reading::FixedButUnknown,
            readings_beside: Vec::new(),
            columns: requests.iter().map(|request| request.column + 1).max().unwrap_or(1),
            requests,
            compared_columns: Vec::new(),
            band_probability: 0.95,
            cut_standard_deviations: 3.0,
            percentiles: vec![0.05, 0.5, 0.95],
            sampling: Sampling::default(),
        }
    }
}
