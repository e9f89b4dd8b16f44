//! From the text of an `expected.toml` to what must be met, with all its diagnostics at once.

use std::path::Path;
use std::sync::Arc;

use super::case::{
    Case, Check, CheckInstant, CheckSubject, ComputedColumn, ExpectedNumber, History, Numbers, Quantity, QuantityKind,
    Reduce,
};
use super::dimension::{dimension_of, si_unit, state_dimension, stiffness_dimension};
use super::problem::CaseProblem;
use super::reference::{Reference, open_reference};
use super::script_file::read_script;
use super::tables::{ColumnTable, ExpectedTable, HistoryTable, NumberTable, Origin, QUANTITIES};
use loosepin_mechanics::model::{BodyId, Motion, Position, Relative};
use loosepin_simulate::accuracy::position_outputs;
use loosepin_simulate::{Column, columns, input};
use loosepin_text::diagnostics::{Diagnostic, Diagnostics, Source};
use loosepin_text::document::{Entry, Reader, Reads, Value, Written, parse_toml};
use loosepin_text::units::{Dimension, ReadableUnit, Rule, SiUnit};

/// Parts of a state of a body, in the order of `history.csv`: positions, velocities, accelerations.
const STATE_PARTS: [&str; 9] = ["x", "y", "angle", "vx", "vy", "omega", "ax", "ay", "alpha"];

/// Reads the tables of an `expected.toml`.
///
/// # Errors
/// Everything that is wrong with it or with a file that it names, each with its place.
pub(super) fn read_expected(source: &Arc<Source>, folder: &Path, case: &Case) -> Result<Vec<Check>, Diagnostics> {
    let toml = parse_toml(source)?;
    let mut reader = Reader::new(source);
    let root = reader.root(toml.get_ref(), &ExpectedTable::KEYS);
    let root = ExpectedTable::of(&mut reader, root).expect("every key may be left out");
    let mut file = ExpectedReader { reader, case, span_s: cycle_s(case)? };
    let mut checks = Vec::new();
    if let Some(entry) = &root.expected {
        for entry in file.reader.named(entry, "a number") {
            checks.extend(file.numbers(&entry));
        }
    }
    if let Some(entry) = &root.history {
        for entry in file.reader.named(entry, "a history") {
            checks.extend(file.history(&entry, folder));
        }
    }
    checks.extend(read_script(&mut file.reader, &root, folder, case));
    if checks.is_empty() && !file.reader.diagnostics.has_errors() {
        // Nothing expected would be met by anything.
        file.reader.report(&CaseProblem::NothingExpected { entry: "the file".to_owned() }, (0..0).into());
    }
    if file.reader.diagnostics.has_errors() { Err(file.reader.diagnostics) } else { Ok(checks) }
}

/// Length of the cycle of the model, transient included, s.
fn cycle_s(case: &Case) -> Result<f64, Diagnostics> {
    let cycle = &case.model.cycle;
    let input = input(&case.mechanism, &case.values, cycle.span).map_err(|failure| failure.diagnostic(&case.model))?;
    Ok((cycle.transient_turns + cycle.recorded_turns) * input.turn_s())
}

struct ExpectedReader<'c> {
    reader: Reader,
    case: &'c Case,
    /// Length of a run where nothing else is said, s.
    span_s: f64,
}

impl Reads for ExpectedReader<'_> {
    fn document(&mut self) -> &mut Reader {
        &mut self.reader
    }
}

