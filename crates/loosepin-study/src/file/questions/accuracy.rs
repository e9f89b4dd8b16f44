//! How near the bounds are to be, and what that may cost: in the study file, and on the command line.

use std::ops::Range;
use std::sync::Arc;

use crate::file::problem::StudyProblem;
use crate::file::questions::ask::Ask;
use crate::file::questions::target::AccuracyTarget;
use crate::file::reader::StudyReader;
use crate::file::sizes::MAX_RUNS;
use crate::file::study::Study;
use crate::file::words::{dimension_of_statistic, numbers, statistic_name};
use loosepin_result::study::Budget;
use loosepin_text::diagnostics::{Code, Diagnostic, Place, Source, Span, nearest_name, problems};
use loosepin_text::document::{Entry, Written, listed};
use loosepin_text::units::{Dimension, ExpressionProblem, Measured, Rule, format_value, parse_quantity};

problems! {
    /// Problems of an accuracy or a budget. `what` says what it is of, in words.
    #[derive(Debug, Clone, PartialEq)]
    pub enum AccuracyProblem | Value(ExpressionProblem) {
        /// An output of which nothing is asked.
        UnknownOutput { name: String, nearest: Option<String>, asked: Vec<String> } => Code::UnknownReference,
            says("no question has an output '{name}'"),
            hint_of(Some(match nearest {
                Some(nearest) => format!("did you mean '{nearest}'?"),
                None if asked.is_empty() => "add it under [[ask]]".to_owned(),
                None => format!("the questions have {}", listed(asked, "and")),
            }));
        /// A statistic that does not exist or has no bounds of one number.
        UnknownStatistic { name: String, nearest: Option<String> } => Code::UnknownChoice,
            says("'{name}' is not a statistic with an accuracy"),
            hint_of(Some(match nearest {
                Some(nearest) => format!("did you mean '{nearest}'?"),
                None => format!("available: {}", listed(&numbers().map(str::to_owned).collect::<Vec<_>>(), "and")),
            }));
        /// A statistic that is not asked of the output.
        NotAsked { statistic: &'static str, output: String, asked: Vec<String> } => Code::UnknownReference,
            says("no question has the {statistic} of '{output}'"),
            hint_of(Some(match asked.is_empty() {
                true => "add it to the statistics of an [[ask]]".to_owned(),
                false => format!("its statistics are {}; add others to the statistics of an [[ask]]", listed(asked, "and")),
            }));
        /// No question has an accuracy of this dimension.
        WrongDimension { what: String, found: Dimension, due: Vec<String> } => Code::WrongDimension,
            says("{what} is {found}; must be {}", listed(due, "or")),
            hint("an accuracy has the unit of the bounds; for probabilities it is a number such as 0.01");
        /// A value without a unit where all bounds have one.
        MissingUnit { what: String, text: String, due: Dimension } => Code::MissingUnit,
            says("{what} is {text} without a unit; must be {due}"),
            hint_of(due.example().map(|example| format!("for example {example}")));
        /// No question is left to which it could apply.
        NothingAsked { what: String } => Code::AskNotPossible,
            says("{what}: more runs do not improve any of these bounds"),
            hint("an accuracy needs a statistic of one number, such as a mean or a counted probability");
        /// A second value of the same dimension in a list.
        Twice { what: String } => Code::BreaksRule,
            says("{what}: the same bounds already have an accuracy"),
            hint("remove one of them");
        /// A value that is not positive.
        NotPositive { what: String, found: String } => Code::BreaksRule,
            says("{what} is {found}; must be > 0");
        /// A budget that is neither runs, nor a time, nor rounds.
        Budget { text: String } => Code::ExpressionSyntax,
            says("'{text}' is no budget of runs, time or rounds"),
            hint("for example 20000 runs, 30 min or 12 rounds");
        /// A number of runs or rounds that is not a whole one.
        NotWhole { found: String, most: u64 } => Code::BreaksRule,
            says("a budget of {found}; must be a whole number from 1 to {most}");
    }
}

/// A bound that an accuracy can be of.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Askable {
    output: usize,
    statistic: &'static str,
    dimension: Dimension,
}

