//! A checked problem with what its plan and its answers share.

use std::collections::BTreeSet;
use std::sync::{Arc, OnceLock};

use crate::data::direction::Direction;
use crate::data::points::{inner_points, mixture_points};
use crate::data::problem::{Problem, Reading, Request};
use crate::estimators::estimate::{Confidence, Estimate};
use crate::estimators::moments::mean;
use crate::estimators::polynomials::inner_basis::InnerBasis;
use crate::estimators::polynomials::orthogonal::Axis;
use crate::estimators::pool::{Pool, PoolPoint};
use crate::estimators::tail::index_of_distribution;
use crate::measures::targets::target;
use crate::search::design::candidates;
use crate::search::parts::Structure;
use crate::search::search_box::{BoxPoint, SearchBox};
use crate::search::target::Target;
use loosepin_terms::Statistic;
use loosepin_uncertainty::{Copula, Distribution, EpistemicVariable, RandomVariable, ScrambledSobol, SobolError, hash};

/// Probabilities of the quantiles by which a whole distribution function is searched.
const CDF_SEARCH_PROBABILITIES: [f64; 3] = [0.05, 0.5, 0.95];

/// Index of the heaviest tail of the random inputs, parameters of their distributions in the middle.
fn tail_of_inputs(problem: &Problem) -> f64 {
    let middle: Vec<f64> = problem.epistemic.iter().map(EpistemicVariable::middle).collect();
    let index = |input: usize| {
        let Some(variable) = problem.variable_at(input, &middle) else { return 0.0 };
        let upper = index_of_distribution(|above| variable.quantile(1.0 - above), problem.sampling.inner);
        let lower = index_of_distribution(|below| -variable.quantile(below), problem.sampling.inner);
        upper.max(lower)
    };
    (0..problem.random.len()).map(index).fold(0.0, f64::max)
}

/// Streams of random numbers.
const INNER: u64 = 0x0069_6e6e_6572;
const MIXTURE: u64 = 0x006d_6978_7475;

/// Boxes, their parts, candidates for new points, and polynomials of the random inputs.
#[derive(Debug, Clone)]
pub(crate) struct Setup {
    pub problem: Problem,
    pub confidence: Confidence,
    /// Points of the inner runs.
    pub inner: ScrambledSobol,
    /// Points of the probability-only treatment.
    pub mixture: ScrambledSobol,
    pub epistemic_box: SearchBox,
    /// Box of the interval-only treatment: random inputs cut, then epistemic inputs.
    pub joint_box: SearchBox,
    /// The parts of the epistemic box.
    pub structure: Structure,
    pub candidates: Vec<Vec<f64>>,
    pub joint_candidates: Vec<Vec<f64>>,
    /// Computed on first use; `None` if the runs are too few.
    inner_basis: OnceLock<Option<Arc<InnerBasis>>>,
    mixture_basis: OnceLock<Option<Arc<InnerBasis>>>,
}

impl Setup {
    /// The setup of a checked `problem`, whose inputs lie in `joint` in the interval-only treatment.
    pub fn try_new(problem: Problem, joint: Vec<EpistemicVariable>) -> Result<Self, SobolError> {
        let sampling = problem.sampling;
        let (epistemic_box, joint_box) = (SearchBox::new(problem.epistemic.clone()), SearchBox::new(joint));
        let structure = Structure::new(&epistemic_box);
        let dimensions = epistemic_box.dimensions();
        let mut epistemic_candidates = candidates(dimensions)?;
        if structure.is_divided() {
            epistemic_candidates.extend(structure.candidates(dimensions)?);
        }
        Ok(Self {
            confidence: Confidence::new(sampling.confidence, sampling.replicates)
                .with_tail_of_inputs(tail_of_inputs(&problem)),
            inner: ScrambledSobol::try_new(hash(sampling.seed, INNER), problem.random.len())?,
            mixture: ScrambledSobol::try_new(hash(sampling.seed, MIXTURE), joint_box.inputs().len())?,
            candidates: epistemic_candidates,
            joint_candidates: candidates(joint_box.dimensions())?,
            inner_basis: OnceLock::new(),
            mixture_basis: OnceLock::new(),
            structure,
            epistemic_box,
            joint_box,
            problem,
        })
    }

    /// Inner runs at each outer point.
    pub fn inner_runs(&self) -> usize {
        if self.problem.random.is_empty() { 1 } else { self.problem.sampling.inner }
    }

    /// Whether the epistemic box has no dimension, so that there is nothing to search.
    pub fn has_no_epistemic_inputs(&self) -> bool {
        self.epistemic_box.dimensions() == 0
    }

    /// Whether the probability-only treatment needs runs of its own: without epistemic inputs it is the double loop.
    pub fn has_mixture(&self) -> bool {
        !self.problem.compared_columns.is_empty() && !self.epistemic_box.is_a_point()
    }

    /// Whether the interval-only treatment needs runs of its own: without random inputs it is the double loop.
    pub fn has_extremes(&self) -> bool {
        !self.problem.compared_columns.is_empty() && !self.problem.random.is_empty()
    }

