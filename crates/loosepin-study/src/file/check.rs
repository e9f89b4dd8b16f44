//! Checks of the inputs together with the rules of the model.

use super::description::{EpistemicInput, RandomInput};
use super::problem::StudyProblem;
use super::reader::StudyReader;
use super::study_table::StudyTable;
use loosepin_bounds::Reading;
use loosepin_mechanics::model::{QuantityError, QuantityId};
use loosepin_text::diagnostics::{Diagnostic, Place, Span};
use loosepin_text::document::Entry;
use loosepin_text::units::{Dimension, format_apart, format_number, format_value};
use loosepin_uncertainty::{EpistemicVariable, RandomVariable};

/// Share of a distribution that may be impossible; what is drawn there is a failed run.
const MAX_IMPOSSIBLE_SHARE: f64 = 0.01;
/// Quantiles at which the share is measured: it is resolved to a tenth of what is accepted.
const QUANTILES: usize = 1000;
/// Probability that counts as none: beyond six standard deviations of a normal distribution.
const NEARLY_NONE: f64 = 1e-9;
/// Of numbers that are written in two files.
const ROUND_OFF: f64 = 1e-9;
/// Corners of the box of intervals, with every combination of lists, that are tried; of more none is.
const MAX_CORNERS: usize = 1024;

/// The entry of the input `path` in a table of inputs.
pub(super) fn entry_of<'t>(table: &Option<Entry<'t>>, path: &str) -> Option<Entry<'t>> {
    table.as_ref()?.get(path)
}

impl StudyReader {
    /// Checks one end of an interval, or one of a list, against the rules of the model, all other values being those of the
    /// file; says whether it is possible.
    pub fn check_end(
        &mut self,
        quantity: QuantityId,
        path: &str,
        value_si: f64,
        entry: &Entry<'_>,
        is_member: bool,
    ) -> bool {
        let problem = self.problem_at_end(quantity, path, value_si, is_member);
        if let Some(problem) = &problem {
            self.report(problem, entry);
        }
        problem.is_none()
    }

    fn problem_at_end(&self, quantity: QuantityId, path: &str, value_si: f64, is_member: bool) -> Option<StudyProblem> {
        let quantities = &self.model.quantities();
        let end = format_value(value_si, quantities[quantity].dimension);
        let path = path.to_owned();
        let values = match quantities.evaluate(&[(quantity, value_si)]) {
            Ok(values) => values,
            Err(error) => return Some(StudyProblem::ImpossibleEnd { path, end, error }),
        };
        let lost = self.plays_of(quantity).into_iter().find(|&id| values[id] == 0.0)?;
        let clearance = quantities[lost].path.clone();
        Some(StudyProblem::ClearanceTouchesZero { path, end, clearance, is_member })
    }

    /// The clearances that follow from `quantity`: at 0 their joints and couplings would have no play.
    fn plays_of(&self, quantity: QuantityId) -> Vec<QuantityId> {
        self.model.play_from(quantity).into_iter().map(|play| play.quantity).collect()
    }

    /// Checks that something is uncertain, and that something is asked.
    pub fn check_complete(&mut self, root: &StudyTable<'_>) {
        let is_empty = |reader: &mut Self, entries: &[&Option<Entry<'_>>]| {
            entries.iter().copied().flatten().all(|entry| {
                if entry.is_table() { reader.reader.any_keys(entry).is_empty() } else { entry.is_empty_list() }
            })
        };
        if is_empty(self, &[&root.random, &root.epistemic]) && self.journals.is_none() {
            let has_dynamics = self.model.has_dynamics();
            self.reader.report(&StudyProblem::NothingUncertain { has_dynamics }, root.table.span);
        }
        // Readings of a rig are asked about by `identify`, which needs no question.
        if is_empty(self, &[&root.ask, &root.require, &root.measured]) {
            self.reader.report(&StudyProblem::NothingAsked, root.table.span);
        }
    }

    /// Checks what only the whole study shows.
    pub fn check_whole(&mut self, root: &StudyTable<'_>) {
        self.check_model_values(root);
        if self.reader.diagnostics.has_errors() {
            return;
        }
        self.check_second_order(root);
        if let Err(error) = self.check_corners() {
            let problem = StudyProblem::ImpossibleTogether { error };
            let span = root.epistemic.as_ref().map(|entry| entry.key_span).unwrap_or_default();
            self.reader.report(&problem, span);
            return;
        }
        // Rows of a specimen were looked at whole: a value that is impossible beside others may be possible in its row.
        let alone = if root.specimen.is_some() { 0 } else { self.random.len() };
        for index in 0..alone {
            if let Some(problem) = self.impossible_share(index) {
                let path = self.random[index].path.clone();
                let span = entry_of(&root.random, &path).map_or(root.table.span, |entry| entry.span);
                let place = Place::new(&self.reader.source, span);
                self.reader.diagnostics.push(Diagnostic::error(&problem, Some(place)));
            }
        }
    }

