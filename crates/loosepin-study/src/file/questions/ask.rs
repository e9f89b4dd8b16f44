//! Questions: one statistic or more of an output at a place of the cycle.

use crate::file::description::RareMethod;
use crate::file::measurements::specimen_problem::SpecimenProblem;
use crate::file::problem::StudyProblem;
use crate::file::questions::location::POSES;
use crate::file::questions::output::{COMPONENT, DEVIATION, OUTPUT};
use crate::file::questions::target::AccuracyTarget;
use crate::file::reader::StudyReader;
use crate::file::sampling::ACCURACY;
use crate::file::words::{PLAIN_STATISTICS, REDUCTIONS, STATISTICS, WITH_A_NUMBER, words};
use crate::places::Where;
use loosepin_bounds::{NumberKind, Reading, Statistic};
use loosepin_result::study::{Deviation, Reduction, Side};
use loosepin_text::diagnostics::{Diagnostic, Place};
use loosepin_text::document::{Entry, Key, Keys, Kind, Reads, Table, Value, choice, optional};
use loosepin_text::units::{Dimension, Rule, format_number};
use loosepin_text::{choices, record};
use loosepin_uncertainty::EpistemicVariable;

record! {
    /// a question: statistics of an output
    pub(crate) lenient struct AskTable for Reads, exactly one of [at, poses, reduce];
    required output: Entry<'t> as OUTPUT;
    optional component: Entry<'t> as COMPONENT;
    required of: Entry<'t> as DEVIATION;
    /// the whole curve over the cycle
    optional at: Entry<'t> = Kind::Choice(&["cycle"]), "\"cycle\"";
    optional poses: Entry<'t> as POSES;
    /// one number calculated from the whole curve
    optional reduce: Entry<'t> = Kind::Choice(&words(&REDUCTIONS)), "\"maximum_absolute\"";
    /// statistics by name, or as tables with a number
    required statistics: Entry<'t> =
        Kind::List(&Kind::AnyOf(&[Kind::Choice(&words(&PLAIN_STATISTICS)), Kind::Table(&STATISTIC_KEYS)])),
        "[\"mean\", { quantile = 0.975 }]";
    /// largest numerical error of these bounds: the samples increase until it is reached; a value or a list
    optional accuracy: Entry<'t> = ACCURACY, "\"1 um\"";
    /// bounds of these quantiles and probabilities that are also promised for a share of the box; none if omitted
    optional promise: Entry<'t> = choice::<PromisedEnds>(), "\"upper\"";
}

choices!(
    /// Ends of a statistic that are promised.
    pub(crate) struct PromisedEnds(&'static [Side]):
    "upper" => &[Side::Upper],
    "lower" => &[Side::Lower],
    "both" => &Side::BOTH,
);

choices!(
    /// How a probability is estimated; nothing where it is only counted.
    struct Method(Option<RareMethod>):
    "count" => None,
    "importance" => Some(RareMethod::Importance),
    "subset" => Some(RareMethod::Subset),
    "automatic" => Some(RareMethod::Automatic),
);

const METHOD: Key = optional(
    "method",
    choice::<Method>(),
    "\"importance\"",
    "of a probability: count (if omitted), importance or subset for small ones, automatic where too few are counted",
);
/// One for each statistic with a number, then what goes with some of them.
const OF_STATISTICS: [Key; WITH_A_NUMBER.len() + 1] = {
    let mut keys = [METHOD; WITH_A_NUMBER.len() + 1];
    let mut place = 0;
    while place < WITH_A_NUMBER.len() {
        let description = WITH_A_NUMBER[place].description();
        if let Some(number) = description.number {
            let kind = match number.kind {
                NumberKind::Share => Kind::Number { rule: Rule::Probability },
                NumberKind::Limit | NumberKind::LimitOfMagnitude => Kind::AnyQuantity,
            };
            keys[place] = optional(description.word, kind, number.example, number.meaning);
        }
        place += 1;
    }
    keys
};
const STATISTIC_KEYS: Keys = Keys::new("a statistic with a number", &OF_STATISTICS).with_exactly_one(&[&STATISTICS]);

/// A question.
#[derive(Debug, Clone, PartialEq)]
pub struct Ask {
    /// Index in [`Study::outputs`](crate::file::Study::outputs).
    pub output: usize,
    /// Which deviation of it.
    pub deviation: Deviation,
    /// Place in the cycle.
    pub location: Where,
    /// Its requested statistics, in file order; limits in the SI unit of the output.
    pub asked: Vec<Asked>,
    /// Ends of the statistics that are promised for a share of the box.
    pub promised: Vec<Side>,
    /// Columns of a run that hold its numbers, in the order of the poses; empty until the columns of the study are laid out.
    pub columns: Vec<usize>,
}

/// One thing that is asked.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Asked {
    /// A statistic, counted by the double loop.
    Statistic(Statistic),
    /// A probability that is not only counted.
    Rare(Statistic, RareMethod),
    /// What contributes to the answer.
    Contributors,
    /// A band in which this share of mechanisms stays for the whole cycle.
    SimultaneousBand(f64),
}

