//! Runs of a study at inputs that the caller chooses: a design of experiments, one row for each run.

use crate::drafts::progress::Progress;
use crate::error::StudyError;
use crate::file::{EpistemicInput, EpistemicSubject, MAX_RUNS, RandomInput, RandomSubject, Study};
use crate::planning::problem::problem;
use crate::response::extras::RunExtras;
use crate::response::problem::PrepareError;
use crate::response::recorded_output::RecordedOutput;
use crate::response::study_response::StudyResponse;
use crate::runs::evaluate::{RunOutcome, Work, evaluate_into};
use crate::runs::memory_at_hand::{MemoryAtHand, MemoryKind};
use crate::runs::table::{ExtraColumns, RunColumn};
use loosepin_bounds::{Problem, Purpose, RunInputs};
use loosepin_mechanics::model::{PlayId, QuantityError, QuantityId, Values};
use rayon::prelude::*;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::sync::{Arc, Mutex, PoisonError};

/// Runs that one thread makes side by side at least: with fewer, another thread compiles more than it runs.
const MIN_RUNS_PER_THREAD: usize = 8;

/// What each number of a run takes in memory: its value, and a copy with its columns in the table of the caller.
const BYTES_PER_NUMBER: usize = 24;
/// What a run takes beside: its inputs, their copies and places.
const BYTES_PER_RUN: usize = 400;
const BYTES_PER_GIB: f64 = (1_u64 << 30) as f64;

/// A compiled study, and its runs at any inputs. A run has the same bits whatever stands in the other rows, for any number of threads.
///
/// Where clearances of a run are zero, other joints have play than in the model: such runs are of a mechanism of their own, with the same
/// ideal motion.
pub struct DesignRuns {
    study: Study,
    response: StudyResponse,
    problem: Problem,
    /// Compiled with other joints with play, or why that is impossible.
    others: Mutex<Vec<OtherPlays>>,
}

/// The study with these joints with play.
type OtherPlays = (Vec<PlayId>, Result<Arc<StudyResponse>, String>);

/// Finished runs of a design.
pub struct DesignTable {
    /// The numbers of each run, or why it failed in words; `None` if it was not made before the stop.
    pub rows: Vec<Option<Result<Vec<f64>, String>>>,
    /// A run whose tolerance is coarse for its smallest clearance, in words, where there is one.
    pub coarse: Option<String>,
    /// Counters of the runs, column by column, with the names that they have in `runs.parquet`. Where a joint has no play, it has no
    /// contact, and its forces are not numbers.
    pub counters: Vec<RunColumn>,
}

/// What is known of a run before it is made.
#[derive(Clone)]
enum Judged {
    Fine,
    Coarse(f64, String),
    Refused(String),
}

impl DesignRuns {
    /// Compiles `study`.
    ///
    /// # Errors
    /// The study cannot begin; the second value is the study.
    pub fn new(study: Study) -> Result<Self, Box<(StudyError, Study)>> {
        match StudyResponse::new(&study) {
            Ok(response) => {
                Ok(Self { problem: problem(&study, &response), study, response, others: Mutex::new(Vec::new()) })
            }
            Err(error) => Err(Box::new((error.into(), study))),
        }
    }

    /// The study.
    pub fn study(&self) -> &Study {
        &self.study
    }

    /// Numbers of a row of inputs: random inputs, then epistemic ones, each kind in file order.
    pub fn inputs(&self) -> usize {
        self.study.random.len() + self.study.epistemic.len()
    }

    /// Numbers of a row that a run delivers.
    pub fn columns(&self) -> usize {
        self.response.plan().columns.len()
    }

    /// Everything that each run records, each once.
    pub fn recorded(&self) -> Vec<RecordedOutput> {
        RecordedOutput::of_plan(self.response.plan())
    }

