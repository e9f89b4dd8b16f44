//! A store that SQLite has written, with whatever in the columns of its rows.

use std::path::Path;
use std::sync::OnceLock;

use loosepin::store::{RunStore, StoreIdentity};
use rusqlite::types::Value;
use rusqlite::{Connection, params_from_iter};

/// Tables that rows may stand in instead of those of a store: others that answer to the same questions.
const OTHER_TABLES: [&str; 8] = [
    "CREATE TABLE identity (name, value); CREATE TABLE run (list, place, inputs, failure, numbers, checksum);",
    "CREATE TABLE identity (name, value); CREATE TABLE row (list, place, inputs, failure, numbers, checksum);
     CREATE VIEW run AS SELECT * FROM row;",
    "CREATE TABLE identity (name, value); CREATE VIEW run AS WITH RECURSIVE n(k) AS (SELECT 0 UNION ALL SELECT k + 1 FROM n)
     SELECT 0 AS list, k AS place, x'' AS inputs, NULL AS failure, x'' AS numbers, x'' AS checksum FROM n;",
    "CREATE VIEW identity AS WITH RECURSIVE n(k) AS (SELECT 0 UNION ALL SELECT k + 1 FROM n)
     SELECT 'nobody' AS name, k AS value FROM n; CREATE TABLE run (list, place, inputs, failure, numbers, checksum);",
    "CREATE TABLE identity (name, value); CREATE TABLE run (list, place, inputs, failure,
     numbers AS (zeroblob(900000000)), checksum);",
    "CREATE TABLE identity (name, value); CREATE TABLE run (list, place, inputs, failure, numbers, checksum,
     PRIMARY KEY (list, place)); CREATE TRIGGER grow AFTER INSERT ON run BEGIN INSERT INTO run VALUES (NEW.list,
     NEW.place + 1, NEW.inputs, NEW.failure, NEW.numbers, NEW.checksum); END;",
    "CREATE TABLE identity (name TEXT COLLATE nobody_knows, value); CREATE TABLE run (list, place, inputs, failure, numbers,
     checksum, CHECK (list < 3));",
    "CREATE TABLE identity (name, value); CREATE TABLE run (list, place, inputs, numbers);",
];
/// What the library writes into a store before the first row.
struct Format {
    /// The statements that make its tables.
    tables: String,
    /// Who has written the file.
    application: i32,
    /// Version of the format.
    version: i32,
}

impl Format {
    /// Has the library write an empty store beside `path`, and reads it.
    fn of_library(path: &Path, identity: &StoreIdentity) -> Format {
        // In a folder of its own: that of the input is locked.
        let folder = path.with_file_name("format");
        let lock = super::store::lock(&folder);
        let library = RunStore::open(&lock, identity).expect("an empty store is written");
        let path = library.path().to_owned();
        drop(library);
        let store = Connection::open(&path).expect("it is a file of SQLite");
        let number = |name| store.pragma_query_value(None, name, |row| row.get(0)).expect("a number of the header");
        let tables = "SELECT group_concat(sql, ';') FROM sqlite_schema WHERE sql IS NOT NULL";
        let tables = store.query_row(tables, [], |row| row.get(0)).expect("it has tables");
        let format = Format { tables, application: number("application_id"), version: number("user_version") };
        drop(store);
        format
    }
}

/// What stands for the right checksum of its row.
const RIGHT_CHECKSUM: u8 = 5;

/// Bytes that are read one after the other; behind the last one stand zeros.
struct Bytes<'b>(&'b [u8]);