impl Asked {
    /// The statistic, however it is estimated; `None` if it is of no single column.
    pub fn statistic(self) -> Option<Statistic> {
        match self {
            Self::Statistic(statistic) | Self::Rare(statistic, _) => Some(statistic),
            Self::Contributors | Self::SimultaneousBand(_) => None,
        }
    }
}

impl Ask {
    /// A question for the values of runs alone, without a statistic of them.
    pub fn of_values(output: usize, deviation: Deviation, location: Where) -> Self {
        Self { output, deviation, location, asked: Vec::new(), promised: Vec::new(), columns: Vec::new() }
    }

    /// Every statistic of each of its columns, in file order.
    pub fn statistics(&self) -> impl Iterator<Item = Statistic> {
        self.asked.iter().filter_map(|asked| asked.statistic())
    }

    /// Probabilities that are not only counted, with how they are estimated.
    pub fn by_method(&self) -> impl Iterator<Item = (Statistic, RareMethod)> {
        self.asked.iter().filter_map(|asked| match *asked {
            Asked::Rare(statistic, method) => Some((statistic, method)),
            _ => None,
        })
    }

    /// Whether `statistic` is a probability that is not only counted.
    pub fn is_by_method(&self, statistic: Statistic) -> bool {
        self.by_method().any(|(own, _)| own == statistic)
    }

    /// Shares of mechanisms for which a band is wanted that they stay in for the whole cycle.
    pub fn bands(&self) -> impl Iterator<Item = f64> {
        self.asked.iter().filter_map(|asked| match *asked {
            Asked::SimultaneousBand(share) => Some(share),
            _ => None,
        })
    }

    /// Whether it is asked what contributes to the answer.
    pub fn is_for_contributors(&self) -> bool {
        self.asked.contains(&Asked::Contributors)
    }
}

/// The number of a curve that lies beyond the limit of a probability where any of its values does.
pub fn furthest(statistic: Statistic) -> Reduction {
    statistic.event().map_or(Reduction::largest_magnitude(), Reduction::furthest_into)
}

/// A question about a curve without the small probabilities in it, then these: of leaving the limit anywhere in the cycle, which is what
/// the furthest value over the cycle does.
fn anywhere_in_the_cycle(mut ask: Ask) -> Vec<Ask> {
    if !ask.location.is_cycle() {
        return vec![ask];
    }
    let anywhere: Vec<Ask> = ask
        .by_method()
        .map(|(statistic, method)| Ask {
            asked: vec![Asked::Rare(statistic, method)],
            ..Ask::of_values(ask.output, ask.deviation, Where::reduced(furthest(statistic)))
        })
        .collect();
    ask.asked.retain(|asked| !matches!(asked, Asked::Rare(..)));
    let is_left = !ask.asked.is_empty();
    is_left.then_some(ask).into_iter().chain(anywhere).collect()
}

impl StudyReader {
    /// Reads the questions, and how near their bounds are to be.
    pub fn read_asks(&mut self, written: Option<&Entry<'_>>) -> (Vec<Ask>, Vec<AccuracyTarget>) {
        let entries = self.double_brackets(written);
        let (mut asks, mut accuracy) = (Vec::new(), Vec::new());
        for entry in &entries {
            let Some(table) = AskTable::read(self, entry) else { continue };
            let written = self.accuracies(table.accuracy.as_ref());
            if let Some(ask) = self.ask(&table) {
                let place = asks.len();
                asks.extend(anywhere_in_the_cycle(ask));
                accuracy.extend(self.targets(written, &asks, Some(place)));
            }
        }
        (asks, accuracy)
    }

