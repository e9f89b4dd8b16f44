//! Finished runs on disk: what a study of hours has computed is never lost.
//!
//! One SQLite file a study, with a row for each finished run. Rows are known by their list (0 for the runs of the study itself, one
//! more for each direct study of the inverse question) and their place in it, which the plan fixes: whoever asks again for the run
//! at a place with the same inputs is given its row back.
//!
//! # What survives
//!
//! * Runs are collected and committed together at least every [`LONGEST_UNSAVED`]: what is older is on disk.
//! * A commit is an append to the write-ahead log `runs.sqlite-wal`, followed by a flush to the device (`synchronous = FULL`); only
//!   when the log is copied into the file, which is flushed first, is the log begun anew. Whatever moment the process or the
//!   machine stops at, the log is read again when the store is opened, up to its last whole commit: SQLite keeps a checksum of
//!   every frame.
//! * Each row carries a checksum (BLAKE3, 128 bits) of its list, place, inputs and numbers, and the structure of the file is checked
//!   when it is opened. A row that was damaged is never used: the store is refused. A row that is missing is run again and has the
//!   same bits.
//! * While a store is open the file is locked: a second process is refused.
//!
//! It knows nothing of mechanisms or of statistics: numbers in, the same numbers out.

pub mod results;

mod error;
mod file;
mod join;
mod row;
mod shard;
#[cfg(test)]
mod tests;
mod writer;

use std::ops::Range;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{Sender, SyncSender, channel, sync_channel};
use std::thread::JoinHandle;

pub use error::StoreError;
use file::StoreFile;
use join::join;
pub use row::{InputsKey, KeptRun};
pub use shard::{Shard, ShardError};
pub use writer::LONGEST_UNSAVED;
use writer::{Request, write_requests};

/// Name of the file in a folder of results.
pub const STORE_FILE: &str = "runs.sqlite";
/// Names of the files that may stand beside it while it is open, or after it was left by force.
pub const STORE_COMPANIONS: [&str; 2] = ["runs.sqlite-wal", "runs.sqlite-journal"];

/// Name of the copy that shards of a study read of what was merged, beside the store.
pub const PUBLISHED_FILE: &str = "merged.sqlite";

/// Whose runs a store holds.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct StoreIdentity {
    /// Version of the program: other versions may give other bits.
    pub version: String,
    /// Hash of everything that the runs are computed from.
    pub inputs: String,
}

/// What becomes of runs that a store holds already.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Beginning {
    /// They are taken over.
    GoOn,
    /// They are dropped, whosever they are.
    Anew,
    /// There must be none.
    Empty,
}

impl Beginning {
    /// As whoever calls has stated: to replace what is there, or to go on with it.
    pub fn stated(with_force: bool, with_resume: bool) -> Self {
        match (with_force, with_resume) {
            (true, _) => Self::Anew,
            (false, true) => Self::GoOn,
            (false, false) => Self::Empty,
        }
    }
}

/// An open store. Rows are written by a thread of its own, so that nobody who has finished a run waits for the disk.
#[derive(Debug)]
pub struct RunStore {
    path: PathBuf,
    requests: Option<Sender<Request>>,
    thread: Option<JoinHandle<()>>,
    is_broken: Arc<AtomicBool>,
    runs_at_start: u64,
}

impl RunStore {
    /// Opens the store at `path`, or makes an empty one where there is none.
    ///
    /// # Errors
    /// [`StoreError`]: it is in use, belongs to another study or version, is damaged, or the file system refuses.
    pub fn open(path: &Path, identity: &StoreIdentity) -> Result<Self, StoreError> {
        Self::open_beside(path, None, identity)
    }

    /// The same with `published`, a copy of another store that [`RunStore::publish`] has written: what is in there is found here as
    /// well.
    ///
    /// # Errors
    /// As for [`RunStore::open`], of both.
    pub fn open_beside(path: &Path, published: Option<&Path>, identity: &StoreIdentity) -> Result<Self, StoreError> {
        let file = StoreFile::open(path, identity)?;
        let published = published.map(|published| StoreFile::open_published(published, identity)).transpose()?;
        Self::serve(path, file, published)
    }

    /// The store in `file`, with a thread that serves it.
    fn serve(path: &Path, file: StoreFile, published: Option<StoreFile>) -> Result<Self, StoreError> {
        let runs_at_start = file.runs()?;
        let (requests, inbox) = channel();
        let is_broken = Arc::new(AtomicBool::new(false));
        let flag = Arc::clone(&is_broken);
        let thread = std::thread::Builder::new()
            .name("loosepin-store".to_owned())
            .spawn(move || write_requests(file, published.as_ref(), &inbox, &flag))
            .map_err(|error| StoreError::NotUsable { path: path.to_owned(), reason: error.to_string() })?;
        Ok(Self { path: path.to_owned(), requests: Some(requests), thread: Some(thread), is_broken, runs_at_start })
    }

    /// Opens the store at `path` at the beginning of a study.
    ///
    /// # Errors
    /// As for [`RunStore::open`], and [`StoreError::HoldsRuns`] where there were to be none.
    pub fn begin(path: &Path, identity: &StoreIdentity, beginning: Beginning) -> Result<Self, StoreError> {
        Self::begin_beside(path, None, identity, beginning)
    }

