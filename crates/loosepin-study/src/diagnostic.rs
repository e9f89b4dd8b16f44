//! Errors of a study as diagnostics.

use super::error::StudyError;
use super::file::Study;
use crate::response::problem::PrepareError;
use loosepin_bounds::{PlanError, SurrogatePlanError};
use loosepin_text::diagnostics::{Code, Diagnostic, Place, Problem};
use loosepin_text::document::parse_toml;
use loosepin_text::units::format_value;

/// The middle of an interval is the value of the model where they differ by less than this share.
const MIDDLE_TOLERANCE: f64 = 1e-9;

impl Problem for StudyError {
    fn code(&self) -> Code {
        match self {
            Self::Prepare(error) => error.code(),
            Self::NothingAsked => Code::NothingAsked,
            Self::Loosened { .. } => Code::AskNotPossible,
            Self::Plan(_)
            | Self::Contributors(_)
            | Self::Surrogate(_)
            | Self::Promise(_)
            | Self::TimeOfShards
            | Self::TooManyRuns { .. }
            | Self::BudgetTooSmall { .. } => Code::SamplingNotPossible,
            Self::TooMuchMemory { .. } => Code::TooMuchMemory,
            Self::Threads(_) => Code::NoThreads,
            Self::Store(error) => error.code(),
            Self::Table(_) | Self::AllFailed { .. } => Code::AllRunsFailed,
            Self::TooManyFailed(_) => Code::TooManyFailed,
            Self::Interrupted { .. } => Code::Interrupted,
            Self::RoundOpen(_) => Code::RoundOpen,
            Self::NotMade { .. } => Code::RunsNotMade,
        }
    }

    fn hint(&self) -> Option<String> {
        match self {
            Self::Prepare(error) => error.hint(),
            Self::NothingAsked => Some("run loosepin identify, or add [[ask]] or [[require]]".to_owned()),
            Self::AllFailed { reason, .. } => reason.hint(),
            Self::BudgetTooSmall { least, .. } => Some(format!(
                "a budget of {least} runs suffices for a first answer; smaller outer and inner under [sampling] need fewer"
            )),
            Self::TooManyRuns { .. } => Some("smaller outer and inner under [sampling] need fewer runs".to_owned()),
            Self::TooMuchMemory { .. } => Some(
                "smaller outer and inner under [sampling] need fewer runs; poses need fewer numbers than curves; \
                 each of --threads takes memory"
                    .to_owned(),
            ),
            Self::Threads(_) => Some(
                "ask for fewer with --threads, or raise the limit of memory (ulimit -v) or of processes (ulimit -u)"
                    .to_owned(),
            ),
            Self::Store(error) => error.hint(),
            Self::Interrupted { .. } => Some("continue with the same command and --resume".to_owned()),
            Self::TooManyFailed(failed) => {
                let again =
                    failed.commonest.as_ref().map(|reason| format!("`{}` repeats one; ", reason.example.command));
                Some(format!(
                    "{}--resume --most-failed SHARE goes on with the runs that are kept",
                    again.unwrap_or_default()
                ))
            }
            Self::RoundOpen(_) => Some("run its shards, then loosepin merge with their folders".to_owned()),
            Self::NotMade { .. } => {
                Some("what was made is kept: continue with the same command and --resume".to_owned())
            }
            Self::TimeOfShards => Some("state it in runs or rounds, for example 200000runs".to_owned()),
            Self::Plan(_)
            | Self::Contributors(_)
            | Self::Surrogate(_)
            | Self::Promise(_)
            | Self::Table(_)
            | Self::Loosened { .. } => None,
        }
    }
}

