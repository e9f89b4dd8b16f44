//! An open store, served by a thread of its own.

use std::ops::Range;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{Sender, SyncSender, channel, sync_channel};
use std::thread::JoinHandle;

use loosepin_files::{Folder, FolderLock};

use super::error::StoreError;
use super::file::StoreFile;
use super::files::{STORE_FILE, remove_store};
use super::identity::StoreIdentity;
use super::join::join;
use super::row::StoredRun;
use super::shard::Shard;
use super::writer::{Request, write_requests};

/// Why a store cannot be used that has no thread.
const NO_THREAD: &str = "the system refused to start a thread for it";

/// The fate of runs that a store holds already when a study begins.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ExistingRuns {
    /// Existing runs are reused.
    GoOn,
    /// Existing runs are dropped, whatever study they belong to.
    Anew,
    /// There must be none.
    Empty,
}

impl ExistingRuns {
    /// Policy from the options of the caller: replace existing runs, or resume with them.
    pub fn from_options(with_force: bool, with_resume: bool) -> Self {
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
    lock: Arc<FolderLock>,
    requests: Option<Sender<Request>>,
    thread: Option<JoinHandle<()>>,
    is_broken: Arc<AtomicBool>,
    runs_at_start: u64,
}

impl RunStore {
    /// Opens the store in a locked folder, or makes an empty one where there is none.
    ///
    /// # Errors
    /// [`StoreError`]: it is in use, belongs to another study or version, is damaged, or the file system refuses.
    pub fn open(lock: &Arc<FolderLock>, identity: &StoreIdentity) -> Result<Self, StoreError> {
        Self::open_beside(lock, None, identity)
    }

    /// Opens the store with the copy of another store beside it, which [`RunStore::publish`] has written into the folder `published`: what
    /// is in there is found here as well.
    ///
    /// # Errors
    /// As for [`RunStore::open`], of both.
    pub fn open_beside(
        lock: &Arc<FolderLock>,
        published: Option<&Folder>,
        identity: &StoreIdentity,
    ) -> Result<Self, StoreError> {
        let file = StoreFile::open(lock.folder(), identity)?;
        let published = published.map(|published| StoreFile::open_published(published, identity)).transpose()?;
        Self::serve(lock, file, published)
    }

    /// The store in `file`, with a thread that serves it.
    fn serve(lock: &Arc<FolderLock>, file: StoreFile, published: Option<StoreFile>) -> Result<Self, StoreError> {
        let path = lock.folder().path().join(STORE_FILE);
        let runs_at_start = file.runs()?;
        let (requests, inbox) = channel();
        let is_broken = Arc::new(AtomicBool::new(false));
        let flag = Arc::clone(&is_broken);
        let thread = std::thread::Builder::new()
            .name("loosepin-store".to_owned())
            .spawn(move || write_requests(file, published.as_ref(), &inbox, &flag))
            .map_err(|_| StoreError::NotUsable { path: path.clone(), reason: NO_THREAD.to_owned() })?;
        Ok(Self {
            path,
            lock: Arc::clone(lock),
            requests: Some(requests),
            thread: Some(thread),
            is_broken,
            runs_at_start,
        })
    }

    /// Opens the store in a locked folder at the beginning of a study.
    ///
    /// # Errors
    /// As for [`RunStore::open`], and [`StoreError::HoldsRuns`] where there were to be none.
    pub fn begin(
        lock: &Arc<FolderLock>,
        identity: &StoreIdentity,
        beginning: ExistingRuns,
    ) -> Result<Self, StoreError> {
        Self::begin_beside(lock, None, identity, beginning)
    }

    /// Opens the store of a shard at the beginning of a study; the shard reads what is `published` as well.
    ///
    /// # Errors
    /// As for [`RunStore::open_beside`], and [`StoreError::HoldsRuns`] where there were to be none.
    pub fn begin_beside(
        lock: &Arc<FolderLock>,
        published: Option<&Folder>,
        identity: &StoreIdentity,
        beginning: ExistingRuns,
    ) -> Result<Self, StoreError> {
        let opened = Self::open_beside(lock, published, identity);
        match (beginning, opened) {
            (_, Err(error @ StoreError::InUse { .. })) => Err(error),
            (ExistingRuns::Anew, opened) => {
                drop(opened);
                remove_store(lock)?;
                // What was published belongs to what is begun anew.
                Self::open_beside(lock, None, identity)
            }
            (ExistingRuns::Empty, Ok(store)) if store.runs_at_start > 0 => {
                Err(StoreError::HoldsRuns { path: store.path.clone(), runs: store.runs_at_start })
            }
            (_, opened) => opened,
        }
    }

    /// Opens the store in a locked folder with the runs of the stores in the folders of `shards` added, and gives how many of them were not there before. Each row is
    /// checked; one that is there already must be the same. Whenever it is stopped it can be done again.
    ///
    /// # Errors
    /// As for [`RunStore::begin`]; a store of a shard is in use (the shard is at work still), damaged, of another study or version, or
    /// holds a run that is another shard's.
    pub fn begin_joined(
        lock: &Arc<FolderLock>,
        identity: &StoreIdentity,
        beginning: ExistingRuns,
        shards: &[(Shard, Folder)],
    ) -> Result<(Self, u64), StoreError> {
        drop(Self::begin(lock, identity, beginning)?);
        let mut file = StoreFile::open(lock.folder(), identity)?;
        let added = join(&mut file, identity, shards)?;
        Ok((Self::serve(lock, file, None)?, added))
    }

    /// Path of the store.
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// How many runs it held when it was opened.
    pub fn runs_at_start(&self) -> u64 {
        self.runs_at_start
    }

    /// Keeps a finished run; returns at once.
    pub fn keep(&self, list: u32, place: u64, run: StoredRun) {
        // Where the writer is gone, `find` and `settle` say so.
        if let Some(requests) = &self.requests {
            let _ = requests.send(Request::Keep { list, place, run });
        }
    }

    /// Whether rows can no longer be written; [`RunStore::flush`] says why.
    pub fn is_broken(&self) -> bool {
        self.is_broken.load(Ordering::Relaxed)
    }

    /// The runs at `places` of a list, each where it is known.
    ///
    /// # Errors
    /// [`StoreError`]: a row is damaged, or the file system refuses.
    pub fn find(&self, list: u32, places: Range<u64>) -> Result<Vec<Option<StoredRun>>, StoreError> {
        self.ask(|reply| Request::Find { list, places, reply })
    }

    /// Waits until everything that was given is on disk; gives the number of runs in the store.
    ///
    /// # Errors
    /// [`StoreError`]: what the file system has refused since.
    pub fn flush(&self) -> Result<u64, StoreError> {
        self.ask(|reply| Request::Settle { reply })
    }

    /// Writes a copy of everything that was given beside the store, which other processes may read by [`RunStore::open_beside`] at any time.
    ///
    /// # Errors
    /// [`StoreError`]: what the file system refuses.
    pub fn publish(&self) -> Result<(), StoreError> {
        self.ask(|reply| Request::Publish { lock: Arc::clone(&self.lock), reply })
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
    /// An error of the file system.
    pub fn remove(mut self) -> Result<(), StoreError> {
        self.close();
        remove_store(&self.lock)
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
