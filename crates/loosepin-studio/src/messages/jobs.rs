//! What runs in the background.

use loosepin::report::DraftBand;
use loosepin::study::result::Verdict;
use serde::Serialize;

/// The state of a job.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum JobState {
    /// Others are before it.
    Waiting,
    /// It runs.
    Running,
    /// Its results are there.
    Done,
    /// It came to no result.
    Failed,
    /// Somebody stopped it; its runs are kept.
    Stopped,
}

/// What a job runs.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum JobKind {
    /// A study.
    Study,
    /// One mechanism by itself.
    Run,
}

/// What is run in the background.
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
    /// What becomes of it.
    pub state: JobState,
    /// Finished runs.
    pub finished: usize,
    /// The runs that it may come to.
    pub most: usize,
    /// Since it began to run.
    pub seconds: f64,
    /// What came out, in sentences.
    pub words: Vec<String>,
    /// What is known before it is finished.
    pub draft: Option<JobDraft>,
    /// What is wrong, where it failed.
    pub diagnostics: Vec<String>,
    /// Folder of its results, in the served folder.
    pub result: Option<String>,
    /// Over all requirements.
    pub verdict: Option<Verdict>,
}

/// What is known of a study before it is finished.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct JobDraft {
    /// In sentences.
    pub words: Vec<String>,
    /// Bands over the cycle from the runs so far.
    pub bands: Vec<DraftBand>,
}
