//! Plans of all questions of a study, made once, before anything has run.

use crate::error::StudyError;
use crate::file::{Budget, MAX_RUNS, Study};
use crate::planning::budget::{Limits, budget};
use crate::planning::goals::goals;
use crate::planning::problem::problem;
use crate::question::{Question, QuestionContext, most_surrogate_runs, questions, surrogate_plan};
use crate::response::study_response::StudyResponse;
use crate::runs::memory_at_hand::{MemoryAtHand, MemoryKind};
use loosepin_bounds::{Refinement, SampleTable, Scratch, SurrogatePlan};
use std::path::Path;
use std::thread::available_parallelism;

/// What a run takes in memory beside its numbers: two copies of its inputs with their places, while a round is made.
const BYTES_PER_RUN: usize = 400;
/// What each number of a run takes in memory: its value, and two copies while bounds are computed. Measured on 4,000 to 260,000 runs of
/// 30 and of 560 numbers: 11 to 19 bytes a number and 500 a run.
const BYTES_PER_NUMBER: usize = 24;
/// What is kept of each number at each value of the epistemic inputs where the runs are in a file: its statistics and models of them.
/// Measured on 512 values and 541 numbers: 1.5 kB with models, of which larger studies have no more.
const BYTES_PER_SAMPLE: usize = 1600;
/// What was read of the file lately.
const BYTES_OF_SCRATCH: usize = 128 << 20;
/// What each number of a run takes in the file, which is read as memory.
const BYTES_PER_FILED_NUMBER: usize = 16;
/// What a study takes whatever its size: its texts, pictures and page. Measured: 5 MiB.
const BYTES_OF_STUDY: usize = 8 << 20;
/// What a thread takes: its stack, 2 MiB, and the runs on its lanes. Measured with a slider-crank on 16 and 64 threads: 2.1 to 2.6 MiB.
const BYTES_PER_THREAD: usize = 3 << 20;
/// Of that, what is in use: most of a stack is not. Measured: 0.1 to 0.7 MiB.
const BYTES_USED_PER_THREAD: usize = 1 << 20;
/// So many numbers of all runs, 128 MiB, are in a file beside the results rather than in memory.
const MIN_IN_SCRATCH: usize = 1 << 24;
const BYTES_PER_GIB: f64 = (1_u64 << 30) as f64;

/// Plans of all questions of a study.
pub(crate) struct Plans {
    /// The direct double loop; it is not run where the surrogate stands alone.
    pub refinement: Refinement,
    /// The surrogates, where the study asks for them.
    pub surrogate: Option<SurrogatePlan>,
    /// All questions beside the bounds, in the order in which they make their runs.
    pub questions: Vec<Box<dyn Question>>,
    /// Whether all bounds are those of the surrogates.
    pub is_surrogate_alone: bool,
    /// Limits of the question that gives the bounds.
    pub limits: Limits,
    /// Numbers of a row of the table.
    row_length: usize,
}

impl Plans {
    /// The plans of `study` on `threads` threads; its runs may be in a file if it has a folder.
    ///
    /// # Errors
    /// Its sampling, its surrogates or one of its questions are not possible.
    pub fn new(study: &Study, response: &StudyResponse, has_folder: bool, threads: usize) -> Result<Self, StudyError> {
        let row_length = response.row_length();
        let refinement = Refinement::try_new(problem(study, response), goals(study, response.plan()))?;
        let direct = refinement.plan(&SampleTable::new(row_length));
        let surrogate = surrogate_plan(study, response)?;
        let is_surrogate_alone = study.surrogate.is_some_and(|surrogate| surrogate.is_alone);
        let basis =
            QuestionContext { study, response, double_loop: direct, surrogate: surrogate.as_ref(), is_surrogate_alone };
        let questions = questions(&basis)?;
        let reserved = questions.iter().map(|question| question.most_runs()).fold(0, usize::saturating_add);
        let of_bounds = match &surrogate {
            Some(plan) if is_surrogate_alone => most_surrogate_runs(study, plan),
            _ => direct.most_runs(),
        };
        let stated_runs = of_bounds.saturating_add(reserved);
        let limits = Limits { budget: budget(study, stated_runs, row_length), stated_runs, reserved };
        let numbers = row_length + study.random.len() + study.epistemic.len();
        let points = if has_folder { Some(direct.problem().sampling.outer) } else { None };
        let size = Size { runs: limits.most_runs().min(stated_runs), numbers, points, threads };
        size.check(&MemoryAtHand::now())?;
        Ok(Self { refinement, surrogate, questions, is_surrogate_alone, limits, row_length })
    }

    /// An empty table with room for the runs of the first question. Where they are many their numbers are in a file in `folder`, which
    /// has no name there; in memory where there is no folder. What has to be said of that comes with it.
    pub fn table(&self, folder: Option<&Path>) -> (SampleTable, Option<String>) {
        let runs = self.limits.stated_runs - self.limits.reserved;
        let (scratch, note) =
            scratch(folder.filter(|_| is_large(runs, self.row_length)), runs.saturating_mul(self.row_length));
        (SampleTable::with_capacity(self.row_length, runs, scratch), note)
    }
}