    /// The same for a shard of a study, which reads what is `published` as well.
    ///
    /// # Errors
    /// As for [`RunStore::open_beside`], and [`StoreError::HoldsRuns`] where there were to be none.
    pub fn begin_beside(
        path: &Path,
        published: Option<&Path>,
        identity: &StoreIdentity,
        beginning: Beginning,
    ) -> Result<Self, StoreError> {
        let opened = Self::open_beside(path, published, identity);
        match (beginning, opened) {
            (_, Err(error @ StoreError::InUse { .. })) => Err(error),
            (Beginning::Anew, opened) => {
                drop(opened);
                remove_store(path)?;
                // What was published belongs to what is begun anew.
                Self::open_beside(path, None, identity)
            }
            (Beginning::Empty, Ok(store)) if store.runs_at_start > 0 => {
                Err(StoreError::HoldsRuns { path: path.to_owned(), runs: store.runs_at_start })
            }
            (_, opened) => opened,
        }
    }

    /// Opens the store at `path` with the runs of `shards` added, and gives how many of them were not there before. Each row is
    /// checked; one that is there already must be the same. Whenever it is stopped it can be done again.
    ///
    /// # Errors
    /// As for [`RunStore::begin`]; a store of a shard is in use (the shard is at work still), damaged, of another study or version, or
    /// holds a run that is another shard's.
    pub fn begin_joined(
        path: &Path,
        identity: &StoreIdentity,
        beginning: Beginning,
        shards: &[(Shard, PathBuf)],
    ) -> Result<(Self, u64), StoreError> {
        drop(Self::begin(path, identity, beginning)?);
        let mut file = StoreFile::open(path, identity)?;
        let added = join(&mut file, path, identity, shards)?;
        Ok((Self::serve(path, file, None)?, added))
    }

    /// Where it is.
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// How many runs it held when it was opened.
    pub fn runs_at_start(&self) -> u64 {
        self.runs_at_start
    }

    /// Keeps a finished run; returns at once.
    pub fn keep(&self, list: u32, place: u64, run: KeptRun) {
        // Where the writer is gone, `find` and `settle` say so.
        if let Some(requests) = &self.requests {
            let _ = requests.send(Request::Keep { list, place, run });
        }
    }

    /// Whether rows can no longer be written; [`RunStore::settle`] says why.
    pub fn is_broken(&self) -> bool {
        self.is_broken.load(Ordering::Relaxed)
    }

    /// The runs at `places` of a list, each where it is known.
    ///
    /// # Errors
    /// [`StoreError`]: a row is damaged, or the file system refuses.
    pub fn find(&self, list: u32, places: Range<u64>) -> Result<Vec<Option<KeptRun>>, StoreError> {
        self.ask(|reply| Request::Find { list, places, reply })
    }

    /// Waits until everything that was given is on disk; gives the number of runs in the store.
    ///
    /// # Errors
    /// [`StoreError`]: what the file system has refused since.
    pub fn settle(&self) -> Result<u64, StoreError> {
        self.ask(|reply| Request::Settle { reply })
    }

    /// Writes a copy of everything that was given to `to`, which other processes may read by [`RunStore::open_beside`] at any time.
    ///
    /// # Errors
    /// [`StoreError`]: what the file system refuses.
    pub fn publish(&self, to: &Path) -> Result<(), StoreError> {
        self.ask(|reply| Request::Publish { to: to.to_owned(), reply })
    }

    fn ask<T>(&self, request: impl FnOnce(SyncSender<Result<T, StoreError>>) -> Request) -> Result<T, StoreError> {
        let gone = || StoreError::NotUsable { path: self.path.clone(), reason: "its thread has ended".to_owned() };
        let (reply, answer) = sync_channel(1);
        self.requests.as_ref().ok_or_else(gone)?.send(request(reply)).map_err(|_| gone())?;
        answer.recv().map_err(|_| gone())?
    }

    /// Closes the store and removes its files: its runs are no longer needed.
    ///
    /// # Errors
    /// What the file system refuses.
    pub fn remove(mut self) -> Result<(), StoreError> {
        self.close();
        remove_store(&self.path)
    }

    fn close(&mut self) {
        self.requests = None;
        if let Some(thread) = self.thread.take() {
            // A thread that has panicked has nothing left to close.
            let _ = thread.join();
        }
    }
}

impl Drop for RunStore {
    fn drop(&mut self) {
        self.close();
    }
}

/// Removes the files of a store that is not open, and the copy beside it; nothing where there is none.
///
/// # Errors
/// What the file system refuses.
pub fn remove_store(path: &Path) -> Result<(), StoreError> {
    let companions = STORE_COMPANIONS.iter().map(|name| path.with_file_name(name));
    for file in companions.chain([path.with_file_name(PUBLISHED_FILE), path.to_owned()]) {
        match std::fs::remove_file(&file) {
            Err(error) if error.kind() != std::io::ErrorKind::NotFound => {
                return Err(StoreError::NotUsable { path: file, reason: error.to_string() });
            }
            _ => {}
        }
    }
    Ok(())
}
