//! Requirements: what an output must keep, and in how many mechanisms.

use crate::file::problem::{MeantLimit, StudyProblem};
use crate::file::questions::ask::furthest;
use crate::file::questions::location::POSES;
use crate::file::questions::output::{COMPONENT, DEVIATION, OUTPUT};
use crate::file::reader::StudyReader;
use crate::places::Where;
use loosepin_bounds::Statistic;
use loosepin_result::study::{Deviation, Reduction};
use loosepin_text::diagnostics::{Diagnostic, Place};
use loosepin_text::document::{Entry, Kind, Reads, choice};
use loosepin_text::units::{Dimension, Rule, format_number, format_refused, format_value, parse_quantity};
use loosepin_text::{choices, record};

/// Limit of a requirement, in the SI unit of the output.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Limit {
    /// A magnitude of at most this, > 0.
    Within(f64),
    /// A value of at most this.
    Below(f64),
    /// A value of at least this.
    Above(f64),
}

impl Limit {
    /// The probability of breaking it.
    pub fn broken(self) -> Statistic {
        match self {
            Self::Within(limit) => Statistic::ProbabilityBeyond(limit),
            Self::Below(limit) => Statistic::ProbabilityAbove(limit),
            Self::Above(limit) => Statistic::ProbabilityBelow(limit),
        }
    }

    /// The number of a whole curve that breaks it where any point of the curve does.
    pub fn reduction(self) -> Reduction {
        furthest(self.broken())
    }

    /// The least and the largest value allowed.
    pub fn ends(self) -> [f64; 2] {
        match self {
            Self::Within(limit) => [-limit, limit],
            Self::Below(limit) => [f64::NEG_INFINITY, limit],
            Self::Above(limit) => [limit, f64::INFINITY],
        }
    }
}

/// A requirement: P(the limit is kept) >= probability for every value of the epistemic inputs.
#[derive(Debug, Clone, PartialEq)]
pub struct Requirement {
    /// Index in [`Study::outputs`](crate::file::Study::outputs).
    pub output: usize,
    /// Which deviation of it.
    pub deviation: Deviation,
    /// The limit.
    pub limit: Limit,
    /// The whole cycle: nowhere in the cycle is the limit exceeded; or poses, each of them by itself.
    pub location: Where,
    /// The least probability, in (0, 1].
    pub probability_at_least: f64,
    /// Whether a promise for a share of the box decides it.
    pub is_promised: bool,
    /// Columns of a run that hold its numbers, one or one for each pose; empty until the columns of the study are laid out.
    pub columns: Vec<usize>,
}

choices!(
    /// What decides a requirement, and whether it is a promise.
    pub(crate) struct DecidedBy(bool): "search" => false, "promise" => true
);

record! {
    /// a requirement that must be met for every value of the unknown (epistemic) inputs
    pub(crate) lenient struct RequireTable for Reads,
        exactly one of [within, below, above], exactly one of [over, poses];
    required output: Entry<'t> as OUTPUT;
    optional component: Entry<'t> as COMPONENT;
    required of: Entry<'t> as DEVIATION;
    /// limit of the magnitude
    optional within: Entry<'t> = Kind::AnyQuantity, "\"0.6 mm\"";
    /// the largest permitted value
    optional below: Entry<'t> = Kind::AnyQuantity, "\"2 kN\"";
    /// the smallest permitted value
    optional above: Entry<'t> = Kind::AnyQuantity, "\"-2 kN\"";
    /// the limit holds over the whole cycle
    optional over: Entry<'t> = Kind::Choice(&["cycle"]), "\"cycle\"";
    optional poses: Entry<'t> as POSES;
    /// the smallest permitted probability of staying within the limit
    required probability_at_least: Entry<'t> = Kind::Number { rule: Rule::RequiredProbability }, "0.9973";
    /// search: for every value of the unknown inputs; promise: for a share of the box, without a model of the statistic
    optional decided_by: DecidedBy = choice::<DecidedBy>(), "\"promise\"", or "search";
}

/// Signs before the limit of a magnitude, which is written without.
const PLUS_MINUS: [&str; 3] = ["±", "+/-", "+-"];

impl StudyReader {
    /// Reads the requirements.
    pub fn read_requirements(&mut self, written: Option<&Entry<'_>>) -> Vec<Requirement> {
        let entries = self.double_brackets(written);
        entries
            .iter()
            .filter_map(|entry| {
                let table = RequireTable::read(self, entry)?;
                self.requirement(&table)
            })
            .collect()
    }

