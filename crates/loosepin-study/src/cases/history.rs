//! Our rows against the rows of a file.

use super::case::{ComputedColumn, History};
use loosepin_simulate::Simulation;

/// Largest absolute difference over the rows of the columns that count as one number, SI; NaN if the run has other
/// rows.
pub(super) fn largest_difference(history: &History, simulation: &Simulation) -> f64 {
    let rows = &history.reference.rows;
    let Some(states) = &simulation.states else { return f64::NAN };
    let outputs = &simulation.record.outputs;
    if states.rows.len() != rows.len() || outputs.iter().any(|output| output.value_si.len() != rows.len()) {
        return f64::NAN;
    }
    let mut largest = 0.0_f64;
    for (index, row) in rows.iter().enumerate() {
        for &(column, ours) in &history.columns {
            let value_si = match ours {
                ComputedColumn::Output(output) => outputs[output].value_si[index],
                ComputedColumn::State(state) => states.rows[index][state],
            };
            let difference = (value_si - row[column]).abs();
            if difference.is_nan() {
                return f64::NAN;
            }
            largest = largest.max(difference);
        }
    }
    largest
}
