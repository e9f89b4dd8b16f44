//! Random inputs, however their distribution is stated: by a family, a sample, a tolerance or a fit.

use std::path::Path;

use super::StudyReader;
use super::keys::{DISCRETE_KEYS, EXPONENTIAL_KEYS, FITTED, GAMMA_KEYS, GUMBEL_KEYS, TRUNCATED_KEYS, WEIBULL_KEYS};
use super::random_problem::{RandomProblem, short_number};
use super::tolerance::parse_tolerance;
use crate::diagnostics::{Complaint, Complaints};
use crate::document::{DocumentProblem, Entry, Table};
use crate::measured::SampleColumn;
use crate::model::QuantityId;
use crate::uncertainty::{Distribution, FittedFamily, Goodness};
use crate::units::{Dimension, Rule, format_number, format_value};

/// Shapes of gamma and Weibull distributions that are accepted: beyond, they are one value or next to two.
const SHAPES: std::ops::RangeInclusive<f64> = 0.05..=1e6;

/// Keys that say more about another one.
const BELONGS_TO: [(&str, &str); 5] =
    [("column", "samples"), ("fitted", "samples"), ("cp", "tolerance"), ("cpk", "tolerance"), ("diameter", "fit")];

/// The limits of a drawing lie this many standard deviations from the mean, times Cp.
const DEVIATIONS_TO_LIMIT: f64 = 3.0;

/// A distribution, and in words where it comes from, where it was not stated as it is.
pub(super) struct Stated {
    pub distribution: Distribution,
    pub origin: Option<String>,
}

impl StudyReader {
    /// Reads the table of a random input.
    pub(super) fn stated(&mut self, table: &Table<'_>, quantity: QuantityId, path: &str) -> Option<Stated> {
        let dimension = self.model.quantities[quantity].dimension;
        self.refuse_stray(table, &BELONGS_TO);
        let stated = if let Some(entry) = table.get("samples") {
            self.samples(table, &entry, dimension)
        } else if let Some(entry) = table.get("tolerance") {
            self.tolerance(table, &entry, dimension)
        } else if let Some(entry) = table.get("fit") {
            self.fit_scatter(table, &entry, quantity, path)
        } else {
            self.distribution(table, dimension).map(|distribution| Stated { distribution, origin: None })
        };
        let cut = table.get("truncated").map(|entry| self.cut(&entry, dimension));
        let Stated { distribution, origin } = stated?;
        let distribution = match cut {
            None => distribution,
            Some(cut) => {
                let [lower, upper] = cut?;
                Distribution::Truncated { of: Box::new(distribution), lower, upper }
            }
        };
        Some(Stated { distribution, origin })
    }

    /// Complains about keys that say more about another one that is not there.
    pub(super) fn refuse_stray(&mut self, table: &Table<'_>, belongs_to: &[(&'static str, &'static str)]) {
        for &(key, to) in belongs_to {
            if let Some(entry) = table.get(key).filter(|_| !table.has(to)) {
                self.reader.complain(&RandomProblem::StrayKey { entry: entry.path.describe(), to }, entry.key_span);
            }
        }
    }

    /// The families whose quantiles are closed forms or lists.
    pub(super) fn further_family(
        &mut self,
        family: &str,
        entry: &Entry<'_>,
        dimension: Dimension,
    ) -> Option<Distribution> {
        let keys = match family {
            "weibull" => &WEIBULL_KEYS,
            "gamma" => &GAMMA_KEYS,
            "gumbel" => &GUMBEL_KEYS,
            "exponential" => &EXPONENTIAL_KEYS,
            _ => &DISCRETE_KEYS,
        };
        let table = self.reader.table(entry, keys)?;
        match family {
            "weibull" | "gamma" => {
                let shape = self.number_within(&table, "shape", SHAPES);
                let scale = self.value(&table, "scale", dimension);
                let lower = self.value_or_zero(&table, "lower", dimension)?;
                let (shape, scale) = (shape?, scale?);
                self.positive(&table, "scale", scale, dimension).then_some(if family == "gamma" {
                    Distribution::Gamma { shape, scale, lower }
                } else {
                    Distribution::Weibull { shape, scale, lower }
                })
            }
            "gumbel" => {
                let mode = self.value(&table, "mode", dimension);
                let scale = self.value(&table, "scale", dimension)?;
                let mode = mode?;
                self.positive(&table, "scale", scale, dimension).then_some(Distribution::Gumbel { mode, scale })
            }
            "exponential" => {
                let mean = self.value(&table, "mean", dimension);
                let lower = self.value_or_zero(&table, "lower", dimension)?;
                let mean = mean?;
                if mean > lower {
                    return Some(Distribution::Exponential { mean, lower });
                }
                let rule = format!("above the lower end {}", format_value(lower, dimension));
                self.refuse(&table, "mean", mean, dimension, rule);
                None
            }
            _ => self.discrete(&table, dimension),
        }
    }

