//! Random inputs, however their distribution is stated: by a family, a sample, a tolerance or a fit.

use crate::file::description::{EpistemicInput, EpistemicSubject, UncertainParameter};
use crate::file::problem::StudyProblem;
use crate::file::random_inputs::family::{FAMILIES, FAMILY_COUNT, family_keys, names};
use crate::file::random_inputs::fit::{DIAMETER, FIT};
use crate::file::random_inputs::random_problem::{RandomProblem, short_number};
use crate::file::reader::{StudyReader, adopt};
use crate::file::words::words;
use loosepin_math::sort_ascending;
use loosepin_mechanics::model::QuantityId;
use loosepin_simulate::measured::SampleColumn;
use loosepin_text::diagnostics::Diagnostic;
use loosepin_text::document::{Entry, Key, Keys, Kind, Reads, Table, joined, read_beside};
use loosepin_text::record;
use loosepin_text::tolerance::parse_tolerance;
use loosepin_text::units::{Dimension, Measured, Rule, format_apart, format_number, format_value, parse_quantity};
use loosepin_uncertainty::{Distribution, FittedFamily, GoodnessOfFit, Interval, Parameter, RandomVariable};

/// Keys that say more about another one.
const BELONGS_TO: [(&str, &str); 5] =
    [("column", "samples"), ("fitted", "samples"), ("cp", "tolerance"), ("cpk", "tolerance"), ("diameter", "fit")];

/// Round-off of a number that is written in two files.
const ROUND_OFF: f64 = 1e-9;
/// The limits of a drawing lie this many standard deviations from the mean, times Cp.
const DEVIATIONS_TO_LIMIT: f64 = 3.0;

record! {
    /// the distribution of a quantity
    pub(crate) lenient struct RandomTable for Reads, exactly one of [samples, tolerance, fit],
        planned &[("empirical", "name the file: samples = \"measured.csv\", column = \"pin\"")];
    /// a CSV file of measured values, relative to the folder of this file; all values are equally probable
    optional samples: Entry<'t> = Kind::Text, "\"measured.csv\"";
    /// header of the column with the samples, with its unit: pin [mm]
    optional column: Entry<'t> = Kind::Text, "\"pin\"";
    /// family of distributions to fit to the samples, instead of using them directly
    optional fitted: Entry<'t> = Kind::Choice(&words(&FittedFamily::ALL)), "\"normal\"";
    /// tolerance: a normal distribution whose limits are 3 cpk standard deviations from the mean; also "50 +0.02 -0.01 mm", or "± 0.05 mm"
    /// about the value in the model
    optional tolerance: Entry<'t> = Kind::Text, "\"50 ± 0.05 mm\"";
    /// capability index Cpk of the process; alone: centred; below cp: off centre by an unknown amount
    optional cpk: Entry<'t> = Kind::Number { rule: Rule::Finite }, "1.33";
    /// capability index Cp of the process: its Cpk if it were centred
    optional cp: Entry<'t> = Kind::Number { rule: Rule::Finite }, "1.67";
    optional fit: Entry<'t> as FIT;
    optional diameter: Entry<'t> as DIAMETER;
    /// truncates the distribution to an interval and rescales it
    optional truncated: Entry<'t> = Kind::Table(&TruncatedTable::KEYS), "{ upper = \"50.1 mm\" }";
}

record! {
    /// the interval of a truncated distribution; at least one of the ends
    lenient struct TruncatedTable for Reads;
    /// lower end
    optional lower: Entry<'t> = Kind::AnyQuantity, "\"49.9 mm\"";
    /// upper end
    optional upper: Entry<'t> = Kind::AnyQuantity, "\"50.1 mm\"";
}

/// What states a distribution in [`RandomTable`].
const STATEMENTS: &[&str] = RandomTable::KEYS.exactly_one[0];
/// Keys of a random input: the families of distributions, and those of [`RandomTable`].
pub(crate) const RANDOM_KEYS: Keys = Keys {
    keys: &joined::<Key, { FAMILY_COUNT + RandomTable::KEYS.keys.len() }>(&[
        &family_keys(&FAMILIES),
        RandomTable::KEYS.keys,
    ]),
    exactly_one: &[&joined::<&str, { FAMILY_COUNT + STATEMENTS.len() }>(&[
        &names(&family_keys(&FAMILIES)),
        STATEMENTS,
    ])],
    ..RandomTable::KEYS
};

