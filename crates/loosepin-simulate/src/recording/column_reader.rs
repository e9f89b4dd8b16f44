//! Columns read inside a step, beside those of the ideal mechanism.

use crate::ideal::column::Column;
use crate::ideal::column_table::ColumnTable;
use crate::ideal::reference::IdealReference;
use crate::observer::Step;
use loosepin_mechanics::mechanism::{Arms, Mechanism, SampleError};
use loosepin_mechanics::model::Values;

/// Reads columns and their deviations. A series is a column, or behind all columns the deviation of one.
pub struct ColumnReader<'a> {
    pub columns: Vec<Column>,
    arms: Arms,
    pub reference: IdealReference<'a>,
    table: ColumnTable,
    /// Whether the table holds the present step.
    is_in_table: bool,
    with_forces: bool,
    /// Why the ideal mechanism could not be read.
    pub failure: Option<SampleError>,
}

/// How ideal values are read.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Ideal {
    /// Solved at the instant.
    Solved,
    /// From the table, where that holds the step.
    Tabled,
}

impl<'a> ColumnReader<'a> {
    /// Reads `columns` of `mechanism`; with forces and accelerations where these ask for them or `with_forces`. Steps take at most
    /// `longest_step_s`.
    pub fn new(
        (mechanism, values): (&Mechanism, &Values),
        columns: Vec<Column>,
        reference: IdealReference<'a>,
        with_forces: bool,
        longest_step_s: f64,
    ) -> Self {
        Self {
            arms: Arms::new(mechanism, values),
            reference,
            table: ColumnTable::new(longest_step_s),
            is_in_table: false,
            with_forces: with_forces || columns.iter().any(|column| column.reading.needs_forces()),
            failure: None,
            columns,
        }
    }

    /// Columns and deviations.
    pub fn series(&self) -> usize {
        2 * self.columns.len()
    }

    /// Makes a table of ideal values ready where that saves time over `step`.
    pub fn prepare_table(&mut self, step: &Step<'_, '_>) {
        self.is_in_table = false;
        if !self.reference.is_solved() {
            return;
        }
        let break_s = self.reference.next_break_s(0.5 * (step.start_s + step.end_s));
        let Self { columns, arms, reference, with_forces, .. } = self;
        let exact = |time_s: f64| {
            let ideal = reference.at(time_s, *with_forces)?;
            Ok(columns.iter().map(|column| column.reading.value(arms, ideal)).collect())
        };
        match self.table.holds([step.start_s, step.end_s], break_s, exact) {
            Ok(is_in_table) => self.is_in_table = is_in_table,
            Err(error) => self.fail(error),
        }
    }

    /// All series at `time_s` within the step.
    pub fn look(&mut self, step: &mut Step<'_, '_>, time_s: f64, ideal: Ideal) -> Vec<f64> {
        let dynamics = if self.with_forces { step.evaluate(time_s) } else { step.set_state(time_s) };
        let count = self.columns.len();
        let mut values = Vec::with_capacity(self.series());
        values.extend(self.columns.iter().map(|column| column.reading.value(&self.arms, dynamics)));
        if ideal == Ideal::Tabled && self.is_in_table {
            let weights = self.table.weights(time_s);
            values.extend_from_within(..count);
            for (column, deviation) in values[count..].iter_mut().enumerate() {
                *deviation -= self.table.value(&weights, column);
            }
            return values;
        }
        match self.reference.at(time_s, self.with_forces) {
            Ok(ideal) => {
                for (index, column) in self.columns.iter().enumerate() {
                    let ideal_si = column.reading.value(&self.arms, ideal);
                    values.push(values[index] - ideal_si);
                }
            }
            Err(error) => {
                self.fail(error);
                values.resize(2 * count, f64::NAN);
            }
        }
        values
    }

    /// One series at `time_s` within the step.
    pub fn look_at(&mut self, step: &mut Step<'_, '_>, time_s: f64, series: usize, ideal: Ideal) -> f64 {
        let index = series % self.columns.len();
        let column = &self.columns[index];
        let with_forces = column.reading.needs_forces();
        let dynamics = if with_forces { step.evaluate(time_s) } else { step.set_state(time_s) };
        let value_si = column.reading.value(&self.arms, dynamics);
        if series < self.columns.len() {
            return value_si;
        }
        if ideal == Ideal::Tabled && self.is_in_table {
            return value_si - self.table.value(&self.table.weights(time_s), index);
        }
        match self.reference.at(time_s, with_forces) {
            Ok(ideal) => value_si - column.reading.value(&self.arms, ideal),
            Err(error) => {
                self.fail(error);
                f64::NAN
            }
        }
    }

    fn fail(&mut self, error: SampleError) {
        self.failure.get_or_insert(error);
    }
}