    /// The tables of a list, each under its name in double brackets.
    pub(crate) fn double_brackets<'t>(&mut self, written: Option<&Entry<'t>>) -> Vec<Entry<'t>> {
        let Some(entry) = written else { return Vec::new() };
        if entry.is_table() {
            self.reader.wrong_type::<()>(entry, "a list of tables, each under a header in double brackets");
            return Vec::new();
        }
        self.reader.list(entry).unwrap_or_default()
    }

    fn ask(&mut self, table: &AskTable<'_>) -> Option<Ask> {
        let output = self.output(&table.table, &table.output, &table.component);
        let deviation = self.deviation(table.of.as_ref(), output);
        let places = [&table.at, &table.poses, &table.reduce];
        let location = self.location(places, output.zip(deviation));
        let location = location.and_then(|location| self.place_of_wear(places, output, location));
        // Without the output the dimension of limits is not known.
        let output = output?;
        let statistics = table.statistics.as_ref()?;
        let entries = self.statistics(statistics, self.outputs[output].dimension)?;
        self.check_sides(&entries, deviation, location.as_ref());
        let (deviation, location) = (deviation?, location?);
        // Of two places one is wrong, and which is not known.
        if places.into_iter().flatten().count() == 1 {
            self.check_new(&entries, (output, deviation), &location);
        }
        self.warn_of_moments_of_a_life(output, &entries);
        let promised = self.promised_ends(table.promise.as_ref(), &entries);
        let asked = entries.into_iter().map(|(_, asked)| asked).collect();
        let ask = Ask { asked, promised, ..Ask::of_values(output, deviation, location) };
        if !ask.location.is_cycle() && ask.bands().next().is_some() {
            let problem = StudyProblem::BandOfPoint { entry: table.table.path.describe() };
            return self.refused(&problem, statistics.span);
        }
        Some(ask)
    }

    /// Warns of a statistic of a life that asks how long each is, not only which are shorter: runs that do not end count as all cycles.
    fn warn_of_moments_of_a_life(&mut self, output: usize, entries: &[(Entry<'_>, Asked)]) {
        if !self.is_life(output) {
            return;
        }
        for (entry, asked) in entries {
            if matches!(asked, Asked::Statistic(statistic) if !statistic.is_by_shares()) {
                let problem = StudyProblem::MomentOfLife { entry: entry.path.describe() };
                let place = Place::new(&self.reader.source, entry.span);
                self.reader.diagnostics.push(Diagnostic::warning(&problem, Some(place)));
            }
        }
    }

    /// The place of a question, where the output has a number there: wear grows through the recorded part, and its maximum is the wear at
    /// the end.
    pub(crate) fn place_of_wear(
        &mut self,
        places: [&Option<Entry<'_>>; 3],
        output: Option<usize>,
        location: Where,
    ) -> Option<Where> {
        if !self.is_wear(output) || location.reduction() == Some(Reduction::Maximum) {
            return Some(location);
        }
        let entry = places.into_iter().flatten().next()?;
        self.refused(&StudyProblem::PlaceOfWear { entry: entry.path.describe() }, entry.key_span)
    }

    fn statistics<'t>(&mut self, entry: &Entry<'t>, dimension: Dimension) -> Option<Vec<(Entry<'t>, Asked)>> {
        let entries = self.reader.list(entry)?;
        if entries.is_empty() {
            return self.refused(&StudyProblem::Empty { entry: entry.path.describe() }, entry.span);
        }
        let asked: Vec<Option<Asked>> = entries.iter().map(|entry| self.statistic(entry, dimension)).collect();
        entries.into_iter().zip(asked).map(|(entry, asked)| Some((entry, asked?))).collect()
    }

    fn statistic(&mut self, entry: &Entry<'_>, dimension: Dimension) -> Option<Asked> {
        if entry.is_text() {
            let text = self.reader.text(entry)?;
            if let Some(form) = other_form(text).or_else(|| as_quantile(text)) {
                let problem = StudyProblem::StatisticForm { entry: entry.path.describe(), word: text.to_owned(), form };
                return self.refused(&problem, entry.span);
            }
            let statistic = self.reader.choice(entry, &PLAIN_STATISTICS)?;
            return Some(statistic.map_or(Asked::Contributors, Asked::Statistic));
        }
        if !entry.is_table() {
            return self.reader.wrong_type(entry, "the name of a statistic or a table such as { quantile = 0.975 }");
        }
        let table = self.reader.table(entry, &STATISTIC_KEYS)?;
        let kind = WITH_A_NUMBER.into_iter().find(|statistic| table.has(statistic.word()))?;
        let method = self.method(&table, kind)?;
        let number = self.number_of(&table, kind, dimension)?;
        let statistic = Statistic::from_word(kind.word(), Some(number))?;
        Some(match method {
            _ if statistic.is_of_curve() => Asked::SimultaneousBand(number),
            None => Asked::Statistic(statistic),
            Some(method) => Asked::Rare(statistic, method),
        })
    }

    /// The number of a statistic of this kind.
    fn number_of(&mut self, table: &Table<'_>, kind: Statistic, dimension: Dimension) -> Option<f64> {
        let entry = table.get(kind.word())?;
        match kind.description().number?.kind {
            NumberKind::Share if entry.is_text() => {
                let found = self.reader.text(&entry)?.to_owned();
                self.refused(&StudyProblem::Percent { entry: entry.path.describe(), found }, entry.span)
            }
            NumberKind::Share => self.reader.number(table, kind.word()),
            NumberKind::Limit => self.reader.measured(&entry, dimension, Rule::Finite),
            NumberKind::LimitOfMagnitude => {
                let limit = self.reader.measured(&entry, dimension, Rule::Finite)?;
                self.limit(&entry, limit, dimension, Rule::NonNegative)
            }
        }
    }

    /// How a probability is estimated; inside, `None` if it is only counted.
    fn method(&mut self, table: &Table<'_>, kind: Statistic) -> Option<Option<RareMethod>> {
        let Some(entry) = table.get(METHOD.name) else { return Some(None) };
        if !kind.is_probability() {
            let of = kind.description().with_article;
            return self.refused(&StudyProblem::MethodOfQuantile { entry: table.path.describe(), of }, entry.span);
        }
        let Method(method) = Method::read(self, &entry)?;
        if method.is_some() && self.random.is_empty() {
            return self.refused(&StudyProblem::NothingRandom { entry: table.path.describe() }, entry.span);
        }
        if method.is_some() && self.has_rows {
            return self.refused(&SpecimenProblem::Rare { entry: table.path.describe() }, entry.span);
        }
        let has_masses = self.epistemic.iter().any(|input| matches!(input.variable, EpistemicVariable::Evidence(_)));
        let of = match self.readings[0] {
            Reading::RandomSet => Some("reading = \"random-set\""),
            _ => has_masses.then_some("masses of evidence"),
        };
        if let (Some(_), Some(of)) = (method, of) {
            return self.refused(&StudyProblem::RareOfSets { entry: table.path.describe(), of }, entry.span);
        }
        Some(method)
    }
}

/// How a statistic is written whose word, or another one for it, stands alone.
fn other_form(text: &str) -> Option<String> {
    let with_example = WITH_A_NUMBER.into_iter().find(|statistic| statistic.word() == text).and_then(|statistic| {
        let number = statistic.description().number?;
        Some(format!("{{ {text} = {} }}", number.example))
    });
    let every = Statistic::PLAIN.into_iter().chain(WITH_A_NUMBER);
    let mut others = every.flat_map(|statistic| statistic.description().synonyms);
    with_example.or_else(|| others.find(|(word, _)| *word == text).map(|(_, form)| (*form).to_owned()))
}

/// A percentile as it is written elsewhere (`p95`, `95 %`, `95th percentile`) as a quantile.
fn as_quantile(text: &str) -> Option<String> {
    let digits = text.trim_start_matches(['p', 'P', 'q', 'Q']);
    let digits =
        digits.trim_end_matches("percentile").trim_end().trim_end_matches("th").trim_end_matches('%').trim_end();
    let percent: f64 = digits.parse().ok().filter(|_| digits.len() < text.len())?;
    (percent > 0.0 && percent < 100.0).then(|| format!("{{ quantile = {} }}", format_number(percent / 100.0)))
}
