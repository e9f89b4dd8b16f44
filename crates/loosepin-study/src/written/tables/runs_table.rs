//! `runs.parquet`: one run a row.

use std::collections::{BTreeMap, BTreeSet};

use super::FilesError;
use super::arrow_schema::{ARROW_SCHEMA_KEY, arrow_schema};
use super::parquet::{self, Kind, ParquetError, ParquetFile};
use crate::runs::table::{RunColumn, RunData, RunsTable};
use loosepin_text::units::SiUnit;

/// Key of the file metadata that holds the unit of each column, as a JSON object.
const UNITS_KEY: &str = "units";

/// The runs as a Parquet file whose bytes depend on the table alone: no time stamp, fixed writer settings, no compression.
/// Units stand under the key `units` and in the field metadata of the Arrow schema; not-a-number is written as null.
///
/// # Errors
/// Columns of unequal length or of equal name, and texts that are too long for the format.
pub fn runs_parquet(table: &RunsTable) -> Result<Vec<u8>, FilesError> {
    check_columns(table)?;
    written(table, &format!("loosepin {}", loosepin_text::VERSION)).map_err(|source| FilesError::Parquet { source })
}

/// Reads what [`runs_parquet`] wrote, in this version or an earlier one; a null in a column of numbers becomes not-a-number.
///
/// # Errors
/// A compressed file, as older versions wrote it, other column types, and bytes that are not as they were written.
pub fn read_runs_parquet(bytes: &[u8]) -> Result<RunsTable, FilesError> {
    let refused = |source| FilesError::UnreadableRuns { source };
    let mut file = ParquetFile::open(bytes).map_err(refused)?;
    let mut columns = empty_columns(&file)?;
    for group in 0..file.groups() {
        for (index, column) in columns.iter_mut().enumerate() {
            if let Some(codec) = file.codec(group, index) {
                return Err(FilesError::CompressedRuns { codec: codec.to_owned() });
            }
            file.read(group, index, &mut column.data).map_err(refused)?;
        }
    }
    Ok(RunsTable { columns })
}

fn check_columns(table: &RunsTable) -> Result<(), FilesError> {
    let mut names = BTreeSet::new();
    let Some(first) = table.columns.first() else { return Ok(()) };
    for column in &table.columns {
        if column.data.len() != first.data.len() {
            return Err(FilesError::UnequalColumns {
                name: column.name.clone(),
                rows: column.data.len(),
                expected: first.data.len(),
                first: first.name.clone(),
            });
        }
        if !names.insert(column.name.as_str()) {
            return Err(FilesError::RepeatedColumn { name: column.name.clone() });
        }
    }
    Ok(())
}

fn written(table: &RunsTable, created_by: &str) -> Result<Vec<u8>, ParquetError> {
    let units: serde_json::Map<_, _> =
        table.columns.iter().map(|column| (column.name.clone(), column.unit.symbol().into())).collect();
    let entries =
        [(UNITS_KEY, serde_json::Value::from(units).to_string()), (ARROW_SCHEMA_KEY, arrow_schema(&table.columns))];
    parquet::write(table, &entries, created_by)
}

