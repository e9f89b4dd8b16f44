//! The mechanism that was measured: rows of a joint sample in place of the distributions of the random inputs.

use crate::file::description::{Correlation, SpecimenRows};
use crate::file::measurements::specimen_problem::SpecimenProblem;
use crate::file::problem::StudyProblem;
use crate::file::reader::{StudyReader, adopt};
use crate::file::study::Study;
use loosepin_math::sort_ascending;
use loosepin_mechanics::model::QuantityId;
use loosepin_simulate::accuracy::ScatterCorrelation;
use loosepin_simulate::measured::{JointColumn, JointSample};
use loosepin_text::diagnostics::{Diagnostic, Span, nearest_name};
use loosepin_text::document::{Entry, Kind, Reads, read_beside};
use loosepin_text::record;
use loosepin_uncertainty::{Copula, Distribution, EmpiricalCopula, RandomVariable, sample_correlation};
use std::collections::HashMap;
use std::sync::Arc;

/// Rows that a joint sample has, at least: an end of what 95 % of mechanisms do rests on 2.5 % of them.
pub const MIN_ROWS: usize = 100;

record! {
    /// mechanisms that agree with the measurements
    pub(crate) lenient struct SpecimenTable for Reads;
    /// a CSV file, relative to the folder of this file: a column for each random input, named by its path with its unit; all rows are
    /// equally probable
    required mechanisms: Entry<'t> = Kind::Text, "\"narrowed-specimen.csv\"";
}

