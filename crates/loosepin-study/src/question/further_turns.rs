//! Effect of turns after the recorded ones, if the motion does not repeat itself.
//!
//! Statistics are those of the recorded turns. Where a motion never repeats itself, later turns may go further: some of the runs are made
//! once more with more turns recorded, and the largest values of both are compared. Up to the end of the recorded turns both are one motion.

use super::found::{Found, StudyRun};
use super::kind::{Planned, Question, QuestionContext, QuestionKind, QuestionTable};
use crate::assemble::{Material, SETTLED};
use crate::error::StudyError;
use crate::file::{Ask, Limit, MAX_RUNS, QuestionSettings, Study};
use crate::places::Where;
use crate::response::columns::StudyColumn;
use crate::response::limits::MAX_RECORDED_TURNS;
use crate::response::planar_response::check_turns;
use crate::response::problem::PrepareError;
use crate::response::study_response::StudyResponse;
use crate::runs::all_runs::Runs;
use loosepin_mechanics::model::CycleSpan;
use loosepin_result::study::{AnswerPart, FurtherOutput, FurtherTurns, QuestionAnswer, Reduction};
use loosepin_text::document::{Entry, Kind, Reader, Reads, count, optional};
use loosepin_text::record;

/// Without `runs` they take this share of the turns that the study has taken, within these limits.
const SHARE_OF_STUDY: f64 = 0.05;
const FEWEST_RUNS: usize = 8;
const MAX_SHARE_RUNS: usize = 64;
/// As many as a run may record beside one turn.
const MAX_TURNS: u64 = MAX_RECORDED_TURNS as u64 - 1;

record! {
    /// the effect of turns after the recorded ones, if the motion does not repeat itself
    lenient struct FurtherTurnsTable for Reads;
    /// number of turns after the recorded ones
    optional count: usize = count(1, MAX_TURNS), "20", or 5;
    /// number of runs to continue, of those whose motion does not repeat itself (at most all of these); if omitted, 8 to 64, for about a
    /// twentieth of the work of the study
    optional runs: usize = count(1, MAX_RUNS), "200";
}

/// The question as it is listed.
pub const KIND: QuestionKind = QuestionKind {
    table: Some(QuestionTable {
        key: optional(
            "further_turns",
            Kind::Table(&FurtherTurnsTable::KEYS),
            "",
            "how many turns after the recorded ones some runs are looked at, where the motion does not repeat itself",
        ),
        read,
    }),
    planned,
};

/// Number of further turns of some runs.
#[derive(Debug, Clone, Copy)]
struct Settings {
    /// Whether the study states them.
    is_stated: bool,
    /// Turns after the recorded ones.
    turns: u32,
    /// Runs that are made again; `None` if their share of the study decides.
    runs: Option<usize>,
}

fn read(written: Option<&Entry<'_>>, reader: &mut Reader, stated: &mut QuestionSettings) {
    let FurtherTurnsTable { count, runs, .. } = FurtherTurnsTable::read_or_usual(reader, written);
    stated.state(Settings { is_stated: written.is_some(), turns: count as u32, runs });
}

/// What turns after the recorded ones change.
struct FurtherTurnsQuestion {
    settings: Settings,
    /// Runs of the bounds at most, among which are those that continue.
    most_of_bounds: usize,
    /// What they change, or why there is nothing to look at; `None` before the runs.
    answer: Option<FurtherTurnsResult>,
}

type FurtherTurnsResult = Result<FurtherTurns, &'static str>;

const IS_TIME: &str = "The study covers a duration, not turns: no turns follow those that are recorded.";
const IS_LIFE: &str = "Joints wear: the life is extrapolated from its cycles, not from further turns.";
const NO_EXTREME: &str =
    "No largest or smallest value of the recorded turns is asked for: further turns change nothing.";
const REPEATS: &str = "Every motion repeats itself: further turns change nothing.";
const CANNOT_GO_ON: &str = "No run could be continued for so many turns.";

