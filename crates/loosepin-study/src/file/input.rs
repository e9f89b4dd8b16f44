//! Random and epistemic inputs.

use core::f64::consts::TAU;

use super::description::{EpistemicInput, EpistemicSubject, RandomInput, RandomSubject};
use super::evidence::{ElementTable, FuzzyTable};
use super::problem::StudyProblem;
use super::reader::StudyReader;
use crate::file::random_inputs::fit::{DIAMETER, FIT};
use crate::file::random_inputs::random::{RANDOM_KEYS, RandomTable};
use crate::file::random_inputs::random_problem::RandomProblem;
use loosepin_mechanics::model::{ContactId, NormalDescription, QuantityId};
use loosepin_text::document::{DocumentProblem, Entry, Kind, Reads};
use loosepin_text::record;
use loosepin_text::tolerance::{limits_of_class, parse_tolerance};
use loosepin_text::units::{Dimension, Measured, Rule, format_apart, format_value};
use loosepin_uncertainty::{EpistemicVariable, Evidence, Interval, Members};

/// First words of paths in a model: TOML makes a table of them where the quotes are forgotten.
const FIRST_WORDS: [&str; 6] = ["parameter", "body", "joint", "contact", "drive", "assembly"];

/// Ends in degrees become radians with this relative error, at most.
const PERIOD_ROUND_OFF: f64 = 1e-12;

const RANDOM_EXAMPLE: &str = "a table such as { normal = { mean = \"50 mm\", standard_deviation = \"0.02 mm\" } }";
const EPISTEMIC_EXAMPLE: &str = "a table such as { interval = [\"0.1 mm\", \"0.5 mm\"] }";

record! {
    /// an unknown (epistemic) input
    pub(super) lenient struct EpistemicTable for Reads,
        exactly one of [interval, any_of, fit, evidence, periodic, fuzzy, quantiles, mean];
    /// lower and upper end; every value between them is possible, with no known probabilities
    optional interval: Entry<'t> = Kind::List(&Kind::AnyQuantity), "[\"0.1 mm\", \"0.5 mm\"]";
    /// list of all possible values: laws for the law of a contact, otherwise values with their unit
    optional any_of: Entry<'t> = Kind::List(&Kind::AnyQuantity), "[\"lankarani-nikravesh\", \"flores\"]";
    /// intervals with Dempster-Shafer masses that sum to 1; the true value lies in one of them
    optional evidence: Entry<'t> = Kind::List(&Kind::Table(&ElementTable::KEYS)), "";
    /// one period of an angle or phase that may have any value; both ends are the same angle
    optional periodic: Entry<'t> = Kind::List(&Kind::AnyQuantity), "[\"0 deg\", \"360 deg\"]";
    /// fuzzy number: values with different degrees of possibility
    optional fuzzy: Entry<'t> = Kind::Table(&FuzzyTable::KEYS), "";
    /// a few quantiles of a random quantity whose distribution is otherwise unknown; needs support
    optional quantiles: Entry<'t> =
        Kind::List(&Kind::List(&Kind::AnyOf(&[Kind::Number { rule: Rule::Probability }, Kind::AnyQuantity]))),
        "[[0.05, \"0.1 mm\"], [0.5, \"0.2 mm\"], [0.95, \"0.4 mm\"]]";
    /// the mean of a random quantity whose distribution is otherwise unknown; needs support
    optional mean: Entry<'t> = Kind::AnyQuantity, "\"0.2 mm\"";
    /// with quantiles or a mean: the smallest and the largest possible value
    optional support: Entry<'t> = Kind::List(&Kind::AnyQuantity), "[\"0.05 mm\", \"0.5 mm\"]";
    optional fit: Entry<'t> as FIT;
    optional diameter: Entry<'t> as DIAMETER;
}

