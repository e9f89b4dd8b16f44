//! Studies in the background: one runs, the others wait. Single runs, which take seconds, do not wait for studies.

use std::collections::VecDeque;
use std::io;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Condvar, Mutex, MutexGuard, PoisonError};
use std::thread::{self, JoinHandle};
use std::time::{Duration, Instant};

use loosepin::report::{draft_bands, draft_text};
use loosepin::study::result::Draft;
use loosepin::study::{Progress, default_threads};
use tokio::sync::broadcast;

use crate::files::folder::Folder;
use crate::jobs::job::{Failure, Outcome, read_study, run, run_witness};
use crate::messages::{Job, JobDraft, JobKind, JobState, Shown};
use crate::view::texts::plain;

/// Most jobs that wait.
const MAX_WAITING: usize = 16;
/// Jobs that are remembered after they have ended.
const MAX_ENDED: usize = 50;
/// Least time between two messages on a job that runs.
const REST: Duration = Duration::from_millis(200);
/// Messages that a slow connection may lag behind; it is sent the newest with the next one.
const BEHIND: usize = 64;

/// A task of the queue.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Task {
    /// A study that is saved.
    Study {
        /// Its path in the served folder.
        path: String,
        /// The texts that the page shows; those on the disk where it says none.
        shown: Option<Box<Shown>>,
    },
    /// The mechanism at a witness of a finished study.
    Witness {
        /// Path of the result.
        result: String,
        /// Place among its witnesses.
        witness: usize,
    },
}

impl Task {
    fn kind(&self) -> JobKind {
        match self {
            Self::Study { .. } => JobKind::Study,
            Self::Witness { .. } => JobKind::Run,
        }
    }

    fn subject(&self) -> &str {
        match self {
            Self::Study { path, .. } | Self::Witness { result: path, .. } => path,
        }
    }
}

/// The jobs of a server.
pub struct Jobs {
    folder: Folder,
    state: Mutex<State>,
    woken: Condvar,
    told: broadcast::Sender<Job>,
}

#[derive(Default)]
struct State {
    jobs: Vec<Job>,
    waiting: VecDeque<(u64, Task)>,
    running: Vec<(u64, Arc<AtomicBool>)>,
    last_id: u64,
    is_closed: bool,
}

impl Jobs {
    /// None yet, of studies in `folder`; with the threads that run them.
    ///
    /// # Errors
    /// The system starts no thread.
    pub fn begin(folder: &Folder) -> io::Result<(Arc<Self>, Vec<JoinHandle<()>>)> {
        let (told, _) = broadcast::channel(BEHIND);
        let jobs = Arc::new(Self { folder: folder.clone(), state: Mutex::default(), woken: Condvar::new(), told });
        let mut workers = Vec::new();
        for kind in [JobKind::Study, JobKind::Run] {
            let worker = Arc::clone(&jobs);
            // Where it is refused, those that were started end by themselves.
            let started = thread::Builder::new().spawn(move || worker.work(kind)).inspect_err(|_| jobs.close())?;
            workers.push(started);
        }
        Ok((jobs, workers))
    }

    fn state(&self) -> MutexGuard<'_, State> {
        self.state.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// All of them, in the order in which they were asked for.
    pub fn all(&self) -> Vec<Job> {
        self.state().jobs.clone()
    }

    /// Whether a job on a study or result waits or runs.
    pub fn is_open(&self, subject: &str) -> bool {
        let is_open = |job: &Job| matches!(job.state, JobState::Waiting | JobState::Running);
        self.state().jobs.iter().any(|job| is_open(job) && plain(job.study.trim_end_matches('/')) == subject)
    }

    /// Hears of each change.
    pub fn listen(&self) -> broadcast::Receiver<Job> {
        self.told.subscribe()
    }

    /// Adds a task to the queue.
    ///
    /// # Errors
    /// Too many wait, or one on the same study or result waits or runs already.
    pub fn add(&self, task: Task) -> Result<(), String> {
        let mut state = self.state();
        let is_open = |job: &Job| matches!(job.state, JobState::Waiting | JobState::Running);
        let (kind, subject) = (task.kind(), task.subject().to_owned());
        if state.jobs.iter().any(|job| is_open(job) && job.kind == kind && job.study == subject) {
            return Err(match kind {
                JobKind::Study => format!("{subject} is already running"),
                JobKind::Run => format!("a single run of {subject} is not finished yet: wait for it, or stop it"),
            });
        }
        if state.waiting.len() >= MAX_WAITING {
            return Err(format!("{MAX_WAITING} runs are already waiting; stop one of them, or wait"));
        }
        state.last_id += 1;
        let job = Job {
            id: state.last_id,
            kind,
            study: subject.clone(),
            title: subject,
            state: JobState::Waiting,
            finished: 0,
            most: 0,
            seconds: 0.0,
            words: Vec::new(),
            draft: None,
            reason: None,
            diagnostics: Vec::new(),
            result: None,
            verdict: None,
        };
        let id = job.id;
        state.waiting.push_back((id, task));
        state.jobs.push(job.clone());
        let ended = state.jobs.iter().filter(|job| !is_open(job)).count();
        if ended > MAX_ENDED
            && let Some(oldest) = state.jobs.iter().position(|job| !is_open(job))
        {
            state.jobs.remove(oldest);
        }
        drop(state);
        let _ = self.told.send(job);
        self.woken.notify_all();
        Ok(())
    }

