//! Surrogates of groups of columns, and the double loop's view of one of them.

use super::super::evaluate::Response;
use super::super::problem::Problem;
use super::super::table::{Failure, Purpose, SampleTable};
use super::plan::{ColumnGroup, SurrogateSettings};
use super::space::TrainingSpace;
use crate::surrogate::{Options, Surrogate, SurrogateError, TrainingData, TrainingOutput};

/// Why an evaluation of a surrogate gave nothing: outside the range of its runs.
const OUTSIDE: Failure = Failure(1);

/// What was learned of all groups.
#[derive(Clone)]
pub struct Learned {
    /// One entry a group, in their order.
    pub groups: Vec<LearnedGroup>,
}

/// What was learned of a group of columns.
#[derive(Clone)]
pub struct LearnedGroup {
    /// The columns.
    pub group: ColumnGroup,
    /// One surrogate for each combination of the members of lists, or why there are none.
    pub surrogates: Result<Vec<Surrogate>, SurrogateError>,
    /// Training runs without these columns.
    pub failed: usize,
}

impl Learned {
    /// Learns every group from the training runs in `table`.
    pub(super) fn new(
        problem: &Problem,
        space: &TrainingSpace,
        settings: &SurrogateSettings,
        table: &SampleTable,
    ) -> Self {
        let runs: Vec<usize> =
            (0..table.len()).filter(|&run| table.inputs()[run].purpose == Purpose::Training).collect();
        let of_group = |group: &ColumnGroup| {
            let row = |run: usize| -> Option<Vec<f64>> {
                let values: Vec<f64> = group.columns.iter().map(|&column| table.values(run)[column]).collect();
                values.iter().all(|value| value.is_finite()).then_some(values)
            };
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
                let output = TrainingOutput::curve(&group.name, own.iter().map(|&run| row(run)).collect());
                let data = TrainingData::try_new(space.inputs(problem, &points), points, vec![output])?;
                let options = Options { choice: settings.choice, seed: problem.sampling.seed, ..Options::default() };
                Surrogate::fit(&data, &options)
            };
            LearnedGroup {
                group: group.clone(),
                surrogates: (0..space.combinations()).map(of_combination).collect(),
                failed: runs.iter().filter(|&&run| row(run).is_none()).count(),
            }
        };
        Self { groups: settings.groups.iter().map(of_group).collect() }
    }
}

impl LearnedGroup {
    /// Whether what is left of the runs is part of the surrogate.
    pub fn keeps_residual(&self) -> bool {
        let surrogates = self.surrogates.iter().flatten();
        surrogates.flat_map(Surrogate::outputs).any(|output| output.residual.verdict.keeps_residual())
    }
}

/// What a column of the double loop on a surrogate holds about a column of the problem.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Aspect {
    /// ŝ with its share of the rest.
    Value,
    /// ŝ - kσ
    Low,
    /// ŝ + kσ
    High,
    /// The number of least magnitude in the band, or 0 where it changes its sign there.
    Near,
    /// The number of largest magnitude in the band.
    Far,
    /// k²σ²
    Square,
}

impl Aspect {
    pub const ALL: [Self; 6] = [Self::Value, Self::Low, Self::High, Self::Near, Self::Far, Self::Square];
}

/// Some places of a group as a response: for each of them, every aspect.
pub(super) struct LearnedResponse<'a> {
    pub space: &'a TrainingSpace,
    pub surrogates: &'a [Surrogate],
    /// Positions within the group.
    pub places: &'a [usize],
    /// k
    pub reach: f64,
}

impl LearnedResponse<'_> {
    /// ŝ without the rest, and σ, at the places.
    pub fn plain(&self, random: &[f64], epistemic: &[f64]) -> Result<(Vec<f64>, Vec<f64>), SurrogateError> {
        let surrogate = &self.surrogates[self.space.combination(epistemic)];
        let answers = surrogate.predict(&self.space.point(random, epistemic))?;
        let of = |values: &[f64]| self.places.iter().map(|&place| values[place]).collect();
        Ok(answers.first().map(|answer| (of(&answer.values), of(&answer.deviations))).unwrap_or_default())
    }
}

impl Response for LearnedResponse<'_> {
    fn evaluate(&self, random: &[f64], epistemic: &[f64], columns: &mut [f64]) -> Result<(), Failure> {
        let (values, deviations) = self.plain(random, epistemic).map_err(|_| OUTSIDE)?;
        let surrogate = &self.surrogates[self.space.combination(epistemic)];
        let point = self.space.point(random, epistemic);
        // Without random inputs there is no scatter that the rest could belong to: it stays in the band.
        let rest = if random.is_empty() {
            None
        } else {
            surrogate.residual(0, &point, self.space.share(random)).map_err(|_| OUTSIDE)?
        };
        let row = columns.chunks_exact_mut(Aspect::ALL.len());
        for (slot, column) in row.enumerate() {
            let value = values[slot] + rest.as_ref().map_or(0.0, |rest| rest[self.places[slot]]);
            let half = self.reach * deviations[slot];
            let (low, high) = (value - half, value + half);
            // On the side of the value, so that a search sees something smooth.
            let near = (value.abs() - half).max(0.0).copysign(value);
            let far = (value.abs() + half).copysign(value);
            column.copy_from_slice(&[value, low, high, near, far, half * half]);
        }
        Ok(())
    }
}