impl StudyReader {
    /// Reads the table of random inputs.
    pub fn read_random(&mut self, entry: &Entry<'_>) {
        for entry in self.reader.any_keys(entry) {
            if self.model.contact_of_law(entry.name).is_some() {
                self.report(&StudyProblem::RandomLaw { path: entry.name.to_owned() }, &entry.at_key());
                continue;
            }
            let Some(quantity) = self.input(&entry, RANDOM_EXAMPLE) else { continue };
            let table = self.reader.table(&entry, &RANDOM_KEYS).and_then(|table| RandomTable::of(self, table));
            let Some(table) = table else { continue };
            let Some((variable, parameters, origin)) = self.random_input(&entry, &table, quantity) else { continue };
            let (path, subject) = (entry.name.to_owned(), RandomSubject::Quantity(quantity));
            self.random.push(RandomInput { path, subject, variable, origin, parameters });
        }
    }

    /// Reads the table of epistemic inputs.
    pub fn read_epistemic(&mut self, entry: &Entry<'_>) {
        for entry in self.reader.any_keys(entry) {
            if let Some(contact) = self.model.contact_of_law(entry.name) {
                match contact {
                    Ok(contact) => self.read_law(&entry, contact),
                    Err(error) => self.report(&error.into(), &entry.at_key()),
                }
                continue;
            }
            let Some(quantity) = self.input(&entry, EPISTEMIC_EXAMPLE) else { continue };
            if self.random.iter().any(|input| input.quantity() == Some(quantity)) {
                self.report(&StudyProblem::InputTwice { path: entry.name.to_owned() }, &entry.at_key());
            }
            let Some(known) = EpistemicTable::read(self, &entry) else { continue };
            self.refuse_stray(&known.table, &[("diameter", "fit")]);
            let path = entry.name;
            let variable: Option<EpistemicVariable> = if let Some(written) = &known.interval {
                self.interval(written, quantity, path).map(Into::into)
            } else if let Some(written) = &known.periodic {
                self.period(written, quantity, path).map(EpistemicVariable::Periodic)
            } else if let Some(written) = &known.any_of {
                self.numbers(written, quantity, path).map(Into::into)
            } else if let Some(written) = &known.fit {
                self.fit_interval(&known.table, written, quantity, path).map(Into::into)
            } else {
                None
            };
            let is_plain =
                known.interval.is_some() || known.periodic.is_some() || known.any_of.is_some() || known.fit.is_some();
            let variable = match (&known.support, is_plain) {
                (Some(support), true) => {
                    self.refused(&StudyProblem::SupportAlone { entry: support.path.describe() }, support.key_span)
                }
                (_, true) => variable,
                (_, false) => self.structured(&known, quantity, path),
            };
            if let Some(variable) = variable {
                let subject = EpistemicSubject::Quantity(quantity);
                self.epistemic.push(EpistemicInput { path: entry.name.to_owned(), subject, variable });
            }
        }
    }

    /// Reads a structure of a quantity other than an interval or a list; `None` if it has none.
    fn structured(
        &mut self,
        known: &EpistemicTable<'_>,
        quantity: QuantityId,
        path: &str,
    ) -> Option<EpistemicVariable> {
        if let Some(written) = &known.quantiles {
            let support = self.support(known, written, quantity, path)?;
            return self.box_of_quantiles(written, support, quantity).map(Into::into);
        }
        if let Some(written) = &known.mean {
            let support = self.support(known, written, quantity, path)?;
            let dimension = self.model.quantities()[quantity].dimension;
            let mean = self.reader.measured(written, dimension, Rule::Finite)?;
            return self.evidence_of(Evidence::from_mean(mean, support), written, dimension).map(Into::into);
        }
        if let Some(support) = &known.support {
            return self.refused(&StudyProblem::SupportAlone { entry: support.path.describe() }, support.key_span);
        }
        if let Some(written) = &known.evidence {
            return self.evidence(written, quantity, path).map(Into::into);
        }
        known.fuzzy.as_ref().and_then(|written| self.fuzzy(written, quantity, path)).map(Into::into)
    }

