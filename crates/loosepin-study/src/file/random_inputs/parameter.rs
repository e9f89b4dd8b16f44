//! Parameters of distributions that are themselves uncertain: known by an interval, a list, or a distribution of their own.

use crate::file::description::{EpistemicInput, EpistemicSubject, UncertainParameter};
use crate::file::problem::StudyProblem;
use crate::file::random_inputs::family::{FAMILIES, FAMILIES_OF_PARAMETER, PARAMETER_KEYS, ParameterTable};
use crate::file::random_inputs::random::RandomTable;
use crate::file::reader::{Parameters, Pass, StudyReader};
use loosepin_mechanics::model::QuantityId;
use loosepin_text::document::{Entry, Table};
use loosepin_text::units::{Dimension, Rule, format_apart, format_value};
use loosepin_uncertainty::{Distribution, EpistemicVariable, Members, Parameter, RandomVariable, SecondOrder};
use std::ops::RangeInclusive;

/// Parameters of one distribution that may be uncertain: every corner of their box is checked.
const MAX_PARAMETERS: usize = 4;

impl StudyReader {
    /// Reads a distribution some of whose parameters may be uncertain. It is read once for every corner of their box, so that
    /// each rule is checked there as if the corner stood in the file; what is returned has them in the middle.
    pub(crate) fn uncertain_distribution(
        &mut self,
        entry: &Entry<'_>,
        table: &RandomTable<'_>,
        path: &str,
        quantity: QuantityId,
    ) -> Option<(RandomVariable, Vec<UncertainParameter>)> {
        let mut corner = 0;
        loop {
            self.variable_at(Pass::Corner(corner), entry, table, quantity)?;
            let uncertain = self.parameters.found.len();
            if uncertain > MAX_PARAMETERS {
                let problem = StudyProblem::TooManyParameters {
                    entry: entry.path.describe(),
                    found: uncertain,
                    most: MAX_PARAMETERS,
                };
                return self.refused(&problem, entry.span);
            }
            corner += 1;
            if corner == 1 << uncertain {
                break;
            }
        }
        let variable = self.variable_at(Pass::Middle, entry, table, quantity)?;
        let mut parameters = Vec::new();
        for (parameter, dimension, variable) in std::mem::take(&mut self.parameters.found) {
            parameters.push(UncertainParameter { parameter, epistemic: self.epistemic.len() });
            let subject = EpistemicSubject::Parameter { random: self.random.len(), parameter, dimension };
            let path = format!("{path} {}", parameter.words());
            self.epistemic.push(EpistemicInput { path, subject, variable });
        }
        Some((variable, parameters))
    }

    fn variable_at(
        &mut self,
        pass: Pass,
        entry: &Entry<'_>,
        table: &RandomTable<'_>,
        quantity: QuantityId,
    ) -> Option<RandomVariable> {
        let dimension = self.model.quantities()[quantity].dimension;
        let nominal_si = Some(self.model.quantities().nominal()[quantity]);
        self.parameters = Parameters { pass, found: Vec::new(), nominal_si, is_inner: false };
        let distribution: Distribution = self.distribution(&FAMILIES, &table.table, dimension)?;
        let distribution = self.cut(table, distribution, dimension)?;
        match RandomVariable::try_new(distribution) {
            Ok(variable) => Some(variable),
            Err(error) => {
                self.refused(&StudyProblem::Distribution { entry: entry.path.describe(), error, dimension }, entry.span)
            }
        }
    }

    /// Mean and standard deviation. Where the mean is not written it is the value in the model, so that one dimension has one nominal value.
    /// `positive_mean` is the table where the mean must be above zero.
    pub(crate) fn moments(
        &mut self,
        mean_entry: &Option<Entry<'_>>,
        deviation_entry: &Option<Entry<'_>>,
        dimension: Dimension,
        positive_mean: Option<&Table<'_>>,
    ) -> Option<(f64, f64)> {
        let mean = match mean_entry {
            None if !self.parameters.is_inner => self.parameters.nominal_si,
            _ => self.parameter(mean_entry, dimension),
        };
        let deviation = self.parameter(deviation_entry, dimension);
        let (mean, deviation) = (mean?, deviation?);
        let mean_is_possible = match (positive_mean, mean_entry) {
            (None, _) => true,
            (Some(table), None) if mean <= 0.0 => {
                let (entry, found) = (table.path.join("mean").describe(), format_value(mean, dimension));
                let rule = "> 0, and is the value in the model where it is left out".to_owned();
                self.reader.report(&StudyProblem::DistributionRule { entry, found, rule }, table.span);
                false
            }
            (Some(_), _) => self.positive(mean_entry, mean, dimension),
        };
        (self.positive(deviation_entry, deviation, dimension) && mean_is_possible).then_some((mean, deviation))
    }

    /// Lower and upper end.
    pub(crate) fn ends(
        &mut self,
        lower_entry: &Option<Entry<'_>>,
        upper_entry: &Option<Entry<'_>>,
        dimension: Dimension,
    ) -> Option<(f64, f64)> {
        let [lower, upper] = [lower_entry, upper_entry].map(|entry| self.parameter(entry, dimension));
        let (lower, upper) = lower.zip(upper)?;
        if lower < upper {
            return Some((lower, upper));
        }
        let [found, limit] = format_apart([lower, upper], dimension);
        self.refuse_number(lower_entry, found, format!("below the upper end {limit}"))
    }

