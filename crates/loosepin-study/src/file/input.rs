//! Random and epistemic inputs.

use core::f64::consts::TAU;

use super::description::{EpistemicInput, EpistemicSubject, RandomInput};
use super::keys::{
    BETA_KEYS, EPISTEMIC_KEYS, FAMILIES, LOGNORMAL_KEYS, NORMAL_KEYS, RANDOM_KEYS, TRIANGULAR_KEYS,
    TRUNCATED_NORMAL_KEYS, UNIFORM_KEYS,
};
use super::parameter_keys::PARAMETER_FAMILIES;
use super::problem::StudyProblem;
use super::reader::StudyReader;
use loosepin_mechanics::model::{ContactId, NormalDescription, QuantityId};
use loosepin_text::document::{DocumentProblem, Entry, Keys, Table};
use loosepin_text::units::{Dimension, Rule, format_apart, format_value};
use loosepin_uncertainty::{Distribution, EpistemicVariable, Interval, Members};

/// First words of paths in a model: TOML makes a table of them where the quotes are forgotten.
const FIRST_WORDS: [&str; 6] = ["parameter", "body", "joint", "contact", "drive", "assembly"];

/// Shapes of a beta distribution that are accepted. Above, it is a normal distribution a thousand times narrower than
/// its interval; below, it is two values; and its quantiles take longer than the runs.
const SHAPES: std::ops::RangeInclusive<f64> = 1e-3..=1e6;

/// Ends in degrees become radians with this relative error, at most.
const PERIOD_ROUND_OFF: f64 = 1e-12;

const RANDOM_EXAMPLE: &str = "a table such as { normal = { mean = \"50 mm\", standard_deviation = \"0.02 mm\" } }";
const EPISTEMIC_EXAMPLE: &str = "a table such as { interval = [\"0.1 mm\", \"0.5 mm\"] }";

/// Whether a key states the distribution of a parameter.
fn is_family(key: &str) -> bool {
    PARAMETER_FAMILIES.contains(&key)
}

impl StudyReader {
    /// Reads the table of random inputs.
    pub fn read_random(&mut self, entry: &Entry<'_>) {
        for entry in self.reader.any_keys(entry) {
            if self.model.contact_of_law(entry.name).is_some() {
                self.complain(&StudyProblem::RandomLaw { path: entry.name.to_owned() }, &entry.at_key());
                continue;
            }
            let Some(quantity) = self.input(&entry, RANDOM_EXAMPLE) else { continue };
            let Some(table) = self.reader.table(&entry, &RANDOM_KEYS) else { continue };
            let Some((variable, parameters, origin)) = self.random_input(&entry, &table, quantity) else { continue };
            self.random.push(RandomInput { path: entry.name.to_owned(), quantity, variable, origin, parameters });
        }
    }

    /// Reads the table of epistemic inputs.
    pub fn read_epistemic(&mut self, entry: &Entry<'_>) {
        for entry in self.reader.any_keys(entry) {
            if let Some(contact) = self.model.contact_of_law(entry.name) {
                match contact {
                    Ok(contact) => self.read_law(&entry, contact),
                    Err(error) => self.complain(&error.into(), &entry.at_key()),
                }
                continue;
            }
            let Some(quantity) = self.input(&entry, EPISTEMIC_EXAMPLE) else { continue };
            if self.random.iter().any(|input| input.quantity == quantity) {
                self.complain(&StudyProblem::InputTwice { path: entry.name.to_owned() }, &entry.at_key());
            }
            let Some(table) = self.reader.table(&entry, &EPISTEMIC_KEYS) else { continue };
            self.refuse_stray(&table, &[("diameter", "fit")]);
            let variable = if let Some(written) = table.get("interval") {
                self.interval(&written, quantity, entry.name).map(EpistemicVariable::from)
            } else if let Some(written) = table.get("periodic") {
                self.period(&written, quantity, entry.name).map(EpistemicVariable::Periodic)
            } else if let Some(written) = table.get("any_of") {
                self.numbers(&written, quantity, entry.name).map(EpistemicVariable::from)
            } else if let Some(written) = table.get("fit") {
                self.fit_interval(&table, &written, quantity, entry.name).map(EpistemicVariable::from)
            } else {
                None
            };
            let is_plain = ["interval", "periodic", "any_of", "fit"].into_iter().any(|key| table.has(key));
            let variable = match (table.get("support"), is_plain) {
                (Some(support), true) => {
                    self.refused(&StudyProblem::SupportAlone { entry: support.path.describe() }, support.key_span)
                }
                (_, true) => variable,
                (_, false) => self.structured(&table, quantity, entry.name),
            };
            if let Some(variable) = variable {
                let subject = EpistemicSubject::Quantity(quantity);
                self.epistemic.push(EpistemicInput { path: entry.name.to_owned(), subject, variable });
            }
        }
    }

