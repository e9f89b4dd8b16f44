//! Questions and requirements.

use super::StudyReader;
use super::accuracy::AccuracyTarget;
use super::description::{Ask, Deviation, Limit, RareMethod, Reduction, Requirement, Where};
use super::keys::{
    ASK_KEYS, DEVIATIONS, LIMITS, METHODS, PLAIN_STATISTICS, REDUCTIONS, REQUIRE_KEYS, STATISTIC_KEYS, STATISTICS,
};
use super::problem::StudyProblem;
use crate::bounds::{Reading, Statistic};
use crate::diagnostics::{Complaint, Place, nearest_name};
use crate::document::{Entry, Table};
use crate::model::OutputKind;
use crate::uncertainty::EpistemicVariable;
use crate::units::{Dimension, Rule, format_value};

const DEVIATION_MEANINGS: [Deviation; 4] =
    [Deviation::Value, Deviation::Dimensional, Deviation::Clearance, Deviation::Total];
const REDUCTION_MEANINGS: [Reduction; 6] = [
    Reduction::Maximum,
    Reduction::Minimum,
    Reduction::MaximumAbsolute,
    Reduction::RootMeanSquare,
    Reduction::Mean,
    Reduction::Range,
];
const STATISTIC_MEANINGS: [Asked; 4] = [
    Asked::Statistic(Statistic::Mean),
    Asked::Statistic(Statistic::StandardDeviation),
    Asked::Statistic(Statistic::Cdf),
    Asked::Contributors,
];

/// Words for statistics that are written in another form.
const FORMS: [(&str, &str); 7] = [
    ("median", "{ quantile = 0.5 }"),
    ("quantile", "{ quantile = 0.975 }"),
    ("probability_above", "{ probability_above = \"0.4 mm\" }"),
    ("probability_below", "{ probability_below = \"0.4 mm\" }"),
    ("probability_beyond", "{ probability_beyond = \"0.4 mm\" }"),
    ("simultaneous_band", "{ simultaneous_band = 0.95 }"),
    ("std", "\"standard_deviation\""),
];

/// An entry of the list of statistics.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Asked {
    Statistic(Statistic),
    Contributors,
    Rare(Statistic, RareMethod),
    /// A band that a share of whole curves stays in.
    SimultaneousBand(f64),
}

/// A question about a curve without the small probabilities in it, and these: of leaving the limit anywhere in the cycle, which is what
/// the furthest value over the cycle does.
fn anywhere_in_the_cycle(mut ask: Ask) -> (Option<Ask>, Vec<Ask>) {
    if ask.location != Where::Cycle || ask.rare.is_empty() {
        return (Some(ask), Vec::new());
    }
    let rare = std::mem::take(&mut ask.rare);
    let anywhere = rare.iter().map(|&(statistic, method)| {
        let furthest = match statistic {
            Statistic::ProbabilityAbove(_) => Reduction::Maximum,
            Statistic::ProbabilityBelow(_) => Reduction::Minimum,
            _ => Reduction::MaximumAbsolute,
        };
        Ask {
            output: ask.output,
            deviation: ask.deviation,
            location: Where::Reduced(furthest),
            statistics: vec![statistic],
            contributors: false,
            rare: vec![(statistic, method)],
            simultaneous_bands: Vec::new(),
        }
    });
    let anywhere = anywhere.collect();
    ask.statistics.retain(|statistic| rare.iter().all(|(own, _)| own != statistic));
    let is_left = !ask.statistics.is_empty() || ask.contributors || !ask.simultaneous_bands.is_empty();
    (is_left.then_some(ask), anywhere)
}