/// Planned always: whether a motion repeats itself is known once it has run.
///
/// # Errors
/// A run may not have as many turns as are stated.
fn planned(basis: &QuestionContext<'_>) -> Planned {
    let Some(&settings) = basis.study.questions.get::<Settings>() else { return Ok(None) };
    if settings.is_stated {
        let cycle = &basis.study.cycle;
        check_turns(cycle.transient_turns, cycle.recorded_turns + f64::from(settings.turns)).map_err(by_own_table)?;
    }
    let most_of_bounds = basis.double_loop.most_runs();
    Ok(Some(Box::new(FurtherTurnsQuestion { settings, most_of_bounds, answer: None })))
}

/// Error of the number of further turns, which is too large.
fn by_own_table(error: PrepareError) -> PrepareError {
    match error {
        PrepareError::TooManyTurns { turns, what, most, .. } => {
            PrepareError::TooManyTurns { turns, what, most, table: "further_turns", key: "count" }
        }
        other => other,
    }
}

impl Question for FurtherTurnsQuestion {
    fn most_runs(&self) -> usize {
        // Without a number of them they are few, and what the study has runs for stays what it is.
        self.settings.runs.map_or(0, |runs| runs.min(self.most_of_bounds))
    }

    fn run(&mut self, runs: &mut Runs<'_>, _found: &mut Found) -> Result<(), StudyError> {
        self.answer = Some(further_turns(self.settings, runs)?);
        Ok(())
    }

    fn record(&self, _material: &Material<'_>, _found: &Found, run: &mut StudyRun) -> Result<(), StudyError> {
        match &self.answer {
            Some(Ok(answer)) => run.result.further_turns = Some(answer.clone()),
            // A stated question has an answer in any case.
            Some(Err(reason)) if self.settings.is_stated => {
                let mut answer = QuestionAnswer::new("further_turns", "Further turns");
                answer.add_sentence([AnswerPart::from(*reason)]);
                run.result.answers.push(answer);
            }
            _ => {}
        }
        Ok(())
    }
}

/// What more turns change in the study of `runs`, or why there is nothing to look at.
///
/// # Errors
/// The study was interrupted.
fn further_turns(settings: Settings, runs: &Runs<'_>) -> Result<FurtherTurnsResult, StudyError> {
    let (study, table, plan) = (runs.study, &runs.table, runs.response.plan());
    if matches!(study.cycle.span, CycleSpan::Duration(_)) {
        return Ok(Err(IS_TIME));
    }
    if !study.model.has_start_up() {
        return Ok(Err(NO_EXTREME));
    }
    if study.model.cycles_of_wear().is_some() {
        return Ok(Err(IS_LIFE));
    }
    let columns: Vec<(usize, Reduction)> = plan.columns.iter().enumerate().filter_map(extreme).collect();
    if columns.is_empty() {
        return Ok(Err(NO_EXTREME));
    }
    let is_restless = |run: &usize| {
        table.failure(*run).is_none() && runs.response.extras(table.values(*run)).change_over_last_turn >= SETTLED
    };
    let restless: Vec<usize> = (0..table.len()).filter(is_restless).collect();
    if restless.is_empty() {
        return Ok(Err(REPEATS));
    }
    let continuing = spread(&restless, number_of_runs(settings, study, table.len()));
    let mut longer = study.clone();
    longer.cycle.recorded_turns += f64::from(settings.turns);
    let ask = |&(column, reduction): &(usize, Reduction)| {
        let StudyColumn { output, deviation, .. } = plan.columns[column];
        Ask::of_values(output, deviation, Where::reduced(reduction))
    };
    longer.asks = columns.iter().map(ask).collect();
    longer.requirements.clear();
    // More turns than a run may have.
    let Ok(response) = StudyResponse::new(&longer) else { return Ok(Err(CANNOT_GO_ON)) };
    let later_column: Vec<usize> = response.plan().asks.iter().map(|ask| ask.columns[0]).collect();
    let rows = runs.make_again(&response, &continuing)?;
    let continued: Vec<(&[f64], Vec<f64>)> = continuing
        .iter()
        .zip(rows)
        .filter_map(|(&run, later)| {
            let later = later?;
            Some((table.values(run), later_column.iter().map(|&column| later[column]).collect()))
        })
        .collect();
    if continued.is_empty() {
        return Ok(Err(CANNOT_GO_ON));
    }
    let outputs = columns.iter().enumerate().map(|(place, &(column, reduction))| {
        let excesses: Vec<f64> =
            continued.iter().map(|(recorded, later)| excess(reduction, recorded[column], later[place])).collect();
        let known = plan.columns[column];
        FurtherOutput {
            output: plan.outputs[known.output].name.clone(),
            of: known.deviation,
            reduction,
            mean_excess_si: excesses.iter().sum::<f64>() / excesses.len() as f64,
            largest_excess_si: excesses.iter().copied().fold(0.0, f64::max),
        }
    });
    let broken_later = plan.required().map(|(required, own)| {
        let is_whole = required.location.is_cycle();
        let place = columns.iter().position(|(column, _)| is_whole && *column == own)?;
        let is_kept = |value: f64| keeps(required.limit, value);
        let breaks = continued.iter().filter(|(recorded, later)| is_kept(recorded[own]) && !is_kept(later[place]));
        Some(breaks.count() as u64)
    });
    Ok(Ok(FurtherTurns {
        turns: settings.turns,
        runs: continued.len() as u64,
        broken_later: broken_later.collect(),
        outputs: outputs.collect(),
    }))
}

