//! Surrogates of groups of columns.

use super::plan::SurrogatePlan;
use super::settings::ColumnGroup;
use crate::data::table::{Purpose, SampleTable};
use loosepin_surrogate::{Options, OutputSurrogate, Surrogate, SurrogateError, TrainingData, TrainingOutput};

/// Q² from which the residual is a hundredth of the response's deviation at most: the band around the surrogate holds it.
const SMALL_REST: f64 = 0.9999;

/// Surrogates of all groups.
#[derive(Clone)]
pub struct Learned {
    /// One entry a group, in their order.
    pub groups: Vec<LearnedGroup>,
}

/// Surrogates of a group of columns.
#[derive(Clone)]
pub struct LearnedGroup {
    /// The columns.
    pub group: ColumnGroup,
    /// One surrogate for each combination of the members of lists, or why there are none.
    pub surrogates: Result<Vec<Surrogate>, SurrogateError>,
    /// Training runs without these columns.
    pub failed: usize,
}

impl SurrogatePlan {
    /// Learns every group from the training runs in `table`.
    pub fn learn(&self, table: &SampleTable) -> Learned {
        let Self { settings, space, .. } = self;
        let problem = self.problem();
        let runs: Vec<usize> =
            (0..table.len()).filter(|&run| table.inputs()[run].purpose == Purpose::Training).collect();
        let of_group = |group: &ColumnGroup| {
            let of_combination = |combination: usize| {
                let own = runs.iter().copied().filter(|&run| {
                    let inputs = &table.inputs()[run];
                    space.combination(&inputs.epistemic) == combination
                });
                let own: Vec<usize> = own.collect();
                let points: Vec<Vec<f64>> = own
                    .iter()
                    .map(|&run| space.point(&table.inputs()[run].random, &table.inputs()[run].epistemic))
                    .collect();
                let output = TrainingOutput::curve(&group.name, own.iter().map(|&run| group.row(table, run)).collect());
                let data = TrainingData::try_new(space.inputs(problem, &points), points, vec![output])?;
                let options = Options { choice: settings.choice, seed: problem.sampling.seed, ..Options::default() };
                Surrogate::fit(&data, &options)
            };
            LearnedGroup {
                group: group.clone(),
                surrogates: (0..space.combinations()).map(of_combination).collect(),
                failed: runs.iter().filter(|&&run| group.row(table, run).is_none()).count(),
            }
        };
        Learned { groups: settings.groups.iter().map(of_group).collect() }
    }
}

impl LearnedGroup {
    /// Whether the residual of the runs is part of the surrogate.
    pub fn keeps_residual(&self) -> bool {
        self.surrogates.iter().flatten().any(draws_residual)
    }
}

/// Whether every inner run draws from the residual: if it does not fall with more runs, and is not so small that the band holds it.
pub(crate) fn draws_residual(surrogate: &Surrogate) -> bool {
    let is_drawn = |output: &OutputSurrogate| {
        output.residual.verdict.keeps_residual() && output.quality.q2.is_none_or(|q2| q2 < SMALL_REST)
    };
    surrogate.outputs().iter().any(is_drawn)
}