/// Words with what they mean.
fn choices<T: Copy, const N: usize>(words: [&'static str; N], meanings: [T; N]) -> Vec<(&'static str, T)> {
    words.into_iter().zip(meanings).collect()
}

impl StudyReader {
    /// Reads the questions, and how near their bounds are to be.
    pub fn read_asks(&mut self, root: &Table<'_>) -> (Vec<Ask>, Vec<AccuracyTarget>) {
        let entries = self.double_brackets(root, "ask");
        let (mut asks, mut accuracy) = (Vec::new(), Vec::new());
        for entry in &entries {
            let Some(table) = self.reader.table(entry, &ASK_KEYS) else { continue };
            let written = self.accuracies(&table);
            if let Some(ask) = self.ask(&table) {
                let (ask, anywhere) = anywhere_in_the_cycle(ask);
                let place = asks.len();
                asks.extend(ask.into_iter().chain(anywhere));
                accuracy.extend(self.targets(written, &asks, Some(place)));
            }
        }
        (asks, accuracy)
    }

    /// The tables under `[[key]]`.
    pub(super) fn double_brackets<'t>(&mut self, root: &Table<'t>, key: &str) -> Vec<Entry<'t>> {
        let Some(entry) = root.get(key) else { return Vec::new() };
        if entry.is_table() {
            self.reader.wrong_type::<()>(&entry, "a list of tables, each under a header in double brackets");
            return Vec::new();
        }
        self.reader.list(&entry).unwrap_or_default()
    }

    fn ask(&mut self, table: &Table<'_>) -> Option<Ask> {
        let output = self.output(table);
        let deviation = self.deviation(table);
        let location = self.location(table, "at", Some("reduce"));
        // Without the output the dimension of limits is not known.
        let output = output?;
        let statistics = self.statistics(table, self.model.outputs[output].kind.dimension());
        let asked = statistics?;
        let location = location?;
        let contributors = asked.contains(&Asked::Contributors);
        let rare: Vec<(Statistic, RareMethod)> = asked
            .iter()
            .filter_map(|asked| match asked {
                Asked::Rare(statistic, method) => Some((*statistic, *method)),
                _ => None,
            })
            .collect();
        let bands: Vec<f64> = asked
            .iter()
            .filter_map(|asked| if let Asked::SimultaneousBand(share) = asked { Some(*share) } else { None })
            .collect();
        if location != Where::Cycle && !bands.is_empty() {
            if let Some(entry) = table.get("statistics") {
                self.complain(&StudyProblem::BandOfPoint { entry: table.path.describe() }, &entry);
            }
            return None;
        }
        let statistics = asked.into_iter().filter_map(|asked| match asked {
            Asked::Statistic(statistic) | Asked::Rare(statistic, _) => Some(statistic),
            Asked::Contributors | Asked::SimultaneousBand(_) => None,
        });
        let statistics = statistics.collect();
        Some(Ask { output, deviation: deviation?, location, statistics, contributors, rare, simultaneous_bands: bands })
    }

    /// Reads the requirements.
    pub fn read_requirements(&mut self, root: &Table<'_>) -> Vec<Requirement> {
        let entries = self.double_brackets(root, "require");
        entries
            .iter()
            .filter_map(|entry| {
                let table = self.reader.table(entry, &REQUIRE_KEYS)?;
                self.requirement(&table)
            })
            .collect()
    }

    fn requirement(&mut self, table: &Table<'_>) -> Option<Requirement> {
        let output = self.output(table);
        let deviation = self.deviation(table);
        let location = self.location(table, "over", None);
        let probability_at_least = self.reader.number(table, "probability_at_least");
        let output = output?;
        let limit = LIMITS.into_iter().find_map(|key| {
            let entry = table.get(key)?;
            let dimension = self.model.outputs[output].kind.dimension();
            let limit = self.reader.measured(&entry, dimension, Rule::Finite)?;
            match key {
                "below" => Some(Limit::Below(limit)),
                "above" => Some(Limit::Above(limit)),
                _ => self.limit(&entry, limit, dimension, Rule::Positive).map(Limit::Within),
            }
        });
        let probability_at_least = probability_at_least?;
        // Quantities that scatter are drawn, and no number of draws shows that none lies beyond.
        if probability_at_least == 1.0
            && !self.random.is_empty()
            && let Some(entry) = table.get("probability_at_least")
        {
            let problem = StudyProblem::CertaintyOfSamples { entry: entry.path.describe() };
            let place = Place::new(&self.reader.source, entry.span);
            self.reader.complaints.push(Complaint::warning(&problem, Some(place)));
        }
        Some(Requirement { output, deviation: deviation?, limit: limit?, location: location?, probability_at_least })
    }

    fn output(&mut self, table: &Table<'_>) -> Option<usize> {
        let entry = table.get("output")?;
        let name = self.reader.text(&entry)?.to_owned();
        let outputs = &self.model.outputs;
        let Some(index) = outputs.iter().position(|output| output.name == name) else {
            let known = outputs.iter().map(|output| format!("'{}'", output.name)).collect();
            let nearest = nearest_name(&name, outputs.iter().map(|output| output.name.as_str())).map(str::to_owned);
            let problem = StudyProblem::UnknownOutput { entry: table.path.describe(), name, nearest, known };
            self.complain(&problem, &entry);
            return None;
        };
        if matches!(outputs[index].kind, OutputKind::Path(_)) {
            self.complain(&StudyProblem::PathOutput { entry: table.path.describe(), name }, &entry);
            return None;
        }
        Some(index)
    }

    fn deviation(&mut self, table: &Table<'_>) -> Option<Deviation> {
        let entry = table.get("of")?;
        let deviation = self.reader.choice(&entry, &choices(DEVIATIONS, DEVIATION_MEANINGS))?;
        let has_play = self.model.joints.iter().any(|joint| joint.kind.play().is_some());
        if deviation == Deviation::Clearance && !has_play {
            self.complain(&StudyProblem::NoPlay { entry: entry.path.describe() }, &entry);
            return None;
        }
        Some(deviation)
    }

    /// Where in the cycle; `everywhere` is the key that stands for the whole curve, `reduction` the one for a number of it.
    fn location(&mut self, table: &Table<'_>, everywhere: &str, reduction: Option<&str>) -> Option<Where> {
        if let Some(entry) = table.get(everywhere) {
            return self.reader.choice(&entry, &[("cycle", ())]).map(|()| Where::Cycle);
        }
        if let Some(entry) = table.get("poses") {
            return self.poses(&entry);
        }
        let entry = table.get(reduction?)?;
        self.reader.choice(&entry, &choices(REDUCTIONS, REDUCTION_MEANINGS)).map(Where::Reduced)
    }

    fn poses(&mut self, entry: &Entry<'_>) -> Option<Where> {
        if !entry.is_table() {
            return self.reader.wrong_type(entry, "a table such as { crank = [\"60 deg\"] }");
        }
        let due = self.model.cycle_input(&self.model.quantities.nominal()).name;
        let mut angles_rad = Vec::new();
        for entry in self.reader.any_keys(entry) {
            if entry.name != due {
                let problem = StudyProblem::WrongDrive {
                    entry: entry.path.describe(),
                    name: entry.name.to_owned(),
                    due: due.clone(),
                };
                self.complain(&problem, &entry.at_key());
                return None;
            }
            for angle in self.reader.list(&entry)? {
                angles_rad.extend(self.reader.measured(&angle, Dimension::ANGLE, Rule::Finite));
            }
        }
        if angles_rad.is_empty() {
            if !self.reader.complaints.has_errors() {
                self.complain(&StudyProblem::Empty { entry: entry.path.describe() }, entry);
            }
            return None;
        }
        Some(Where::Poses { angles_rad })
    }

    fn statistics(&mut self, table: &Table<'_>, dimension: Dimension) -> Option<Vec<Asked>> {
        let entry = table.get("statistics")?;
        let entries = self.reader.list(&entry)?;
        if entries.is_empty() {
            self.complain(&StudyProblem::Empty { entry: entry.path.describe() }, &entry);
            return None;
        }
        let asked: Vec<Option<Asked>> = entries.iter().map(|entry| self.statistic(entry, dimension)).collect();
        asked.into_iter().collect()
    }

    fn statistic(&mut self, entry: &Entry<'_>, dimension: Dimension) -> Option<Asked> {
        if entry.is_text() {
            let text = self.reader.text(entry)?;
            if let Some((_, form)) = FORMS.into_iter().find(|(word, _)| *word == text) {
                let problem = StudyProblem::StatisticForm { entry: entry.path.describe(), word: text.to_owned(), form };
                self.complain(&problem, entry);
                return None;
            }
            return self.reader.choice(entry, &choices(PLAIN_STATISTICS, STATISTIC_MEANINGS));
        }
        if !entry.is_table() {
            return self.reader.wrong_type(entry, "the name of a statistic or a table such as { quantile = 0.975 }");
        }
        let table = self.reader.table(entry, &STATISTIC_KEYS)?;
        let key = STATISTICS.into_iter().find(|key| table.has(key))?;
        let method = self.method(&table, key)?;
        if let Some(percent) = table.get(key).filter(|entry| entry.is_text() && !key.starts_with("probability")) {
            let found = self.reader.text(&percent)?.to_owned();
            self.complain(&StudyProblem::Percent { entry: percent.path.describe(), found }, &percent);
            return None;
        }
        if key == "quantile" {
            return self.reader.number(&table, key).map(Statistic::Quantile).map(Asked::Statistic);
        }
        if key == "simultaneous_band" {
            return self.reader.number(&table, key).map(Asked::SimultaneousBand);
        }
        let entry = table.get(key)?;
        let limit = self.reader.measured(&entry, dimension, Rule::Finite)?;
        let statistic = match key {
            "probability_above" => Some(Statistic::ProbabilityAbove(limit)),
            "probability_below" => Some(Statistic::ProbabilityBelow(limit)),
            _ => self.limit(&entry, limit, dimension, Rule::NonNegative).map(Statistic::ProbabilityBeyond),
        };
        statistic.map(|statistic| match method {
            None => Asked::Statistic(statistic),
            Some(method) => Asked::Rare(statistic, method),
        })
    }

    /// How a probability is estimated; inside, nothing where it is only counted.
    fn method(&mut self, table: &Table<'_>, key: &str) -> Option<Option<RareMethod>> {
        let Some(entry) = table.get("method") else { return Some(None) };
        if key == "quantile" || key == "simultaneous_band" {
            let of = if key == "quantile" { "a quantile" } else { "a simultaneous band" };
            self.complain(&StudyProblem::MethodOfQuantile { entry: table.path.describe(), of }, &entry);
            return None;
        }
        let meanings = [None, Some(RareMethod::Importance), Some(RareMethod::Subset), Some(RareMethod::Automatic)];
        let method = self.reader.choice(&entry, &choices(METHODS, meanings))?;
        if method.is_some() && self.random.is_empty() {
            self.complain(&StudyProblem::NothingRandom { entry: table.path.describe() }, &entry);
            return None;
        }
        let has_masses = self.epistemic.iter().any(|input| matches!(input.variable, EpistemicVariable::Evidence(_)));
        let of = match self.readings[0] {
            Reading::RandomSet => Some("reading = \"random-set\""),
            _ => has_masses.then_some("masses of evidence"),
        };
        if let (Some(_), Some(of)) = (method, of) {
            self.complain(&StudyProblem::RareOfSets { entry: table.path.describe(), of }, &entry);
            return None;
        }
        Some(method)
    }

    /// A limit of a magnitude.
    fn limit(&mut self, entry: &Entry<'_>, limit: f64, dimension: Dimension, rule: Rule) -> Option<f64> {
        if rule.allows(limit) {
            return Some(limit);
        }
        let found = format_value(limit, dimension);
        self.complain(&StudyProblem::Limit { entry: entry.path.describe(), found, rule: rule.words() }, entry);
        None
    }
}