    /// Refuses distributions of lengths and angles that are elsewhere in the model: one dimension has one nominal value. A measured sample,
    /// and an interval in which the value of one mechanism is known to lie (as `identify` finds it), may lie beside it, which is warned of.
    /// A clearance changes no ideal motion, and what it is in the model plays no part.
    fn check_model_values(&mut self, root: &StudyTable<'_>) {
        // A specimen may be anywhere in its series, and the model stays that of the series.
        let is_series = root.specimen.is_none();
        let span_of = |table: &Option<Entry<'_>>, path: &str| {
            entry_of(table, path).map_or(root.table.span, |entry| entry.key_span)
        };
        let random = self.random.iter().filter(|_| is_series).filter_map(|input| {
            let corners = |known: &EpistemicVariable| known.ends().to_vec();
            let ends = |variable: &RandomVariable| [NEARLY_NONE, 1.0 - NEARLY_NONE].map(|p| variable.quantile(p));
            let all = input.variables(&self.epistemic, corners).iter().flat_map(ends).collect::<Vec<f64>>();
            Some((span_of(&root.random, &input.path), &input.path, input.quantity()?, all, input.origin.is_some()))
        });
        let is_between = |input: &&EpistemicInput| !input.variable.is_periodic();
        let epistemic = self.epistemic.iter().filter(is_between).filter_map(|input| {
            let span = span_of(&root.epistemic, &input.path);
            Some((span, &input.path, input.quantity()?, input.variable.ends().to_vec(), true))
        });
        let nominal = self.model.quantities().nominal();
        type Range<'a> = (Span, &'a String, QuantityId, Vec<f64>, bool);
        let far = |(span, path, quantity, ends, may_be_beside): Range<'_>| {
            let known = &self.model.quantities()[quantity];
            let is_geometric = [Dimension::LENGTH, Dimension::ANGLE].contains(&known.dimension);
            let (from, to) = ends.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), x| (l.min(*x), h.max(*x)));
            let round_off = ROUND_OFF * nominal[quantity].abs();
            let is_inside = (from - round_off..=to + round_off).contains(&nominal[quantity]);
            if !is_geometric || is_inside || !self.plays_of(quantity).is_empty() {
                return None;
            }
            let [value, from, to] = format_apart([nominal[quantity], from, to], known.dimension);
            Some((span, StudyProblem::FarFromModel { path: path.clone(), value, from, to }, may_be_beside))
        };
        let found: Vec<(Span, StudyProblem, bool)> = random.chain(epistemic).filter_map(far).collect();
        for (span, problem, may_be_beside) in found {
            let place = Some(Place::new(&self.reader.source, span));
            let report = if may_be_beside { Diagnostic::warning } else { Diagnostic::error };
            self.reader.diagnostics.push(report(&problem, place));
        }
    }

    /// A parameter with a distribution has one value for all samples, and no masses go with its probabilities.
    fn check_second_order(&mut self, root: &StudyTable<'_>) {
        let is_second_order = |input: &&EpistemicInput| input.variable.is_second_order();
        let Some(path) = self.epistemic.iter().find(is_second_order).map(|input| input.path.clone()) else { return };
        let has_evidence = self.epistemic.iter().any(|input| matches!(input.variable, EpistemicVariable::Evidence(_)));
        for (entry, beside, is_there) in [
            (
                &root.reading,
                "this reading of intervals: the parameter has one value",
                self.readings != [Reading::FixedButUnknown],
            ),
            (&root.epistemic, "masses of evidence", has_evidence),
        ] {
            if let Some(entry) = entry.as_ref().filter(|_| is_there) {
                self.report(&StudyProblem::SecondOrderBeside { path: path.clone(), beside }, &entry.at_key());
            }
        }
    }

    /// Evaluates every corner of the box of intervals with every combination of the numbers of lists.
    fn check_corners(&self) -> Result<(), QuantityError> {
        let shown: Vec<(QuantityId, Vec<f64>)> = self
            .epistemic
            .iter()
            .filter_map(|input| Some((input.quantity()?, input.variable.representative_values())))
            .collect();
        let corners = shown.iter().fold(1_usize, |corners, (_, values)| corners.saturating_mul(values.len()));
        if corners > MAX_CORNERS {
            return Ok(());
        }
        let mut values = self.model.quantities().nominal();
        for corner in 0..corners {
            let mut rest = corner;
            let set: Vec<(QuantityId, f64)> = shown
                .iter()
                .map(|(quantity, values)| {
                    let value = values[rest % values.len()];
                    rest /= values.len();
                    (*quantity, value)
                })
                .collect();
            self.model.quantities().evaluate_into(&set, &mut values)?;
        }
        Ok(())
    }

    /// The share of a random input that is impossible, where it is too large at a corner of its uncertain parameters; the intervals stand at their lower ends,
    /// middles and upper ends in turn, the lists at members from the first to the last.
    fn impossible_share(&self, index: usize) -> Option<StudyProblem> {
        let input = &self.random[index];
        let corners = |known: &EpistemicVariable| known.ends().to_vec();
        let variables = input.variables(&self.epistemic, corners);
        variables.iter().find_map(|variable| self.impossible_share_of(input, variable))
    }

    /// Says that too many of the values `drawn` leave a joint without play, all other values being those of the file.
    fn share_without_play(&self, input: &RandomInput, drawn: &[f64]) -> Option<StudyProblem> {
        let quantity = input.quantity()?;
        let quantities = &self.model.quantities();
        let plays = self.plays_of(quantity);
        let lost = |value_si: f64| {
            let values = quantities.evaluate(&[(quantity, value_si)]).ok()?;
            plays.iter().copied().find(|&id| values[id] == 0.0)
        };
        let all: Vec<(f64, QuantityId)> = if plays.is_empty() {
            Vec::new()
        } else {
            drawn.iter().filter_map(|&value_si| Some((value_si, lost(value_si)?))).collect()
        };
        let is_too_much = all.len() as f64 > MAX_IMPOSSIBLE_SHARE * drawn.len() as f64;
        let &(value_si, clearance) = all.first().filter(|_| is_too_much)?;
        Some(StudyProblem::ClearanceTouchesZero {
            path: input.path.clone(),
            end: format_value(value_si, quantities[quantity].dimension),
            clearance: quantities[clearance].path.clone(),
            is_member: true,
        })
    }

    fn impossible_share_of(&self, input: &RandomInput, variable: &RandomVariable) -> Option<StudyProblem> {
        let quantity = input.quantity()?;
        let quantities = &self.model.quantities();
        let mut values = quantities.nominal();
        let probability = |quantile: usize| (quantile as f64 + 0.5) / QUANTILES as f64;
        let drawn: Vec<f64> = (0..QUANTILES).map(|quantile| variable.quantile(probability(quantile))).collect();
        let is_independent = quantities.is_independent(quantity);
        if let Some(problem) = self.share_without_play(input, &drawn) {
            return Some(problem);
        }
        for fraction in [0.0, 0.5, 1.0] {
            let epistemic = self.epistemic.iter();
            let mut set: Vec<(QuantityId, f64)> =
                epistemic.filter_map(|input| Some((input.quantity()?, input.variable.at(fraction)))).collect();
            set.push((quantity, f64::NAN));
            let mut possible = |value_si: f64| {
                if let Some(last) = set.last_mut() {
                    last.1 = value_si;
                }
                quantities.evaluate_into(&set, &mut values)
            };
            // Where the other values are possible with one of these, and nothing depends on it, its own rule is all there is.
            let is_own_rule = is_independent && drawn.iter().any(|&value_si| possible(value_si).is_ok());
            let mut impossible = 0;
            let mut first = None;
            for &value_si in &drawn {
                let tried = if is_own_rule { quantities[quantity].check(value_si) } else { possible(value_si) };
                if let Err(error) = tried {
                    impossible += 1;
                    first.get_or_insert(error);
                }
            }
            let share = f64::from(impossible) / QUANTILES as f64;
            if share > MAX_IMPOSSIBLE_SHARE {
                return first.map(|error| StudyProblem::ImpossibleShare {
                    path: input.path.clone(),
                    share_percent: format_number(100.0 * share),
                    most_percent: 100.0 * MAX_IMPOSSIBLE_SHARE,
                    error,
                });
            }
        }
        None
    }
}
