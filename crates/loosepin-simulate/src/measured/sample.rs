//! One column of a table: values of one quantity, measured on many parts.

use std::sync::Arc;

use super::problem::MeasuredProblem;
use super::table::TableReader;
use loosepin_text::diagnostics::{Diagnostics, Source, Span, nearest_name};
use loosepin_text::units::Dimension;

/// Measured values of one quantity, SI, in the order of the rows.
#[derive(Debug, Clone)]
pub struct SampleColumn {
    /// Its name in the header.
    pub name: String,
    /// Its dimension.
    pub dimension: Dimension,
    /// The values; rows with an empty cell are left out.
    pub values_si: Vec<f64>,
    /// The whole file.
    pub source: Arc<Source>,
}

impl SampleColumn {
    /// Reads the column called `name` (the only one, where no name is given) of a table: comma-separated, UTF-8, its header
    /// written `name [unit]`, numbers below it. The other columns may hold anything.
    ///
    /// # Errors
    /// Everything that is wrong with it, each with its place.
    pub fn from_source(source: Arc<Source>, name: Option<&str>) -> Result<Self, Diagnostics> {
        let mut reader = TableReader { source: Arc::clone(&source), diagnostics: Diagnostics::new() };
        match reader.sample(name) {
            Some(column) if !reader.diagnostics.has_errors() => Ok(column),
            _ => Err(reader.diagnostics),
        }
    }
}

impl TableReader {
    fn sample(&mut self, name: Option<&str>) -> Option<SampleColumn> {
        let source = Arc::clone(&self.source);
        let mut rows = self.rows()?.into_iter();
        let cells = rows.next()?.cells;
        let place = self.place_of(&cells, name)?;
        let header = self.header(&cells[place])?;
        let mut values_si = Vec::new();
        for row in rows {
            if self.has_length(&row, cells.len()) && !row.cells[place].0.is_empty() {
                values_si.extend(self.number(&row.cells[place]).map(|value| value * header.factor_si));
            }
        }
        if values_si.is_empty() && !self.diagnostics.has_errors() {
            self.report(&MeasuredProblem::NoValue { name: header.name.clone() }, header.place);
        }
        Some(SampleColumn { name: header.name, dimension: header.dimension, values_si, source })
    }

    /// Which cell of the header is called `name`.
    fn place_of(&mut self, cells: &[(String, Span)], name: Option<&str>) -> Option<usize> {
        let known: Vec<&str> =
            cells.iter().map(|(text, _)| text.split('[').next().unwrap_or_default().trim()).collect();
        let whole = Span { start: cells.first()?.1.start, end: cells.last()?.1.end };
        let Some(name) = name else {
            if cells.len() == 1 {
                return Some(0);
            }
            let known = known.into_iter().map(str::to_owned).collect();
            self.report(&MeasuredProblem::WhichColumn { known }, whole);
            return None;
        };
        let mut places = known.iter().enumerate().filter(|(_, known)| **known == name).map(|(place, _)| place);
        match (places.next(), places.next()) {
            (Some(place), None) => Some(place),
            (Some(_), Some(second)) => {
                self.report(&MeasuredProblem::ColumnTwice { name: name.to_owned() }, cells[second].1);
                None
            }
            (None, _) => {
                let nearest = nearest_name(name, known.iter().copied()).map(str::to_owned);
                let known = known.into_iter().map(str::to_owned).collect();
                self.report(&MeasuredProblem::NoColumn { name: name.to_owned(), nearest, known }, whole);
                None
            }
        }
    }
}
