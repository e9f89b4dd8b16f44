//! The runs of a study as a table: one row a run, every column with its name and unit: inputs, single numbers, status, counters.

use crate::file::{EpistemicSubject, Study, named_angle_rad};
use crate::response::columns::ColumnPlan;
use crate::response::extras::RunExtras;
use crate::response::study_response::StudyResponse;
use loosepin_bounds::SampleTable;
use loosepin_simulate::RunFailure;
use loosepin_text::units::SiUnit;
use std::borrow::Cow;

/// One run a row. All columns have the same length; [`crate::written::tables::runs_parquet`] refuses others.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct RunsTable {
    /// The columns, in the order in which they are written.
    pub columns: Vec<RunColumn>,
}

/// One column.
#[derive(Debug, Clone, PartialEq)]
pub struct RunColumn {
    /// Its name: `index`, the path of an uncertain input, the name of a scalar output, `status`, a counter.
    pub name: String,
    /// Unit of its values; [`SiUnit::NONE`] for counts and text.
    pub unit: SiUnit,
    /// Its values.
    pub data: RunData,
}

/// Values of one column.
#[derive(Debug, Clone, PartialEq)]
pub enum RunData {
    /// Numbers. Not-a-number means that the run has no such value, and is written as a null.
    F64(Vec<f64>),
    /// Counts and indices.
    U64(Vec<u64>),
    /// Words.
    Text(Vec<Cow<'static, str>>),
}

impl RunData {
    /// Number of rows.
    pub fn len(&self) -> usize {
        match self {
            RunData::F64(values) => values.len(),
            RunData::U64(values) => values.len(),
            RunData::Text(values) => values.len(),
        }
    }

    /// Whether the table has no rows.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// Whether a row may be without a value.
    pub fn is_nullable(&self) -> bool {
        matches!(self, RunData::F64(_))
    }
}

/// Name of a column with one number for each run.
pub fn scalar_name(plan: &ColumnPlan, index: usize) -> String {
    let column = &plan.columns[index];
    let at = column.spot.turned_into(
        |pose| format!("at {} rad", named_angle_rad(pose.angle_rad)),
        |reduction| reduction.word().to_owned(),
    );
    format!("{} {at}", curve_name(plan, index))
}

/// Name of the curve that a column is a point of: output and deviation.
pub fn curve_name(plan: &ColumnPlan, index: usize) -> String {
    let column = &plan.columns[index];
    format!("{} {}", plan.outputs[column.output].name, column.deviation.word())
}

/// The table for `runs.parquet`. Curves are left out: they would be most of it.
pub fn runs_table(study: &Study, response: &StudyResponse, table: &SampleTable) -> RunsTable {
    let mut columns = Vec::new();
    let mut push = |name: String, unit: SiUnit, data: RunData| columns.push(RunColumn { name, unit, data });
    let inputs = table.inputs();
    let rows = 0..table.len();
    let text = |f: &dyn Fn(usize) -> Cow<'static, str>| RunData::Text(rows.clone().map(f).collect());
    let count = |f: &dyn Fn(usize) -> u64| RunData::U64(rows.clone().map(f).collect());
    let number = |f: &dyn Fn(usize) -> f64| RunData::F64(rows.clone().map(f).collect());
    push("index".to_owned(), SiUnit::NONE, count(&|run| run as u64));
    push("purpose".to_owned(), SiUnit::NONE, text(&|run| inputs[run].purpose.word().into()));
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
            EpistemicSubject::Quantity(_) | EpistemicSubject::Parameter { .. } | EpistemicSubject::Play => {
                number(&|run| inputs[run].epistemic[k])
            }
            EpistemicSubject::Law { .. } => text(&|run| input.written(&study.model, inputs[run].epistemic[k]).into()),
        };
        push(input.path.clone(), input.unit(&study.model), data);
    }
    let plan = response.plan();
    let scalars: Vec<usize> = (0..plan.columns.len()).filter(|&column| is_scalar(plan, column)).collect();
    let (values, extras) = numbers(response, table, &scalars);
    for (&index, values) in scalars.iter().zip(values) {
        let unit = plan.outputs[plan.columns[index].output].unit.clone();
        push(scalar_name(plan, index), unit, RunData::F64(values));
    }
    let status = |run: usize| if table.failure(run).is_some() { "failed" } else { "finished" };
    push("status".to_owned(), SiUnit::NONE, text(&|run| status(run).into()));
    let reason = |run: usize| table.failure(run).map_or("", |failure| RunFailure::code_of(failure.0));
    push("reason".to_owned(), SiUnit::NONE, text(&|run| reason(run).into()));
    columns.extend(extras.into_columns(response.joints()));
    RunsTable { columns }
}