    /// What each question asks for, in the order of the questions.
    pub fn asked(&self) -> Vec<RecordedOutput> {
        let plan = self.response.plan();
        plan.asks.iter().filter_map(|ask| RecordedOutput::of_ask(plan, ask)).collect()
    }

    /// The inputs of a run at a point of the unit cube, with a coordinate for each input: random inputs by their distributions and
    /// correlations, what is not known as if it were uniform over its range.
    pub fn inputs_at(&self, point: &[f64]) -> Vec<f64> {
        self.problem.inputs_at(point).concat()
    }

    /// Whether a number may be the value of an input: any finite one, of a law its place in the list of laws, of the place of a journal one from
    /// 0 to 1.
    pub fn is_value(&self, input: usize, value: f64) -> bool {
        if let Some(RandomInput { subject: RandomSubject::Journal { .. }, .. }) = self.study.random.get(input) {
            return (0.0..=1.0).contains(&value);
        }
        let epistemic = input.checked_sub(self.study.random.len()).and_then(|place| self.study.epistemic.get(place));
        value.is_finite()
            && epistemic.is_none_or(|known| match &known.subject {
                EpistemicSubject::Law { laws, .. } => (0..laws.len()).any(|place| place as f64 == value),
                EpistemicSubject::Play => (-1.0..=1.0).contains(&value),
                EpistemicSubject::Quantity(_) | EpistemicSubject::Parameter { .. } => true,
            })
    }

    /// Makes a run for each of `rows`, whose values are inputs as in [`Self::inputs`] and fulfil [`Self::is_value`], on so many threads.
    /// Once `stop` is set no further run begins.
    ///
    /// # Errors
    /// The threads could not be started, or the memory at hand does not hold the runs.
    pub fn evaluate(
        &self,
        rows: &[Vec<f64>],
        threads: usize,
        progress: &dyn Progress,
        stop: &AtomicBool,
    ) -> Result<DesignTable, StudyError> {
        let random = self.study.random.len();
        let threads = threads.min(rows.len().div_ceil(MIN_RUNS_PER_THREAD)).max(1);
        self.check_memory(rows.len(), threads, &MemoryAtHand::now())?;
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build()?;
        let run = |row: &Vec<f64>| {
            let ([round, point, replicate, index], (random, epistemic)) = ([0; 4], row.split_at(random));
            let (random, epistemic) = (random.to_vec(), epistemic.to_vec());
            RunInputs { round, purpose: Purpose::DoubleLoop, point, replicate, index, random, epistemic }
        };
        let batch: Vec<RunInputs> = rows.iter().map(run).collect();
        progress.runs(0, batch.len());
        let judged: Vec<Judged> = pool.install(|| batch.par_iter().map(|inputs| self.judged(inputs)).collect());
        let kept = judged.iter().map(|judged| match judged {
            Judged::Refused(words) => Some(Err(words.clone())),
            Judged::Fine | Judged::Coarse(..) => None,
        });
        let mut rows: Vec<Option<Result<Vec<f64>, String>>> = kept.collect();
        let finished = AtomicUsize::new(rows.iter().flatten().count());
        let heard = |_: usize, _: &RunOutcome<String>| {
            progress.runs(finished.fetch_add(1, Ordering::Relaxed) + 1, batch.len());
        };
        let is_stopped = || stop.load(Ordering::Relaxed);
        let mut extras: Vec<Option<(RunExtras, usize)>> = vec![None; batch.len()];
        let mut joints: Vec<Vec<String>> = Vec::new();
        for (plays, runs) in self.by_plays(&batch, &rows) {
            let other;
            let response = if plays == self.response.plays() {
                &self.response
            } else {
                match self.other(&plays, &batch[runs[0]]) {
                    Ok(compiled) => {
                        other = compiled;
                        &*other
                    }
                    Err(words) => {
                        for run in runs {
                            rows[run] = Some(Err(words.clone()));
                            heard(run, &Err(words.clone()));
                        }
                        continue;
                    }
                }
            };
            let mut is_waiting = vec![false; batch.len()];
            runs.iter().for_each(|&run| is_waiting[run] = true);
            let work = Work { batch: &batch, is_waiting: &is_waiting, response, stop };
            rows = pool.install(|| evaluate_into(&work, rows, &is_stopped, &heard, |failure| failure.to_string()));
            for run in runs {
                if let Some(Ok(row)) = &mut rows[run] {
                    extras[run] = Some((response.extras(row), joints.len()));
                    row.truncate(self.columns());
                }
            }
            joints.push(response.joints().to_vec());
        }
        let counters = self.counters(&extras, &joints);
        let coarse = judged.into_iter().filter_map(|judged| match judged {
            Judged::Coarse(clearance_m, words) => Some((clearance_m, words)),
            Judged::Fine | Judged::Refused(_) => None,
        });
        let coarse = coarse.min_by(|(one_m, _), (other_m, _)| one_m.total_cmp(other_m)).map(|(_, words)| words);
        Ok(DesignTable { rows, coarse, counters })
    }