    /// The ends between which a quantity must lie.
    fn support(
        &mut self,
        known: &EpistemicTable<'_>,
        written: &Entry<'_>,
        quantity: QuantityId,
        path: &str,
    ) -> Option<Interval> {
        match &known.support {
            Some(support) => self.interval(support, quantity, path),
            None => self.refused(&StudyProblem::NoSupport { entry: written.path.describe() }, written.key_span),
        }
    }

    /// Reads a law that is one of a list.
    fn read_law(&mut self, entry: &Entry<'_>, contact: ContactId) {
        let Some(EpistemicTable { table, any_of, .. }) = EpistemicTable::read(self, entry) else { return };
        let others =
            EpistemicTable::KEYS.keys.iter().filter(|key| any_of.as_ref().is_none_or(|own| own.name != key.name));
        for interval in others.filter_map(|key| table.get(key.name)) {
            self.report(&StudyProblem::IntervalOfLaws { path: entry.name.to_owned() }, &interval.at_key());
        }
        let Some(written) = any_of else { return };
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
                self.report(&StudyProblem::MemberTwice { entry, value }, member);
                is_right = false;
            } else if let Err(error) = self.model.check_law(contact, law) {
                self.report(&StudyProblem::Law { entry: written.path.describe(), error }, member);
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
        let dimension = self.model.quantities()[quantity].dimension;
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
            0 => self.report(&StudyProblem::Empty { entry }, written),
            1 => self.report(&StudyProblem::SingleMember { entry }, written),
            _ => return true,
        }
        false
    }

    /// Reports a member that is there already.
    pub(super) fn member_twice(&mut self, list: &Entry<'_>, value: f64, dimension: Dimension, member: &Entry<'_>) {
        let (entry, value) = (list.path.describe(), format_value(value, dimension));
        self.report(&StudyProblem::MemberTwice { entry, value }, member);
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
            Ok(quantity) if !entry.is_table() => match self.table_of_tolerance(entry, quantity, due) {
                Some(table) => {
                    let (found, path) = (entry.found(), entry.name.to_owned());
                    let problem = RandomProblem::BareTolerance { entry: entry.path.describe(), found, path, table };
                    self.refused(&problem, entry.span)
                }
                None => self.reader.wrong_type(entry, due),
            },
            Ok(quantity) => Some(quantity),
            Err(error) => self.refused(&StudyProblem::from(error), entry.key_span),
        }
    }

    /// The table that is meant where a value with its tolerance stands in place of one; `None` where something else does.
    fn table_of_tolerance(&self, entry: &Entry<'_>, quantity: QuantityId, due: &str) -> Option<String> {
        let text = entry.as_text()?;
        let dimension = self.model.quantities()[quantity].dimension;
        let in_model = Measured { value_si: self.model.quantities().nominal()[quantity], dimension };
        let limits = parse_tolerance(text, in_model).filter(|read| read.nominal.dimension == dimension);
        if due == EPISTEMIC_EXAMPLE {
            let [lower, upper] = limits?.limits.map(|limit| format_value(limit.value_si, dimension));
            return Some(format!("{{ interval = [\"{lower}\", \"{upper}\"] }}"));
        }
        let deviations = match limits {
            Some(_) => text.trim().to_owned(),
            None => limits_of_class(text)??.deviations,
        };
        Some(format!("{{ tolerance = \"{deviations}\" }}"))
    }

    /// One period of a quantity: of an angle a whole turn, or a whole fraction of one.
    fn period(&mut self, entry: &Entry<'_>, quantity: QuantityId, path: &str) -> Option<Interval> {
        let interval = self.interval(entry, quantity, path)?;
        let dimension = self.model.quantities()[quantity].dimension;
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
        let (interval, [first, second]) = self.two_ends(entry, self.model.quantities()[quantity].dimension)?;
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
}