    /// Reads a law that is one of a list.
    fn read_law(&mut self, entry: &Entry<'_>, contact: ContactId) {
        let Some(table) = self.reader.table(entry, &EPISTEMIC_KEYS) else { return };
        for interval in
            EPISTEMIC_KEYS.keys.iter().filter(|key| key.name != "any_of").filter_map(|key| table.get(key.name))
        {
            self.complain(&StudyProblem::IntervalOfLaws { path: entry.name.to_owned() }, &interval.at_key());
        }
        let Some(written) = table.get("any_of") else { return };
        let Some(entries) = self.reader.list(&written) else { return };
        let choices: Vec<(&'static str, NormalDescription)> =
            NormalDescription::all().map(|law| (law.name(), law)).collect();
        let mut laws: Vec<NormalDescription> = Vec::new();
        let mut is_right = true;
        for member in &entries {
            let Some(law) = self.reader.choice(member, &choices) else {
                is_right = false;
                continue;
            };
            if laws.iter().any(|known| known.name() == law.name()) {
                let (entry, value) = (written.path.describe(), format!("\"{}\"", law.name()));
                self.complain(&StudyProblem::MemberTwice { entry, value }, member);
                is_right = false;
            } else if let Err(error) = self.model.with_law(contact, law) {
                self.complain(&StudyProblem::Law { entry: written.path.describe(), error }, member);
                is_right = false;
            }
            laws.push(law);
        }
        if !is_right || !self.has_choice(&written, &entries) {
            return;
        }
        let places = (0..laws.len()).map(|place| place as f64).collect();
        if let Ok(members) = Members::try_new(places) {
            let subject = EpistemicSubject::Law { contact, laws };
            self.epistemic.push(EpistemicInput { path: entry.name.to_owned(), subject, variable: members.into() });
        }
    }

    /// Reads a number that is one of a list.
    fn numbers(&mut self, written: &Entry<'_>, quantity: QuantityId, path: &str) -> Option<Members> {
        let dimension = self.model.quantities[quantity].dimension;
        let entries = self.reader.list(written)?;
        let mut values: Vec<f64> = Vec::new();
        let mut is_right = true;
        for member in &entries {
            let Some(value) = self.reader.measured(member, dimension, Rule::Finite) else {
                is_right = false;
                continue;
            };
            if values.contains(&value) {
                self.member_twice(written, value, dimension, member);
                is_right = false;
            } else if !self.check_end(quantity, path, value, member, true) {
                is_right = false;
            }
            values.push(value);
        }
        (is_right && self.has_choice(written, &entries)).then(|| Members::try_new(values).ok()).flatten()
    }

    /// Whether a list leaves something to choose.
    pub(super) fn has_choice(&mut self, written: &Entry<'_>, entries: &[Entry<'_>]) -> bool {
        let entry = written.path.describe();
        match entries.len() {
            0 => self.complain(&StudyProblem::Empty { entry }, written),
            1 => self.complain(&StudyProblem::SingleMember { entry }, written),
            _ => return true,
        }
        false
    }

    /// Complains about a member that is there already.
    pub(super) fn member_twice(&mut self, list: &Entry<'_>, value: f64, dimension: Dimension, member: &Entry<'_>) {
        let (entry, value) = (list.path.describe(), format_value(value, dimension));
        self.complain(&StudyProblem::MemberTwice { entry, value }, member);
    }

