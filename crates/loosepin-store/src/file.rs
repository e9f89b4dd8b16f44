//! The SQLite file of a store.

use std::io;
use std::ops::Range;
use std::path::{Path, PathBuf};

use loosepin_files::{FileKind, Folder, FolderLock, Identity, Refused};
use rusqlite::config::DbConfig;
use rusqlite::{Connection, OpenFlags, OptionalExtension, Row, params};

use super::error::StoreError;
use super::files::{PUBLISHED_FILE, STORE_COMPANIONS, STORE_FILE};
use super::identity::StoreIdentity;
use super::row::{InputsKey, StoredRun, checksum};

/// `LPIN`, by which `file` and SQLite know whose file it is.
const APPLICATION: i32 = 0x4c50_494e;
/// Version of the tables below; another one is refused.
const FORMAT: i32 = 1;

/// The tables, by name, as SQLite keeps the statements that made them.
const TABLES: [(&str, &str); 2] = [
    ("identity", "CREATE TABLE identity (name TEXT PRIMARY KEY, value TEXT NOT NULL) WITHOUT ROWID"),
    (
        "run",
        "CREATE TABLE run (
    list INTEGER NOT NULL,
    place INTEGER NOT NULL,
    inputs BLOB NOT NULL,
    failure INTEGER,
    numbers BLOB NOT NULL,
    checksum BLOB NOT NULL,
    PRIMARY KEY (list, place)
) WITHOUT ROWID",
    ),
];

/// Settings that SQLite advises for files that somebody else may have written: nothing in the file may call functions, and every cell of a
/// page is looked at before it is used.
fn harden(connection: &Connection) -> rusqlite::Result<()> {
    connection.pragma_update(None, "trusted_schema", false)?;
    connection.pragma_update(None, "cell_size_check", true)
}

/// Characters of a name of the file that are shown.
const SHOWN_CHARS: usize = 40;

/// A name as it is shown.
fn shortened(name: &str) -> String {
    name.chars().take(SHOWN_CHARS).collect()
}

/// An open, locked, checked file.
pub(super) struct StoreFile {
    path: PathBuf,
    connection: Connection,
    folder: Folder,
    /// The file that was opened. Another one may have its name later.
    identity: Identity,
}

/// Path at which SQLite is to open a file of the folder. It opens by paths: this one has no links, and leads to the folder.
fn checked_path(folder: &Folder, name: &str) -> io::Result<PathBuf> {
    let named = if folder.path().as_os_str().is_empty() { Path::new(".") } else { folder.path() };
    let path = if cfg!(unix) { named.canonicalize()? } else { named.to_owned() };
    if Folder::open(&path)?.metadata()?.identity != folder.metadata()?.identity {
        return Err(Refused::LockLost.into());
    }
    for name in STORE_COMPANIONS.into_iter().chain([name]) {
        match folder.find(Path::new(name))?.map(|found| found.kind) {
            None | Some(FileKind::File) => {}
            Some(FileKind::Link) => return Err(Refused::Link.into()),
            Some(FileKind::Folder | FileKind::Other) => return Err(Refused::NotAFile.into()),
        }
    }
    Ok(path.join(name))
}

impl StoreFile {
    /// Opens or makes the file in the folder, locks it and checks that it is whole and whose it is.
    pub fn open(folder: &Folder, identity: &StoreIdentity) -> Result<Self, StoreError> {
        let path = folder.path().join(STORE_FILE);
        let of = |error: rusqlite::Error| StoreError::of(&path, &error);
        let flags = OpenFlags::SQLITE_OPEN_READ_WRITE | OpenFlags::SQLITE_OPEN_CREATE;
        let connection = open(folder, STORE_FILE, flags)?;
        connection.busy_timeout(std::time::Duration::ZERO).map_err(of)?;
        // Locked before the log is begun, so that no memory is shared with other processes: that works on network drives too.
        connection.pragma_update(None, "locking_mode", "EXCLUSIVE").map_err(of)?;
        connection.pragma_update(None, "journal_mode", "WAL").map_err(of)?;
        connection.pragma_update(None, "synchronous", "FULL").map_err(of)?;
        connection.execute_batch("BEGIN EXCLUSIVE; COMMIT").map_err(of)?;
        harden(&connection).map_err(of)?;
        let store = Self::of_connection(connection, folder, STORE_FILE)?;
        let number =
            |name: &str| store.connection.pragma_query_value(None, name, |row| row.get::<_, i32>(0)).map_err(of);
        let is_new = number("application_id")? == 0 && number("user_version")? == 0 && store.is_empty()?;
        if is_new {
            store.begin(identity)?
        } else {
            store.check(identity)?
        }
        Ok(store)
    }