    /// Polynomials on the inner points. `None` if the runs are too few; nor where an input takes single values only, since runs do not
    /// show what a response does at one that was never drawn.
    pub fn inner_basis(&self) -> Option<&InnerBasis> {
        let basis = || {
            if self.problem.random.is_empty() || self.problem.random.iter().any(RandomVariable::has_atoms) {
                return None;
            }
            let axes: Vec<Axis> = self.random_axes().collect();
            let points: Vec<Vec<f64>> =
                inner_points(&self.problem.sampling, &self.inner).map(|(_, _, point)| point).collect();
            InnerBasis::new(&axes, &points, self.problem.sampling.replicates).map(Arc::new)
        };
        self.inner_basis.get_or_init(basis).as_deref()
    }

    /// Polynomials of all inputs on the points of the probability-only treatment, or on those of the double loop if it is the same; `None`
    /// if these are too few.
    pub fn mixture_basis(&self) -> Option<&InnerBasis> {
        if !self.has_mixture() {
            return self.inner_basis();
        }
        let basis = || {
            if let Some(Copula::Empirical(_)) = self.problem.copula {
                // A response is no smooth function of the place of a row among others.
                return None;
            }
            let epistemic = self.problem.epistemic.iter().map(|_| Axis::Legendre);
            let axes: Vec<Axis> = self.random_axes().chain(epistemic).collect();
            let points: Vec<Vec<f64>> =
                mixture_points(&self.problem.sampling, &self.mixture).map(|(_, _, point)| point).collect();
            InnerBasis::new(&axes, &points, self.problem.sampling.replicates).map(Arc::new)
        };
        self.mixture_basis.get_or_init(basis).as_deref()
    }

    /// In what a response may be smooth: a uniform input in its own probability; what else there is, and what is correlated, in the
    /// standard normal variable of the same rank.
    pub fn random_axes(&self) -> impl Iterator<Item = Axis> {
        self.problem.random.iter().map(|variable| match variable.distribution() {
            Distribution::Uniform { .. } if self.problem.copula.is_none() => Axis::Legendre,
            _ => Axis::Hermite,
        })
    }

    /// Columns that any result needs.
    pub fn needed_columns(&self) -> BTreeSet<usize> {
        let requested = self.problem.requests.iter().map(|request| request.column);
        requested.chain(self.problem.compared_columns.iter().copied()).collect()
    }

    /// The requests for single statistics.
    pub fn single_statistics(&self) -> Vec<Request> {
        let requests = self.problem.requests.iter().copied();
        requests.filter(|request| request.statistic.is_single()).collect()
    }

    /// Statistics whose extremes steer the search, and which extremes.
    pub fn searched(&self) -> Vec<(Request, Vec<Direction>)> {
        let both = Direction::BOTH.to_vec();
        let mut searched = Vec::new();
        for request in &self.problem.requests {
            if !request.statistic.is_single() {
                for probability in CDF_SEARCH_PROBABILITIES {
                    let statistic = Statistic::quantile_at(probability);
                    searched.push((Request { column: request.column, statistic }, both.clone()));
                }
            } else {
                searched.push((*request, both.clone()));
            }
        }
        for &column in &self.problem.compared_columns {
            for (probability, direction) in self.band_quantiles() {
                let request = Request { column, statistic: Statistic::quantile_at(probability) };
                if !self.problem.requests.contains(&request) {
                    searched.push((request, vec![direction]));
                }
            }
        }
        searched
    }

    /// Probabilities of the quantiles that bound the central band of the mixed treatment, and the extreme that is wanted of each.
    pub fn band_quantiles(&self) -> [(f64, Direction); 2] {
        let tail = 0.5 * (1.0 - self.problem.band_probability);
        [(tail, Direction::Minimum), (1.0 - tail, Direction::Maximum)]
    }

    /// Places of the outer points.
    pub fn outer_places(&self, pool: &Pool) -> Vec<BoxPoint> {
        pool.points.iter().map(|point| self.epistemic_box.place_of(&point.epistemic)).collect()
    }

    /// Places of single runs in the box of all inputs.
    pub fn extreme_places(&self, pool: &Pool) -> Vec<BoxPoint> {
        let values = |point: &PoolPoint| [&point.random[..], &point.epistemic].concat();
        pool.points.iter().map(|point| self.joint_box.place_of(&values(point))).collect()
    }

    /// One run at each place of the joint box, as something to search.
    pub fn extreme_target(&self, pool: &Pool, column: usize) -> Target {
        let at: Vec<Estimate> = pool.samples(column).into_iter().map(|sample| mean(sample, &self.confidence)).collect();
        target(&at, &self.confidence)
    }

    /// Shares of the mechanisms whose u lies somewhere in an element, each with the outer points in it, where u differs from mechanism to
    /// mechanism; else all of them at one u, which may be any.
    pub fn shares_of_mechanisms(&self, pool: &Pool) -> Vec<(f64, Vec<usize>)> {
        let is_unknown = |input: &EpistemicVariable| {
            let EpistemicVariable::Evidence(evidence) = input else { return false };
            evidence.elements().len() > 1 && !evidence.is_scattering()
        };
        let is_fixed =
            self.problem.reading == Reading::FixedButUnknown && self.problem.epistemic.iter().any(is_unknown);
        if is_fixed {
            return vec![(1.0, (0..pool.points.len()).collect())];
        }
        let places = self.outer_places(pool);
        let elements = self.structure.widest().elements.iter();
        elements.map(|element| (element.mass, element.region.members(&places))).collect()
    }
}
