//! Distributions, of random inputs and of parameters of distributions alike: how the table of each family is read.

use crate::file::random_inputs::family::{
    BetaTable, DiscreteTable, ExponentialTable, GammaTable, GumbelTable, LognormalTable, NormalTable, TriangularTable,
    TruncatedNormalTable, UniformTable, WeibullTable,
};
use crate::file::random_inputs::random_problem::RandomProblem;
use crate::file::reader::StudyReader;
use loosepin_text::document::{Entry, Table};
use loosepin_text::units::{Dimension, Rule, format_apart, format_number};
use loosepin_uncertainty::Distribution;
use std::ops::RangeInclusive;

/// Shapes of a beta distribution that are accepted. Above, it is a normal distribution a thousand times narrower than
/// its interval; below, it is two values; and its quantiles take longer than the runs.
const SHAPES_OF_BETA: RangeInclusive<f64> = 1e-3..=1e6;
/// Shapes of gamma and Weibull distributions that are accepted: beyond, they are one value or next to two.
const SHAPES: RangeInclusive<f64> = 0.05..=1e6;

impl StudyReader {
    pub(crate) fn normal(&mut self, table: Table<'_>, dimension: Dimension) -> Option<Distribution> {
        let NormalTable { mean, standard_deviation: deviation, .. } = NormalTable::of(self, table)?;
        let (mean, standard_deviation) = self.moments(&mean, &deviation, dimension, None)?;
        Some(Distribution::Normal { mean, standard_deviation })
    }

    pub(crate) fn lognormal(&mut self, table: Table<'_>, dimension: Dimension) -> Option<Distribution> {
        let LognormalTable { table, mean, standard_deviation: deviation } = LognormalTable::of(self, table)?;
        let (mean, standard_deviation) = self.moments(&mean, &deviation, dimension, Some(&table))?;
        Some(Distribution::Lognormal { mean, standard_deviation })
    }

    pub(crate) fn truncated_normal(&mut self, table: Table<'_>, dimension: Dimension) -> Option<Distribution> {
        let table = TruncatedNormalTable::of(self, table)?;
        let moments = self.moments(&table.mean, &table.standard_deviation, dimension, None);
        let (lower, upper) = self.ends(&table.lower, &table.upper, dimension)?;
        let (mean, standard_deviation) = moments?;
        Some(Distribution::TruncatedNormal { mean, standard_deviation, lower, upper })
    }

    pub(crate) fn uniform(&mut self, table: Table<'_>, dimension: Dimension) -> Option<Distribution> {
        let table = UniformTable::of(self, table)?;
        let (lower, upper) = self.ends(&table.lower, &table.upper, dimension)?;
        Some(Distribution::Uniform { lower, upper })
    }

    pub(crate) fn triangular(&mut self, table: Table<'_>, dimension: Dimension) -> Option<Distribution> {
        let table = TriangularTable::of(self, table)?;
        let mode = self.parameter(&table.mode, dimension);
        let (lower, upper) = self.ends(&table.lower, &table.upper, dimension)?;
        let mode = mode?;
        if mode < lower || mode > upper {
            let [found, lower, upper] = format_apart([mode, lower, upper], dimension);
            let rule = format!("from the lower end {lower} to the upper end {upper}");
            return self.refuse_number(&table.mode, found, rule);
        }
        Some(Distribution::Triangular { lower, mode, upper })
    }

    pub(crate) fn beta(&mut self, table: Table<'_>, dimension: Dimension) -> Option<Distribution> {
        let table = BetaTable::of(self, table)?;
        let [alpha, beta] = [&table.alpha, &table.beta].map(|entry| self.number_within(entry, SHAPES_OF_BETA));
        let (lower, upper) = self.ends(&table.lower, &table.upper, dimension)?;
        Some(Distribution::Beta { alpha: alpha?, beta: beta?, lower, upper })
    }

