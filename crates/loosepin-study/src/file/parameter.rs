//! Parameters of distributions that are themselves uncertain: known by an interval, a list, or a distribution of their own.

use super::description::{EpistemicInput, EpistemicSubject, UncertainParameter};
use super::parameter_keys::{PARAMETER_FAMILIES, PARAMETER_KEYS};
use super::problem::StudyProblem;
use super::reader::{Parameters, Pass, StudyReader};
use loosepin_mechanics::model::QuantityId;
use loosepin_text::document::{Entry, Table};
use loosepin_text::units::{Dimension, Rule, format_value};
use loosepin_uncertainty::{
    Distribution, EpistemicVariable, Interval, Members, Parameter, RandomVariable, SecondOrder,
};

/// Parameters of one distribution that may be uncertain: every corner of their box is checked.
const MOST_PARAMETERS: usize = 4;

impl StudyReader {
    /// Reads a distribution some of whose parameters may be uncertain. It is read once for every corner of their box, so that
    /// each rule is checked there as if the corner stood in the file; what is returned has them in the middle.
    pub fn uncertain_distribution(
        &mut self,
        entry: &Entry<'_>,
        table: &Table<'_>,
        path: &str,
        quantity: QuantityId,
    ) -> Option<(RandomVariable, Vec<UncertainParameter>)> {
        let mut corner = 0;
        loop {
            self.variable_at(Pass::Corner(corner), entry, table, quantity)?;
            let uncertain = self.parameters.found.len();
            if uncertain > MOST_PARAMETERS {
                let problem = StudyProblem::TooManyParameters {
                    entry: entry.path.describe(),
                    found: uncertain,
                    most: MOST_PARAMETERS,
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
        table: &Table<'_>,
        quantity: QuantityId,
    ) -> Option<RandomVariable> {
        let dimension = self.model.quantities[quantity].dimension;
        let nominal_si = Some(self.model.quantities.nominal()[quantity]);
        self.parameters = Parameters { pass, found: Vec::new(), nominal_si, is_inner: false };
        let distribution: Distribution = self.distribution(table, dimension)?;
        let distribution = self.cut(table, distribution, dimension)?;
        match RandomVariable::try_new(distribution) {
            Ok(variable) => Some(variable),
            Err(error) => {
                self.refused(&StudyProblem::Distribution { entry: entry.path.describe(), error, dimension }, entry.span)
            }
        }
    }

    /// The mean of a distribution; where it is not written, the value in the model, so that one dimension has one nominal value.
    pub(super) fn mean(&mut self, table: &Table<'_>, dimension: Dimension) -> Option<f64> {
        if table.has("mean") || self.parameters.is_inner {
            return self.parameter(table, "mean", dimension);
        }
        self.parameters.nominal_si
    }

    /// A number of a distribution, or what is known of it: then the value that the pass puts there.
    pub fn parameter(&mut self, table: &Table<'_>, key: &str, dimension: Dimension) -> Option<f64> {
        let entry = table.get(key)?;
        if !entry.is_table() {
            return self.reader.measured(&entry, dimension, Rule::Finite);
        }
        if self.parameters.is_inner {
            return self.refused(&StudyProblem::ParameterOfAParameter { entry: entry.path.describe() }, entry.span);
        }
        let table = self.reader.table(&entry, &PARAMETER_KEYS)?;
        let variable = if PARAMETER_FAMILIES.into_iter().any(|family| table.has(family)) {
            self.distribution_of_a_parameter(&entry, &table, dimension).map(EpistemicVariable::from)
        } else if let Some(written) = table.get("interval") {
            self.interval_of_a_parameter(&written, dimension).map(EpistemicVariable::from)
        } else {
            table.get("any_of").and_then(|written| self.members_of_a_parameter(&written, dimension)).map(Into::into)
        }?;
        let Some(parameter) = Parameter::ALL.into_iter().find(|parameter| parameter.key() == key) else {
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
        let distribution = self.distribution(table, dimension);
        self.parameters.is_inner = false;
        match RandomVariable::try_new(distribution?) {
            Ok(variable) => SecondOrder::try_new(variable).ok(),
            Err(error) => {
                self.refused(&StudyProblem::Distribution { entry: entry.path.describe(), error, dimension }, entry.span)
            }
        }
    }

    fn interval_of_a_parameter(&mut self, entry: &Entry<'_>, dimension: Dimension) -> Option<Interval> {
        let (interval, _) = self.two_ends(entry, dimension)?;
        Some(interval)
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
