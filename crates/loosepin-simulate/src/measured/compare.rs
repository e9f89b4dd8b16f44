//! A measured table over the histories of a run.

use std::f64::consts::TAU;

use super::between::interpolated;
use super::problem::MeasuredProblem;
use super::table::MeasuredTable;
use loosepin_result::simulation::{Abscissa, MeasuredCurve, SimulationRecord};
use loosepin_text::diagnostics::{Diagnostic, Diagnostics, Place};
use loosepin_text::units::{Dimension, format_apart};

/// Round-off of the ends of a record, as a share of its length.
const ROUND_OFF: f64 = 1e-9;

/// Adds the columns of `table` to the record, each with the computed values at the same places and the residual:
///
/// ```text
/// residual = measured - computed,   rms = √(Σ residual²/n)
/// ```
///
/// Computed values are interpolated linearly between the rows of the history, which errs by (2π k/samples)²/8 of the k-th
/// harmonic: 2e-5 of the first at 500 samples a turn. Times count from the start of the run. Angles are those of the drive,
/// moved by whole turns as one so that the first of them lies in the first recorded turn.
///
/// # Errors
/// A row outside what was recorded.
pub fn compare_with_measured(table: &MeasuredTable, record: &mut SimulationRecord) -> Result<(), Diagnostics> {
    let (axis, at_si) = match table.abscissa {
        Abscissa::Time => (record.time_s.clone(), table.at_si.clone()),
        Abscissa::DriveAngle => {
            let axis = record.drive_angle_rad.clone();
            let at_si = moved_by_turns(&table.at_si, &axis);
            (axis, at_si)
        }
    };
    check_range(table, &axis, &at_si)?;
    for column in &table.columns {
        let Some(output) = record.outputs.iter().find(|output| column.is_of(&output.name)) else { continue };
        let mut curve = MeasuredCurve {
            file: table.file().to_owned(),
            output: output.name.clone(),
            unit: output.unit.clone(),
            abscissa: table.abscissa,
            at_si: Vec::new(),
            measured_si: Vec::new(),
            computed_si: Vec::new(),
            rms_si: f64::NAN,
            largest_si: f64::NAN,
            largest_at_si: f64::NAN,
        };
        let mut squares = 0.0;
        for (&at, &measured) in at_si.iter().zip(&column.values_si).filter(|(_, value)| value.is_finite()) {
            let computed = interpolated(&axis, &output.value_si, at);
            let residual = measured - computed;
            squares += residual * residual;
            if curve.largest_si.is_nan() || residual.abs() > curve.largest_si.abs() {
                (curve.largest_si, curve.largest_at_si) = (residual, at);
            }
            curve.at_si.push(at);
            curve.measured_si.push(measured);
            curve.computed_si.push(computed);
        }
        curve.rms_si = (squares / curve.at_si.len() as f64).sqrt();
        record.measured.push(curve);
    }
    Ok(())
}

/// The angles moved by the whole turns that bring the first of them into the first turn of `axis`. Where the drive turns
/// backwards, its first turn lies below its start.
fn moved_by_turns(at_rad: &[f64], axis: &[f64]) -> Vec<f64> {
    let (Some(&first), Some(&start), Some(&end)) = (at_rad.first(), axis.first(), axis.last()) else {
        return at_rad.to_vec();
    };
    let turns = if end >= start {
        ((start - first) / TAU - ROUND_OFF).ceil()
    } else {
        let last = at_rad[at_rad.len() - 1];
        ((start - last) / TAU + ROUND_OFF).floor()
    };
    at_rad.iter().map(|at| at + turns * TAU).collect()
}

fn check_range(table: &MeasuredTable, axis: &[f64], at_si: &[f64]) -> Result<(), Diagnostics> {
    let (Some(&start), Some(&end)) = (axis.first(), axis.last()) else { return Ok(()) };
    let (from, to) = (start.min(end), start.max(end));
    let margin = ROUND_OFF * (to - from);
    let outside = |at: &f64| *at < from - margin || *at > to + margin;
    let Some(row) = at_si.iter().position(outside) else { return Ok(()) };
    let dimension = match table.abscissa {
        Abscissa::Time => Dimension::TIME,
        Abscissa::DriveAngle => Dimension::ANGLE,
    };
    let is_early_time = table.abscissa == Abscissa::Time && at_si[row] < from;
    let [found, from, to] = format_apart([at_si[row], from, to], dimension);
    let problem = MeasuredProblem::OutsideRecord { name: table.name.clone(), found, from, to, is_early_time };
    Err(Diagnostic::error(&problem, Some(Place::new(&table.source, table.places[row]))).into())
}