    /// The quantity that a key names, where a table stands behind it.
    fn input(&mut self, entry: &Entry<'_>, due: &'static str) -> Option<QuantityId> {
        if FIRST_WORDS.contains(&entry.name) && entry.is_table() {
            let next = self.reader.any_keys(entry).first().map_or("name", |next| next.name);
            return self
                .refused(&StudyProblem::UnquotedPath { path: format!("{}.{next}", entry.name) }, entry.key_span);
        }
        if entry.name.starts_with("contact.") && entry.name.ends_with(".friction.law") {
            let instead = "run one study for each law".to_owned();
            return self
                .refused(&DocumentProblem::NotYetSupported { entry: entry.path.describe(), instead }, entry.key_span);
        }
        match self.model.find(entry.name) {
            Ok(_) if !entry.is_table() => self.reader.wrong_type(entry, due),
            Ok(quantity) => Some(quantity),
            Err(error) => self.refused(&StudyProblem::from(error), entry.key_span),
        }
    }

    /// One period of a quantity: of an angle a whole turn, or a whole fraction of one.
    fn period(&mut self, entry: &Entry<'_>, quantity: QuantityId, path: &str) -> Option<Interval> {
        let interval = self.interval(entry, quantity, path)?;
        let dimension = self.model.quantities[quantity].dimension;
        let width = interval.upper() - interval.lower();
        let periods = TAU / width;
        let is_whole = (periods - periods.round()).abs() <= PERIOD_ROUND_OFF * periods && periods.round() >= 1.0;
        if dimension == Dimension::ANGLE && !is_whole {
            let [found, _] = format_apart([width, TAU / periods.round().max(1.0)], dimension);
            return self.refused(&StudyProblem::Period { entry: entry.path.describe(), found }, entry.span);
        }
        Some(interval)
    }

    pub(super) fn interval(&mut self, entry: &Entry<'_>, quantity: QuantityId, path: &str) -> Option<Interval> {
        let (interval, [first, second]) = self.two_ends(entry, self.model.quantities[quantity].dimension)?;
        let lower_is_possible = self.check_end(quantity, path, interval.lower(), &first, false);
        let upper_is_possible = self.check_end(quantity, path, interval.upper(), &second, false);
        (lower_is_possible && upper_is_possible).then_some(interval)
    }