/// A file in `folder`, if there is one, for `numbers` numbers; if it cannot be made, a warning.
fn scratch(folder: Option<&Path>, numbers: usize) -> (Option<Scratch>, Option<String>) {
    let Some(folder) = folder else { return (None, None) };
    let error = match Scratch::in_folder(folder) {
        Ok(scratch) => return (Some(scratch), None),
        Err(error) => error,
    };
    let gib = numbers.saturating_mul(BYTES_PER_NUMBER) as f64 / BYTES_PER_GIB;
    let folder = folder.display();
    let note =
        format!("no file for the numbers of the runs in {folder}: {error}; they take up to {gib:.2} GiB of memory");
    (None, Some(note))
}

/// What a study has to have room for.
#[derive(Debug, Clone, Copy)]
struct Size {
    runs: usize,
    /// Numbers of a run.
    numbers: usize,
    /// Values of the epistemic inputs where its runs may be in a file.
    points: Option<usize>,
    threads: usize,
}

impl Size {
    /// Checks that the number of runs is practical, and that the available memory suffices for them.
    fn check(self, at_hand: &MemoryAtHand) -> Result<(), StudyError> {
        let Self { runs, numbers, threads, .. } = self;
        if runs as u64 > MAX_RUNS {
            return Err(StudyError::TooManyRuns { runs });
        }
        for kind in [MemoryKind::Pages, MemoryKind::Data, MemoryKind::Addresses] {
            let (needed_bytes, at_hand_bytes) = (self.needed_bytes(kind), at_hand.bytes_of(kind).unwrap_or(u64::MAX));
            if needed_bytes > at_hand_bytes {
                let [needed_gib, at_hand_gib] = [needed_bytes, at_hand_bytes].map(|bytes| bytes as f64 / BYTES_PER_GIB);
                return Err(StudyError::TooMuchMemory { runs, numbers, threads, kind, needed_gib, at_hand_gib });
            }
        }
        Ok(())
    }

    fn needed_bytes(self, kind: MemoryKind) -> u64 {
        let per_thread = if kind == MemoryKind::Pages { BYTES_USED_PER_THREAD } else { BYTES_PER_THREAD };
        let fixed = BYTES_OF_STUDY as u64 + self.threads as u64 * per_thread as u64;
        let numbers = self.runs as u64 * self.numbers as u64;
        let of_runs = self.runs as u64 * BYTES_PER_RUN as u64;
        let in_memory = of_runs + numbers * BYTES_PER_NUMBER as u64;
        let needed = match self.points.filter(|_| is_large(self.runs, self.numbers)) {
            Some(points) => {
                let of_samples = points as u64 * (self.numbers * BYTES_PER_SAMPLE) as u64;
                let mapped = if kind == MemoryKind::Addresses { numbers * BYTES_PER_FILED_NUMBER as u64 } else { 0 };
                in_memory.min(of_runs + of_samples + BYTES_OF_SCRATCH as u64 + mapped)
            }
            None => in_memory,
        };
        fixed + needed
    }
}

/// Whether this number of runs is kept in a file if there is a folder for it.
fn is_large(runs: usize, numbers: usize) -> bool {
    numbers.saturating_mul(runs) >= MIN_IN_SCRATCH
}

/// Largest number of runs of `study`; with a budget of time or rounds, the number before its samples grow.
///
/// # Errors
/// The study cannot begin, its sampling is not possible, its budget does not suffice for anything, or the memory at hand does not
/// hold its runs.
pub fn plan_runs(study: &Study) -> Result<usize, StudyError> {
    plan_runs_on(study, default_threads())
}

/// [`plan_runs`] on `threads` threads, each of which takes memory of its own.
///
/// # Errors
/// As for [`plan_runs`].
pub fn plan_runs_on(study: &Study, threads: usize) -> Result<usize, StudyError> {
    Ok(planned(study, &StudyResponse::new(study)?, threads)?.limits.most_runs())
}

/// As many threads as the machine has.
pub fn default_threads() -> usize {
    available_parallelism().map_or(1, usize::from)
}

/// The plans of `study` on `threads` threads, whose budget suffices for a first answer.
pub(crate) fn planned(study: &Study, response: &StudyResponse, threads: usize) -> Result<Plans, StudyError> {
    let plans = Plans::new(study, response, true, threads)?;
    if matches!(plans.limits.budget, Some(Budget::Runs { .. })) {
        let first = match &plans.surrogate {
            Some(surrogate) if plans.is_surrogate_alone => surrogate.most_runs(),
            _ => plans.refinement.plan(&SampleTable::new(response.row_length())).first_round_runs(),
        };
        if !plans.limits.watch().allows(first, 0, 0) {
            return Err(plans.limits.too_small(first));
        }
    }
    Ok(plans)
}

/// Largest number of runs of `study`, as [`plan_runs_on`], if shards make them.
///
/// # Errors
/// As for [`plan_runs_on`], and a budget of time: processes that do not run at the same time cannot share one.
pub fn plan_shards(study: &Study, threads: usize) -> Result<usize, StudyError> {
    refuse_time(study)?;
    plan_runs_on(study, threads)
}