    /// The runs that are not made yet, by their joints with play. Those whose values break a rule, which they report themselves, are with
    /// the runs of the model.
    fn by_plays(
        &self,
        batch: &[RunInputs],
        made: &[Option<Result<Vec<f64>, String>>],
    ) -> Vec<(Vec<PlayId>, Vec<usize>)> {
        let mut groups: Vec<(Vec<PlayId>, Vec<usize>)> = Vec::new();
        for (run, inputs) in batch.iter().enumerate().filter(|(run, _)| made[*run].is_none()) {
            let values = self.response.values(&inputs.random, &inputs.epistemic).ok();
            let plays = match values {
                Some(values) => self.study.model.plays_with_contact(&values),
                None => self.response.plays().to_vec(),
            };
            match groups.iter_mut().find(|(known, _)| *known == plays) {
                Some((_, runs)) => runs.push(run),
                None => groups.push((plays, vec![run])),
            }
        }
        groups
    }

    /// The study with the joints with play `plays`, which those of the run `inputs` are; compiled once.
    fn other(&self, plays: &[PlayId], inputs: &RunInputs) -> Result<Arc<StudyResponse>, String> {
        let mut others = self.others.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some((_, known)) = others.iter().find(|(known, _)| known == plays) {
            return known.clone();
        }
        let random = self.study.random.iter().map(RandomInput::quantity).zip(&inputs.random);
        let epistemic = self.study.epistemic.iter().map(EpistemicInput::quantity).zip(&inputs.epistemic);
        let values = random.chain(epistemic).filter_map(|(quantity, &value)| Some((quantity?, value)));
        let at: Vec<(QuantityId, f64)> =
            values.filter(|(quantity, _)| self.study.model.has_play_from(*quantity)).collect();
        let compiled = StudyResponse::with_plays(&self.study, &at).map(Arc::new).map_err(|error| error.to_string());
        others.push((plays.to_vec(), compiled.clone()));
        compiled
    }

    /// The rule that the values of a run break, if they break one: it cannot be made.
    pub fn broken_rule(&self, row: &[f64]) -> Option<QuantityError> {
        let (random, epistemic) = row.split_at(self.study.random.len());
        self.response.values(random, epistemic).err()
    }

    /// The columns of counters; `joints` are those with play of each group of runs.
    fn counters(&self, extras: &[Option<(RunExtras, usize)>], joints: &[Vec<String>]) -> Vec<RunColumn> {
        let names = self.study.model.play_names();
        let all: Vec<String> = names
            .into_iter()
            .filter(|name| self.response.joints().contains(name) || joints.iter().flatten().any(|own| own == name))
            .collect();
        let mut columns = ExtraColumns::new(&all);
        let failed = RunExtras::read(&vec![f64::NAN; RunExtras::count(all.len())], all.len());
        for run in extras {
            let Some((extras, group)) = run else {
                columns.push(&failed);
                continue;
            };
            let of_joint = |name: &String| match joints[*group].iter().position(|own| own == name) {
                Some(place) => extras.joints[place],
                None => failed.joints[0],
            };
            columns.push(&RunExtras { joints: all.iter().map(of_joint).collect(), ..extras.clone() });
        }
        columns.into_columns(&all)
    }

