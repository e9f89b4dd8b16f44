//! Numbers of runs, row by row.

use super::scratch::{FileRange, Scratch};

/// Numbers of the rows that are written to the scratch file together.
const NUMBERS_PER_PART: usize = 1 << 19;

/// Rows of the same length: the first ones in a scratch file where there is one, the last ones in memory.
#[derive(Debug, Clone, Default)]
pub(super) struct Rows {
    columns: usize,
    scratch: Option<Scratch>,
    /// Rows in each part, 0 without a file.
    rows_per_part: usize,
    parts: Vec<FileRange>,
    here: Vec<f64>,
}

impl Rows {
    /// No rows of `columns` numbers so far.
    pub fn new(columns: usize, scratch: Option<Scratch>) -> Self {
        let scratch = scratch.filter(|_| columns > 0);
        let rows_per_part = if scratch.is_some() { NUMBERS_PER_PART.div_ceil(columns) } else { 0 };
        Self { columns, scratch, rows_per_part, ..Self::default() }
    }

    /// Numbers of each row.
    pub fn columns(&self) -> usize {
        self.columns
    }

    /// The file, where there is one that takes more.
    pub fn scratch(&self) -> Option<&Scratch> {
        self.scratch.as_ref()
    }

    /// Looks for room for `rows` rows.
    pub fn reserve(&mut self, rows: usize) {
        let rows = if self.scratch.is_some() { rows.min(self.rows_per_part) } else { rows };
        let _ = self.here.try_reserve_exact(self.columns.saturating_mul(rows));
    }

    /// Adds a row, of [`Self::columns`] numbers.
    pub fn push(&mut self, row: impl Iterator<Item = f64>) {
        self.here.extend(row);
        let Some(scratch) = &self.scratch else { return };
        if self.here.len() >= self.rows_per_part * self.columns {
            match scratch.put(&self.here) {
                Ok(part) => {
                    self.parts.push(part);
                    self.here.clear();
                }
                // A file that is full takes no more: the rows from here on stay in memory.
                Err(_) => self.scratch = None,
            }
        }
    }

    /// The numbers of `row`.
    pub fn row(&self, row: usize) -> &[f64] {
        let away = self.parts.len() * self.rows_per_part;
        let (numbers, row) = match row.checked_sub(away) {
            Some(row) => (&self.here[..], row),
            None => (&self.parts[row / self.rows_per_part][..], row % self.rows_per_part),
        };
        &numbers[row * self.columns..(row + 1) * self.columns]
    }
}

#[cfg(test)]
mod tests {
    use super::super::scratch::Scratch;
    use super::{NUMBERS_PER_PART, Rows};

    #[test]
    fn identity_rows_in_a_file_are_those_in_memory() {
        let columns = 1000;
        let count = 5 * NUMBERS_PER_PART / (2 * columns);
        let scratch = Scratch::in_folder(&std::env::temp_dir()).expect("a file");
        let [mut here, mut away] = [None, Some(scratch)].map(|scratch| Rows::new(columns, scratch));
        away.reserve(count);
        for row in 0..count {
            let numbers = || (0..columns).map(|column| (row * columns + column) as f64);
            here.push(numbers());
            away.push(numbers());
        }
        assert_eq!((away.parts.len(), away.here.is_empty()), (2, false), "some in the file and some in memory");
        assert!((0..count).all(|row| here.row(row) == away.row(row)));
    }
}
