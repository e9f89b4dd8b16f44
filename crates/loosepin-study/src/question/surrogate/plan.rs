//! The plan of the surrogates of a study.

use crate::error::StudyError;
use crate::file::{Study, StudySurrogate};
use crate::planning::problem::problem;
use crate::response::columns::ColumnPlan;
use crate::response::study_response::StudyResponse;
use loosepin_bounds::{ColumnGroup, MAX_WITNESSES, SurrogatePlan, SurrogateSettings};

/// The plan of the surrogates of `study`; `None` if it asks for none.
///
/// # Errors
/// The numbers of runs are not possible.
pub fn surrogate_plan(study: &Study, response: &StudyResponse) -> Result<Option<SurrogatePlan>, StudyError> {
    let Some(StudySurrogate { choice, training_runs, confirming_runs, .. }) = study.surrogate else {
        return Ok(None);
    };
    let mut problem = problem(study, response);
    // Distribution functions are shown of the direct runs.
    problem.requests.retain(|request| request.statistic.is_single());
    let groups = groups(response.plan());
    let settings = SurrogateSettings { choice, training: training_runs, confirming: confirming_runs, groups };
    Ok(Some(SurrogatePlan::try_new(problem, settings)?))
}

/// Largest number of runs of `plan`.
pub fn most_surrogate_runs(study: &Study, plan: &SurrogatePlan) -> usize {
    let combinations: usize = study.epistemic.iter().map(|input| input.variable.choices()).product();
    plan.settings().training * combinations + plan.settings().confirming * MAX_WITNESSES
}

/// A group for each curve, then one for each other column.
fn groups(plan: &ColumnPlan) -> Vec<ColumnGroup> {
    let mut groups: Vec<ColumnGroup> = Vec::new();
    let name = |column: usize| {
        let of = plan.columns[column].deviation.word();
        format!("{} {of}", plan.outputs[plan.columns[column].output].name)
    };
    let is_known = |groups: &[ColumnGroup], column: &usize| groups.iter().any(|group| group.columns.contains(column));
    for ask in plan.asks.iter().filter(|ask| ask.location.is_cycle()) {
        let columns: Vec<usize> = ask.columns.iter().copied().filter(|column| !is_known(&groups, column)).collect();
        if let Some(&first) = columns.first() {
            groups.push(ColumnGroup { name: name(first), columns });
        }
    }
    for column in 0..plan.columns.len() {
        if !is_known(&groups, &column) {
            groups.push(ColumnGroup { name: name(column), columns: vec![column] });
        }
    }
    groups
}