/// Statistics of `asks`, or of the one of them at `only`, that the double loop counts, with what their bounds measure.
fn askable(asks: &[Ask], only: Option<usize>, dimension_of: impl Fn(usize) -> Dimension) -> Vec<Askable> {
    let of_ask = |ask: &Ask| {
        let counted = ask.statistics().filter(|statistic| !ask.is_by_method(*statistic));
        let known = counted.filter_map(|statistic| {
            let name = statistic_name(statistic)?;
            let dimension = dimension_of_statistic(statistic, dimension_of(ask.output));
            Some(Askable { output: ask.output, statistic: name, dimension })
        });
        known.collect::<Vec<Askable>>()
    };
    let (first, count) = only.map_or((0, asks.len()), |only| (only, 1));
    asks.iter().skip(first).take(count).flat_map(of_ask).collect()
}

/// Checks a value against the bounds that it concerns. `span` is its place in the text.
fn checked(what: &str, text: &str, measured: Measured, concerned: &[Askable]) -> Result<Measured, AccuracyProblem> {
    let what = what.to_owned();
    let Some(first) = concerned.first() else { return Err(AccuracyProblem::NothingAsked { what }) };
    let found = measured.dimension;
    if concerned.iter().all(|bound| bound.dimension != found) {
        let mut due: Vec<Dimension> = Vec::new();
        for bound in concerned {
            if !due.contains(&bound.dimension) {
                due.push(bound.dimension);
            }
        }
        return Err(if found.is_number() {
            AccuracyProblem::MissingUnit { what, text: text.trim().to_owned(), due: first.dimension }
        } else {
            AccuracyProblem::WrongDimension { what, found, due: due.iter().map(Dimension::to_string).collect() }
        });
    }
    if Rule::Positive.allows(measured.value_si) {
        Ok(measured)
    } else {
        Err(AccuracyProblem::NotPositive { what, found: format_value(measured.value_si, found) })
    }
}

impl Study {
    /// Adds an accuracy from the command line: a value for all bounds that measure what it measures, or for those of an output or
    /// of one of its statistics: `1um`, `slider=1um`, `slider.mean=1um`.
    ///
    /// # Errors
    /// An output or statistic that is not asked for; a value that no bound can be measured by, or that is not positive.
    pub fn add_accuracy(&mut self, text: &str) -> Result<(), Diagnostic> {
        let source = Source::new("--accuracy", text);
        let target = self.parse_accuracy(text).map_err(|(problem, span)| diagnostic(&problem, &source, span))?;
        self.accuracy.push(target);
        self.stated.extend(["--accuracy".to_owned(), text.to_owned()]);
        Ok(())
    }

    /// Replaces the budget by one from the command line: `20000`, `20000 runs`, `30 min`, `12 rounds`.
    ///
    /// # Errors
    /// A text that is none.
    pub fn set_budget(&mut self, text: &str) -> Result<(), Diagnostic> {
        let source = Source::new("--budget", text);
        let budget = parse_budget(text).map_err(|problem| diagnostic(&problem, &source, 0..text.len()))?;
        self.budget = Some(budget);
        self.stated.extend(["--budget".to_owned(), text.to_owned()]);
        self.budget_place = Some(Place::new(&source, 0..text.len()));
        Ok(())
    }

    /// Replaces the share of runs that may fail, in [0, 1], by that of the command line.
    pub fn set_most_failed(&mut self, share: f64) {
        self.sampling.most_failed = share;
        self.stated.extend(["--most-failed".to_owned(), share.to_string()]);
    }

    /// Notes settings that the model has, which the command line states.
    pub(crate) fn state_settings(&mut self, set: &[String]) {
        self.settings.extend_from_slice(set);
        self.stated.extend(set.iter().flat_map(|text| ["--set".to_owned(), text.clone()]));
    }

    /// Notes points whose paths are shown, which the command line names.
    pub(crate) fn state_paths(&mut self, points: &[String]) {
        self.paths.extend_from_slice(points);
        self.stated.extend(points.iter().flat_map(|point| ["--path".to_owned(), point.clone()]));
    }