impl StudyReader {
    /// Replaces the distributions of the `random` inputs by the rows of `[specimen]`, where that is there; `correlation` is that of the file.
    pub(crate) fn read_specimen(
        &mut self,
        [written, random]: [Option<&Entry<'_>>; 2],
        correlation: Option<Correlation>,
    ) -> (Option<Correlation>, Option<SpecimenRows>) {
        let Some(entry) = written else { return (correlation, None) };
        match self.rows_of_specimen(entry, random) {
            Some((copula, rows)) => (Some(Correlation { stated: Vec::new(), copula }), Some(rows)),
            None => (correlation, None),
        }
    }

    fn rows_of_specimen(&mut self, entry: &Entry<'_>, random: Option<&Entry<'_>>) -> Option<(Copula, SpecimenRows)> {
        let written = SpecimenTable::read(self, entry)?.mechanisms?;
        let file = self.reader.text(&written)?.to_owned();
        let sample = match read_beside(&self.reader.source, &file).and_then(JointSample::from_source) {
            Ok(sample) => sample,
            Err(diagnostics) => {
                adopt(&mut self.reader, &diagnostics, written.span);
                return None;
            }
        };
        self.tables.push(Arc::clone(&sample.source));
        if self.reader.diagnostics.has_errors() {
            // A random input that could not be read would be a column too many.
            return None;
        }
        self.refuse_beside_rows(random);
        let order = self.columns_of(&sample, &file, &written)?;
        let count = sample.rows_si.len();
        if count < MIN_ROWS {
            let problem = SpecimenProblem::FewRows { found: count, least: MIN_ROWS };
            self.reader.diagnostics.push(Diagnostic::error(&problem, Some(sample.header_place())));
            return None;
        }
        let rows: Vec<Vec<f64>> =
            sample.rows_si.iter().map(|row| order.iter().map(|column| row[*column]).collect()).collect();
        self.check_rows(&sample, &rows)?;
        let variables: Option<Vec<RandomVariable>> =
            (0..self.random.len()).map(|input| self.variable_of(&rows, input, &sample, &order)).collect();
        let copula = EmpiricalCopula::new(&rows)?;
        let effective = effective_rows(&rows);
        for (input, variable) in self.random.iter_mut().zip(variables?) {
            input.variable = variable;
            input.origin = Some(format!(
                "of the measured specimen, rows of {file} drawn whole, which say as much as {} mechanisms",
                effective.floor()
            ));
        }
        let place = self.reader.place(written.span);
        let problem = SpecimenProblem::Finite { rows: count, effective };
        self.reader.diagnostics.push(Diagnostic::warning(&problem, Some(place)));
        Some((Copula::Empirical(copula), SpecimenRows { file, rows_si: rows, effective }))
    }

    /// Refuses what has no answer for a joint sample.
    fn refuse_beside_rows(&mut self, random: Option<&Entry<'_>>) {
        if let Some(input) = self.random.iter().find(|input| !input.parameters.is_empty()) {
            let path = input.path.clone();
            let span = random.and_then(|table| table.get(&path)).map_or(Span::default(), |entry| entry.span);
            self.reader.report(&SpecimenProblem::UncertainParameter { path }, span);
        }
    }

    /// Refuses a surrogate beside a joint sample.
    pub(crate) fn refuse_surrogate(&mut self, written: Option<&Entry<'_>>) {
        let span = written.map(|entry| entry.key_span).unwrap_or_default();
        self.reader.report(&SpecimenProblem::Beside { what: "a surrogate" }, span);
    }

    /// Column of each random input.
    fn columns_of(&mut self, sample: &JointSample, file: &str, written: &Entry<'_>) -> Option<Vec<usize>> {
        let known = self.random.iter().filter(|input| input.quantity().is_some());
        let known: Vec<String> = known.map(|input| input.path.clone()).collect();
        if known.is_empty() {
            return self.refused(&SpecimenProblem::NothingRandom, written.span);
        }
        let mut is_right = !self.reader.diagnostics.has_errors();
        for column in &sample.columns {
            let due = self.random.iter().find(|input| input.path == column.name);
            let problem = match due {
                None => SpecimenProblem::UnknownColumn {
                    name: column.name.clone(),
                    nearest: nearest_name(&column.name, known.iter().map(String::as_str)).map(str::to_owned),
                },
                Some(input) if input.dimension(&self.model) != column.dimension => SpecimenProblem::ColumnDimension {
                    name: column.name.clone(),
                    found: column.dimension,
                    due: input.dimension(&self.model),
                },
                Some(_) => continue,
            };
            is_right = false;
            self.reader.diagnostics.push(Diagnostic::error(&problem, Some(sample.column_place(column))));
        }
        let column_of = |path: &String| sample.columns.iter().position(|column: &JointColumn| column.name == *path);
        let order: Vec<Option<usize>> = known.iter().map(column_of).collect();
        for (path, column) in known.iter().zip(&order) {
            if column.is_none() {
                is_right = false;
                let problem = SpecimenProblem::NoColumn { path: path.clone(), file: file.to_owned() };
                self.reader.diagnostics.push(Diagnostic::error(&problem, Some(sample.header_place())));
            }
        }
        if is_right { order.into_iter().collect() } else { None }
    }

    /// Refuses rows that are no mechanism of the model at the lower ends, the middles and the upper ends of the epistemic inputs alike.
    fn check_rows(&mut self, sample: &JointSample, rows: &[Vec<f64>]) -> Option<()> {
        let quantities = &self.model.quantities();
        let mut values = quantities.nominal();
        let others = |fraction: f64| -> Vec<(QuantityId, f64)> {
            let epistemic = self.epistemic.iter();
            epistemic.filter_map(|input| Some((input.quantity()?, input.variable.at(fraction)))).collect()
        };
        let others: Vec<Vec<(QuantityId, f64)>> = [0.0, 0.5, 1.0].map(others).to_vec();
        let mut impossible = Vec::new();
        for (row, row_si) in rows.iter().enumerate() {
            let mut last = None;
            for set in &others {
                let mut set = set.clone();
                let of_row = self.random.iter().zip(row_si);
                set.extend(of_row.filter_map(|(input, &value_si)| Some((input.quantity()?, value_si))));
                match quantities.evaluate_into(&set, &mut values) {
                    Ok(()) => {
                        last = None;
                        break;
                    }
                    Err(error) => last = Some(error),
                }
            }
            impossible.extend(last.map(|error| (row, error)));
        }
        let Some((row, error)) = impossible.first().cloned() else { return Some(()) };
        let problem = SpecimenProblem::ImpossibleRow { rows: impossible.len(), error };
        self.reader.diagnostics.push(Diagnostic::error(&problem, Some(sample.row_place(row))));
        None
    }

    fn variable_of(
        &mut self,
        rows: &[Vec<f64>],
        input: usize,
        sample: &JointSample,
        order: &[usize],
    ) -> Option<RandomVariable> {
        let mut values: Vec<f64> = rows.iter().map(|row| row[input]).collect();
        sort_ascending(&mut values);
        match RandomVariable::try_new(Distribution::Empirical { values: values.into() }) {
            Ok(variable) => Some(variable),
            Err(error) => {
                let own = &self.random[input];
                let (path, dimension) = (&own.path, own.dimension(&self.model));
                let problem = StudyProblem::Distribution { entry: format!("column '{path}'"), error, dimension };
                let place = sample.column_place(&sample.columns[order[input]]);
                self.reader.diagnostics.push(Diagnostic::error(&problem, Some(place)));
                None
            }
        }
    }
}

impl Study {
    /// Linear correlations of the columns of the rows of a specimen; empty for inputs given by distributions.
    pub(crate) fn correlations_of_rows(&self) -> Vec<ScatterCorrelation> {
        let Some(rows) = &self.specimen else { return Vec::new() };
        let inputs = self.random.len();
        let column = |input: usize| rows.rows_si.iter().map(|row| row[input]).collect::<Vec<f64>>();
        let columns: Vec<Vec<f64>> = (0..inputs).map(column).collect();
        let pairs = (0..inputs).flat_map(|second| (0..second).map(move |first| (first, second)));
        pairs
            .filter_map(|(first, second)| {
                Some(ScatterCorrelation {
                    first: self.random[first].quantity()?,
                    second: self.random[second].quantity()?,
                    linear: sample_correlation(&columns[first], &columns[second]),
                })
            })
            .collect()
    }
}

/// Number of different rows, equally probable, that say as much: n²/Σ m², where a row is there m times.
fn effective_rows(rows: &[Vec<f64>]) -> f64 {
    let mut times: HashMap<Vec<u64>, f64> = HashMap::new();
    for row in rows {
        *times.entry(row.iter().map(|value| value.to_bits()).collect()).or_default() += 1.0;
    }
    let count = rows.len() as f64;
    // Whole numbers: their sum has the same bits in any order.
    count * count / times.values().map(|times| times * times).sum::<f64>()
}

#[cfg(test)]
mod tests {
    use super::effective_rows;

    #[test]
    fn analytic_rows_that_are_repeated_count_once() {
        let rows = |times: &[usize]| -> Vec<Vec<f64>> {
            times.iter().enumerate().flat_map(|(k, times)| vec![vec![k as f64, -1.0]; *times]).collect()
        };
        assert_eq!(effective_rows(&rows(&[1; 8])), 8.0);
        assert_eq!(effective_rows(&rows(&[2; 8])), 8.0);
        // 100/(36 + 16).
        assert_eq!(effective_rows(&rows(&[6, 4])), 100.0 / 52.0);
    }
}
