//! What contributors are stated of: the numbers that requirements and questions are about, at their places.

use crate::file::{Ask, Deviation, Reduction};
use crate::places::Location;
use crate::response::columns::{ColumnPlan, StudyColumn};
use loosepin_math::sort_by_number;
use loosepin_result::study::RequirementOutcome;

/// Places of one output in a requirement or a question that does not ask for contributors: more tables would hide the first.
const MAX_PLACES: usize = 4;

/// Columns whose contributors are stated together.
#[derive(Debug, Clone, PartialEq)]
pub struct Subject {
    pub deviation: Deviation,
    /// One number of a run, or all poses of a curve.
    pub columns: Vec<usize>,
    pub is_curve: bool,
}

impl Subject {
    /// The angle of the drive, if it is at a pose.
    pub fn pose_rad(&self, plan: &ColumnPlan) -> Option<f64> {
        plan.columns[self.columns[0]].spot.pose().filter(|_| !self.is_curve).map(|pose| pose.angle_rad)
    }
}

/// Every question that asks for contributors; where none does, each output at the places of its requirements, then of its first question.
/// `outcomes`: those of the requirements, in the order of [`ColumnPlan::required`].
pub fn subjects(plan: &ColumnPlan, outcomes: &[RequirementOutcome]) -> Vec<Subject> {
    let asked: Vec<Subject> = plan.asks.iter().filter(|ask| ask.is_for_contributors()).flat_map(of_ask).collect();
    if !asked.is_empty() {
        return asked;
    }
    let mut outputs: Vec<usize> = Vec::new();
    let named = plan.asks.iter().map(|ask| ask.output).chain(plan.requirements.iter().map(|own| own.output));
    for output in named {
        if !outputs.contains(&output) {
            outputs.push(output);
        }
    }
    let of_output = |output: usize| {
        let mut found: Vec<Subject> = Vec::new();
        for subject in required(plan, outcomes, output).into_iter().chain(first_asked(plan, output)) {
            if !found.contains(&subject) {
                found.push(subject);
            }
        }
        found
    };
    outputs.into_iter().flat_map(of_output).collect()
}

/// What an ask is about: a curve as a whole, poses one by one.
fn of_ask(ask: &Ask) -> Vec<Subject> {
    let is_curve = ask.location.is_cycle();
    let parts: Vec<&[usize]> = if is_curve { vec![&ask.columns[..]] } else { ask.columns.chunks(1).collect() };
    parts.into_iter().map(|columns| Subject { deviation: ask.deviation, columns: columns.to_vec(), is_curve }).collect()
}

/// The numbers of the requirements of an output, that which is kept in the fewest mechanisms first.
fn required(plan: &ColumnPlan, outcomes: &[RequirementOutcome], output: usize) -> Vec<Subject> {
    let mut own: Vec<_> =
        plan.required().zip(outcomes).filter(|((required, _), _)| required.output == output).collect();
    sort_by_number(&mut own, |(_, outcome)| outcome.probability[0]);
    own.into_iter().map(|((required, column), _)| number(required.deviation, column)).take(MAX_PLACES).collect()
}

/// The numbers of the first question about an output: of a curve of deviations the largest of the cycle.
fn first_asked(plan: &ColumnPlan, output: usize) -> Vec<Subject> {
    let Some(ask) = plan.asks.iter().find(|ask| ask.output == output) else { return Vec::new() };
    if !ask.location.is_cycle() {
        return of_ask(ask).into_iter().take(MAX_PLACES).collect();
    }
    let is_largest = |column: &StudyColumn| {
        (column.output, column.deviation) == (output, ask.deviation)
            && column.spot == Location::reduced(Reduction::largest_magnitude())
    };
    match plan.columns.iter().position(is_largest) {
        Some(column) => vec![number(ask.deviation, column)],
        // A value has no largest deviation.
        None => of_ask(ask),
    }
}

fn number(deviation: Deviation, column: usize) -> Subject {
    Subject { deviation, columns: vec![column], is_curve: false }
}
