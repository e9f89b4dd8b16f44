//! Promises for a share of the box as a question: all runs at once, fixed beforehand.

use super::columns::ColumnPlan;
use super::error::StudyError;
use super::file::Study;
use super::problem::problem;
use super::question::{Next, Question};
use super::response::StudyResponse;
use super::simultaneous::CurveBand;
use loosepin_bounds::{PromisePlan, PromiseRequest, PromisedBound, Request, RunInputs, SampleTable, SimultaneousBand};
use loosepin_result::study::Side;

/// The plan of what `study` promises; nothing where it promises nothing.
///
/// # Errors
/// Nothing can be promised.
pub(super) fn promise_plan(study: &Study, response: &StudyResponse) -> Result<Option<PromisePlan>, StudyError> {
    let Some(settings) = study.promise else { return Ok(None) };
    let plan = &response.shared.plan;
    let promised = plan.asks.iter().filter(|planned| !planned.ask.promised.is_empty());
    let bands = promised.flat_map(|planned| planned.ask.simultaneous_bands.iter().copied()).collect();
    Ok(Some(PromisePlan::try_new(problem(study, response), promised_ends(plan), bands, settings)?))
}

/// Every end that is promised, once: those of the questions, then those that decide requirements.
fn promised_ends(plan: &ColumnPlan) -> Vec<PromiseRequest> {
    let of_asks = plan.asks.iter().flat_map(|planned| {
        let statistics = planned
            .columns
            .iter()
            .flat_map(|&column| planned.ask.statistics.iter().map(move |&statistic| Request { column, statistic }));
        statistics.flat_map(|request| planned.ask.promised.iter().map(move |&side| PromiseRequest { request, side }))
    });
    let decided = plan.requirements.iter().filter(|planned| planned.requirement.is_promised);
    let of_requirements = decided.flat_map(|planned| {
        let statistic = planned.requirement.limit.broken();
        let request = move |&column: &usize| Request { column, statistic };
        planned.columns.iter().map(move |column| PromiseRequest { request: request(column), side: Side::Upper })
    });
    let mut ends: Vec<PromiseRequest> = Vec::new();
    for end in of_asks.chain(of_requirements) {
        if !ends.contains(&end) {
            ends.push(end);
        }
    }
    ends
}

/// The runs of a promise.
pub(super) struct PromiseQuestion<'p> {
    plan: &'p PromisePlan,
    runs: Option<Vec<RunInputs>>,
}

impl<'p> PromiseQuestion<'p> {
    /// The runs of `plan` as round `round`.
    pub fn new(plan: &'p PromisePlan, round: u32) -> Self {
        Self { plan, runs: Some(plan.round(round)) }
    }
}

impl Question for PromiseQuestion<'_> {
    type Answer = Vec<PromisedBound>;

    fn next(&mut self, runs: &SampleTable) -> Result<Next<Self::Answer>, StudyError> {
        // A failed run leaves nothing promised, and no other answer stands on it.
        match self.runs.take() {
            Some(wanted) => Ok(Next::Beside(wanted)),
            None => Ok(Next::Answer(self.plan.results(runs)?)),
        }
    }
}

/// What is promised.
pub(super) struct Promised {
    pub plan: PromisePlan,
    /// Ends of single numbers.
    pub ends: Vec<PromisedBound>,
    /// Bands over curves: the band of the double loop, and the factor of its shape; nothing where it has no shape.
    pub bands: Vec<(SimultaneousBand, PromisedBound)>,
}

impl Promised {
    /// The `ends`, and those of `bands` that are promised: their shapes come from the runs of the double loop, and so were fixed
    /// without a look at those of the promise.
    ///
    /// # Errors
    /// The table lacks runs.
    pub fn new(
        plan: PromisePlan,
        ends: Vec<PromisedBound>,
        bands: &[CurveBand],
        table: &SampleTable,
    ) -> Result<Self, StudyError> {
        let promised = bands.iter().filter(|band| band.is_promised);
        let shaped = promised.filter_map(|band| Some((&band.columns, band.found.clone()?)));
        let factor = |(columns, band): (&Vec<usize>, SimultaneousBand)| {
            let factor = plan.band(table, columns, &band)?;
            Ok((band, factor))
        };
        let bands = shaped.map(factor).collect::<Result<_, StudyError>>()?;
        Ok(Self { plan, ends, bands })
    }
}