/// A distribution that was not stated as such.
struct Stated {
    distribution: Distribution,
    /// Its source, in words.
    origin: String,
    /// Interval of its mean, if that is off centre by an unknown amount.
    mean: Option<Interval>,
}

impl StudyReader {
    /// Reads the table of a random input: its distribution, those of its parameters that are uncertain, and in words where it
    /// comes from, where it was not stated as it is.
    pub(crate) fn random_input(
        &mut self,
        entry: &Entry<'_>,
        table: &RandomTable<'_>,
        quantity: QuantityId,
    ) -> Option<(RandomVariable, Vec<UncertainParameter>, Option<String>)> {
        let (path, dimension) = (entry.name, self.model.quantities()[quantity].dimension);
        self.refuse_stray(&table.table, &BELONGS_TO);
        let stated = if let Some(entry) = &table.samples {
            self.samples(table, entry, dimension)
        } else if let Some(entry) = &table.tolerance {
            self.tolerance(table, entry, quantity)
        } else if let Some(entry) = &table.fit {
            let scatter = self.fit_scatter(&table.table, entry, quantity, path);
            scatter.map(|(distribution, origin)| Stated { distribution, origin, mean: None })
        } else {
            let (variable, parameters) = self.uncertain_distribution(entry, table, path, quantity)?;
            return Some((variable, parameters, None));
        };
        let Stated { distribution, origin, mean } = stated?;
        let distribution = self.cut(table, distribution, dimension)?;
        let checked = RandomVariable::try_new(distribution).and_then(|variable| {
            let ends = mean.iter().flat_map(|mean| [mean.lower(), mean.upper()]);
            ends.map(|end| variable.with_parameters([(Parameter::Mean, end)])).collect::<Result<Vec<_>, _>>()?;
            Ok(variable)
        });
        let variable = match checked {
            Ok(variable) => variable,
            Err(error) => {
                let entry_words = entry.path.describe();
                return self.refused(&StudyProblem::Distribution { entry: entry_words, error, dimension }, entry.span);
            }
        };
        let mut parameters = Vec::new();
        if let Some(mean) = mean {
            let parameter = Parameter::Mean;
            parameters.push(UncertainParameter { parameter, epistemic: self.epistemic.len() });
            let subject = EpistemicSubject::Parameter { random: self.random.len(), parameter, dimension };
            let path = format!("{path} {}", parameter.words());
            self.epistemic.push(EpistemicInput { path, subject, variable: mean.into() });
        }
        Some((variable, parameters, Some(origin)))
    }

    /// Reports keys that say more about another one that is not there.
    pub(crate) fn refuse_stray(&mut self, table: &Table<'_>, belongs_to: &[(&'static str, &'static str)]) {
        for &(key, to) in belongs_to {
            if let Some(entry) = table.get(key).filter(|_| !table.has(to)) {
                self.reader.report(&RandomProblem::StrayKey { entry: entry.path.describe(), to }, entry.key_span);
            }
        }
    }

