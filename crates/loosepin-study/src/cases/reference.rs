//! A file of rows that a run is held against.

use std::path::Path;
use std::sync::Arc;

use super::problem::CaseProblem;
use crate::file::adopt;
use loosepin_text::diagnostics::{Diagnostics, Place, Source, Span};
use loosepin_text::document::{Reader, read_source};

/// Rows at equal times, SI; the first column is the time.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Reference {
    /// Names of the columns, the time among them.
    pub columns: Vec<String>,
    /// The rows.
    pub rows: Vec<Vec<f64>>,
}

impl Reference {
    /// Reads a file of comma-separated numbers under a header.
    ///
    /// # Errors
    /// A file that cannot be read, a cell that is no number, a row of another length, fewer than two rows.
    pub fn from_path(path: &Path) -> Result<Reference, Diagnostics> {
        let source = read_source(path)?;
        let file = path.file_name().map(|name| name.to_string_lossy().into_owned()).unwrap_or_default();
        let mut lines = source.text().lines();
        let columns: Vec<String> = lines.next().unwrap_or_default().split(',').map(str::to_owned).collect();
        let rows = lines.map(|line| row(&source, line, columns.len())).collect::<Result<Vec<_>, _>>()?;
        let end_s = rows.last().map_or(0.0, |row: &Vec<f64>| row[0]);
        if rows.len() < 2 || !(end_s > 0.0) {
            let problem = CaseProblem::BadTimes { file, rows: rows.len(), end_s: end_s.to_string() };
            return Err(Diagnostics::one(&problem, Some(Place::new(&source, 0..0))));
        }
        Ok(Reference { columns, rows })
    }

    /// The last time, s.
    pub fn span_s(&self) -> f64 {
        self.rows.last().map_or(0.0, |row| row[0])
    }
}

/// Opens a file of rows; diagnostics without a place get that of its name.
pub(super) fn open_reference(reader: &mut Reader, folder: &Path, file: &str, span: Span) -> Option<Arc<Reference>> {
    match Reference::from_path(&folder.join(file)) {
        Ok(reference) => Some(Arc::new(reference)),
        Err(diagnostics) => {
            adopt(reader, &diagnostics, span);
            None
        }
    }
}

fn row(source: &Arc<Source>, line: &str, due: usize) -> Result<Vec<f64>, Diagnostics> {
    // A line is a part of the text: its place is where it begins in it.
    let start = line.as_ptr() as usize - source.text().as_ptr() as usize;
    let report = |problem: CaseProblem| Diagnostics::one(&problem, Some(Place::new(source, start..start + line.len())));
    let cells: Vec<&str> = line.split(',').collect();
    if cells.len() != due {
        return Err(report(CaseProblem::BadRow { found: cells.len(), due }));
    }
    let number = |cell: &&str| cell.parse().map_err(|_| report(CaseProblem::BadCell { cell: (*cell).to_owned() }));
    cells.iter().map(number).collect()
}