impl Bytes<'_> {
    fn take<const N: usize>(&mut self) -> [u8; N] {
        let (taken, rest) = self.0.split_at(N.min(self.0.len()));
        self.0 = rest;
        std::array::from_fn(|k| taken.get(k).copied().unwrap_or(0))
    }

    fn some(&mut self) -> Vec<u8> {
        let [length] = self.take::<1>();
        let (taken, rest) = self.0.split_at(usize::from(length).min(self.0.len()));
        self.0 = rest;
        taken.to_vec()
    }

    /// A value of a column, and whether it is to be the right checksum.
    fn value(&mut self) -> (Value, bool) {
        let [kind] = self.take::<1>();
        let value = match kind % 8 {
            0 => Value::Null,
            1 => Value::Integer(i64::from(self.take::<1>()[0])),
            2 => Value::Integer(i64::from_le_bytes(self.take())),
            3 => Value::Real(f64::from_le_bytes(self.take())),
            4 => Value::Text(String::from_utf8_lossy(&self.some()).into_owned()),
            RIGHT_CHECKSUM => Value::Null,
            6 => Value::Blob(self.take::<16>().to_vec()),
            _ => Value::Blob(self.some()),
        };
        (value, kind % 8 == RIGHT_CHECKSUM)
    }
}

/// Writes a store at `path`: a byte for its tables, a byte for what it says of itself, then rows to the end of the bytes. Whether
/// SQLite could do it.
pub fn write_rows(bytes: &[u8], path: &Path, identity: &StoreIdentity) -> bool {
    static FORMAT: OnceLock<Format> = OnceLock::new();
    let format = FORMAT.get_or_init(|| Format::of_library(path, identity));
    let mut bytes = Bytes(bytes);
    let [tables, says] = bytes.take::<2>();
    let mut written = || -> rusqlite::Result<()> {
        let mut connection = Connection::open(path)?;
        // As long as it is being written no other process needs it.
        connection.pragma_update(None, "journal_mode", "OFF")?;
        connection.pragma_update(None, "synchronous", "OFF")?;
        connection.pragma_update(None, "page_size", 512)?;
        let transaction = connection.transaction()?;
        let other = (usize::from(tables) % (1 + OTHER_TABLES.len())).checked_sub(1);
        transaction.execute_batch(other.map_or(&format.tables, |index| OTHER_TABLES[index]))?;
        transaction.pragma_update(None, "application_id", format.application)?;
        transaction.pragma_update(
            None,
            "user_version",
            if says & 1 == 0 { format.version } else { i32::from(says) },
        )?;
        for (name, value) in [("version", &identity.version), ("inputs", &identity.inputs)] {
            // Refused where there is no such table, which is an input too.
            let _ = transaction.execute("INSERT INTO identity VALUES (?1, ?2)", [name, value]);
        }
        while !bytes.0.is_empty() {
            let mut row: Vec<(Value, bool)> = (0..6).map(|_| bytes.value()).collect();
            if let Some(right) = row.iter().position(|(_, is_right)| *is_right) {
                row[right].0 = Value::Blob(right_checksum(&row));
            }
            let _ = transaction.execute(
                "INSERT INTO run VALUES (?1, ?2, ?3, ?4, ?5, ?6)",
                params_from_iter(row.into_iter().map(|(value, _)| value)),
            );
        }
        transaction.commit()
    };
    written().is_ok()
}

/// The checksum that the row is to have by `store/row.rs`: of list, place, inputs, reason of failure, numbers.
fn right_checksum(row: &[(Value, bool)]) -> Vec<u8> {
    let integer = |column: usize| if let Value::Integer(value) = row[column].0 { value } else { 0 };
    let blob = |column: usize| if let Value::Blob(bytes) = &row[column].0 { bytes.as_slice() } else { &[] };
    let failure = match row[3].0 {
        Value::Integer(reason) => [1, reason.to_le_bytes()[0], reason.to_le_bytes()[1]],
        _ => [0; 3],
    };
    let mut hasher = blake3::Hasher::new();
    hasher.update(&(integer(0) as u32).to_le_bytes()).update(&integer(1).to_le_bytes());
    hasher.update(blob(2)).update(&failure).update(blob(4));
    hasher.finalize().as_bytes()[..16].to_vec()
}
