//! Questions and requirements.

use super::description::{Ask, Asked, Limit, RareMethod, Requirement, Where};
use super::keys::{ASK_KEYS, LIMITS, REQUIRE_KEYS, STATISTIC_KEYS};
use super::problem::StudyProblem;
use super::reader::StudyReader;
use super::sizes::MOST_POSES;
use super::specimen_problem::SpecimenProblem;
use super::target::AccuracyTarget;
use super::words::{DEVIATIONS, METHODS, PLAIN_STATISTICS, REDUCTIONS, WITH_A_NUMBER};
use crate::outputs::{COMPONENTS, Seen, StudyOutput};
use crate::runs::named_angle_rad;
use loosepin_bounds::{Event, NumberKind, Reading, Statistic};
use loosepin_mechanics::model::{Recorded, WearMeasure};
use loosepin_result::study::{Deviation, Reduction};
use loosepin_text::diagnostics::{Complaint, Place, nearest_name};
use loosepin_text::document::{Entry, Reader, Table, Written};
use loosepin_text::units::{Dimension, Rule, format_number, format_refused, format_value, parse_quantity};
use loosepin_uncertainty::EpistemicVariable;

/// Keys that say where in the cycle; one is due.
const PLACES: [&str; 3] = ["at", "poses", "reduce"];

/// The number of a curve that lies beyond the limit of a probability where any of its values does.
pub fn furthest(statistic: Statistic) -> Reduction {
    match statistic.event() {
        Some(Event::Above(_)) => Reduction::Maximum,
        Some(Event::Below(_) | Event::UpTo(_)) => Reduction::Minimum,
        Some(Event::Beyond(_)) | None => Reduction::MaximumAbsolute,
    }
}

