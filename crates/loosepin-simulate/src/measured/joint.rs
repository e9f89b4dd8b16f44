//! A joint sample: a table whose columns belong together row by row.

use std::sync::Arc;

use super::problem::MeasuredProblem;
use super::table::{Header, TableReader};
use loosepin_text::diagnostics::{Diagnostics, Place, Source, Span};
use loosepin_text::units::Dimension;

/// Rows of values of several quantities, SI, none of them empty.
#[derive(Debug, Clone)]
pub struct JointSample {
    /// The columns, in the order of the file.
    pub columns: Vec<JointColumn>,
    /// The values of each row, in the order of the columns.
    pub rows_si: Vec<Vec<f64>>,
    /// The whole file.
    pub source: Arc<Source>,
    row_places: Vec<Span>,
    header_place: Span,
}

/// A column of a joint sample.
#[derive(Debug, Clone)]
pub struct JointColumn {
    /// Its name in the header.
    pub name: String,
    /// Its dimension.
    pub dimension: Dimension,
    place: Span,
}

impl JointSample {
    /// The joint sample of a table: comma-separated, UTF-8, its header written `name [unit]` for each column, a number in every cell below.
    ///
    /// # Errors
    /// Everything that is wrong with it, each with its place.
    pub fn from_source(source: Arc<Source>) -> Result<Self, Diagnostics> {
        let mut reader = TableReader { source: Arc::clone(&source), diagnostics: Diagnostics::new() };
        match reader.joint() {
            Some(sample) if !reader.diagnostics.has_errors() => Ok(sample),
            _ => Err(reader.diagnostics),
        }
    }

    /// Place of a row.
    pub fn row_place(&self, row: usize) -> Place {
        Place::new(&self.source, self.row_places.get(row).copied().unwrap_or(self.header_place))
    }

    /// Place of the header of a column.
    pub fn column_place(&self, column: &JointColumn) -> Place {
        Place::new(&self.source, column.place)
    }

    /// Place of the whole header.
    pub fn header_place(&self) -> Place {
        Place::new(&self.source, self.header_place)
    }
}

impl TableReader {
    fn joint(&mut self) -> Option<JointSample> {
        let source = Arc::clone(&self.source);
        let mut rows = self.rows()?.into_iter();
        let headers = self.headers(&rows.next()?.cells)?;
        let header_place = Span { start: headers.first()?.place.start, end: headers.last()?.place.end };
        let (mut rows_si, mut row_places) = (Vec::new(), Vec::new());
        for row in rows {
            if !self.has_length(&row, headers.len()) {
                continue;
            }
            let mut values_si = Vec::with_capacity(headers.len());
            for (cell, header) in row.cells.iter().zip(&headers) {
                if cell.0.is_empty() {
                    self.report(&MeasuredProblem::EmptyCell { name: header.name.clone() }, cell.1);
                } else {
                    values_si.extend(self.number(cell).map(|value| value * header.factor_si));
                }
            }
            let end = row.cells.last().map_or(row.start, |(_, place)| place.end);
            rows_si.push(values_si);
            row_places.push(Span { start: row.start, end });
        }
        if rows_si.is_empty() && !self.diagnostics.has_errors() {
            self.report(&MeasuredProblem::Empty { what: "row below its header" }, header_place);
        }
        let column =
            |header: Header| JointColumn { name: header.name, dimension: header.dimension, place: header.place };
        let columns = headers.into_iter().map(column).collect();
        Some(JointSample { columns, rows_si, source, row_places, header_place })
    }
}
