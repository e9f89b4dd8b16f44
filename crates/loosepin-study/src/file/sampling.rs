//! Settings of the runs: their number, and their accuracy.

use super::description::Sampling;
use super::problem::StudyProblem;
use super::reader::StudyReader;
use loosepin_bounds::MAX_OUTER;
use loosepin_mechanics::model::{CYCLE_NUMBERS, Cycle};
use loosepin_text::document::{DefaultValue, Entry, Kind, Reads, Table, Value, count};
use loosepin_text::record;
use loosepin_text::units::{Dimension, Rule, parse_quantity};

/// Samples of the random inputs, at most: that many Sobol' points are distinct.
pub(super) const MAX_INNER: u64 = 1 << 24;

/// A value, or several of different dimensions.
pub(super) const ACCURACY: Kind = Kind::AnyOf(&[Kind::AnyQuantity, Kind::List(&Kind::AnyQuantity)]);

record! {
    /// the turns to simulate and to record, where they differ from the model
    pub(super) lenient struct StudyCycleTable for Reads;
    /// turns simulated before recording; as in the model if omitted
    optional transient_turns: f64 = CYCLE_NUMBERS[0].kind, "2";
    /// turns recorded; as in the model if omitted
    optional recorded_turns: f64 = CYCLE_NUMBERS[1].kind, "1";
    /// rows recorded per turn; as in the model if omitted
    optional samples_per_turn: usize = CYCLE_NUMBERS[2].kind, "500";
}

record! {
    /// the number of runs and their accuracy
    pub(super) lenient struct SamplingTable for Reads,
        planned &[("threads", "threads are given on the command line, since results do not depend on them: --threads")],
        removed &[(
            "reweighting",
            "leave it out; runs are made at every value of the parameters that the search looks at, as with \"never\"",
        )];
    /// number of points in the box of the intervals
    optional outer: usize = count(1, MAX_OUTER as u64), "64", or 64;
    /// number of samples of the random inputs at each point; where it is omitted, more if a requirement needs them
    optional inner: usize = count(2, MAX_INNER), "256", or 256;
    /// number of independent randomisations; the sampling error is estimated from them
    optional replicates: usize = count(2, 1024), "4", or 4;
    /// error tolerance of positions: the error of one step is limited to 0.5 % of it, in lasting contacts to 10 %
    optional tolerance: StepTolerance = Kind::AnyQuantity, "\"1e-8 m\"", or "1e-8 m";
    /// share of failed runs above which the study ends with an error
    optional most_failed: f64 = Kind::Number { rule: Rule::RequiredProbability }, "0.1", or 0.1;
    /// largest numerical error of all bounds with this unit: the samples increase until it is reached; a value or a list
    optional accuracy: Entry<'t> = ACCURACY, "\"1 um\"";
    /// limit at which the study ends even if the accuracy is not reached: runs, a time, or "12 rounds"
    optional budget: Entry<'t> = Kind::AnyQuantity, "\"30 min\"";
}

/// Tolerance of a step, m.
pub(super) struct StepTolerance(f64);

impl<'t, R: Reads + ?Sized> Value<'t, R> for StepTolerance {
    fn read(reader: &mut R, entry: &Entry<'t>) -> Option<Self> {
        reader.document().measured(entry, Dimension::LENGTH, Rule::Positive).map(Self)
    }
}

impl<'t, R: Reads + ?Sized> DefaultValue<'t, R, &'static str> for StepTolerance {
    fn default_value(_reader: &mut R, _table: &Table<'t>, _key: &'static str, usual: &'static str) -> Option<Self> {
        parse_quantity(usual).ok().map(|usual| Self(usual.value_si))
    }
}

impl StudyReader {
    /// The cycle of the model with what `written` says of it.
    pub(super) fn cycle(&mut self, written: Option<&Entry<'_>>) -> Cycle {
        let mut cycle = self.model.cycle();
        if let Some(table) = written.and_then(|entry| StudyCycleTable::read(self, entry)) {
            let start_up = table.table.get("transient_turns").filter(|_| table.transient_turns.unwrap_or(0.0) != 0.0);
            if let Some(entry) = start_up.filter(|_| !self.model.has_start_up()) {
                self.report(&StudyProblem::NoStartUp { entry: entry.path.describe() }, &entry);
            }
            cycle.transient_turns = table.transient_turns.unwrap_or(cycle.transient_turns);
            cycle.recorded_turns = table.recorded_turns.unwrap_or(cycle.recorded_turns);
            cycle.samples_per_turn = table.samples_per_turn.unwrap_or(cycle.samples_per_turn);
        }
        cycle
    }

    /// How many runs, with the table that says so, of no keys where it is left out.
    pub(super) fn sampling<'t>(&mut self, written: Option<&Entry<'t>>) -> (Sampling, SamplingTable<'t>) {
        let table = SamplingTable::read_or_usual(self, written);
        let SamplingTable { outer, inner, replicates, most_failed, tolerance: StepTolerance(tolerance_m), .. } = table;
        (Sampling { outer, inner, replicates, tolerance_m, most_failed }, table)
    }
}
