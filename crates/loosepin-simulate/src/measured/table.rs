//! From the text of a table to SI numbers, with all diagnostics at once.

use std::path::Path;
use std::sync::Arc;

use super::between::interpolated;
use super::problem::MeasuredProblem;
use loosepin_result::simulation::Abscissa;
use loosepin_text::diagnostics::{Diagnostic, Diagnostics, Place, Source, Span, nearest_name};
use loosepin_text::document::read_source;
use loosepin_text::units::{Dimension, SiUnit, parse_unit};

/// A table of measured values: one instant or angle a row, one output a column, in SI.
#[derive(Debug, Clone)]
pub struct MeasuredTable {
    /// Meaning of the first column.
    pub abscissa: Abscissa,
    /// Its name in the header.
    pub name: String,
    /// Its values, s or rad, increasing.
    pub at_si: Vec<f64>,
    /// The other columns, in the order of the file.
    pub columns: Vec<MeasuredColumn>,
    pub(super) source: Arc<Source>,
    /// Span of each value of the first column.
    pub(super) places: Vec<Span>,
}

/// One measured quantity.
#[derive(Debug, Clone)]
pub struct MeasuredColumn {
    /// Name of the output that it is to be held against.
    pub name: String,
    /// Its dimension.
    pub dimension: Dimension,
    /// Its values, SI; NaN if the cell is empty.
    pub values_si: Vec<f64>,
    /// Place of its header.
    pub(super) place: Span,
}

impl MeasuredColumn {
    /// Whether it was measured of this output. The two columns of a path, `tracer x` and `tracer y`, may be written with `_` as
    /// in `history.csv`.
    pub fn is_of(&self, output: &str) -> bool {
        self.name == output || self.name == output.replace(' ', "_")
    }
}

/// A cell of the header.
pub(super) struct Header {
    pub name: String,
    /// One unit in SI.
    pub factor_si: f64,
    pub dimension: Dimension,
    pub place: Span,
}

/// A row: its cells without the blanks around them, each with its place.
pub(super) struct Row {
    /// Start in the text.
    pub start: usize,
    pub cells: Vec<(String, Span)>,
}

/// A table in the making.
pub(super) struct TableReader {
    pub source: Arc<Source>,
    pub diagnostics: Diagnostics,
}

impl MeasuredTable {
    /// Reads a table: comma-separated, UTF-8, a header `name [unit]` for each column, the first of them a time or an angle of the
    /// drive, numbers below it. An empty cell is a value that was not measured.
    ///
    /// # Errors
    /// Everything that is wrong with it, each with its place.
    pub fn from_path(path: &Path) -> Result<Self, Diagnostics> {
        Self::from_source(&read_source(path)?)
    }

    /// Reads a table from text that is reported as `name`.
    ///
    /// # Errors
    /// As [`Self::from_path`].
    pub fn from_text(name: &str, text: &str) -> Result<Self, Diagnostics> {
        Self::from_source(&Source::new(name, text))
    }

    /// Reads a table from a source that was read already.
    ///
    /// # Errors
    /// As [`Self::from_path`].
    pub fn from_source(source: &Arc<Source>) -> Result<Self, Diagnostics> {
        let mut reader = TableReader { source: Arc::clone(source), diagnostics: Diagnostics::new() };
        let table = reader.table();
        match table {
            Some(table) if !reader.diagnostics.has_errors() => Ok(table),
            _ => Err(reader.diagnostics),
        }
    }

    /// Value of one of its columns at `at`, on the line between its rows; that of the first or the last row outside.
    pub fn value(&self, column: &MeasuredColumn, at: f64) -> f64 {
        interpolated(&self.at_si, &column.values_si, at)
    }

    /// The text of the file.
    pub fn text(&self) -> &str {
        self.source.text()
    }

    /// The file.
    pub fn source(&self) -> &Source {
        &self.source
    }

    /// The name that the file is reported by.
    pub fn file(&self) -> &str {
        self.source.name()
    }