/// The columns that `file` announces, without rows.
fn empty_columns(file: &ParquetFile<'_>) -> Result<Vec<RunColumn>, FilesError> {
    let mut units: BTreeMap<String, String> = match file.entry(UNITS_KEY) {
        Some(text) => serde_json::from_str(text)
            .map_err(|source| FilesError::Layout { what: format!("'{UNITS_KEY}' of the runs"), source })?,
        None => BTreeMap::new(),
    };
    let columns = file.columns().iter().map(|column| {
        let name = column.name.clone();
        let data = match column.kind {
            Some(Kind::Double) => RunData::F64(Vec::new()),
            Some(Kind::Count) => RunData::U64(Vec::new()),
            Some(Kind::Text) => RunData::Text(Vec::new()),
            None => return Err(FilesError::ForeignColumn { name, stored: column.stored.clone() }),
        };
        let unit = units.remove(&name).map_or(SiUnit::NONE, SiUnit::from_symbol);
        Ok(RunColumn { name, unit, data })
    });
    columns.collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Written by the version of 30 November 2026, through the crate `parquet`: [`table`] of 65,600 rows.
    const EARLIER: &[u8] = include_bytes!(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/runs/earlier.parquet"));
    /// The same: the first 96 runs of a study.
    const EARLIER_STUDY: &[u8] =
        include_bytes!(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/runs/earlier_study.parquet"));

    /// A table with what is special in its first 40 rows.
    fn table(rows: usize) -> RunsTable {
        let special = [-0.0, f64::INFINITY, f64::NAN, f64::MIN_POSITIVE, f64::NEG_INFINITY, f64::MAX];
        let column = |name: &str, unit: SiUnit, data: RunData| RunColumn { name: name.to_owned(), unit, data };
        let number = |of: &dyn Fn(usize) -> f64| RunData::F64((0..rows).map(of).collect());
        let count = |of: &dyn Fn(usize) -> u64| RunData::U64((0..rows).map(of).collect());
        let text = |of: &dyn Fn(usize) -> String| RunData::Text((0..rows).map(|row| of(row).into()).collect());
        let root = |row: usize| if row.is_multiple_of(5) { f64::NAN } else { (row as f64).sqrt() };
        let of_first = |row: usize| [String::new(), "Spiel in µm".to_owned(), "long ".repeat(row)][row % 3].clone();
        let columns = vec![
            column("index", SiUnit::NONE, count(&|row| row as u64)),
            column("counts B2", SiUnit::NONE, count(&|row| if row < 40 { u64::MAX >> (row * 13 % 64) } else { 5 })),
            column("purpose", SiUnit::NONE, text(&|row| format!("mixed {}", row / 30_000))),
            column("law", SiUnit::NONE, text(&|row| if row < 40 { of_first(row) } else { "flores".to_owned() })),
            column("joint.B2.clearance", SiUnit::LENGTH, number(&|row| if row < 40 { root(row) } else { 0.25e-3 })),
            column("peak_force B2", SiUnit::FORCE, number(&|row| if row < 40 { special[row % 6] } else { f64::NAN })),
            column("missing", SiUnit::NONE, number(&|_| f64::NAN)),
            column("steps of a run", SiUnit::NONE, number(&|row| (row / 6000) as f64)),
        ];
        RunsTable { columns }
    }

    /// Whether two tables are the same, bit for bit; one not-a-number is as good as another.
    fn is_same(one: &RunsTable, other: &RunsTable) -> bool {
        let column = |(one, other): (&RunColumn, &RunColumn)| match (&one.data, &other.data) {
            (RunData::F64(own), RunData::F64(others)) => {
                let number = |(a, b): (&f64, &f64)| a.to_bits() == b.to_bits() || (a.is_nan() && b.is_nan());
                (&one.name, &one.unit, own.len()) == (&other.name, &other.unit, others.len())
                    && own.iter().zip(others).all(number)
            }
            _ => one == other,
        };
        one.columns.len() == other.columns.len() && one.columns.iter().zip(&other.columns).all(column)
    }

    #[test]
    fn pinned_files_of_earlier_versions_are_read() {
        let read = |bytes| read_runs_parquet(bytes).unwrap_or_else(|error| panic!("{error}"));
        assert!(is_same(&read(EARLIER), &table(65_600)));
        let study = read(EARLIER_STUDY);
        assert_eq!(study.columns.len(), 22);
        let again = runs_parquet(&study).unwrap_or_else(|error| panic!("{error}"));
        assert!(again.len() < EARLIER_STUDY.len());
        assert!(is_same(&read(&again), &study));
    }

    /// As pyarrow 26.0.1 reads the last row: `pq.read_table("earlier_study.parquet").to_pandas().iloc[95]`.
    #[test]
    fn peer_the_last_run_of_an_earlier_study() {
        let study = read_runs_parquet(EARLIER_STUDY).unwrap_or_else(|error| panic!("{error}"));
        let last = |name: &str| {
            let column = study.columns.iter().find(|column| column.name == name).expect("it is a column");
            let value = match &column.data {
                RunData::F64(values) => format!("{:?}", values[95]),
                RunData::U64(values) => values[95].to_string(),
                RunData::Text(values) => values[95].to_string(),
            };
            format!("{value} {}", column.unit.symbol())
        };
        assert_eq!(last("index"), "95 1");
        assert_eq!(last("purpose"), "probability_only 1");
        assert_eq!(last("inner"), "55 1");
        assert_eq!(last("parameter.upper_length"), "0.7999541201276005 m");
        assert_eq!(last("tip_y total maximum_absolute"), "5.9449310130743616e-5 m");
        assert_eq!(last("reason"), " 1");
        assert_eq!(last("change_over_last_turn"), "NaN 1");
        assert_eq!(last("evaluations"), "5883 1");
        assert_eq!(last("peak_force elbow"), "11.742816154959215 N");
    }

    /// Two row groups: test_study.py of loosepin-python reads the file with pyarrow. Where the bytes change, write it anew and look at it.
    #[test]
    fn pinned_file_of_two_row_groups() {
        let bytes = written(&table(65_600), "loosepin").unwrap_or_else(|error| panic!("{error}"));
        if std::env::var_os("LOOSEPIN_REWRITE_PAGES").is_some() {
            let path = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/runs/two_groups.parquet");
            #[expect(clippy::disallowed_methods, reason = "a file of the tests")]
            std::fs::write(path, &bytes).unwrap_or_else(|error| panic!("{error}"));
        }
        let pinned = include_bytes!(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/runs/two_groups.parquet"));
        let first = bytes.iter().zip(pinned).position(|(own, pinned)| own != pinned);
        let lengths = [bytes.len(), pinned.len()];
        assert!(
            bytes == pinned,
            "{lengths:?} bytes, first other one at {first:?}; LOOSEPIN_REWRITE_PAGES=1 writes the file"
        );
    }

    #[test]
    fn identity_runs_are_read_back() {
        for rows in [0, 1, 2, 7, 8, 9, 40, 300, 65_536, 65_537] {
            let written = table(rows);
            let bytes = runs_parquet(&written).unwrap_or_else(|error| panic!("{error}"));
            let read = read_runs_parquet(&bytes).unwrap_or_else(|error| panic!("{error}"));
            assert!(is_same(&read, &written), "{rows} rows");
        }
    }
    /// Numbers without an order (Knuth, MMIX).
    struct Random(u64);

    impl Random {
        fn below(&mut self, limit: u64) -> u64 {
            self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (self.0 >> 20) % limit
        }

        /// A column of any kind: few or many values that differ, in long or short runs, few or many of them missing.
        fn column(&mut self, name: &str, rows: usize) -> RunColumn {
            let different = [1, 2, 3, 200, 1 << 40][self.below(5) as usize];
            let run = [1, 3, 1000][self.below(3) as usize];
            let missing = [1, 2, 10, 1 << 40][self.below(4) as usize];
            let (longest, kind, shift) = ([1, 9, 200][self.below(3) as usize], self.below(3), self.below(64));
            let mut value = 0;
            let mut next = || {
                value = if self.below(run) == 0 { self.below(different) } else { value };
                (value, self.below(missing) == 0)
            };
            let data = match kind {
                0 => RunData::F64(
                    (0..rows).map(|_| next()).map(|(v, no)| if no { f64::NAN } else { v as f64 }).collect(),
                ),
                1 => RunData::U64(
                    (0..rows).map(|_| next()).map(|(v, no)| if no { u64::MAX } else { v << shift }).collect(),
                ),
                _ => {
                    let text =
                        |(v, no): (u64, bool)| if no { String::new() } else { "ä".repeat((v % longest) as usize) };
                    RunData::Text((0..rows).map(|_| text(next()).into()).collect())
                }
            };
            RunColumn { name: name.to_owned(), unit: SiUnit::FORCE, data }
        }
    }

    #[test]
    fn identity_random_runs_are_read_back() {
        let mut random = Random(1);
        for rows in [0, 1, 2, 7, 8, 9, 63, 64, 65, 255, 256, 257, 1000, 65_535, 65_536, 65_537] {
            for _ in 0..if rows > 1000 { 1 } else { 4 } {
                let columns = ["a", "b", "c", "d", "e"].map(|name| random.column(name, rows)).to_vec();
                let written = RunsTable { columns };
                let bytes = runs_parquet(&written).unwrap_or_else(|error| panic!("{error}"));
                let read = read_runs_parquet(&bytes).unwrap_or_else(|error| panic!("{error}"));
                assert!(is_same(&read, &written), "{rows} rows");
                assert!(runs_parquet(&read).unwrap_or_else(|error| panic!("{error}")) == bytes, "{rows} rows");
            }
        }
    }

    /// A dictionary where it is shorter: eight bytes a row where all values differ, two bits a row where there are four.
    #[test]
    fn analytic_sizes_with_and_without_a_dictionary() {
        let size = |of: fn(u32) -> f64| {
            let data = RunData::F64((0..8000).map(of).collect());
            let table = RunsTable { columns: vec![RunColumn { name: "a".to_owned(), unit: SiUnit::NONE, data }] };
            parquet::write(&table, &[], "").unwrap_or_else(|error| panic!("{error}")).len()
        };
        // Pages' headers, levels, statistics and footer, in bytes.
        const BESIDE: usize = 250;
        let (plain, few) = (size(|row| f64::from(row).sqrt()), size(|row| f64::from(row % 4)));
        assert!((64_000..64_000 + BESIDE).contains(&plain), "{plain}");
        assert!((2000..2000 + BESIDE).contains(&few), "{few}");
    }

    /// A table of all kinds of columns, by dictionary and without, in few bytes.
    fn small() -> Vec<u8> {
        let column = |name: &str, data: RunData| RunColumn { name: name.to_owned(), unit: SiUnit::LENGTH, data };
        let numbers = (0..9).map(|row| if row % 3 == 0 { f64::NAN } else { f64::from(row).sqrt() }).collect();
        let columns = vec![
            column("a", RunData::F64(numbers)),
            column("b", RunData::U64((0..9).map(|row| row * row).collect())),
            column("c", RunData::Text((0..9).map(|row| ["flores", "johnson"][row % 2].into()).collect())),
        ];
        let entries = [(UNITS_KEY, "{\"a\":\"m\"}".to_owned())];
        parquet::write(&RunsTable { columns }, &entries, "").unwrap_or_else(|error| panic!("{error}"))
    }

    /// Whatever the bytes are, they are a table or refused: no panic, and no row beyond those of a row group, here 65,536.
    #[test]
    fn damaged_files_are_tables_or_refused() {
        let whole = small();
        for length in 0..whole.len() {
            assert!(read_runs_parquet(&whole[..length]).is_err(), "{length} bytes");
            assert!(length == 0 || read_runs_parquet(&whole[length..]).is_err(), "without {length} bytes");
        }
        let mut answers = [0, 0];
        let mut read = |bytes: &[u8]| match read_runs_parquet(bytes) {
            Ok(table) => {
                let rows = |column: &RunColumn| column.data.len();
                assert!(table.columns.iter().all(|column| rows(column) == rows(&table.columns[0])));
                assert!(table.columns.iter().all(|column| rows(column) <= 1 << 16));
                answers[0] += 1;
            }
            Err(_) => answers[1] += 1,
        };
        for at in 0..whole.len() {
            let mut bytes = whole.clone();
            for change in 1..=u8::MAX {
                bytes[at] = whole[at] ^ change;
                read(&bytes);
            }
            // One byte fewer, and one more.
            bytes.remove(at);
            read(&bytes);
            bytes.insert(at, whole[at]);
            bytes.insert(at, whole[at].wrapping_add(1));
            read(&bytes);
        }
        for at in (0..EARLIER_STUDY.len()).step_by(3) {
            let mut bytes = EARLIER_STUDY.to_vec();
            bytes[at] ^= 0xff;
            read(&bytes);
        }
        // Changed values are values: not all is refused.
        assert!(answers.iter().all(|&count| count > 1000), "{answers:?}");
    }

    #[test]
    fn foreign_files_are_refused_in_words() {
        let told = |bytes: &[u8]| read_runs_parquet(bytes).expect_err("no runs").to_string();
        let unread = "runs.parquet cannot be read: ";
        assert_eq!(told(b"PAR"), format!("{unread}the file does not begin and end with PAR1"));
        assert_eq!(told(b"PAR1\0\0\0\0PARE"), format!("{unread}the file does not begin and end with PAR1"));
        assert_eq!(told(b"PAR1\xff\0\0\0PAR1"), format!("{unread}the footer: 255 bytes are needed where 0 are left"));
        // The codec of the first chunk, 0 behind the path ["a"], becomes 6; its type and repetition, 5 and 1, become 4.
        let whole = small();
        let changed = |from: &[u8], to: &[u8]| {
            let at = whole.windows(from.len()).position(|window| window == from).expect("it is there");
            [&whole[..at], to, &whole[at + from.len()..]].concat()
        };
        assert_eq!(
            told(&changed(b"\x19\x18\x01a\x15\x00", b"\x19\x18\x01a\x15\x0c")),
            "the runs are compressed with ZSTD; this version reads only uncompressed runs"
        );
        assert_eq!(
            told(&changed(b"\x15\x0a\x25\x02\x18\x01a", b"\x15\x08\x25\x02\x18\x01a")),
            "column 'a' of the runs has the type FLOAT; must be DOUBLE, INT64 with INTEGER(64, false), or BYTE_ARRAY with STRING"
        );
        assert_eq!(
            told(&changed(b"\x15\x0a\x25\x02\x18\x01a", b"\x15\x0a\x25\x04\x18\x01a")),
            format!("{unread}column 'a': the repetition is 2; must be 0 (required) or 1 (optional)")
        );
        assert_eq!(
            told(&changed(b"{\"a\":\"m\"}", b"{\"a\":\"m\"]")),
            "'units' of the runs cannot be read: expected `,` or `}` at line 1 column 9"
        );
        // The rows of the file, 9 in field 3, become 8.
        assert_eq!(
            told(&changed(b"\x16\x12\x19\x1c", b"\x16\x10\x19\x1c")),
            format!("{unread}the number of rows is 8; must be 9, those of all row groups")
        );
        assert_eq!(
            told(&changed(b"\x25\x00\x18\x01b", b"\x25\x00\x18\x01a")),
            format!("{unread}column 'a': its name appears twice; names must differ")
        );
    }
}
