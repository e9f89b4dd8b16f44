//! The runs that determine shares of the variance.

use crate::file::{RandomSubject, Study};
use loosepin_bounds::{DoubleLoop, Purpose, RunInputs, SampleTable};
use loosepin_uncertainty::contributors::{IndexPlan, IndexPlanError, Indices, independent_groups};
use loosepin_uncertainty::hash;

/// Independent scramblings, for the errors of indices.
const REPLICATES: usize = 8;
/// Pairs of sample points in each, at least.
const MIN_PAIRS: usize = 4;
/// Values of the epistemic inputs at which indices are computed, at most: the middle and corners.
const MAX_POINTS: usize = 5;
/// Separates the stream of random numbers.
const CONTRIBUTORS: u64 = 0x636f_6e74_7269_6200;

/// The runs of the indices: the same points of the random inputs at a handful of values of the epistemic ones.
pub struct ContributorPlan {
    /// Points of the random inputs.
    pub indices: IndexPlan,
    /// Values of the epistemic inputs.
    pub points: Vec<Vec<f64>>,
}

impl ContributorPlan {
    /// The plan of `study`; `None` if nothing is random.
    ///
    /// # Errors
    /// More random inputs than indices can be had of.
    pub fn new(study: &Study, plan: &DoubleLoop) -> Result<Option<Self>, IndexPlanError> {
        if study.random.is_empty() {
            return Ok(None);
        }
        let groups = groups(study);
        let pairs = (study.sampling.inner / REPLICATES).max(MIN_PAIRS);
        let seed = hash(study.seed, CONTRIBUTORS);
        let indices = IndexPlan::try_new(study.random.len(), groups, REPLICATES, pairs, seed)?;
        let mut points = plan.structural_points();
        let stride = points.len().saturating_sub(1).div_ceil(MAX_POINTS - 1).max(1);
        points =
            points.into_iter().enumerate().filter(|(k, _)| *k == 0 || (k - 1) % stride == 0).map(|(_, p)| p).collect();
        Ok(Some(Self { indices, points }))
    }

    /// Number of runs.
    pub fn runs(&self) -> usize {
        self.points.len() * self.indices.runs()
    }

    /// The runs in their order, as round `round`.
    pub fn round(&self, plan: &DoubleLoop, round: u32) -> Vec<RunInputs> {
        let rows = self.indices.points();
        let per_replicate = rows.len() / REPLICATES;
        let of_point = |(point, epistemic): (usize, &Vec<f64>)| {
            let inputs = |(row, at): (usize, &Vec<f64>)| RunInputs {
                round,
                purpose: Purpose::Contributors,
                point: point as u32,
                replicate: (row / per_replicate) as u32,
                index: (row % per_replicate) as u32,
                random: plan.random_values(at, epistemic),
                epistemic: epistemic.clone(),
            };
            rows.iter().enumerate().map(inputs).collect::<Vec<RunInputs>>()
        };
        self.points.iter().enumerate().flat_map(of_point).collect()
    }

    /// Indices of `columns` at each point.
    pub fn indices(&self, table: &SampleTable, columns: &[usize]) -> Vec<Option<Indices>> {
        (0..self.points.len() as u32)
            .map(|point| {
                let is_own = |run: &usize| {
                    let inputs = &table.inputs()[*run];
                    inputs.purpose == Purpose::Contributors && inputs.point == point
                };
                let runs: Vec<usize> = (0..table.len()).filter(is_own).collect();
                let values = |&column: &usize| runs.iter().map(|&run| table.values(run)[column]).collect();
                self.indices.indices(&columns.iter().map(values).collect::<Vec<Vec<f64>>>())
            })
            .collect()
    }
}

/// Random inputs that are correlated belong together, and those of one journal.
pub fn groups(study: &Study) -> Vec<Vec<usize>> {
    if study.specimen.is_some() {
        // A row is drawn whole.
        return vec![(0..study.random.len()).collect()];
    }
    let stated = study.correlation.iter().flat_map(|correlation| &correlation.stated);
    let places = study.random.iter().map(|input| match &input.subject {
        RandomSubject::Journal { place } => Some(place),
        RandomSubject::Quantity(_) => None,
    });
    // The numbers that the place of a journal is drawn from belong together.
    let places: Vec<Option<&String>> = places.collect();
    let of_journals = (1..places.len()).filter(|&next| places[next].is_some() && places[next] == places[next - 1]);
    let pairs: Vec<(usize, usize)> =
        stated.map(|pair| (pair.first, pair.second)).chain(of_journals.map(|next| (next - 1, next))).collect();
    independent_groups(study.random.len(), &pairs)
}