    /// Whether every column is one of `outputs`, names with SI units.
    ///
    /// # Errors
    /// Each column that is none, or measures something else.
    pub fn check(&self, outputs: &[(&str, &SiUnit)]) -> Result<(), Diagnostics> {
        let mut diagnostics = Diagnostics::new();
        for column in &self.columns {
            let name = column.name.clone();
            let problem = match outputs.iter().find(|(output, _)| column.is_of(output)) {
                None => {
                    let known: Vec<String> = outputs.iter().map(|(name, _)| (*name).to_owned()).collect();
                    let nearest = nearest_name(&name, outputs.iter().map(|(name, _)| *name)).map(str::to_owned);
                    MeasuredProblem::UnknownOutput { name, nearest, known }
                }
                Some((_, unit)) if **unit != SiUnit::of_dimension(column.dimension) => {
                    let due = format!("in {}", unit.symbol());
                    MeasuredProblem::OtherDimension { name, found: column.dimension, due }
                }
                Some(_) => continue,
            };
            diagnostics.push(Diagnostic::error(&problem, Some(Place::new(&self.source, column.place))));
        }
        if diagnostics.is_empty() { Ok(()) } else { Err(diagnostics) }
    }
}

impl TableReader {
    pub fn report(&mut self, problem: &MeasuredProblem, place: Span) {
        let place = Place::new(&self.source, place);
        self.diagnostics.push(Diagnostic::error(problem, Some(place)));
    }

    fn table(&mut self) -> Option<MeasuredTable> {
        let source = Arc::clone(&self.source);
        let mut rows = self.rows()?.into_iter();
        let headers = self.headers(&rows.next()?.cells)?;
        let (first, others) = headers.split_first()?;
        let abscissa = match first.dimension {
            found if found == Dimension::TIME => Abscissa::Time,
            found if found == Dimension::ANGLE => Abscissa::DriveAngle,
            found => {
                self.report(&MeasuredProblem::FirstColumn { name: first.name.clone(), found }, first.place);
                return None;
            }
        };
        if others.is_empty() {
            self.report(&MeasuredProblem::NothingMeasured { name: first.name.clone() }, first.place);
        }
        let (mut at_si, mut places) = (Vec::new(), Vec::new());
        let mut values_si = vec![Vec::new(); others.len()];
        let mut before: Option<(f64, String)> = None;
        for row in rows {
            if !self.has_length(&row, headers.len()) {
                continue;
            }
            let cells = row.cells;
            let Some(at) = self.number(&cells[0]) else { continue };
            if let Some((_, written)) = before.as_ref().filter(|(last, _)| at <= *last) {
                let (found, before) = (cells[0].0.clone(), written.clone());
                let problem = MeasuredProblem::NotIncreasing { name: first.name.clone(), found, before };
                self.report(&problem, cells[0].1);
            }
            before = Some((at, cells[0].0.clone()));
            at_si.push(at * first.factor_si);
            places.push(cells[0].1);
            for ((cell, values), header) in cells[1..].iter().zip(&mut values_si).zip(others) {
                let value = if cell.0.is_empty() { Some(f64::NAN) } else { self.number(cell) };
                values.push(value.unwrap_or(f64::NAN) * header.factor_si);
            }
        }
        if at_si.is_empty() && !self.diagnostics.has_errors() {
            self.report(&MeasuredProblem::Empty { what: "row below its header" }, first.place);
        }
        let columns = others.iter().zip(values_si).map(|(header, values_si)| MeasuredColumn {
            name: header.name.clone(),
            dimension: header.dimension,
            values_si,
            place: header.place,
        });
        let columns = columns.collect();
        Some(MeasuredTable { abscissa, name: first.name.clone(), at_si, columns, source, places })
    }