/// A column that more turns can only move one way.
fn extreme((index, column): (usize, &StudyColumn)) -> Option<(usize, Reduction)> {
    let reduction = column.spot.reduction()?;
    reduction.moved_by_more_turns().map(|_| (index, reduction))
}

/// Excess of the later turns over the recorded ones. Where the recorded turns end a step ends, so that both differ by its error.
fn excess(reduction: Reduction, recorded_si: f64, later_si: f64) -> f64 {
    let direction = reduction.moved_by_more_turns().unwrap_or(f64::NAN);
    (direction * (later_si - recorded_si)).max(0.0)
}

fn keeps(limit: Limit, value_si: f64) -> bool {
    let [lower, upper] = limit.ends();
    (lower..=upper).contains(&value_si)
}

/// The stated number of runs, or a number that takes a small share of the turns of the study.
fn number_of_runs(settings: Settings, study: &Study, made: usize) -> usize {
    if let Some(runs) = settings.runs {
        return runs;
    }
    let own = study.cycle.transient_turns + study.cycle.recorded_turns;
    let affordable = SHARE_OF_STUDY * made as f64 * own / (own + f64::from(settings.turns));
    (affordable as usize).clamp(FEWEST_RUNS, MAX_SHARE_RUNS)
}

/// `count` of `runs`, spread evenly; all of them where there are no more.
fn spread(runs: &[usize], count: usize) -> Vec<usize> {
    let count = count.min(runs.len());
    (0..count).map(|k| runs[(2 * k + 1) * runs.len() / (2 * count)]).collect()
}

#[cfg(test)]
mod tests {
    use super::{excess, spread};
    use loosepin_result::study::Reduction;

    #[test]
    fn runs_are_spread_evenly_and_each_is_taken_once() {
        let runs: Vec<usize> = (0..100).map(|run| 3 * run).collect();
        assert_eq!(spread(&runs, 4), [36, 111, 186, 261]);
        assert_eq!(spread(&runs, 100), runs);
        assert_eq!(spread(&runs[..3], 8), [0, 3, 6]);
    }

    #[test]
    fn analytic_more_turns_move_each_extreme_its_way() {
        assert_eq!(excess(Reduction::Maximum, 1.0, 1.5), 0.5);
        assert_eq!(excess(Reduction::Minimum, -1.0, -1.5), 0.5);
        assert_eq!(excess(Reduction::MaximumAbsolute, 2.0, 2.0 - 1e-12), 0.0);
    }
}