    fn parse_accuracy(&self, text: &str) -> Result<AccuracyTarget, (AccuracyProblem, Range<usize>)> {
        let asked = askable(&self.asks, None, |output| self.outputs[output].dimension);
        let (named, value) = match text.split_once('=') {
            Some((named, value)) => (Some(named), value),
            None => (None, text),
        };
        let value_span = text.len() - value.len()..text.len();
        let (mut output, mut statistic) = (None, None);
        if let Some(named) = named {
            // Names of outputs have no point.
            let (name, of) = match named.split_once('.') {
                Some((name, of)) => (name, Some(of)),
                None => (named, None),
            };
            let index = self.asked_output(name.trim()).map_err(|problem| (problem, 0..name.len()))?;
            output = Some(index);
            if let Some(of) = of {
                let span = name.len() + 1..named.len();
                let found = asked_statistic(of.trim()).map_err(|problem| (problem, span.clone()))?;
                let of_output = || asked.iter().filter(|bound| bound.output == index);
                if of_output().all(|bound| bound.statistic != found) {
                    let mut others: Vec<String> = Vec::new();
                    for bound in of_output() {
                        if !others.iter().any(|known| known == bound.statistic) {
                            others.push(bound.statistic.to_owned());
                        }
                    }
                    let output = name.trim().to_owned();
                    return Err((AccuracyProblem::NotAsked { statistic: found, output, asked: others }, span));
                }
                statistic = Some(found);
            }
        }
        let concerned: Vec<Askable> = asked
            .into_iter()
            .filter(|bound| output.is_none_or(|output| bound.output == output))
            .filter(|bound| statistic.is_none_or(|statistic| bound.statistic == statistic))
            .collect();
        let what = match named {
            Some(named) => format!("the accuracy of {}", named.trim()),
            None => "the accuracy".to_owned(),
        };
        let measured = parse_quantity(value).map_err(|error| {
            (error.problem.into(), value_span.start + error.span.start..value_span.start + error.span.end)
        })?;
        let measured = checked(&what, value, measured, &concerned).map_err(|problem| (problem, value_span))?;
        let Measured { value_si: most_si, dimension } = measured;
        Ok(AccuracyTarget { is_argument: true, ask: None, output, statistic, dimension, most_si })
    }

    fn asked_output(&self, name: &str) -> Result<usize, AccuracyProblem> {
        let mut asked: Vec<&str> = Vec::new();
        for ask in &self.asks {
            let of = self.outputs[ask.output].name.as_str();
            if of == name {
                return Ok(ask.output);
            }
            if !asked.contains(&of) {
                asked.push(of);
            }
        }
        let nearest = nearest_name(name, asked.iter().copied()).map(str::to_owned);
        let asked = asked.iter().map(|name| format!("'{name}'")).collect();
        Err(AccuracyProblem::UnknownOutput { name: name.to_owned(), nearest, asked })
    }
}

fn asked_statistic(name: &str) -> Result<&'static str, AccuracyProblem> {
    numbers().find(|known| *known == name).ok_or_else(|| AccuracyProblem::UnknownStatistic {
        name: name.to_owned(),
        nearest: nearest_name(name, numbers()).map(str::to_owned),
    })
}

fn diagnostic(problem: &AccuracyProblem, source: &Arc<Source>, span: Range<usize>) -> Diagnostic {
    Diagnostic::error(problem, Some(Place::new(source, span)))
}

/// Rounds, at most.
const MAX_ROUNDS: u64 = u32::MAX as u64;

/// Reads a budget: a number of runs, a time, or a number of rounds.
fn parse_budget(text: &str) -> Result<Budget, AccuracyProblem> {
    let trimmed = text.trim();
    let counted = |number: &str, of: &str, most: u64| -> Result<u64, AccuracyProblem> {
        let number = number.trim();
        let value: f64 = number.parse().map_err(|_| AccuracyProblem::Budget { text: trimmed.to_owned() })?;
        if value >= 1.0 && value <= most as f64 && value.fract() == 0.0 {
            Ok(value as u64)
        } else {
            Err(AccuracyProblem::NotWhole { found: format!("{number} {of}"), most })
        }
    };
    let ending = |words: [&str; 2]| words.into_iter().find_map(|word| trimmed.strip_suffix(word));
    if let Some(number) = ending(["rounds", "round"]) {
        return counted(number, "rounds", MAX_ROUNDS).map(|rounds| Budget::Rounds { rounds: rounds as u32 });
    }
    if let Some(number) = ending(["runs", "run"]) {
        return counted(number, "runs", MAX_RUNS).map(|runs| Budget::Runs { runs });
    }
    if trimmed.parse::<f64>().is_ok() {
        return counted(trimmed, "runs", MAX_RUNS).map(|runs| Budget::Runs { runs });
    }
    match parse_quantity(trimmed) {
        Ok(measured) if measured.dimension == Dimension::TIME => {
            if measured.value_si > 0.0 {
                return Ok(Budget::Time { seconds: measured.value_si });
            }
            Err(AccuracyProblem::NotPositive { what: "a budget".to_owned(), found: trimmed.to_owned() })
        }
        _ => Err(AccuracyProblem::Budget { text: trimmed.to_owned() }),
    }
}