/// That no time ends a study whose rounds are to be the same wherever they are made.
pub(crate) fn refuse_time(study: &Study) -> Result<(), StudyError> {
    match study.budget {
        Some(Budget::Time { .. }) => Err(StudyError::TimeOfShards),
        _ => Ok(()),
    }
}

#[cfg(test)]
mod tests {
    use super::{MemoryAtHand, MemoryKind, Size, scratch};
    use std::path::Path;

    /// A million runs of 15 numbers on 4 threads.
    const MILLION: Size = Size { runs: 1_000_000, numbers: 15, points: None, threads: 4 };
    /// More than any study takes.
    const PLENTY: u64 = 1 << 50;

    fn at_hand(pages_bytes: u64) -> MemoryAtHand {
        MemoryAtHand { pages_bytes, data_bytes: None, addresses_bytes: None }
    }

    fn said(size: Size, at_hand: &MemoryAtHand) -> String {
        size.check(at_hand).expect_err("a byte too few").to_string()
    }

    #[test]
    fn analytic_what_a_plan_needs_and_what_there_is() {
        // 400 bytes a run and 24 a number, 8 MiB, and 1 MiB a thread, of whose 3 MiB not all are used.
        let of_runs = 1_000_000 * (400 + 15 * 24);
        let needed = of_runs + (8 << 20) + 4 * (1 << 20);
        let limited = of_runs + (8 << 20) + 4 * (3 << 20);
        assert!(MILLION.check(&at_hand(needed)).is_ok());
        let begin = "1000000 runs of 15 numbers each on 4 threads need about 0.7";
        assert_eq!(said(MILLION, &at_hand(needed - 1)), format!("{begin}2 GiB of memory; 0.72 GiB are at hand"));
        let data = |bytes| MemoryAtHand { data_bytes: Some(bytes), ..at_hand(PLENTY) };
        assert!(MILLION.check(&data(limited)).is_ok());
        assert_eq!(
            said(MILLION, &data(limited - 1)),
            format!("{begin}3 GiB of memory for data; its limit (ulimit -d) leaves 0.73 GiB")
        );
        let addresses = |bytes| MemoryAtHand { addresses_bytes: Some(bytes), ..at_hand(PLENTY) };
        assert!(MILLION.check(&addresses(limited)).is_ok());
        assert_eq!(
            said(MILLION, &addresses(limited - 1)),
            format!("{begin}3 GiB of address space; its limit (ulimit -v) leaves 0.73 GiB")
        );
    }

    #[test]
    fn analytic_runs_in_a_file_need_memory_for_their_statistics_alone() {
        let fixed = (8 << 20) + 4 * (1 << 20);
        // A million runs of 541 numbers at 256 values: 400 bytes a run, 1600 a number and value, 128 MiB of what was read.
        let large = Size { numbers: 541, points: Some(256), ..MILLION };
        let needed = 1_000_000 * 400 + 256 * 541 * 1600 + (128 << 20);
        assert!(needed < 1 << 30 && large.check(&at_hand(fixed + needed)).is_ok());
        assert!(large.check(&at_hand(fixed + needed - 1)).is_err());
        // The file is read as memory, which takes address space: 16 bytes a number.
        let addresses = needed + 1_000_000 * 541 * 16 + (8 << 20) + 4 * (3 << 20);
        assert_eq!(large.needed_bytes(MemoryKind::Addresses), addresses);
        // Without a folder they are in memory; and what is small is, with one.
        let pages = |size: Size| size.needed_bytes(MemoryKind::Pages);
        assert_eq!(pages(Size { points: None, ..large }), fixed + 1_000_000 * (400 + 541 * 24));
        assert_eq!(pages(Size { runs: 10_000, ..large }), fixed + 10_000 * (400 + 541 * 24));
    }

    #[test]
    fn more_runs_than_anybody_waits_for_are_refused_whatever_the_memory() {
        let of = |runs| Size { runs, numbers: 0, points: None, threads: 1 };
        assert!(of(1 << 30).check(&at_hand(PLENTY)).is_ok());
        assert_eq!(said(of((1 << 30) + 1), &at_hand(PLENTY)), "1073741825 runs; must be at most 1073741824");
    }

    #[test]
    fn a_file_that_cannot_be_made_is_said() {
        let (file, note) = scratch(Some(Path::new("/nowhere/at/all")), 1 << 30);
        assert!(file.is_none());
        let note = note.expect("a note");
        let begin = "no file for the numbers of the runs in /nowhere/at/all: ";
        // 2^30 numbers of 24 bytes.
        assert!(note.starts_with(begin) && note.ends_with("; they take up to 24.00 GiB of memory"), "{note}");
        let (file, note) = scratch(Some(&std::env::temp_dir()), 1 << 30);
        assert!(file.is_some() && note.is_none());
        assert!(matches!(scratch(None, 1 << 30), (None, None)));
    }
}