impl ExpectedReader<'_> {
    fn numbers(&mut self, entry: &Entry<'_>) -> Option<Check> {
        let table = NumberTable::read(self, entry)?;
        let quantity = self.quantity(&table);
        let settings = self.settings(table.set.as_ref());
        let (quantity, due) = quantity?;
        let value = table.value.as_ref()?;
        let values = self.one_or_each(value, due)?;
        if values.is_empty() {
            self.nothing(value);
        }
        let tolerance_si = self.reader.measured(table.tolerance.as_ref()?, due, Rule::NonNegative)?;
        let unit = self.unit(value, due);
        let mut numbers: Vec<ExpectedNumber> = values
            .into_iter()
            .map(|value_si| ExpectedNumber { value_si, settings: Vec::new(), at: None, words: None })
            .collect();
        for (entry, at, dimension) in [
            (&table.angle, CheckInstant::Angle as fn(f64) -> CheckInstant, Dimension::ANGLE),
            (&table.time, CheckInstant::Time, Dimension::TIME),
            (&table.penetration, CheckInstant::Penetration, Dimension::LENGTH),
        ] {
            let Some(entry) = entry else { continue };
            let instants = self.one_or_each(entry, dimension)?;
            self.same_length(entry, instants.len(), numbers.len())?;
            let texts = self.texts(entry);
            for ((number, instant), text) in numbers.iter_mut().zip(instants).zip(texts) {
                number.at = Some(at(instant));
                number.words = Some(format!("at {text}"));
            }
        }
        if let (Some(settings), Some(entry)) = (settings?, &table.set) {
            self.same_length(entry, settings.len(), numbers.len())?;
            for (number, setting) in numbers.iter_mut().zip(settings) {
                let (path, value) = setting.split_once('=').unwrap_or((&setting, ""));
                let quantity = path.rsplit('.').next().unwrap_or(path);
                number.words = Some(format!("with {} {value}", quantity.replace('_', " ")));
                number.settings.push(setting);
            }
        }
        Some(Check {
            name: entry.name.replace('_', " "),
            origin: table.origin?.0,
            source: table.source.filter(|_| table.reason.is_some())?,
            place: self.reader.place(entry.key_span),
            what: CheckSubject::Numbers(Numbers { quantity, numbers, tolerance_si, unit }),
        })
    }

    /// The settings, checked against the model; `None` if the key is not written.
    fn settings(&mut self, written: Option<&Entry<'_>>) -> Option<Option<Vec<String>>> {
        let Some(entry) = written else { return Some(None) };
        let mut settings = Vec::new();
        for entry in self.reader.list(entry)? {
            let text = self.reader.text(&entry)?.to_owned();
            if let Err(diagnostics) = self.case.model.set_values(std::slice::from_ref(&text)) {
                let place = self.reader.place(entry.span);
                for diagnostic in diagnostics.sorted() {
                    self.reader.diagnostics.push(Diagnostic { place: Some(place.clone()), ..diagnostic.clone() });
                }
                return None;
            }
            settings.push(text);
        }
        Some(Some(settings))
    }

    /// That a list names nothing to compare.
    fn nothing(&mut self, entry: &Entry<'_>) {
        self.reader.report(&CaseProblem::NothingExpected { entry: entry.path.describe() }, entry.span);
    }

    fn same_length(&mut self, entry: &Entry<'_>, found: usize, due: usize) -> Option<()> {
        if found == due {
            return Some(());
        }
        let problem = CaseProblem::ListLength { entry: entry.path.describe(), found, due };
        self.reader.report(&problem, entry.span);
        None
    }

    /// A value, or the values of a list.
    fn one_or_each(&mut self, entry: &Entry<'_>, due: Dimension) -> Option<Vec<f64>> {
        if !entry.is_list() {
            return self.reader.measured(entry, due, Rule::Finite).map(|value_si| vec![value_si]);
        }
        let entries = self.reader.list(entry)?;
        entries.iter().map(|entry| self.reader.measured(entry, due, Rule::Finite)).collect()
    }

    /// A value, or the values of a list, as written.
    fn texts(&mut self, entry: &Entry<'_>) -> Vec<String> {
        let list = if entry.is_list() { self.reader.list(entry) } else { None };
        match list {
            Some(entries) => entries.iter().filter_map(|entry| self.reader.text(entry)).map(str::to_owned).collect(),
            None => self.reader.text(entry).map(str::to_owned).into_iter().collect(),
        }
    }

    /// The unit in which a value, or the first of a list, is written.
    fn unit(&mut self, entry: &Entry<'_>, due: Dimension) -> ReadableUnit {
        let first =
            if entry.is_list() { self.reader.list(entry).and_then(|list| list.into_iter().next()) } else { None };
        let written = match self.reader.written(first.as_ref().unwrap_or(entry)) {
            Some(Written::Text(text)) => text.split_once(' ').map(|(_, unit)| unit),
            _ => None,
        };
        written.and_then(|unit| ReadableUnit::of_dimension(unit, due)).unwrap_or_else(|| si_unit(due))
    }

    /// How the numbers are obtained, and what they measure.
    fn quantity(&mut self, written: &NumberTable<'_>) -> Option<(Quantity, Dimension)> {
        let table = &written.table;
        let (word, kind, keys) = self
            .reader
            .choice(written.quantity.as_ref()?, &QUANTITIES.map(|(word, kind, keys)| (word, (word, kind, keys))))?;
        for key in ["joint", "output", "state", "reduce", "angle", "time", "penetration", "span"] {
            if let Some(entry) = table.get(key).filter(|_| !keys.contains(&key)) {
                let problem = CaseProblem::KeyWithoutEffect { entry: entry.path.describe(), quantity: word };
                self.reader.report(&problem, entry.key_span);
            }
        }
        let play = if keys.contains(&"joint") { Some(self.play(written)?) } else { None };
        let column = if keys.contains(&"output") { Some(self.column(written, kind)?) } else { None };
        let reduce = match &written.reduce {
            Some(entry) => Some(Reduce::read(self, entry)?),
            None => None,
        };
        let needs_instant = keys.contains(&"output") && reduce.is_none();
        if needs_instant && !keys.iter().any(|key| ["angle", "time"].contains(key) && table.has(key)) {
            let instant = if keys.contains(&"angle") { "angle" } else { "time" };
            self.reader.demand(table, instant);
            return None;
        }
        if keys.contains(&"penetration") && !self.reader.demand(table, "penetration") {
            return None;
        }
        let span_s = match &written.span {
            Some(entry) => self.reader.measured(entry, Dimension::TIME, Rule::Positive)?,
            None => self.span_s,
        };
        let due = self.dimension(kind, play, column.as_ref(), reduce);
        Some((Quantity { kind, play, column, reduce, span_s }, due))
    }

    fn play(&mut self, written: &NumberTable<'_>) -> Option<usize> {
        if !self.reader.demand(&written.table, "joint") {
            return None;
        }
        let entry = written.joint.as_ref()?;
        let name = self.reader.text(entry)?;
        let mechanism = &self.case.mechanism;
        let known: Vec<String> =
            mechanism.plays.iter().map(|&play| mechanism.model.play_name(play).to_owned()).collect();
        let found = known.iter().position(|known| known == name);
        if found.is_none() {
            self.unknown(entry, "joint with play", name, known);
        }
        found
    }

    fn unknown(&mut self, entry: &Entry<'_>, what: &'static str, name: &str, known: Vec<String>) {
        let problem = CaseProblem::UnknownName { entry: entry.path.describe(), what, name: name.to_owned(), known };
        self.reader.report(&problem, entry.span);
    }

    /// The output, or the state of a body read as one.
    fn column(&mut self, written: &NumberTable<'_>, kind: QuantityKind) -> Option<Column> {
        if let Some(entry) = &written.state {
            let (body, part) = self.state(entry)?;
            let angle = Position::Angle(Relative::to_ground(BodyId(body + 1)));
            let (reading, unit) = match part {
                2 => (Motion::position(angle), SiUnit::ANGLE),
                5 => (Motion::velocity(angle), SiUnit::ANGULAR_VELOCITY),
                8 => (Motion::acceleration(angle), SiUnit::ANGULAR_ACCELERATION),
                _ => {
                    let known = ["angle", "omega", "alpha"].map(str::to_owned).to_vec();
                    self.unknown(entry, "state for single values called", STATE_PARTS[part], known);
                    return None;
                }
            };
            let name = self.reader.text(entry)?.to_owned();
            return Some(Column { output: 0, words: name.clone(), name, unit, reading: reading.into() });
        }
        if !self.reader.demand(&written.table, "output") {
            return None;
        }
        let entry = written.output.as_ref()?;
        let index = self.output(entry)?;
        let column = columns(&self.case.mechanism.model).swap_remove(index);
        let is_quasi_static = matches!(
            kind,
            QuantityKind::WorstCase | QuantityKind::FirstOrderPlay | QuantityKind::DimensionalStandardDeviation
        );
        let known: Vec<String> = position_outputs(&self.case.mechanism).into_iter().map(|output| output.name).collect();
        if is_quasi_static && !known.contains(&column.name) {
            self.unknown(entry, "output of positions", &column.name, known);
            return None;
        }
        Some(column)
    }

    fn output(&mut self, entry: &Entry<'_>) -> Option<usize> {
        let name = self.reader.text(entry)?;
        let known: Vec<String> = columns(&self.case.mechanism.model).into_iter().map(|column| column.name).collect();
        let found = known.iter().position(|known| known == name);
        if found.is_none() {
            self.unknown(entry, "output", name, known);
        }
        found
    }

    /// Index of a body without the ground, and of a part of its state.
    fn state(&mut self, entry: &Entry<'_>) -> Option<(usize, usize)> {
        let text = self.reader.text(entry)?;
        let (body, part) = text.split_once('.').unwrap_or((text, ""));
        let bodies: Vec<String> = self.case.model.bodies[1..].iter().map(|body| body.name.clone()).collect();
        let Some(body) = bodies.iter().position(|known| known == body) else {
            self.unknown(entry, "moving body", body, bodies);
            return None;
        };
        let Some(part) = STATE_PARTS.iter().position(|known| *known == part) else {
            self.unknown(entry, "state of a body called", part, STATE_PARTS.map(str::to_owned).to_vec());
            return None;
        };
        Some((body, part))
    }

    fn dimension(
        &self,
        kind: QuantityKind,
        play: Option<usize>,
        column: Option<&Column>,
        reduce: Option<Reduce>,
    ) -> Dimension {
        match kind {
            QuantityKind::ContactOnset | QuantityKind::ImpactDuration => Dimension::TIME,
            QuantityKind::ImpactSpeed | QuantityKind::SeparationSpeed => Dimension::VELOCITY,
            QuantityKind::PeakForce | QuantityKind::StaticForce => Dimension::FORCE,
            QuantityKind::LargestPenetration | QuantityKind::LoopDrift => Dimension::LENGTH,
            QuantityKind::ContactStiffness => {
                play.map_or(Dimension::NUMBER, |play| stiffness_dimension(self.case, play))
            }
            QuantityKind::ContactLoss | QuantityKind::FrictionLoss | QuantityKind::DriveWork => Dimension::TORQUE,
            QuantityKind::Contacts | QuantityKind::DeliveredRestitution | QuantityKind::EnergyResidual => {
                Dimension::NUMBER
            }
            QuantityKind::Output
            | QuantityKind::IdealOutput
            | QuantityKind::WorstCase
            | QuantityKind::FirstOrderPlay
            | QuantityKind::DimensionalStandardDeviation => match reduce {
                Some(Reduce::AngleOfMinimum | Reduce::AngleOfMaximum) => Dimension::ANGLE,
                _ => column.map_or(Dimension::NUMBER, |column| dimension_of(&column.unit)),
            },
        }
    }

    fn history(&mut self, entry: &Entry<'_>, folder: &Path) -> Vec<Check> {
        let Some(table) = HistoryTable::read(self, entry) else { return Vec::new() };
        let reference = table.file.and_then(|entry| {
            let file = self.reader.text(&entry)?.to_owned();
            open_reference(&mut self.reader, folder, &file, entry.span)
        });
        let listed = table.columns.as_ref().and_then(|entry| self.reader.list(entry)).unwrap_or_default();
        if let Some(columns) = table.columns.as_ref().filter(|_| listed.is_empty()) {
            self.nothing(columns);
        }
        let (Some(Origin(origin)), Some(source), Some(_), Some(reference)) =
            (table.origin, table.source, table.reason, reference)
        else {
            return Vec::new();
        };
        let mut checks = Vec::new();
        for listed in listed {
            if let Some((name, history)) = self.history_column(&listed, &reference) {
                let place = self.reader.place(listed.span);
                let name = format!("{}: {name}", entry.name.replace('_', " "));
                checks.push(Check {
                    name,
                    origin,
                    source: source.clone(),
                    place,
                    what: CheckSubject::History(history),
                });
            }
        }
        checks
    }

    fn history_column(&mut self, entry: &Entry<'_>, reference: &Arc<Reference>) -> Option<(String, History)> {
        let table = ColumnTable::read(self, entry)?;
        let wanted = table.column?;
        let name = self.reader.text(&wanted)?;
        let Some(column) = reference.columns.iter().position(|known| known == name) else {
            self.unknown(&wanted, "column", name, reference.columns.clone());
            return None;
        };
        let (ours, due, words) = if let Some(entry) = table.output {
            let index = self.output(&entry)?;
            let column = columns(&self.case.mechanism.model).swap_remove(index);
            (ComputedColumn::Output(index), dimension_of(&column.unit), column.name)
        } else {
            let entry = table.state?;
            let (body, part) = self.state(&entry)?;
            let bodies = self.case.model.bodies.len() - 1;
            let index = (part / 3 * bodies + body) * 3 + part % 3;
            (ComputedColumn::State(index), state_dimension(part), self.reader.text(&entry)?.to_owned())
        };
        let entry = table.tolerance?;
        let tolerance_si = self.reader.measured(&entry, due, Rule::NonNegative)?;
        let unit = self.unit(&entry, due);
        Some((words, History { reference: Arc::clone(reference), columns: vec![(column, ours)], tolerance_si, unit }))
    }
}

#[cfg(test)]
mod tests {
    use crate::cases::Case;
    use std::fs;
    use std::path::Path;

    #[test]
    fn a_case_that_expects_nothing_is_refused() {
        let model = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../cases/slider_crank_5000/model.toml");
        let folder = tempfile::tempdir().expect("a folder");
        fs::copy(model, folder.path().join("model.toml")).expect("a model");
        let diagnostic = |expected: &str| {
            fs::write(folder.path().join("expected.toml"), expected).expect("a file");
            Case::from_folder(folder.path()).map(|_| ()).expect_err(expected).to_string()
        };
        assert!(diagnostic("").contains("the file expects nothing"), "{}", diagnostic(""));
        let empty = "[expected.top]\nquantity = \"ideal_output\"\noutput = \"slider\"\nangle = []\nvalue = []\n\
                     tolerance = \"1 um\"\norigin = \"analytic\"\nsource = \"none\"\nreason = \"none\"\n";
        assert!(diagnostic(empty).contains("value expects nothing"), "{}", diagnostic(empty));
    }
}