/// Whether `column` is one number a run that was asked for, and no point of a curve.
fn is_scalar(plan: &ColumnPlan, column: usize) -> bool {
    let is_asked = plan.asks.iter().any(|ask| !ask.location.is_cycle() && ask.columns.contains(&column));
    is_asked || plan.requirements.iter().any(|required| required.columns.contains(&column))
}

/// Extras of all runs, column by column.
#[derive(Default)]
pub(crate) struct ExtraColumns {
    energy_residual: Vec<f64>,
    change_over_last_turn: Vec<f64>,
    steps: Vec<u64>,
    evaluations: Vec<u64>,
    joints: Vec<JointColumns>,
}

/// Extras of one joint with play.
#[derive(Default)]
struct JointColumns {
    contacts: Vec<u64>,
    largest_penetration_m: Vec<f64>,
    peak_force_n: Vec<f64>,
}

impl ExtraColumns {
    /// Those of runs with these joints with play; of no run yet.
    pub fn new(joints: &[String]) -> Self {
        Self { joints: joints.iter().map(|_| JointColumns::default()).collect(), ..Self::default() }
    }

    /// Adds those of a run; of a failed one they are not numbers.
    pub fn push(&mut self, extras: &RunExtras) {
        // A failed run has no counters: zero evaluations.
        let whole = |value: f64| if value.is_finite() { value as u64 } else { 0 };
        self.energy_residual.push(extras.energy_residual);
        self.change_over_last_turn.push(extras.change_over_last_turn);
        self.steps.push(whole(extras.steps));
        self.evaluations.push(whole(extras.evaluations));
        for (own, joint) in self.joints.iter_mut().zip(&extras.joints) {
            own.contacts.push(whole(joint.contacts));
            own.largest_penetration_m.push(joint.largest_penetration_m);
            own.peak_force_n.push(joint.peak_force_n);
        }
    }

    /// The columns with their names.
    pub fn into_columns(self, joints: &[String]) -> Vec<RunColumn> {
        let column = |name: &str, unit: SiUnit, data: RunData| RunColumn { name: name.to_owned(), unit, data };
        let mut columns = vec![
            column("energy_residual", SiUnit::NONE, RunData::F64(self.energy_residual)),
            column("change_over_last_turn", SiUnit::NONE, RunData::F64(self.change_over_last_turn)),
            column("steps", SiUnit::NONE, RunData::U64(self.steps)),
            column("evaluations", SiUnit::NONE, RunData::U64(self.evaluations)),
        ];
        for (joint, own) in joints.iter().zip(self.joints) {
            let name = |what: &str| format!("{what} {joint}");
            columns.push(column(&name("contacts"), SiUnit::NONE, RunData::U64(own.contacts)));
            let penetration = RunData::F64(own.largest_penetration_m);
            columns.push(column(&name("largest_penetration"), SiUnit::LENGTH, penetration));
            columns.push(column(&name("peak_force"), SiUnit::FORCE, RunData::F64(own.peak_force_n)));
        }
        columns
    }
}

/// The `scalars` of all runs, column by column, and their extras. Every row is read once: where runs are many, rows lie in a file.
fn numbers(response: &StudyResponse, table: &SampleTable, scalars: &[usize]) -> (Vec<Vec<f64>>, ExtraColumns) {
    let mut values: Vec<Vec<f64>> = scalars.iter().map(|_| Vec::with_capacity(table.len())).collect();
    let mut columns = ExtraColumns::new(response.joints());
    for run in 0..table.len() {
        let row = table.values(run);
        for (own, &column) in values.iter_mut().zip(scalars) {
            own.push(row[column]);
        }
        columns.push(&response.extras(row));
    }
    (values, columns)
}