    /// Whether a number is above zero; reports if not.
    pub(crate) fn positive(&mut self, entry: &Option<Entry<'_>>, value: f64, dimension: Dimension) -> bool {
        if value > 0.0 {
            return true;
        }
        self.refuse_number::<()>(entry, format_value(value, dimension), "> 0".to_owned());
        false
    }

    /// A shape of a distribution.
    pub(crate) fn number_within(&mut self, entry: &Option<Entry<'_>>, shapes: RangeInclusive<f64>) -> Option<f64> {
        let shape = match entry {
            Some(number) if !number.is_table() => self.reader.number_of(number)?,
            _ => self.parameter(entry, Dimension::NUMBER)?,
        };
        if shapes.contains(&shape) {
            return Some(shape);
        }
        let [found, least, most] = format_apart([shape, *shapes.start(), *shapes.end()], Dimension::NUMBER);
        self.refuse_number(entry, found, format!("from {least} to {most}"))
    }

    /// A number that may be left out where it is 0.
    pub(crate) fn value_or_zero(&mut self, entry: &Option<Entry<'_>>, dimension: Dimension) -> Option<f64> {
        if entry.is_some() { self.parameter(entry, dimension) } else { Some(0.0) }
    }

    /// Reports a number of a distribution, where it is written.
    pub(crate) fn refuse_number<T>(&mut self, entry: &Option<Entry<'_>>, found: String, rule: String) -> Option<T> {
        let entry = entry.as_ref()?;
        // A value that stands nowhere in the file: the end of what is looked at of a parameter with a distribution.
        let is_family = |name| FAMILIES_OF_PARAMETER.iter().any(|family| family.key.name == name);
        let is_quantile = entry.is_table() && self.reader.any_keys(entry).iter().any(|key| is_family(key.name));
        let rule = if is_quantile {
            format!(
                "{rule} wherever the parameter is looked at: without two ends, from its 0.135 % to its 99.865 % quantile"
            )
        } else {
            rule
        };
        self.refused(&StudyProblem::DistributionRule { entry: entry.path.describe(), found, rule }, entry.span)
    }

    /// A number of a distribution, or its structure: then the value that the pass puts there.
    pub(crate) fn parameter(&mut self, entry: &Option<Entry<'_>>, dimension: Dimension) -> Option<f64> {
        let entry = entry.as_ref()?;
        if !entry.is_table() {
            return self.reader.measured(entry, dimension, Rule::Finite);
        }
        if self.parameters.is_inner {
            return self.refused(&StudyProblem::ParameterOfAParameter { entry: entry.path.describe() }, entry.span);
        }
        let table = self.reader.table(entry, &PARAMETER_KEYS)?;
        let known = ParameterTable::of(self, table)?;
        let variable = if FAMILIES_OF_PARAMETER.iter().any(|family| known.table.has(family.key.name)) {
            self.distribution_of_a_parameter(entry, &known.table, dimension).map(EpistemicVariable::from)
        } else if let Some(written) = known.interval {
            self.two_ends(&written, dimension).map(|(interval, _)| interval.into())
        } else {
            known.any_of.and_then(|written| self.members_of_a_parameter(&written, dimension)).map(Into::into)
        }?;
        let Some(parameter) = Parameter::ALL.into_iter().find(|parameter| parameter.key() == entry.name) else {
            return self.refused(&StudyProblem::UncertainParameter { entry: entry.path.describe() }, entry.span);
        };
        let value = match self.parameters.pass {
            Pass::Corner(corner) => variable.ends()[corner >> self.parameters.found.len() & 1],
            Pass::Middle => variable.middle(),
        };
        self.parameters.found.push((parameter, dimension, variable));
        Some(value)
    }

    fn distribution_of_a_parameter(
        &mut self,
        entry: &Entry<'_>,
        table: &Table<'_>,
        dimension: Dimension,
    ) -> Option<SecondOrder> {
        self.parameters.is_inner = true;
        let distribution = self.distribution(&FAMILIES_OF_PARAMETER, table, dimension);
        self.parameters.is_inner = false;
        match RandomVariable::try_new(distribution?) {
            Ok(variable) => SecondOrder::try_new(variable).ok(),
            Err(error) => {
                self.refused(&StudyProblem::Distribution { entry: entry.path.describe(), error, dimension }, entry.span)
            }
        }
    }

    fn members_of_a_parameter(&mut self, written: &Entry<'_>, dimension: Dimension) -> Option<Members> {
        let entries = self.reader.list(written)?;
        let mut values: Vec<f64> = Vec::new();
        for member in &entries {
            let value = self.reader.measured(member, dimension, Rule::Finite)?;
            if values.contains(&value) {
                let (entry, value) = (written.path.describe(), format_value(value, dimension));
                return self.refused(&StudyProblem::MemberTwice { entry, value }, member.span);
            }
            values.push(value);
        }
        self.has_choice(written, &entries).then(|| Members::try_new(values).ok()).flatten()
    }
}