    /// Opens the copy of a store in the folder to be read, by any number of processes at a time, and checks it like [`StoreFile::open`]. It
    /// must not be written meanwhile: only what [`StoreFile::publish`] has written is read so.
    pub fn open_published(folder: &Folder, identity: &StoreIdentity) -> Result<Self, StoreError> {
        let connection = open(folder, PUBLISHED_FILE, OpenFlags::SQLITE_OPEN_READ_ONLY)?;
        harden(&connection).map_err(|error| StoreError::of(&folder.path().join(PUBLISHED_FILE), &error))?;
        let store = Self::of_connection(connection, folder, PUBLISHED_FILE)?;
        store.check(identity)?;
        Ok(store)
    }

    fn of_connection(connection: Connection, folder: &Folder, name: &str) -> Result<Self, StoreError> {
        let path = folder.path().join(name);
        let found = folder.find(Path::new(name)).and_then(|found| found.ok_or(Refused::LockLost.into()));
        let identity = found.map_err(|error| StoreError::not_usable(&path, &error))?.identity;
        Ok(Self { path, connection, folder: folder.clone(), identity })
    }

    /// That the file still has its name in the folder: what is written into it is found again.
    fn check_place(&self) -> Result<(), StoreError> {
        let lost = match self.folder.find(Path::new(self.path.file_name().unwrap_or_default())) {
            Ok(Some(found)) if found.identity == self.identity => return Ok(()),
            Ok(_) => Refused::LockLost.into(),
            Err(error) => error,
        };
        Err(StoreError::not_usable(&self.path, &lost))
    }

    /// Whether it has no table: just made, or left before its first commit.
    fn is_empty(&self) -> Result<bool, StoreError> {
        let tables = self.connection.query_row("SELECT count(*) FROM sqlite_schema", [], |row| row.get::<_, i64>(0));
        Ok(self.or_store_error(tables)? == 0)
    }

    fn begin(&self, identity: &StoreIdentity) -> Result<(), StoreError> {
        let written = || -> rusqlite::Result<()> {
            let transaction = self.connection.unchecked_transaction()?;
            for (_, made) in TABLES {
                transaction.execute(made, [])?;
            }
            for (name, value) in [("version", &identity.version), ("inputs", &identity.inputs)] {
                transaction.execute("INSERT INTO identity VALUES (?1, ?2)", params![name, value])?;
            }
            transaction.pragma_update(None, "application_id", APPLICATION)?;
            transaction.pragma_update(None, "user_version", FORMAT)?;
            transaction.commit()
        };
        self.or_store_error(written())
    }

    /// That it is a store of this format, whole, and of this identity.
    fn check(&self, identity: &StoreIdentity) -> Result<(), StoreError> {
        let number = |name: &str| {
            self.or_store_error(self.connection.pragma_query_value(None, name, |row| row.get::<_, i32>(0)))
        };
        match (number("application_id")?, number("user_version")?) {
            (APPLICATION, FORMAT) => {}
            (APPLICATION, format) => {
                let [found, expected] = [format, FORMAT].map(|format| format.to_string());
                return Err(StoreError::OfOther { path: self.path.clone(), what: "format", found, expected });
            }
            _ => {
                let reason = "it is a database, but not one of loosepin".to_owned();
                return Err(StoreError::Damaged { path: self.path.clone(), reason });
            }
        }
        self.check_tables()?;
        let said = self.connection.query_row("PRAGMA quick_check(1)", [], |row| row.get::<_, String>(0));
        let said = self.or_store_error(said)?;
        if said != "ok" {
            return Err(StoreError::Damaged { path: self.path.clone(), reason: said });
        }
        for (what, name, expected) in [("version", "version", &identity.version), ("study", "inputs", &identity.inputs)]
        {
            let found = self
                .connection
                .query_row("SELECT value FROM identity WHERE name = ?1", [name], |row| row.get::<_, String>(0))
                .optional();
            let found = self.or_store_error(found)?.unwrap_or_default();
            if found != *expected {
                let [found, expected] = [&found, expected].map(|text| text.chars().take(8).collect());
                return Err(StoreError::OfOther { path: self.path.clone(), what, found, expected });
            }
        }
        Ok(())
    }

