//! Options for running a study.

use crate::drafts::progress::Progress;
use crate::runs::external_runs::RunProvider;
use crate::runs::run_subset::RunSubset;
use loosepin_store::RunStore;
use std::sync::atomic::AtomicBool;

/// Options for running a study. The result is the same for any of them.
#[derive(Clone, Copy)]
pub struct RunOptions<'a> {
    /// Number of threads.
    pub threads: usize,
    /// Receives its progress.
    pub progress: &'a dyn Progress,
    /// Stops it when set.
    pub stop: &'a AtomicBool,
    /// Store of finished runs; none if omitted.
    pub store: Option<&'a RunStore>,
    /// Which of the runs are made here. A part that is not the whole needs a store.
    pub run_subset: RunSubset,
    /// Makes the runs in place of the threads.
    pub provider: Option<&'a dyn RunProvider>,
}

impl<'a> RunOptions<'a> {
    /// All runs made here, on `threads` threads, without a store.
    pub fn new(threads: usize, progress: &'a dyn Progress, stop: &'a AtomicBool) -> Self {
        Self { threads, progress, stop, store: None, run_subset: RunSubset::Whole, provider: None }
    }
}
