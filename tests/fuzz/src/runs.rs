//! Reads `runs.parquet`: a table whose columns have one length, and which is read back as it is written, or a refusal.

use loosepin::study::files::{read_runs_parquet, runs_parquet};

/// Reads the bytes of a file of runs.
pub fn read(bytes: &[u8]) {
    let Ok(table) = read_runs_parquet(bytes) else { return };
    let rows = table.columns.first().map_or(0, |column| column.data.len());
    assert!(table.columns.iter().all(|column| column.data.len() == rows), "columns of several lengths");
    let written = runs_parquet(&table).expect("what was read can be written");
    let again = read_runs_parquet(&written).expect("what was written can be read");
    // Not-a-number is no equal of itself: the bytes are.
    assert!(runs_parquet(&again).expect("the same table") == written, "another table");
}