    /// An interval wider than a point, and the entries of its ends.
    pub(super) fn two_ends<'t>(
        &mut self,
        entry: &Entry<'t>,
        dimension: Dimension,
    ) -> Option<(Interval, [Entry<'t>; 2])> {
        let pair = self.reader.pair(entry)?;
        let [lower, upper] = [0, 1].map(|index: usize| self.reader.measured(&pair[index], dimension, Rule::Finite));
        let (lower, upper) = lower.zip(upper)?;
        let words = entry.path.describe();
        let [lower_words, upper_words] = format_apart([lower, upper], dimension);
        if lower > upper {
            let problem = StudyProblem::IntervalTurnedRound { entry: words, lower: lower_words, upper: upper_words };
            return self.refused(&problem, entry.span);
        }
        if lower == upper {
            return self.refused(&StudyProblem::IntervalWithoutWidth { entry: words, value: lower_words }, entry.span);
        }
        Interval::try_new(lower, upper).ok().map(|interval| (interval, pair))
    }

    pub(super) fn distribution(&mut self, table: &Table<'_>, dimension: Dimension) -> Option<Distribution> {
        let family = FAMILIES.into_iter().find(|family| table.has(family))?;
        let entry = table.get(family)?;
        let keys: &'static Keys = match family {
            "normal" => &NORMAL_KEYS,
            "truncated_normal" => &TRUNCATED_NORMAL_KEYS,
            "uniform" => &UNIFORM_KEYS,
            "lognormal" => &LOGNORMAL_KEYS,
            "triangular" => &TRIANGULAR_KEYS,
            "beta" => &BETA_KEYS,
            _ => return self.further_family(family, &entry, dimension),
        };
        let table = self.reader.table(&entry, keys)?;
        let positive_mean = family == "lognormal";
        match family {
            "normal" | "lognormal" => {
                let (mean, standard_deviation) = self.moments(&table, dimension, positive_mean)?;
                Some(if positive_mean {
                    Distribution::Lognormal { mean, standard_deviation }
                } else {
                    Distribution::Normal { mean, standard_deviation }
                })
            }
            "truncated_normal" => {
                let moments = self.moments(&table, dimension, positive_mean);
                let (lower, upper) = self.ends(&table, dimension)?;
                let (mean, standard_deviation) = moments?;
                Some(Distribution::TruncatedNormal { mean, standard_deviation, lower, upper })
            }
            "uniform" => self.ends(&table, dimension).map(|(lower, upper)| Distribution::Uniform { lower, upper }),
            "triangular" => {
                let mode = self.parameter(&table, "mode", dimension);
                let (lower, upper) = self.ends(&table, dimension)?;
                let mode = mode?;
                if mode < lower || mode > upper {
                    let [found, lower, upper] = format_apart([mode, lower, upper], dimension);
                    let rule = format!("from the lower end {lower} to the upper end {upper}");
                    self.refuse(&table, "mode", found, rule);
                    return None;
                }
                Some(Distribution::Triangular { lower, mode, upper })
            }
            _ => {
                let [alpha, beta] = ["alpha", "beta"].map(|key| self.number_within(&table, key, SHAPES));
                let (lower, upper) = self.ends(&table, dimension)?;
                Some(Distribution::Beta { alpha: alpha?, beta: beta?, lower, upper })
            }
        }
    }

    fn moments(&mut self, table: &Table<'_>, dimension: Dimension, positive_mean: bool) -> Option<(f64, f64)> {
        let mean = self.mean(table, dimension);
        let deviation = self.parameter(table, "standard_deviation", dimension);
        let (mean, deviation) = (mean?, deviation?);
        let mean_is_possible = !positive_mean || self.positive(table, "mean", mean, dimension);
        (self.positive(table, "standard_deviation", deviation, dimension) && mean_is_possible)
            .then_some((mean, deviation))
    }

    fn ends(&mut self, table: &Table<'_>, dimension: Dimension) -> Option<(f64, f64)> {
        let [lower, upper] = ["lower", "upper"].map(|key| self.parameter(table, key, dimension));
        let (lower, upper) = lower.zip(upper)?;
        if lower < upper {
            return Some((lower, upper));
        }
        let [found, limit] = format_apart([lower, upper], dimension);
        self.refuse(table, "lower", found, format!("below the upper end {limit}"));
        None
    }

    pub(super) fn positive(&mut self, table: &Table<'_>, key: &str, value: f64, dimension: Dimension) -> bool {
        if value > 0.0 {
            return true;
        }
        self.refuse(table, key, format_value(value, dimension), "> 0".to_owned());
        false
    }

    /// A shape of a distribution.
    pub(super) fn number_within(
        &mut self,
        table: &Table<'_>,
        key: &str,
        shapes: std::ops::RangeInclusive<f64>,
    ) -> Option<f64> {
        let is_uncertain = table.get(key).is_some_and(|entry| entry.is_table());
        let shape = if is_uncertain {
            self.parameter(table, key, Dimension::NUMBER)?
        } else {
            self.reader.number(table, key)?
        };
        if shapes.contains(&shape) {
            return Some(shape);
        }
        let [found, least, most] = format_apart([shape, *shapes.start(), *shapes.end()], Dimension::NUMBER);
        self.refuse(table, key, found, format!("from {least} to {most}"));
        None
    }

    pub(super) fn refuse(&mut self, table: &Table<'_>, key: &str, found: String, rule: String) {
        if let Some(entry) = table.get(key) {
            // A value that stands nowhere in the file: the end of what is looked at of a parameter with a distribution.
            let is_quantile = entry.is_table() && self.reader.any_keys(&entry).iter().any(|key| is_family(key.name));
            let rule = if is_quantile {
                format!(
                    "{rule} wherever the parameter is looked at: without two ends, from its 0.135 % to its 99.865 % quantile"
                )
            } else {
                rule
            };
            self.complain(&StudyProblem::DistributionRule { entry: entry.path.describe(), found, rule }, &entry);
        }
    }
}