    /// That it has the tables that were made, and nothing else. A view in the place of a table, a column or an index that is worked out, or
    /// a trigger would run whatever was written into the file: without end, or with all memory there is. So they are looked for
    /// before anything is read of them, the structure included ("Defense Against The Dark Arts",
    /// <https://www.sqlite.org/security.html>).
    fn check_tables(&self) -> Result<(), StoreError> {
        let damaged = |reason: String| StoreError::Damaged { path: self.path.clone(), reason };
        let statement = self.connection.prepare("SELECT name, sql FROM sqlite_schema");
        let mut statement = self.or_store_error(statement)?;
        let mut rows = self.or_store_error(statement.query([]))?;
        let mut found = [false; TABLES.len()];
        while let Some(row) = self.or_store_error(rows.next())? {
            let (name, made): (String, String) =
                self.or_store_error(row.get(0).and_then(|name| Ok((name, row.get(1)?))))?;
            match TABLES.iter().position(|table| *table == (name.as_str(), made.as_str())) {
                Some(table) => found[table] = true,
                None => return Err(damaged(format!("'{}' in it is no table of a store", shortened(&name)))),
            }
        }
        match TABLES.iter().zip(found).find(|(_, is_there)| !is_there) {
            Some(((name, _), _)) => Err(damaged(format!("it has no table '{name}'"))),
            None => Ok(()),
        }
    }

    /// Path of the file.
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// How many runs it holds.
    pub fn runs(&self) -> Result<u64, StoreError> {
        let count = self.connection.query_row("SELECT count(*) FROM run", [], |row| row.get::<_, i64>(0));
        Ok(self.or_store_error(count)?.max(0).cast_unsigned())
    }

    /// Writes these rows together, and waits until they are on the device.
    pub fn commit(&mut self, rows: &[(u32, u64, StoredRun)]) -> Result<(), StoreError> {
        self.check_place()?;
        let mut written = || -> rusqlite::Result<()> {
            let transaction = self.connection.transaction()?;
            {
                let mut insert =
                    transaction.prepare_cached("INSERT OR REPLACE INTO run VALUES (?1, ?2, ?3, ?4, ?5, ?6)")?;
                for (list, place, run) in rows {
                    let (inputs, failure) = (&run.inputs.0, run.outcome.as_ref().err().copied());
                    let numbers = run.bytes();
                    let sum = checksum(*list, *place, inputs, failure, &numbers);
                    insert.execute(params![list, place.cast_signed(), inputs, failure, numbers, sum])?;
                }
            }
            transaction.commit()
        };
        let written = written();
        self.or_store_error(written)
    }

    /// The runs at `places` of a list.
    pub fn find(&self, list: u32, places: Range<u64>) -> Result<Vec<Option<StoredRun>>, StoreError> {
        let mut found: Vec<Option<StoredRun>> = vec![None; places.clone().count()];
        let query = "SELECT list, place, inputs, failure, numbers, checksum FROM run \
            WHERE list = ?1 AND place >= ?2 AND place < ?3";
        let statement = self.connection.prepare_cached(query);
        let mut statement = self.or_store_error(statement)?;
        let rows = statement.query(params![list, places.start.cast_signed(), places.end.cast_signed()]);
        let mut rows = self.or_store_error(rows)?;
        while let Some(row) = self.or_store_error(rows.next())? {
            let (_, place, run) = self.read(row)?;
            found[(place - places.start) as usize] = Some(run);
        }
        Ok(found)
    }