    /// The distribution within `truncated = { lower, upper }`, where that is written.
    pub(crate) fn cut(
        &mut self,
        table: &RandomTable<'_>,
        distribution: Distribution,
        dimension: Dimension,
    ) -> Option<Distribution> {
        let Some(entry) = &table.truncated else { return Some(distribution) };
        let cut = TruncatedTable::read(self, entry)?;
        if cut.lower.is_none() && cut.upper.is_none() {
            return self.refused(&RandomProblem::NoCut { entry: entry.path.describe() }, entry.span);
        }
        let mut end = |end: &Option<Entry<'_>>, open: f64| match end {
            Some(written) => self.reader.measured(written, dimension, Rule::Finite),
            None => Some(open),
        };
        let (lower, upper) = (end(&cut.lower, f64::NEG_INFINITY), end(&cut.upper, f64::INFINITY));
        let (lower, upper) = (lower?, upper?);
        if lower < upper {
            return Some(Distribution::Truncated { of: Box::new(distribution), lower, upper });
        }
        let [found, limit] = format_apart([lower, upper], dimension);
        self.refuse_number(&cut.lower, found, format!("below the upper end {limit}"))
    }

    /// Reads a sample, as it is or with a family fitted to it.
    fn samples(&mut self, table: &RandomTable<'_>, entry: &Entry<'_>, dimension: Dimension) -> Option<Stated> {
        let fitted = table.fitted.as_ref().map(|entry| (self.reader.choice(entry, &FittedFamily::ALL), entry));
        let column = table.column.as_ref().map(|entry| self.reader.text(entry));
        let file = self.reader.text(entry)?;
        let column = match column {
            Some(column) => Some(column?),
            None => None,
        };
        let read = read_beside(&self.reader.source, file);
        let column = match read.and_then(|source| SampleColumn::from_source(source, column)) {
            Ok(column) => column,
            Err(diagnostics) => {
                adopt(&mut self.reader, &diagnostics, entry.span);
                return None;
            }
        };
        self.tables.push(column.source.clone());
        if column.dimension != dimension {
            let (words, found, due) = (entry.path.describe(), column.dimension, dimension);
            let problem = RandomProblem::SampleDimension { entry: words, column: column.name, found, due };
            return self.refused(&problem, entry.span);
        }
        let mut values = column.values_si;
        sort_ascending(&mut values);
        let count = values.len();
        let origin = |how: &str| format!("{how} of '{}' in {file}", column.name);
        let Some((family, written)) = fitted else {
            let distribution = Distribution::Empirical { values: values.into() };
            return Some(Stated { distribution, origin: origin("values"), mean: None });
        };
        let (family, words) = (family?, written.path.describe());
        let name = FittedFamily::ALL.iter().find(|known| known.1 == family).map_or("", |known| known.0);
        match family.fit(&values) {
            Ok(fit) => {
                self.judge(&fit.goodness, name, &column.name, written);
                let GoodnessOfFit { kolmogorov_smirnov, anderson_darling, .. } = fit.goodness;
                let how = format!(
                    "fitted ({}; Kolmogorov-Smirnov distance {}, Anderson-Darling {}) to {count} values",
                    fit.method,
                    short_number(kolmogorov_smirnov),
                    short_number(anderson_darling)
                );
                Some(Stated { distribution: fit.distribution, origin: origin(&how), mean: None })
            }
            Err(error) => {
                let column = column.name.clone();
                let problem = RandomProblem::NoFit { entry: words, family: name, column, error, dimension };
                self.refused(&problem, written.span)
            }
        }
    }

    /// Warns where a fit is poor.
    fn judge(&mut self, goodness: &GoodnessOfFit, family: &'static str, column: &str, entry: &Entry<'_>) {
        if goodness.is_rejected == Some(true) {
            let problem = RandomProblem::PoorFit {
                entry: entry.path.describe(),
                family,
                column: column.to_owned(),
                distance: short_number(goodness.anderson_darling),
            };
            let place = self.reader.place(entry.span);
            self.reader.diagnostics.push(Diagnostic::warning(&problem, Some(place)));
        }
    }

    /// Reads a value with its tolerance: normal about the middle of the limits, which lie 3 Cp standard deviations away.
    fn tolerance(&mut self, table: &RandomTable<'_>, entry: &Entry<'_>, quantity: QuantityId) -> Option<Stated> {
        let dimension = self.model.quantities()[quantity].dimension;
        let [cp, cpk] = [&table.cp, &table.cpk].map(|read| read.as_ref().map(|entry| (self.capability(entry), entry)));
        let text = self.reader.text(entry)?;
        let nominal_si = self.model.quantities().nominal()[quantity];
        let Some(tolerance) = parse_tolerance(text, Measured { value_si: nominal_si, dimension }) else {
            let is_limit = parse_quantity(text).is_ok_and(|limit| {
                limit.dimension == dimension && limit.value_si > 0.0 && limit.value_si < 0.5 * nominal_si.abs()
            });
            let nominal = || format_value(nominal_si, dimension);
            let problem = RandomProblem::NoTolerance {
                entry: entry.path.describe(),
                text: text.to_owned(),
                nominal: is_limit.then(nominal),
            };
            return self.refused(&problem, entry.span);
        };
        if !self.reader.measures(entry, tolerance.limits[0].dimension, dimension) {
            return None;
        }
        // What a clearance is in the model plays no part: no ideal motion depends on it.
        let is_play = self.model.has_play_from(quantity);
        if !is_play && (tolerance.nominal.value_si - nominal_si).abs() > ROUND_OFF * nominal_si.abs() {
            let [written, nominal] = format_apart([tolerance.nominal.value_si, nominal_si], dimension);
            let problem = StudyProblem::OtherNominal { entry: entry.path.describe(), written, nominal };
            return self.refused(&problem, entry.span);
        }
        let [lower, upper] = tolerance.limits.map(|limit| limit.value_si);
        if !(lower < upper) {
            let [lower, upper] = format_apart([lower, upper], dimension);
            return self.refused(&RandomProblem::NoRoom { entry: entry.path.describe(), lower, upper }, entry.span);
        }
        for limit_si in [lower, upper] {
            // Limits are what parts may be: no probability excuses an impossible one.
            if let Err(error) = self.model.quantities().evaluate(&[(quantity, limit_si)]) {
                let (path, end) = (self.model.quantities()[quantity].path.clone(), format_value(limit_si, dimension));
                return self.refused(&StudyProblem::ImpossibleEnd { path, end, error }, entry.span);
            }
        }
        let [cp_value, cpk_value] = [&cp, &cpk].map(|read| read.as_ref().and_then(|(value, _)| *value));
        let (capability, words) = match (cp, cpk) {
            (None, None) => (1.0, "limits taken as 3 standard deviations from a centred mean".to_owned()),
            (Some((cp, _)), None) => {
                let cp = cp?;
                (cp, format!("Cp {}, taken as centred since no Cpk is given", format_number(cp)))
            }
            (None, Some((cpk, _))) => {
                let cpk = cpk?;
                (cpk, format!("Cpk {}, taken as centred", format_number(cpk)))
            }
            (Some((cp, _)), Some((cpk, written))) => {
                let (cp, cpk) = (cp?, cpk?);
                let words = written.path.describe();
                if cpk > cp {
                    let [cp, cpk] = [cp, cpk].map(format_number);
                    return self.refused(&RandomProblem::CapabilitiesExchanged { entry: words, cpk, cp }, written.span);
                }
                let words = if cpk < cp {
                    "the mean off centre by an unknown amount, to either side".to_owned()
                } else {
                    "centred".to_owned()
                };
                (cp, format!("Cp {}, Cpk {}, {words}", format_number(cp), format_number(cpk)))
            }
        };
        let standard_deviation = (upper - lower) / (2.0 * DEVIATIONS_TO_LIMIT * capability);
        let middle = 0.5 * (lower + upper);
        // Cpk is what is left of Cp on the side to which the mean is off centre.
        let shift = match (cp_value, cpk_value) {
            (Some(cp), Some(cpk)) => (cp - cpk) * DEVIATIONS_TO_LIMIT * standard_deviation,
            _ => 0.0,
        };
        let mean = if shift > 0.0 { Interval::try_new(middle - shift, middle + shift).ok() } else { None };
        let distribution = Distribution::Normal { mean: middle, standard_deviation };
        Some(Stated { distribution, origin: format!("{text}, {words}"), mean })
    }

    /// A Cp or Cpk.
    fn capability(&mut self, entry: &Entry<'_>) -> Option<f64> {
        let value = self.reader.number_of(entry)?;
        if value > 0.0 {
            return Some(value);
        }
        let problem = RandomProblem::Capability { entry: entry.path.describe(), found: format_number(value) };
        self.refused(&problem, entry.span)
    }
}
