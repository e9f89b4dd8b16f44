//! Every run as a row: inputs, single numbers, status, counters.

use super::columns::{ColumnPlan, Spot};
use super::file::{EpistemicSubject, Study, Where};
use super::response::StudyResponse;
use super::runs::{RunColumn, RunData, RunsTable, named_angle_rad};
use loosepin_bounds::SampleTable;
use loosepin_simulate::RunFailure;
use loosepin_text::units::SiUnit;

/// What a column is called that is one number a run.
pub fn scalar_name(plan: &ColumnPlan, index: usize) -> String {
    let column = &plan.columns[index];
    let at = match column.spot {
        Spot::Pose { angle_rad, .. } => format!("at {} rad", named_angle_rad(angle_rad)),
        Spot::Reduced(reduction) => reduction.word().to_owned(),
    };
    format!("{} {at}", curve_name(plan, index))
}

/// What the curve is called that a column is a point of: output and deviation.
pub fn curve_name(plan: &ColumnPlan, index: usize) -> String {
    let column = &plan.columns[index];
    format!("{} {}", plan.outputs[column.output].name, column.deviation.word())
}

/// The table for `runs.parquet`. Curves are left out: they would be most of it.
pub fn runs_table(study: &Study, response: &StudyResponse, table: &SampleTable) -> RunsTable {
    let rows = 0..table.len();
    let mut columns = Vec::new();
    let mut push = |name: String, unit: SiUnit, data: RunData| columns.push(RunColumn { name, unit, data });
    let inputs = table.inputs();
    push("index".to_owned(), SiUnit::NONE, RunData::U64(rows.clone().map(|run| run as u64).collect()));
    let text = |f: &dyn Fn(usize) -> String| RunData::Text(rows.clone().map(f).collect());
    let count = |f: &dyn Fn(usize) -> u64| RunData::U64(rows.clone().map(f).collect());
    let number = |f: &dyn Fn(usize) -> f64| RunData::F64(rows.clone().map(f).collect());
    push("purpose".to_owned(), SiUnit::NONE, text(&|run| inputs[run].purpose.word().to_owned()));
    push("round".to_owned(), SiUnit::NONE, count(&|run| u64::from(inputs[run].round)));
    push("outer".to_owned(), SiUnit::NONE, count(&|run| u64::from(inputs[run].point)));
    push("replicate".to_owned(), SiUnit::NONE, count(&|run| u64::from(inputs[run].replicate)));
    push("inner".to_owned(), SiUnit::NONE, count(&|run| u64::from(inputs[run].index)));
    for (k, input) in study.random.iter().enumerate() {
        let unit = input.unit(&study.model);
        push(input.path.clone(), unit, number(&|run| inputs[run].random[k]));
    }
    for (k, input) in study.epistemic.iter().enumerate() {
        let data = match &input.subject {
            EpistemicSubject::Quantity(_) | EpistemicSubject::Parameter { .. } => {
                number(&|run| inputs[run].epistemic[k])
            }
            EpistemicSubject::Law { .. } => text(&|run| input.written(&study.model, inputs[run].epistemic[k])),
        };
        push(input.path.clone(), input.unit(&study.model), data);
    }
    let plan = &response.shared.plan;
    for (index, column) in plan.columns.iter().enumerate() {
        let is_scalar =
            plan.asks.iter().any(|planned| planned.ask.location != Where::Cycle && planned.columns.contains(&index))
                || plan.requirements.iter().any(|planned| planned.columns.contains(&index));
        if !is_scalar {
            continue;
        }
        let unit = plan.outputs[column.output].unit.clone();
        push(scalar_name(plan, index), unit, number(&|run| table.values(run)[index]));
    }
    let status = |run: usize| if table.failure(run).is_some() { "failed" } else { "finished" };
    push("status".to_owned(), SiUnit::NONE, text(&|run| status(run).to_owned()));
    let reason = |run: usize| table.failure(run).map_or("", |failure| RunFailure::code_of(failure.0));
    push("reason".to_owned(), SiUnit::NONE, text(&|run| reason(run).to_owned()));
    let extras: Vec<_> = rows.clone().map(|run| response.extras(table.values(run))).collect();
    // A failed run has no counters: zero evaluations.
    let whole = |value: f64| if value.is_finite() { value as u64 } else { 0 };
    push("energy_residual".to_owned(), SiUnit::NONE, number(&|run| extras[run].energy_residual));
    push("change_over_last_turn".to_owned(), SiUnit::NONE, number(&|run| extras[run].change_over_last_turn));
    push("steps".to_owned(), SiUnit::NONE, count(&|run| whole(extras[run].steps)));
    push("evaluations".to_owned(), SiUnit::NONE, count(&|run| whole(extras[run].evaluations)));
    for (k, joint) in response.joints.iter().enumerate() {
        push(format!("contacts {joint}"), SiUnit::NONE, count(&|run| whole(extras[run].joints[k].contacts)));
        let depth = |run: usize| extras[run].joints[k].largest_penetration_m;
        push(format!("largest_penetration {joint}"), SiUnit::LENGTH, number(&depth));
        push(format!("peak_force {joint}"), SiUnit::FORCE, number(&|run| extras[run].joints[k].peak_force_n));
    }
    RunsTable { columns }
}