    fn discrete(&mut self, table: &Table<'_>, dimension: Dimension) -> Option<Distribution> {
        let (written, shares) = (table.get("values")?, table.get("probabilities")?);
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
            let due = format!("one for each of the {} values is due", values.len());
            let found = format!("{} entries", probabilities.len());
            self.reader.complain(&RandomProblem::Probabilities { entry, found, due }, shares.span);
            is_right = false;
        } else if !((sum - 1.0).abs() <= 1e-9) {
            let (found, due) = (format!("the sum {}", format_number(sum)), "the sum must be 1".to_owned());
            self.reader.complain(&RandomProblem::Probabilities { entry, found, due }, shares.span);
            is_right = false;
        }
        is_right.then_some(Distribution::Discrete { values, probabilities })
    }

    /// Reads `truncated = { lower, upper }`.
    fn cut(&mut self, entry: &Entry<'_>, dimension: Dimension) -> Option<[f64; 2]> {
        let table = self.reader.table(entry, &TRUNCATED_KEYS)?;
        if !table.has("lower") && !table.has("upper") {
            self.reader.complain(&RandomProblem::NoCut { entry: entry.path.describe() }, entry.span);
            return None;
        }
        let mut end = |key: &str, open: f64| match table.get(key) {
            Some(_) => self.value(&table, key, dimension),
            None => Some(open),
        };
        let (lower, upper) = (end("lower", f64::NEG_INFINITY), end("upper", f64::INFINITY));
        let (lower, upper) = (lower?, upper?);
        if lower < upper {
            return Some([lower, upper]);
        }
        let rule = format!("below the upper end {}", format_value(upper, dimension));
        self.refuse(&table, "lower", lower, dimension, rule);
        None
    }

    /// Reads a sample, as it is or with a family fitted to it.
    fn samples(&mut self, table: &Table<'_>, entry: &Entry<'_>, dimension: Dimension) -> Option<Stated> {
        let families: Vec<(&'static str, FittedFamily)> = FittedFamily::ALL.to_vec();
        debug_assert!(families.iter().map(|family| family.0).eq(FITTED));
        let fitted = table.get("fitted").map(|entry| (self.reader.choice(&entry, &families), entry));
        let column = table.get("column").map(|entry| self.reader.text(&entry));
        let file = self.reader.text(entry)?;
        let column = match column {
            Some(column) => Some(column?),
            None => None,
        };
        let folder = Path::new(self.reader.source.name()).parent().unwrap_or(Path::new(""));
        let column = match SampleColumn::from_path(&folder.join(file), column) {
            Ok(column) => column,
            Err(complaints) => {
                self.adopt(&complaints, entry);
                return None;
            }
        };
        self.tables.push(column.source.clone());
        if column.dimension != dimension {
            let (words, found, due) = (entry.path.describe(), column.dimension, dimension);
            let problem = RandomProblem::SampleDimension { entry: words, column: column.name, found, due };
            self.reader.complain(&problem, entry.span);
            return None;
        }
        let mut values = column.values_si;
        values.sort_by(f64::total_cmp);
        let count = values.len();
        let origin = |how: &str| Some(format!("{how} of '{}' in {file}", column.name));
        let Some((family, written)) = fitted else {
            let distribution = Distribution::Empirical { values: values.into() };
            return Some(Stated { distribution, origin: origin("values") });
        };
        let (family, words) = (family?, written.path.describe());
        let name = FittedFamily::ALL.iter().find(|known| known.1 == family).map_or("", |known| known.0);
        match family.fit(&values) {
            Ok(fit) => {
                self.judge(&fit.goodness, name, &column.name, &written);
                let Goodness { kolmogorov_smirnov, anderson_darling, .. } = fit.goodness;
                let how = format!(
                    "fitted ({}; Kolmogorov-Smirnov distance {}, Anderson-Darling {}) to {count} values",
                    fit.method,
                    short_number(kolmogorov_smirnov),
                    short_number(anderson_darling)
                );
                Some(Stated { distribution: fit.distribution, origin: origin(&how) })
            }
            Err(error) => {
                let column = column.name.clone();
                let problem = RandomProblem::NoFit { entry: words, family: name, column, error, dimension };
                self.reader.complain(&problem, written.span);
                None
            }
        }
    }

    /// Warns where a fit is poor.
    fn judge(&mut self, goodness: &Goodness, family: &'static str, column: &str, entry: &Entry<'_>) {
        if goodness.is_rejected == Some(true) {
            let problem = RandomProblem::PoorFit {
                entry: entry.path.describe(),
                family,
                column: column.to_owned(),
                distance: short_number(goodness.anderson_darling),
            };
            let place = self.reader.place(entry.span);
            self.reader.complaints.push(Complaint::warning(&problem, Some(place)));
        }
    }

    /// Takes over the complaints about a table; what has no place of its own stands where the table is named.
    fn adopt(&mut self, complaints: &Complaints, entry: &Entry<'_>) {
        for complaint in complaints.sorted() {
            let place = complaint.place.clone().unwrap_or_else(|| self.reader.place(entry.span));
            self.reader.complaints.push(Complaint { place: Some(place), ..complaint.clone() });
        }
    }

    /// Reads a value with its tolerance: normal about the middle of the limits, which lie 3 Cp standard deviations away.
    fn tolerance(&mut self, table: &Table<'_>, entry: &Entry<'_>, dimension: Dimension) -> Option<Stated> {
        let [cp, cpk] = ["cp", "cpk"].map(|key| table.get(key).map(|entry| (self.capability(table, key), entry)));
        let text = self.reader.text(entry)?;
        let Some(tolerance) = parse_tolerance(text) else {
            let problem = RandomProblem::NoTolerance { entry: entry.path.describe(), text: text.to_owned() };
            self.reader.complain(&problem, entry.span);
            return None;
        };
        if !self.reader.measures(entry, tolerance.limits[0].dimension, dimension) {
            return None;
        }
        let [lower, upper] = tolerance.limits.map(|limit| limit.value_si);
        if !(lower < upper) {
            let [lower, upper] = [lower, upper].map(|limit| format_value(limit, dimension));
            self.reader.complain(&RandomProblem::NoRoom { entry: entry.path.describe(), lower, upper }, entry.span);
            return None;
        }
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
                    let problem = RandomProblem::CapabilitiesExchanged { entry: words, cpk, cp };
                    self.reader.complain(&problem, written.span);
                    return None;
                }
                if cpk < cp {
                    let instead =
                        "the mean is then off centre by an unknown amount up to (Cp - Cpk) 3 standard deviations to \
                                   either side; give cpk alone for a centred process"
                            .to_owned();
                    let entry = format!("{words} beside a greater cp");
                    self.reader.complain(&DocumentProblem::NotYetSupported { entry, instead }, written.span);
                    return None;
                }
                (cp, format!("Cp and Cpk {}, centred", format_number(cp)))
            }
        };
        let standard_deviation = (upper - lower) / (2.0 * DEVIATIONS_TO_LIMIT * capability);
        let distribution = Distribution::Normal { mean: 0.5 * (lower + upper), standard_deviation };
        Some(Stated { distribution, origin: Some(format!("{text}, {words}")) })
    }

    /// A Cp or Cpk.
    fn capability(&mut self, table: &Table<'_>, key: &str) -> Option<f64> {
        let value = self.reader.number(table, key)?;
        if value > 0.0 {
            return Some(value);
        }
        let entry = table.get(key)?;
        let problem = RandomProblem::Capability { entry: entry.path.describe(), found: format_number(value) };
        self.reader.complain(&problem, entry.span);
        None
    }

    /// A number that may be left out where it is 0.
    fn value_or_zero(&mut self, table: &Table<'_>, key: &str, dimension: Dimension) -> Option<f64> {
        if table.has(key) { self.value(table, key, dimension) } else { Some(0.0) }
    }
}