    fn requirement(&mut self, table: &RequireTable<'_>) -> Option<Requirement> {
        let RequireTable { table: whole, within, below, above, .. } = table;
        let output = self.output(whole, &table.output, &table.component);
        let deviation = self.deviation(table.of.as_ref(), output);
        let location = self.location([&table.over, &table.poses, &None], output.zip(deviation));
        let probability_at_least = table.probability_at_least.as_ref().and_then(|entry| self.reader.number_of(entry));
        let output = output?;
        let dimension = self.outputs[output].dimension;
        let limit = if let Some(entry) = within {
            let limit = self.magnitude(entry, dimension);
            limit.and_then(|limit| self.limit(entry, limit, dimension, Rule::Positive)).map(Limit::Within)
        } else if let Some(entry) = below {
            self.reader.measured(entry, dimension, Rule::Finite).map(Limit::Below)
        } else {
            above.as_ref().and_then(|entry| self.reader.measured(entry, dimension, Rule::Finite)).map(Limit::Above)
        };
        let probability_entry = table.probability_at_least.as_ref()?;
        let probability_at_least = probability_at_least?;
        let decided_by = whole.get("decided_by").filter(|_| table.decided_by.0);
        let is_promised = decided_by.is_some_and(|entry| self.is_decided_by_promise(&entry, probability_at_least));
        // Quantities that scatter are drawn, and no number of draws shows that none lies beyond.
        if probability_at_least == 1.0 && !self.random.is_empty() {
            let problem = StudyProblem::CertaintyOfSamples { entry: probability_entry.path.describe() };
            let place = Place::new(&self.reader.source, probability_entry.span);
            self.reader.diagnostics.push(Diagnostic::warning(&problem, Some(place)));
        }
        let (deviation, limit, location) = (deviation?, limit?, location?);
        if let (Limit::Within(_), Some(entry)) = (limit, within)
            && !self.can_judge_both_sides(deviation, &location)
        {
            return self.refused(&StudyProblem::NotOfOneSide { entry: entry.path.describe() }, entry.span);
        }
        // A life is to be long, everything else of wear small.
        let is_life = self.is_life(output);
        let is_on_its_side = if is_life { matches!(limit, Limit::Above(_)) } else { matches!(limit, Limit::Below(_)) };
        if self.is_wear(Some(output)) && !(location.is_cycle() && is_on_its_side) {
            let entry = whole.path.describe();
            return self.refused(&StudyProblem::LimitOfWear { entry, is_life }, whole.span);
        }
        if let (true, Limit::Above(least)) = (is_life, limit)
            && let Some(cycles) = self.cycles_of_wear().filter(|cycles| least > *cycles)
        {
            let span = above.as_ref().map_or(whole.span, |entry| entry.span);
            let [least, cycles] = [least, cycles].map(format_number);
            let problem = StudyProblem::LifeBeyondCycles { entry: whole.path.describe(), least, cycles };
            return self.refused(&problem, span);
        }
        let columns = Vec::new();
        Some(Requirement { output, deviation, limit, location, probability_at_least, is_promised, columns })
    }

    /// The limit of a magnitude. Two limits, and one behind `±`, are told what is to be written.
    fn magnitude(&mut self, entry: &Entry<'_>, dimension: Dimension) -> Option<f64> {
        let of_text = |text: &str| {
            let half = PLUS_MINUS.iter().find_map(|sign| text.trim_start().strip_prefix(sign))?.trim();
            parse_quantity(half).is_ok().then(|| half.to_owned())
        };
        let meant = if entry.is_list() {
            let ends = self.reader.pair(entry)?;
            let [lower, upper] = [&ends[0], &ends[1]].map(|end| self.reader.measured(end, dimension, Rule::Finite));
            let [lower, upper] = [lower?, upper?];
            if lower == -upper {
                MeantLimit::Magnitude(format_value(upper.abs(), dimension))
            } else {
                MeantLimit::Two([lower, upper].map(|end| format_value(end, dimension)))
            }
        } else if let Some(half) = entry.as_text().and_then(of_text) {
            MeantLimit::Magnitude(half)
        } else {
            return self.reader.measured(entry, dimension, Rule::Finite);
        };
        let problem = StudyProblem::WithinIsOneLimit { entry: entry.path.describe(), found: entry.found(), meant };
        self.refused(&problem, entry.span)
    }

    /// The cycles after which wear is stated; `None` if they are an input, of which each run has its own.
    fn cycles_of_wear(&self) -> Option<f64> {
        let cycles = self.model.cycles_of_wear()?;
        let is_input = self.random.iter().any(|input| input.quantity() == Some(cycles))
            || self.epistemic.iter().any(|input| input.quantity() == Some(cycles));
        (!is_input).then(|| self.model.quantities().nominal()[cycles])
    }

    /// A limit of a magnitude.
    pub(crate) fn limit(&mut self, entry: &Entry<'_>, limit: f64, dimension: Dimension, rule: Rule) -> Option<f64> {
        if rule.allows(limit) {
            return Some(limit);
        }
        let found = format_refused(limit, dimension);
        self.refused(&StudyProblem::Limit { entry: entry.path.describe(), found, rule: rule.words() }, entry.span)
    }
}