impl StudyError {
    /// The diagnostic about the study, or about its model, at the part that it concerns.
    pub fn diagnostic(&self, study: &Study) -> Diagnostic {
        match self {
            Self::Prepare(PrepareError::Mechanism(error)) => {
                study.model.diagnostic_of_mechanism(error).unwrap_or_else(|| Diagnostic::error(self, None))
            }
            Self::Prepare(PrepareError::InSpace { found }) => (**found).clone(),
            Self::Prepare(PrepareError::OfModel { failure }) => {
                study.model.diagnostic_of_run(failure).unwrap_or_else(|| Diagnostic::error(self, None))
            }
            Self::Prepare(PrepareError::Nominal { .. }) if let Some((place, words)) = middle_of(study) => {
                let hint = Some(format!("that is {words}, which the study says and not the model"));
                Diagnostic { hint, ..Diagnostic::error(self, Some(place)) }
            }
            Self::Prepare(PrepareError::Nominal { failure }) | Self::AllFailed { reason: failure, .. } => {
                // The words are those of the study, the place is that of the model.
                let place = study.model.diagnostic_of_run(failure).and_then(|found| found.place);
                Diagnostic { place, ..Diagnostic::error(self, None) }
            }
            Self::Plan(_)
            | Self::Contributors(_)
            | Self::Surrogate(_)
            | Self::Promise(_)
            | Self::TooManyRuns { .. }
            | Self::TooMuchMemory { .. } => {
                let key = match self {
                    Self::Surrogate(_) => "surrogate",
                    Self::Promise(_) => "promise",
                    _ => "sampling",
                };
                let within = match self {
                    Self::Plan(PlanError::Problem(problem)) => problem.key(),
                    Self::Surrogate(SurrogatePlanError::TooFewTraining { .. }) => Some("training_runs"),
                    Self::Surrogate(SurrogatePlanError::Confirming { .. }) => Some("confirming_runs"),
                    _ => None,
                };
                let mut diagnostic = Diagnostic::error(self, Some(place_within(key, within, study)));
                // These errors bring their way out with them.
                if let Some((message, hint)) = diagnostic.message.clone().split_once("\nhint: ") {
                    diagnostic.message = message.to_owned();
                    diagnostic.hint = Some(hint.to_owned());
                }
                diagnostic
            }
            Self::Prepare(PrepareError::TooManyTurns { table, key, .. }) => {
                Diagnostic::error(self, Some(place_within(table, Some(key), study)))
            }
            Self::Prepare(PrepareError::JournalsTogether { .. }) => {
                Diagnostic::error(self, Some(place_within("journals", None, study)))
            }
            Self::Prepare(PrepareError::TooManyPoses { .. }) => {
                Diagnostic::error(self, Some(place_within("cycle", Some("samples_per_turn"), study)))
            }
            Self::Prepare(
                PrepareError::UncertainStart { path }
                | PrepareError::UncertainDrive { path }
                | PrepareError::SpeedThroughZero { path },
            ) => {
                let table = if study.random.iter().any(|input| input.path == *path) { "random" } else { "epistemic" };
                Diagnostic::error(self, Some(place_within(table, Some(path), study)))
            }
            Self::Prepare(
                PrepareError::Law(_)
                | PrepareError::TooManyLaws { .. }
                | PrepareError::TooManyColumns { .. }
                | PrepareError::PoseNotRecorded { .. }
                | PrepareError::PathStandsStill { .. },
            )
            | Self::Loosened { .. } => Diagnostic::error(self, Some(Place::new(study.source(), 0..0))),
            Self::BudgetTooSmall { least, .. } if study.surrogate.is_some_and(|surrogate| surrogate.is_alone) => {
                let also = if study.allowances.is_empty() { "" } else { ", and so do fewer inputs under [allow]" };
                let hint = format!(
                    "a budget of {least} runs suffices for a first answer; fewer training_runs and confirming_runs under \
                     [surrogate] need fewer{also}"
                );
                Diagnostic { hint: Some(hint), ..Diagnostic::error(self, study.budget_place().cloned()) }
            }
            Self::BudgetTooSmall { .. } | Self::TimeOfShards => Diagnostic::error(self, study.budget_place().cloned()),
            Self::NothingAsked => Diagnostic::error(self, Some(Place::new(study.source(), 0..0))),
            Self::Threads(_)
            | Self::Store(_)
            | Self::Table(_)
            | Self::RoundOpen(_)
            | Self::NotMade { .. }
            | Self::TooManyFailed(_)
            | Self::Interrupted { .. } => Diagnostic::error(self, None),
        }
    }
}

/// The value behind a key of a table, or the header of the table; the top of the file where all of it is left out.
fn place_within(table: &str, key: Option<&str>, study: &Study) -> Place {
    let toml = parse_toml(study.source()).ok();
    let found = toml.as_ref().and_then(|toml| toml.get_ref().get_key_value(table));
    let inside = found.and_then(|(_, value)| value.get_ref().as_table()?.get(key?));
    let span = inside.map(|value| value.span()).or_else(|| found.map(|(key, _)| key.span()));
    Place::new(study.source(), span.unwrap_or_default())
}

/// The first epistemic quantity whose middle is not what the model has: where it stands, and its value in words.
fn middle_of(study: &Study) -> Option<(Place, String)> {
    let nominal = study.model.quantities().nominal();
    study.epistemic.iter().find_map(|input| {
        let quantity = input.quantity()?;
        let middle = input.variable.at(0.5);
        if (middle - nominal[quantity]).abs() <= MIDDLE_TOLERANCE * nominal[quantity].abs() {
            return None;
        }
        let value = format_value(middle, study.model.quantities()[quantity].dimension);
        Some((place_within("epistemic", Some(&input.path), study), format!("'{}' at {value}", input.path)))
    })
}