/// Accuracies under a key as written, until the questions are known.
#[derive(Debug, Default)]
pub(crate) struct WrittenAccuracies {
    written: Vec<(String, String, Measured, Span)>,
}

impl StudyReader {
    /// Reads the accuracies at an entry: one, or a list.
    pub fn accuracies(&mut self, entry: Option<&Entry<'_>>) -> WrittenAccuracies {
        let mut found = WrittenAccuracies::default();
        let Some(entry) = entry else { return found };
        let entries = if entry.is_list() { self.reader.list(entry).unwrap_or_default() } else { vec![entry.clone()] };
        if entry.is_empty_list() {
            self.report(&StudyProblem::Empty { entry: entry.path.describe() }, entry);
        }
        for entry in entries {
            let Some((text, measured)) = self.any_value(&entry) else { continue };
            found.written.push((entry.path.describe(), text, measured, entry.span));
        }
        found
    }

    fn any_value(&mut self, entry: &Entry<'_>) -> Option<(String, Measured)> {
        match self.reader.written(entry)? {
            Written::Number(value_si) => {
                Some((value_si.to_string(), Measured { value_si, dimension: Dimension::NUMBER }))
            }
            Written::Text(text) => match parse_quantity(text) {
                Ok(measured) => Some((text.to_owned(), measured)),
                Err(error) => {
                    let span = self.reader.inside(entry, text, &error.span);
                    self.refused(&error.problem, span)
                }
            },
        }
    }

    /// The accuracies of `asks`; of the question `of_ask` alone if they stand in one.
    pub fn targets(&mut self, written: WrittenAccuracies, asks: &[Ask], of_ask: Option<usize>) -> Vec<AccuracyTarget> {
        let concerned = askable(asks, of_ask, |output| self.outputs[output].dimension);
        let mut targets = Vec::new();
        for (what, text, measured, span) in written.written {
            let is_twice = targets.iter().any(|target: &AccuracyTarget| target.dimension == measured.dimension);
            match checked(&what, &text, measured, &concerned) {
                Ok(_) if is_twice => self.reader.report(&AccuracyProblem::Twice { what }, span),
                Ok(Measured { value_si: most_si, dimension }) => targets.push(AccuracyTarget {
                    is_argument: false,
                    ask: of_ask,
                    output: None,
                    statistic: None,
                    dimension,
                    most_si,
                }),
                Err(problem) => self.reader.report(&problem, span),
            }
        }
        targets
    }

    /// Reads a budget, and where it is written.
    pub fn budget(&mut self, entry: Option<&Entry<'_>>) -> Option<(Budget, Place)> {
        let entry = entry?;
        let text = match self.reader.written(entry)? {
            Written::Number(number) => number.to_string(),
            Written::Text(text) => text.to_owned(),
        };
        match parse_budget(&text) {
            Ok(budget) => Some((budget, self.reader.place(entry.span))),
            Err(problem) => self.refused(&problem, entry.span),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{Budget, parse_budget};

    #[test]
    fn budgets_are_runs_times_or_rounds() {
        for (text, budget) in [
            ("20000", Budget::Runs { runs: 20_000 }),
            (" 20000runs", Budget::Runs { runs: 20_000 }),
            ("2e4 runs ", Budget::Runs { runs: 20_000 }),
            ("30min", Budget::Time { seconds: 1800.0 }),
            ("1.5 h", Budget::Time { seconds: 5400.0 }),
            ("12 rounds", Budget::Rounds { rounds: 12 }),
        ] {
            assert_eq!(parse_budget(text), Ok(budget), "{text}");
        }
        let refused = |text: &str| parse_budget(text).unwrap_err().to_string();
        assert_eq!(refused("soon"), "'soon' is no budget of runs, time or rounds");
        assert_eq!(refused("3 mm"), "'3 mm' is no budget of runs, time or rounds");
        assert_eq!(refused("2.5 runs"), "a budget of 2.5 runs; must be a whole number from 1 to 1073741824");
        assert_eq!(refused("0 rounds"), "a budget of 0 rounds; must be a whole number from 1 to 4294967295");
        assert_eq!(refused("-3 min"), "a budget is -3 min; must be > 0");
    }
}
