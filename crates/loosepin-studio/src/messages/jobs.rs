//! Background jobs.

use loosepin::report::DraftBand;
use loosepin::study::result::Verdict;
use serde::Serialize;

/// The state of a job.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum JobState {
    /// Others are before it.
    Waiting,
    /// The job is running.
    Running,
    /// Its results are there.
    Done,
    /// The job has failed.
    Failed,
    /// Somebody stopped it; its runs are kept.
    Stopped,
}

/// Kind of a job.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum JobKind {
    /// A study.
    Study,
    /// One mechanism by itself.
    Run,
}

/// A background job.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Job {
    /// Its number.
    pub id: u64,
    /// Which of both.
    pub kind: JobKind,
    /// The study; of a single run the result that it belongs to.
    pub study: String,
    /// Its name.
    pub title: String,
    /// Its state.
    pub state: JobState,
    /// Finished runs.
    pub finished: usize,
    /// Upper limit of its runs.
    pub most: usize,
    /// Since it began to run.
    pub seconds: f64,
    /// Results, in sentences.
    pub words: Vec<String>,
    /// Intermediate results before it is finished.
    pub draft: Option<JobDraft>,
    /// Why it failed, in a sentence.
    pub reason: Option<String>,
    /// Errors, if it failed.
    pub diagnostics: Vec<String>,
    /// Folder of its results, in the served folder.
    pub result: Option<String>,
    /// Over all requirements.
    pub verdict: Option<Verdict>,
}

/// Intermediate results of a study.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct JobDraft {
    /// In sentences.
    pub words: Vec<String>,
    /// Bands over the cycle from the runs so far.
    pub bands: Vec<DraftBand>,
}