    /// All rows, that of the header first; `None` if there is none.
    pub fn rows(&mut self) -> Option<Vec<Row>> {
        let source = Arc::clone(&self.source);
        // A byte order mark is no part of the first name.
        let start = if source.text().starts_with('\u{feff}') { '\u{feff}'.len_utf8() } else { 0 };
        let text = &source.text()[start..];
        let first_line = text.lines().find(|line| !line.trim().is_empty()).unwrap_or_default();
        if first_line.contains(';') && !first_line.contains(',') {
            let line = text.lines().map(str::trim).filter(|line| !line.is_empty()).nth(1).unwrap_or(first_line.trim());
            let (line, meant) = (line.to_owned(), line.replace(',', ".").replace(';', ","));
            let at = start + text.find(first_line).unwrap_or(0);
            self.report(&MeasuredProblem::Semicolons { line, meant }, (at..at + first_line.len()).into());
            return None;
        }
        let mut records = csv::ReaderBuilder::new().has_headers(false).flexible(true).from_reader(text.as_bytes());
        let mut rows = Vec::new();
        for record in records.records() {
            match record {
                Ok(record) => {
                    // A record is said to begin where the one before ends, be it amid a line break or before empty lines.
                    let after = start + record.position().map_or(0, |position| position.byte() as usize);
                    let rest = &source.text()[after..];
                    let start = after + rest.len() - rest.trim_start_matches(['\r', '\n']).len();
                    rows.push(Row { start, cells: self.cells(&record, start) });
                }
                Err(error) => {
                    let place = error.position().map_or(0, |position| position.byte() as usize);
                    let problem = MeasuredProblem::NoTable { reason: error.to_string() };
                    self.report(&problem, (place..place + 1).into());
                    return None;
                }
            }
        }
        if rows.is_empty() {
            self.report(&MeasuredProblem::Empty { what: "header" }, Span::default());
            return None;
        }
        Some(rows)
    }

    /// Whether a row has as many cells as the header; reports where it has not.
    pub fn has_length(&mut self, row: &Row, due: usize) -> bool {
        let found = row.cells.len();
        if found != due {
            let is_comment = row.cells.first().is_some_and(|(text, _)| text.starts_with('#'));
            let problem = if is_comment { MeasuredProblem::Comment } else { MeasuredProblem::RowLength { found, due } };
            let end = row.cells.last().map_or(row.start, |(_, place)| place.end);
            self.report(&problem, Span { start: row.start, end });
        }
        found == due
    }

    pub fn headers(&mut self, cells: &[(String, Span)]) -> Option<Vec<Header>> {
        let headers: Vec<Option<Header>> = cells.iter().map(|cell| self.header(cell)).collect();
        let headers = headers.into_iter().collect::<Option<Vec<Header>>>()?;
        for (index, header) in headers.iter().enumerate() {
            if headers[..index].iter().any(|earlier| earlier.name == header.name) {
                self.report(&MeasuredProblem::ColumnTwice { name: header.name.clone() }, header.place);
            }
        }
        Some(headers)
    }

    pub fn header(&mut self, (text, place): &(String, Span)) -> Option<Header> {
        let parts = text.strip_suffix(']').and_then(|text| text.split_once('['));
        let Some((name, unit)) = parts.filter(|(name, unit)| !name.trim().is_empty() && !unit.contains(['[', ']']))
        else {
            self.report(&MeasuredProblem::NoUnit { text: text.clone() }, *place);
            return None;
        };
        let unit = if unit.trim() == "1" { "" } else { unit };
        match parse_unit(unit) {
            Ok(measured) => Some(Header {
                name: name.trim().to_owned(),
                factor_si: measured.value_si,
                dimension: measured.dimension,
                place: *place,
            }),
            Err(error) => {
                self.report(&MeasuredProblem::Unit(error.problem), *place);
                None
            }
        }
    }

    /// The cells of a row without the blanks around them, each with its place.
    fn cells(&self, record: &csv::StringRecord, first: usize) -> Vec<(String, Span)> {
        let text = self.source.text();
        let line_end = text[first.min(text.len())..].find(['\n', '\r']).map_or(text.len(), |length| first + length);
        let line = &text[first.min(line_end)..line_end];
        // Where cells are quoted their places are not told apart.
        let is_plain =
            !line.contains('"') && record.iter().map(str::len).sum::<usize>() + record.len() == line.len() + 1;
        let mut start = first;
        record
            .iter()
            .map(|cell| {
                let trimmed = cell.trim();
                let begin = start + (cell.len() - cell.trim_start().len());
                start += cell.len() + 1;
                let place = if is_plain { begin..begin + trimmed.len() } else { first..line_end };
                (trimmed.to_owned(), place.into())
            })
            .collect()
    }

    pub fn number(&mut self, (text, place): &(String, Span)) -> Option<f64> {
        let value = text.parse().ok().filter(|value: &f64| value.is_finite());
        if value.is_none() {
            self.report(&MeasuredProblem::NotANumber { text: text.clone() }, *place);
        }
        value
    }
}