/// A question about a curve without the small probabilities in it, then these: of leaving the limit anywhere in the cycle, which is what
/// the furthest value over the cycle does.
fn anywhere_in_the_cycle(mut ask: Ask) -> Vec<Ask> {
    if ask.location != Where::Cycle {
        return vec![ask];
    }
    let anywhere: Vec<Ask> = ask
        .by_method()
        .map(|(statistic, method)| Ask {
            asked: vec![Asked::Rare(statistic, method)],
            ..Ask::of_values(ask.output, ask.deviation, Where::Reduced(furthest(statistic)))
        })
        .collect();
    ask.asked.retain(|asked| !matches!(asked, Asked::Rare(..)));
    let is_left = !ask.asked.is_empty();
    is_left.then_some(ask).into_iter().chain(anywhere).collect()
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
                let place = asks.len();
                asks.extend(anywhere_in_the_cycle(ask));
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
        let deviation = self.deviation(table, output);
        let location = self.location(table, "at", Some("reduce"), output.zip(deviation));
        let location = location.and_then(|location| self.place_of_wear(table, output, location));
        // Without the output the dimension of limits is not known.
        let output = output?;
        let entries = self.statistics(table, self.outputs[output].dimension)?;
        let (deviation, location) = (deviation?, location?);
        // Of two places one is wrong, and which is not known.
        if PLACES.into_iter().filter(|key| table.has(key)).count() == 1 {
            self.check_new(&entries, (output, deviation), &location);
        }
        self.warn_of_moments_of_a_life(output, &entries);
        let promised = self.promised_ends(table, &entries);
        let asked = entries.into_iter().map(|(_, asked)| asked).collect();
        let ask = Ask { asked, promised, ..Ask::of_values(output, deviation, location) };
        if ask.location != Where::Cycle && ask.bands().next().is_some() {
            let entry = table.get("statistics")?;
            return self.refused(&StudyProblem::BandOfPoint { entry: table.path.describe() }, entry.span);
        }
        Some(ask)
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
        let deviation = self.deviation(table, output);
        let location = self.location(table, "over", None, output.zip(deviation));
        let probability_at_least = self.reader.number(table, "probability_at_least");
        let output = output?;
        let limit = LIMITS.into_iter().find_map(|key| {
            let entry = table.get(key)?;
            let dimension = self.outputs[output].dimension;
            let limit = self.reader.measured(&entry, dimension, Rule::Finite)?;
            match key {
                "below" => Some(Limit::Below(limit)),
                "above" => Some(Limit::Above(limit)),
                _ => self.limit(&entry, limit, dimension, Rule::Positive).map(Limit::Within),
            }
        });
        let probability_at_least = probability_at_least?;
        let is_promised = self.is_decided_by_promise(table, probability_at_least);
        // Quantities that scatter are drawn, and no number of draws shows that none lies beyond.
        if probability_at_least == 1.0
            && !self.random.is_empty()
            && let Some(entry) = table.get("probability_at_least")
        {
            let problem = StudyProblem::CertaintyOfSamples { entry: entry.path.describe() };
            let place = Place::new(&self.reader.source, entry.span);
            self.reader.complaints.push(Complaint::warning(&problem, Some(place)));
        }
        let (deviation, limit, location) = (deviation?, limit?, location?);
        // A life is to be long, everything else of wear small.
        let is_life = self.is_life(output);
        let is_on_its_side = if is_life { matches!(limit, Limit::Above(_)) } else { matches!(limit, Limit::Below(_)) };
        if self.is_wear(Some(output)) && !(location == Where::Cycle && is_on_its_side) {
            let (entry, is_life) = (table.path.describe(), is_life);
            return self.refused(&StudyProblem::LimitOfWear { entry, is_life }, table.span);
        }
        if let (true, Limit::Above(least)) = (is_life, limit)
            && let Some(cycles) = self.cycles_of_wear().filter(|cycles| least > *cycles)
        {
            let span = table.get("above").map_or(table.span, |entry| entry.span);
            let [least, cycles] = [least, cycles].map(format_number);
            let problem = StudyProblem::LifeBeyondCycles { entry: table.path.describe(), least, cycles };
            return self.refused(&problem, span);
        }
        let columns = Vec::new();
        Some(Requirement { output, deviation, limit, location, probability_at_least, is_promised, columns })
    }

    /// The output that a table names, by its place in [`Self::outputs`].
    pub(super) fn output(&mut self, table: &Table<'_>) -> Option<usize> {
        let entry = table.get("output")?;
        let name = self.reader.text(&entry)?.to_owned();
        let outputs = &self.model.outputs;
        let Some(index) = outputs.iter().position(|output| output.name == name) else {
            let known = outputs.iter().map(|output| format!("'{}'", output.name)).collect();
            let nearest = nearest_name(&name, outputs.iter().map(|output| output.name.as_str())).map(str::to_owned);
            let problem = StudyProblem::UnknownOutput { entry: table.path.describe(), name, nearest, known };
            return self.refused(&problem, entry.span);
        };
        let component = table.get("component");
        if !matches!(outputs[index].kind.recorded(), Recorded::Path(_)) {
            if let Some(component) = component {
                let problem = StudyProblem::ComponentOfNoPath { entry: table.path.describe(), name };
                return self.refused(&problem, component.key_span);
            }
            return self.outputs.iter().position(|output| output.output == index);
        }
        let Some(component) = component else {
            return self.refused(&StudyProblem::PathOutput { entry: table.path.describe(), name }, entry.span);
        };
        let component = self.reader.choice(&component, &COMPONENTS.map(|name| (name, name)))?;
        self.outputs.iter().position(|output| output.output == index && output.component == Some(component))
    }

    /// Which deviation of an output, where that is known.
    pub(super) fn deviation(&mut self, table: &Table<'_>, output: Option<usize>) -> Option<Deviation> {
        let entry = table.get("of")?;
        let deviation = self.reader.choice(&entry, &DEVIATIONS)?;
        if deviation == Deviation::Value
            && let Some(StudyOutput { seen: Seen::Path(..), component: Some(component), .. }) =
                output.map(|output| &self.outputs[output])
        {
            let problem = StudyProblem::ValueOfPathError { entry: entry.path.describe(), component };
            return self.refused(&problem, entry.span);
        }
        if deviation != Deviation::Value && self.is_wear(output) {
            let problem = StudyProblem::WearOfDeviation { entry: entry.path.describe() };
            return self.refused(&problem, entry.span);
        }
        let has_play = self.model.plays().next().is_some();
        if deviation == Deviation::Clearance && !has_play {
            return self.refused(&StudyProblem::NoPlay { entry: entry.path.describe() }, entry.span);
        }
        Some(deviation)
    }

    /// Whether an output is the life of a joint.
    fn is_life(&self, output: usize) -> bool {
        matches!(self.outputs[output].seen, Seen::Wear(_, WearMeasure::Life))
    }

    /// The cycles after which wear is stated; nothing where they are an input, of which each run has its own.
    fn cycles_of_wear(&self) -> Option<f64> {
        let cycles = self.model.wear?.cycles;
        let is_input = self.random.iter().any(|input| input.quantity == cycles)
            || self.epistemic.iter().any(|input| input.quantity() == Some(cycles));
        (!is_input).then(|| self.model.quantities.nominal()[cycles])
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
                self.reader.complaints.push(Complaint::warning(&problem, Some(place)));
            }
        }
    }

    /// Whether an output is the wear of a joint.
    fn is_wear(&self, output: Option<usize>) -> bool {
        output.is_some_and(|output| matches!(self.outputs[output].seen, Seen::Wear(..)))
    }

    /// The place of a question, where the output has a number there: wear grows through the recorded part, and its maximum is the wear at
    /// the end.
    fn place_of_wear(&mut self, table: &Table<'_>, output: Option<usize>, location: Where) -> Option<Where> {
        if !self.is_wear(output) || location == Where::Reduced(Reduction::Maximum) {
            return Some(location);
        }
        let entry = PLACES.into_iter().find_map(|key| table.get(key))?;
        self.refused(&StudyProblem::PlaceOfWear { entry: entry.path.describe() }, entry.key_span)
    }

    /// Where in the cycle; `everywhere` is the key that stands for the whole curve, `reduction` the one for a number of it, which is
    /// `of` an output and a deviation.
    fn location(
        &mut self,
        table: &Table<'_>,
        everywhere: &str,
        reduction: Option<&str>,
        of: Option<(usize, Deviation)>,
    ) -> Option<Where> {
        if let Some(entry) = table.get(everywhere) {
            if let Some(found) = angle_of(&entry, &mut self.reader) {
                let drive = self.model.cycle_input(&self.model.quantities.nominal()).name;
                let problem = StudyProblem::AngleForCurve { entry: entry.path.describe(), found, drive };
                return self.refused(&problem, entry.span);
            }
            return self.reader.choice(&entry, &[("cycle", ())]).map(|()| Where::Cycle);
        }
        if let Some(entry) = table.get("poses") {
            return self.poses(&entry, of);
        }
        let entry = table.get(reduction?)?;
        self.reader.choice(&entry, &REDUCTIONS).map(Where::Reduced)
    }

    fn poses(&mut self, entry: &Entry<'_>, of: Option<(usize, Deviation)>) -> Option<Where> {
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
                return self.refused(&problem, entry.key_span);
            }
            let angles = self.reader.list(&entry)?;
            if let Some(surplus) = angles.get(MOST_POSES) {
                let problem = StudyProblem::TooManyPoses { entry: entry.path.describe(), found: angles.len() };
                return self.refused(&problem, surplus.span);
            }
            for angle in angles {
                let Some(angle_rad) = self.reader.measured(&angle, Dimension::ANGLE, Rule::Finite) else { continue };
                if angles_rad.contains(&angle_rad) {
                    let pose = format_value(angle_rad, Dimension::ANGLE);
                    self.complain(&StudyProblem::PoseTwice { entry: angle.path.describe(), pose }, &angle);
                    continue;
                }
                self.check_apart(&angle, of, angle_rad);
                angles_rad.push(angle_rad);
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

    /// Two angles of which the results could not tell which is which, since both have the same name there.
    fn check_apart(&mut self, entry: &Entry<'_>, of: Option<(usize, Deviation)>, angle_rad: f64) {
        let Some(of) = of else { return };
        let known = self.poses.entry((of, (named_angle_rad(angle_rad) + 0.0).to_bits())).or_default();
        let beside_rad = known.iter().copied().find(|known_rad| *known_rad != angle_rad);
        known.push(angle_rad);
        if let Some(beside_rad) = beside_rad {
            let problem = StudyProblem::PosesTooNear {
                entry: entry.path.describe(),
                pose: format_value(angle_rad, Dimension::ANGLE),
                apart: format!("{:.1e} rad", (angle_rad - beside_rad).abs()),
            };
            self.complain(&problem, entry);
        }
    }

    fn statistics<'t>(&mut self, table: &Table<'t>, dimension: Dimension) -> Option<Vec<(Entry<'t>, Asked)>> {
        let entry = table.get("statistics")?;
        let entries = self.reader.list(&entry)?;
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

    /// How a probability is estimated; inside, nothing where it is only counted.
    fn method(&mut self, table: &Table<'_>, kind: Statistic) -> Option<Option<RareMethod>> {
        let Some(entry) = table.get("method") else { return Some(None) };
        if !kind.is_probability() {
            let of = kind.description().with_article;
            return self.refused(&StudyProblem::MethodOfQuantile { entry: table.path.describe(), of }, entry.span);
        }
        let method = self.reader.choice(&entry, &METHODS)?;
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

    /// A limit of a magnitude.
    fn limit(&mut self, entry: &Entry<'_>, limit: f64, dimension: Dimension, rule: Rule) -> Option<f64> {
        if rule.allows(limit) {
            return Some(limit);
        }
        let found = format_refused(limit, dimension);
        self.refused(&StudyProblem::Limit { entry: entry.path.describe(), found, rule: rule.words() }, entry.span)
    }
}

/// The angle that stands where a whole curve is named, as it is written.
fn angle_of(entry: &Entry<'_>, reader: &mut Reader) -> Option<String> {
    if entry.is_table() {
        return None;
    }
    if !entry.is_text() {
        return reader.number_at(entry).map(format_number);
    }
    let Some(Written::Text(text)) = reader.written(entry) else { return None };
    parse_quantity(text).is_ok_and(|read| read.dimension == Dimension::ANGLE).then(|| format!("\"{text}\""))
}

/// How a statistic is written whose word, or another one for it, stands alone.
fn other_form(text: &str) -> Option<String> {
    let with_example = WITH_A_NUMBER.into_iter().find(|statistic| statistic.word() == text).and_then(|statistic| {
        let number = statistic.description().number?;
        Some(format!("{{ {text} = {} }}", number.example))
    });
    let every = Statistic::PLAIN.into_iter().chain(WITH_A_NUMBER);
    let mut others = every.flat_map(|statistic| statistic.description().other_words);
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