    /// Hands every run over, in the order of lists and places.
    pub fn for_each(
        &self,
        mut take: impl FnMut(u32, u64, StoredRun) -> Result<(), StoreError>,
    ) -> Result<(), StoreError> {
        let query = "SELECT list, place, inputs, failure, numbers, checksum FROM run ORDER BY list, place";
        let statement = self.connection.prepare(query);
        let mut statement = self.or_store_error(statement)?;
        let mut rows = self.or_store_error(statement.query([]))?;
        while let Some(row) = self.or_store_error(rows.next())? {
            let (list, place, run) = self.read(row)?;
            take(list, place, run)?;
        }
        Ok(())
    }

    /// A row with its list and place, once its checksum is right.
    fn read(&self, row: &Row<'_>) -> Result<(u32, u64, StoredRun), StoreError> {
        let list: u32 = self.or_store_error(row.get(0))?;
        let place: i64 = self.or_store_error(row.get(1))?;
        let place = place.cast_unsigned();
        let inputs: Vec<u8> = self.or_store_error(row.get(2))?;
        let failure: Option<u16> = self.or_store_error(row.get(3))?;
        let numbers: Vec<u8> = self.or_store_error(row.get(4))?;
        let sum: Vec<u8> = self.or_store_error(row.get(5))?;
        let damaged = |what: &str| StoreError::Damaged {
            path: self.path.clone(),
            reason: format!("run {place} of list {list} {what}"),
        };
        if checksum(list, place, &inputs, failure, &numbers)[..] != sum[..] {
            return Err(damaged("does not have its checksum"));
        }
        let inputs = InputsKey(inputs.try_into().map_err(|_| damaged("has no key of its inputs"))?);
        let outcome = match failure {
            Some(reason) => Err(reason),
            None => Ok(StoredRun::numbers(&numbers).ok_or_else(|| damaged("has half a number"))?),
        };
        Ok((list, place, StoredRun { inputs, outcome }))
    }

    /// Writes a copy beside it that other processes may read while this one is written: whole or not at all, in place of the one
    /// that was there.
    pub fn publish(&self, lock: &FolderLock) -> Result<(), StoreError> {
        let to = self.folder.path().join(PUBLISHED_FILE);
        let refused = |error: io::Error| StoreError::not_usable(&to, &error);
        let temporary = lock.temporary_name().map_err(refused)?;
        let path = checked_path(&self.folder, &temporary).map_err(refused)?;
        let Some(name) = path.to_str() else {
            return Err(refused(io::Error::other("a path that is not Unicode")));
        };
        if let Err(error) = self.connection.execute("VACUUM INTO ?1", [name]) {
            let _ = lock.remove(&temporary);
            return Err(StoreError::of(&to, &error));
        }
        lock.adopt(&temporary, PUBLISHED_FILE).map_err(refused)
    }

    fn or_store_error<T>(&self, result: rusqlite::Result<T>) -> Result<T, StoreError> {
        result.map_err(|error| StoreError::of(&self.path, &error))
    }
}

/// A connection to a file of the folder. SQLite follows no link.
fn open(folder: &Folder, name: &str, flags: OpenFlags) -> Result<Connection, StoreError> {
    let named = folder.path().join(name);
    let path = checked_path(folder, name).map_err(|error| StoreError::not_usable(&named, &error))?;
    let flags = flags | OpenFlags::SQLITE_OPEN_NO_MUTEX | OpenFlags::SQLITE_OPEN_NOFOLLOW;
    Connection::open_with_flags(path, flags).map_err(|error| StoreError::of(&named, &error))
}

/// Where another file has its name, the log that has the name of its own is that of the other one: it is not removed.
impl Drop for StoreFile {
    fn drop(&mut self) {
        if self.check_place().is_err() {
            let _ = self.connection.set_db_config(DbConfig::SQLITE_DBCONFIG_NO_CKPT_ON_CLOSE, true);
        }
    }
}