    /// Stops a job, or takes it out of the queue.
    pub fn stop(&self, id: u64) {
        let mut state = self.state();
        if let Some((_, stop)) = state.running.iter().find(|(running, _)| *running == id) {
            stop.store(true, Ordering::Relaxed);
            return;
        }
        let before = state.waiting.len();
        state.waiting.retain(|(waiting, _)| *waiting != id);
        if state.waiting.len() < before {
            drop(state);
            self.change(id, |job| job.state = JobState::Stopped);
        }
    }

    /// Stops what runs, and begins nothing any more.
    pub fn close(&self) {
        let mut state = self.state();
        state.is_closed = true;
        state.running.iter().for_each(|(_, stop)| stop.store(true, Ordering::Relaxed));
        drop(state);
        self.woken.notify_all();
    }

    /// Changes a job, and notifies all listeners.
    fn change(&self, id: u64, change: impl FnOnce(&mut Job)) {
        let mut state = self.state();
        if let Some(job) = state.jobs.iter_mut().find(|job| job.id == id) {
            change(job);
            let job = job.clone();
            drop(state);
            // Nobody may be listening.
            let _ = self.told.send(job);
        }
    }

    fn work(&self, kind: JobKind) {
        while let Some((id, task, stop)) = self.next(kind) {
            let began = Instant::now();
            let outcome = self.run(id, &task, &stop, began);
            self.state().running.retain(|(running, _)| *running != id);
            self.change(id, |job| {
                job.seconds = began.elapsed().as_secs_f64();
                job.draft = None;
                match outcome {
                    Ok(Outcome::Finished { result, words, verdict }) => {
                        job.state = JobState::Done;
                        (job.result, job.words, job.verdict) = (Some(result), words, verdict);
                    }
                    Ok(Outcome::Stopped) => job.state = JobState::Stopped,
                    Err(Failure { reason, lines }) => {
                        job.state = JobState::Failed;
                        (job.reason, job.diagnostics) = (Some(reason), lines);
                    }
                }
            });
        }
    }

    /// Waits for the next job of a kind in the queue; `None` after the end.
    fn next(&self, kind: JobKind) -> Option<(u64, Task, Arc<AtomicBool>)> {
        let mut state = self.state();
        loop {
            if state.is_closed {
                return None;
            }
            let place = state.waiting.iter().position(|(_, task)| task.kind() == kind);
            if let Some((id, task)) = place.and_then(|place| state.waiting.remove(place)) {
                let stop = Arc::new(AtomicBool::new(false));
                state.running.push((id, Arc::clone(&stop)));
                return Some((id, task, stop));
            }
            state = self.woken.wait(state).unwrap_or_else(PoisonError::into_inner);
        }
    }

    fn run(&self, id: u64, task: &Task, stop: &AtomicBool, began: Instant) -> Result<Outcome, Failure> {
        self.change(id, |job| job.state = JobState::Running);
        let (path, shown) = match task {
            Task::Study { path, shown } => (path, shown),
            Task::Witness { result, witness } => {
                let named = |title: String| self.change(id, |job| job.title = title);
                return run_witness(&self.folder, result, *witness, &named, stop);
            }
        };
        let study = read_study(&self.folder, path, shown.as_deref())?;
        self.change(id, |job| job.title.clone_from(&study.name));
        let threads = default_threads();
        let teller = Teller { jobs: self, id, began, last: Mutex::new(None) };
        run(&self.folder, &study, &teller, stop, threads)
    }
}

/// Tells how far a job is.
struct Teller<'j> {
    jobs: &'j Jobs,
    id: u64,
    began: Instant,
    last: Mutex<Option<Instant>>,
}

impl Progress for Teller<'_> {
    fn runs(&self, finished: usize, most: usize) {
        let mut last = self.last.lock().unwrap_or_else(PoisonError::into_inner);
        if last.is_some_and(|last| last.elapsed() < REST) {
            return;
        }
        *last = Some(Instant::now());
        drop(last);
        self.jobs.change(self.id, |job| {
            (job.finished, job.most, job.seconds) = (finished, most, self.began.elapsed().as_secs_f64());
        });
    }

    fn wants_drafts(&self) -> bool {
        true
    }

    fn draft(&self, draft: &Draft) {
        let text = draft_text(draft);
        let draft = JobDraft {
            words: Some(text).filter(|text| !text.is_empty()).into_iter().collect(),
            bands: draft_bands(draft),
        };
        self.jobs.change(self.id, |job| job.draft = Some(draft));
    }
}