    pub(crate) fn weibull(&mut self, table: Table<'_>, dimension: Dimension) -> Option<Distribution> {
        let WeibullTable { shape, scale, lower, .. } = WeibullTable::of(self, table)?;
        let [shape, scale, lower] = self.shape_scale_and_end([&shape, &scale, &lower], dimension)?;
        Some(Distribution::Weibull { shape, scale, lower })
    }

    pub(crate) fn gamma(&mut self, table: Table<'_>, dimension: Dimension) -> Option<Distribution> {
        let GammaTable { shape, scale, lower, .. } = GammaTable::of(self, table)?;
        let [shape, scale, lower] = self.shape_scale_and_end([&shape, &scale, &lower], dimension)?;
        Some(Distribution::Gamma { shape, scale, lower })
    }

    /// Shape, scale and lower end of a distribution without upper end.
    fn shape_scale_and_end(
        &mut self,
        [shape, scale_entry, lower]: [&Option<Entry<'_>>; 3],
        dimension: Dimension,
    ) -> Option<[f64; 3]> {
        let shape = self.number_within(shape, SHAPES);
        let scale = self.parameter(scale_entry, dimension);
        let lower = self.value_or_zero(lower, dimension)?;
        let (shape, scale) = (shape?, scale?);
        self.positive(scale_entry, scale, dimension).then_some([shape, scale, lower])
    }

    pub(crate) fn gumbel(&mut self, table: Table<'_>, dimension: Dimension) -> Option<Distribution> {
        let table = GumbelTable::of(self, table)?;
        let mode = self.parameter(&table.mode, dimension);
        let scale = self.parameter(&table.scale, dimension)?;
        let mode = mode?;
        self.positive(&table.scale, scale, dimension).then_some(Distribution::Gumbel { mode, scale })
    }

    pub(crate) fn exponential(&mut self, table: Table<'_>, dimension: Dimension) -> Option<Distribution> {
        let table = ExponentialTable::of(self, table)?;
        let mean = self.parameter(&table.mean, dimension);
        let lower = self.value_or_zero(&table.lower, dimension)?;
        let mean = mean?;
        if mean > lower {
            return Some(Distribution::Exponential { mean, lower });
        }
        let [found, limit] = format_apart([mean, lower], dimension);
        self.refuse_number(&table.mean, found, format!("above the lower end {limit}"))
    }

    pub(crate) fn discrete(&mut self, table: Table<'_>, dimension: Dimension) -> Option<Distribution> {
        let table = DiscreteTable::of(self, table)?;
        let (written, shares) = (table.values?, table.probabilities?);
        let entries = self.reader.list(&written);
        let share_entries = self.reader.list(&shares);
        let (entries, share_entries) = (entries?, share_entries?);
        let values: Vec<Option<f64>> =
            entries.iter().map(|entry| self.reader.measured(entry, dimension, Rule::Finite)).collect();
        let number = Dimension::NUMBER;
        let probabilities: Vec<Option<f64>> =
            share_entries.iter().map(|entry| self.reader.measured(entry, number, Rule::RequiredProbability)).collect();
        let values: Vec<f64> = values.into_iter().collect::<Option<_>>()?;
        let probabilities: Vec<f64> = probabilities.into_iter().collect::<Option<_>>()?;
        let mut is_right = self.has_choice(&written, &entries);
        for (index, entry) in entries.iter().enumerate() {
            if values[..index].contains(&values[index]) {
                self.member_twice(&written, values[index], dimension, entry);
                is_right = false;
            }
        }
        let (entry, sum) = (shares.path.describe(), probabilities.iter().sum::<f64>());
        if probabilities.len() != values.len() {
            let due = format!("expected one for each of the {} values", values.len());
            let found = format!("{} entries", probabilities.len());
            self.reader.report(&RandomProblem::Probabilities { entry, found, due }, shares.span);
            is_right = false;
        } else if !((sum - 1.0).abs() <= 1e-9) {
            let (found, due) = (format!("the sum {}", format_number(sum)), "the sum must be 1".to_owned());
            self.reader.report(&RandomProblem::Probabilities { entry, found, due }, shares.span);
            is_right = false;
        }
        is_right.then_some(Distribution::Discrete { values, probabilities })
    }
}
