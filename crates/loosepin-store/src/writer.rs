//! The thread that owns the file: collects rows to be stored, and commits them in time.

use std::ops::Range;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{Receiver, RecvTimeoutError, SyncSender};
use std::time::{Duration, Instant};

use loosepin_files::FolderLock;

use super::error::StoreError;
use super::file::StoreFile;
use super::row::StoredRun;

/// A finished run waits no longer than this before it is written.
pub const LONGEST_UNSAVED: Duration = Duration::from_millis(500);

/// Numbers that may wait: 64 MiB of them.
const MAX_WAITING_NUMBERS: usize = 8 << 20;

/// Request to the thread.
pub(super) enum Request {
    /// To keep a run.
    Keep {
        /// Its list.
        list: u32,
        /// Its place in the list.
        place: u64,
        /// The run.
        run: StoredRun,
    },
    /// For the runs at some places of a list.
    Find {
        /// The list.
        list: u32,
        /// The places.
        places: Range<u64>,
        /// Receiver of the answer.
        reply: SyncSender<Result<Vec<Option<StoredRun>>, StoreError>>,
    },
    /// To write everything, and a copy of it for others.
    Publish {
        /// The lock of its folder.
        lock: Arc<FolderLock>,
        /// Receiver of the answer.
        reply: SyncSender<Result<(), StoreError>>,
    },
    /// To write everything now.
    Settle {
        /// Receiver of the number of runs.
        reply: SyncSender<Result<u64, StoreError>>,
    },
}

/// Runs that wait, and since when.
#[derive(Default)]
struct Waiting {
    rows: Vec<(u32, u64, StoredRun)>,
    numbers: usize,
    since: Option<Instant>,
}

impl Waiting {
    fn add(&mut self, row: (u32, u64, StoredRun)) {
        self.numbers += row.2.outcome.as_ref().map_or(0, Vec::len);
        self.rows.push(row);
        self.since.get_or_insert_with(Instant::now);
    }

    fn is_due(&self) -> bool {
        self.numbers > MAX_WAITING_NUMBERS || self.left() == Duration::ZERO
    }

    /// How long they may still wait.
    fn left(&self) -> Duration {
        self.since.map_or(LONGEST_UNSAVED, |since| LONGEST_UNSAVED.saturating_sub(since.elapsed()))
    }

    /// Commits everything. What could not be written is not kept for another try: the study stops, and runs it again.
    fn commit(&mut self, file: &mut StoreFile, broken: &mut Option<StoreError>, flag: &AtomicBool) {
        let waiting = std::mem::take(self);
        if waiting.rows.is_empty() || broken.is_some() {
            return;
        }
        if let Err(error) = file.commit(&waiting.rows) {
            *broken = Some(match error {
                StoreError::NotUsable { path, reason } => {
                    StoreError::NotSaved { path, reason, kept: file.runs().unwrap_or(0) }
                }
                error => error,
            });
            flag.store(true, Ordering::Relaxed);
        }
    }
}

/// The runs at `places` of a list: those of `file`, and those of `published` for what it lacks.
fn find(
    file: &StoreFile,
    published: Option<&StoreFile>,
    list: u32,
    places: Range<u64>,
) -> Result<Vec<Option<StoredRun>>, StoreError> {
    let own = file.find(list, places.clone())?;
    let Some(published) = published.filter(|_| own.iter().any(Option::is_none)) else { return Ok(own) };
    let others = published.find(list, places)?;
    Ok(own.into_iter().zip(others).map(|(own, other)| own.or(other)).collect())
}

/// Serves the requests until nobody can send any more. What `published` has is found as if it were in `file`.
pub(super) fn write_requests(
    mut file: StoreFile,
    published: Option<&StoreFile>,
    inbox: &Receiver<Request>,
    flag: &AtomicBool,
) {
    let mut waiting = Waiting::default();
    let mut broken: Option<StoreError> = None;
    loop {
        let request = inbox.recv_timeout(waiting.left());
        match request {
            Ok(Request::Keep { list, place, run }) => waiting.add((list, place, run)),
            Ok(Request::Find { list, places, reply }) => {
                waiting.commit(&mut file, &mut broken, flag);
                let found = broken.clone().map_or_else(|| find(&file, published, list, places), Err);
                // Who asked may have given up.
                let _ = reply.send(found);
            }
            Ok(Request::Publish { lock, reply }) => {
                waiting.commit(&mut file, &mut broken, flag);
                let _ = reply.send(broken.clone().map_or_else(|| file.publish(&lock), Err));
            }
            Ok(Request::Settle { reply }) => {
                waiting.commit(&mut file, &mut broken, flag);
                let _ = reply.send(broken.clone().map_or_else(|| file.runs(), Err));
            }
            Err(RecvTimeoutError::Timeout) => {}
            Err(RecvTimeoutError::Disconnected) => {
                waiting.commit(&mut file, &mut broken, flag);
                return;
            }
        }
        if waiting.is_due() {
            waiting.commit(&mut file, &mut broken, flag);
        }
    }
}