    /// That the memory at hand holds so many runs.
    fn check_memory(&self, runs: usize, threads: usize, at_hand: &MemoryAtHand) -> Result<(), StudyError> {
        if runs as u64 > MAX_RUNS {
            return Err(StudyError::TooManyRuns { runs });
        }
        let numbers = self.inputs() + self.response.row_length();
        let needed_bytes = numbers.saturating_mul(BYTES_PER_NUMBER).saturating_add(BYTES_PER_RUN).saturating_mul(runs);
        for kind in [MemoryKind::Pages, MemoryKind::Data, MemoryKind::Addresses] {
            if let Some(bytes) = at_hand.bytes_of(kind).filter(|&bytes| needed_bytes as u64 > bytes) {
                let [needed_gib, at_hand_gib] = [needed_bytes as f64, bytes as f64].map(|bytes| bytes / BYTES_PER_GIB);
                return Err(StudyError::TooMuchMemory { runs, numbers, threads, kind, needed_gib, at_hand_gib });
            }
        }
        Ok(())
    }

    /// Whether a run can be compared with the others, and is resolved by the tolerance. The run itself reports values that break a rule.
    fn judged(&self, inputs: &RunInputs) -> Judged {
        let Ok(values) = self.response.values(&inputs.random, &inputs.epistemic) else { return Judged::Fine };
        let speed_rad_s = |values: &Values| self.study.model.input(self.study.cycle.span, values).speed_rad_s;
        if !(speed_rad_s(&values) * speed_rad_s(self.response.nominal()) > 0.0) {
            return Judged::Refused("the drive stands still or turns the other way than in the model".to_owned());
        }
        let Some(smallest) = self.study.model.smallest_clearance(&values) else { return Judged::Fine };
        let clearance_m = smallest.clearance_m;
        match smallest.check(self.study.sampling.tolerance_m) {
            Ok(None) => Judged::Fine,
            Ok(Some(warning)) => Judged::Coarse(clearance_m, warning.to_string()),
            Err(error) => Judged::Refused(error.to_string()),
        }
    }
}

/// The argument of a program that is to blame where a study that it stated ([`Study::of_evaluated`]) cannot begin, if one is.
pub fn argument_of(error: &StudyError) -> Option<&'static str> {
    match error {
        StudyError::Prepare(PrepareError::UncertainStart { .. } | PrepareError::SpeedThroughZero { .. }) => {
            Some("inputs")
        }
        StudyError::Prepare(PrepareError::PoseNotRecorded { .. } | PrepareError::PathStandsStill { .. }) => {
            Some("outputs")
        }
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::DesignRuns;
    use crate::runs::memory_at_hand::MemoryAtHand;
    use crate::written::texts::study_with;

    #[test]
    fn more_runs_than_the_memory_holds_are_refused() {
        let study = study_with("cases/slider_crank_worn_pin/study.toml", &[]);
        let runs = DesignRuns::new(study).unwrap_or_else(|refused| panic!("{}", refused.0));
        let at_hand = MemoryAtHand { pages_bytes: 1 << 30, data_bytes: None, addresses_bytes: None };
        assert!(runs.check_memory(10_000, 2, &at_hand).is_ok());
        let refused = runs.check_memory(1_000_000, 2, &at_hand).map_err(|error| error.to_string());
        let text = "1000000 runs of 560 numbers each on 2 threads need about 12.89 GiB of memory; 1.00 GiB are at hand";
        assert_eq!(refused, Err(text.to_owned()));
    }
}
