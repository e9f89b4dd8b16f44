//! The promise of a study, before any run.

use crate::error::StudyError;
use crate::file::Study;
use crate::planning::problem::problem;
use crate::response::columns::ColumnPlan;
use crate::response::study_response::StudyResponse;
use loosepin_bounds::{PromisePlan, PromiseRequest, Request};
use loosepin_result::study::Side;
use loosepin_text::units::distinct;

/// The plan of what `study` promises; `None` if it promises nothing.
///
/// # Errors
/// Nothing can be promised.
pub fn promise_plan(study: &Study, response: &StudyResponse) -> Result<Option<PromisePlan>, StudyError> {
    let Some(settings) = study.promise else { return Ok(None) };
    let plan = response.plan();
    let promised = plan.asks.iter().filter(|ask| !ask.promised.is_empty());
    let bands = promised.flat_map(|ask| ask.bands()).collect();
    Ok(Some(PromisePlan::try_new(problem(study, response), promised_ends(plan), bands, settings)?))
}

/// Every end that is promised, once: those of the questions, then those that decide requirements.
fn promised_ends(plan: &ColumnPlan) -> Vec<PromiseRequest> {
    let of_asks = plan.asks.iter().flat_map(|ask| {
        let of_column = move |&column: &usize| ask.statistics().map(move |statistic| Request { column, statistic });
        let requests = ask.columns.iter().flat_map(of_column);
        requests.flat_map(|request| ask.promised.iter().map(move |&side| PromiseRequest { request, side }))
    });
    let decided = plan.requirements.iter().filter(|required| required.is_promised);
    let of_requirements = decided.flat_map(|required| {
        let statistic = required.limit.broken();
        let request = move |&column: &usize| Request { column, statistic };
        required.columns.iter().map(move |column| PromiseRequest { request: request(column), side: Side::Upper })
    });
    distinct(of_asks.chain(of_requirements))
}
