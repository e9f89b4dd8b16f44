//! From the text of an `expected.toml` to what must be met, with all its complaints at once.

use std::path::Path;
use std::sync::Arc;

use super::case::{At, Case, Check, ExpectedNumber, History, Numbers, Ours, Quantity, QuantityKind, Reduce, What};
use super::dimension::{dimension_of, si_unit, state_dimension, stiffness_dimension};
use super::keys::{COLUMN_KEYS, EXPECTED_KEYS, HISTORY_KEYS, NUMBER_KEYS, ORIGINS, QUANTITIES, REDUCTIONS};
use super::problem::CaseProblem;
use super::reference::{Reference, open_reference};
use super::script_file::read_script;
use loosepin_mechanics::model::{BodyId, Motion, Position, Relative};
use loosepin_simulate::accuracy::position_outputs;
use loosepin_simulate::{Column, columns, input};
use loosepin_text::diagnostics::{Complaint, Complaints, Source};
use loosepin_text::document::{Entry, Reader, Table, Written, parse_toml};
use loosepin_text::units::{Dimension, ReadableUnit, Rule, SiUnit};

/// Parts of a state of a body, in the order of `history.csv`: positions, velocities, accelerations.
const STATE_PARTS: [&str; 9] = ["x", "y", "angle", "vx", "vy", "omega", "ax", "ay", "alpha"];

/// Reads the tables of an `expected.toml`.
///
/// # Errors
/// Everything that is wrong with it or with a file that it names, each with its place.
pub(super) fn read_expected(source: &Arc<Source>, folder: &Path, case: &Case) -> Result<Vec<Check>, Complaints> {
    let toml = parse_toml(source)?;
    let mut reader = Reader::new(source);
    let root = reader.root(toml.get_ref(), &EXPECTED_KEYS);
    let mut file = ExpectedReader { reader, case, span_s: cycle_s(case)? };
    let mut checks = Vec::new();
    if let Some(entry) = root.get("expected") {
        for entry in file.reader.named(&entry, "a number") {
            checks.extend(file.numbers(&entry));
        }
    }
    if let Some(entry) = root.get("history") {
        for entry in file.reader.named(&entry, "a history") {
            checks.extend(file.history(&entry, folder));
        }
    }
    checks.extend(read_script(&mut file.reader, &root, folder, case));
    if checks.is_empty() && !file.reader.complaints.has_errors() {
        // Nothing expected would be met by anything.
        file.reader.complain(&CaseProblem::NothingExpected { entry: "the file".to_owned() }, (0..0).into());
    }
    if file.reader.complaints.has_errors() { Err(file.reader.complaints) } else { Ok(checks) }
}

/// Length of the cycle of the model, transient included, s.
fn cycle_s(case: &Case) -> Result<f64, Complaints> {
    let cycle = &case.model.cycle;
    let input = input(&case.mechanism, &case.values, cycle.span).map_err(|failure| failure.complaint(&case.model))?;
    Ok((cycle.transient_turns + cycle.recorded_turns) * input.turn_s())
}

struct ExpectedReader<'c> {
    reader: Reader,
    case: &'c Case,
    /// Length of a run where nothing else is said, s.
    span_s: f64,
}

impl ExpectedReader<'_> {
    fn numbers(&mut self, entry: &Entry<'_>) -> Option<Check> {
        let table = self.reader.table(entry, &NUMBER_KEYS)?;
        let origin = self.origin(&table);
        let source = self.text(&table, "source");
        self.text(&table, "reason");
        let quantity = self.quantity(&table);
        let settings = self.settings(&table);
        let (quantity, due) = quantity?;
        let values = self.one_or_each(&table.get("value")?, due)?;
        if values.is_empty() {
            self.nothing(&table.get("value")?);
        }
        let tolerance_si = self.reader.measured(&table.get("tolerance")?, due, Rule::NonNegative)?;
        let unit = self.unit(&table.get("value")?, due);
        let mut numbers: Vec<ExpectedNumber> = values
            .into_iter()
            .map(|value_si| ExpectedNumber { value_si, settings: Vec::new(), at: None, words: None })
            .collect();
        for (key, dimension) in
            [("angle", Dimension::ANGLE), ("time", Dimension::TIME), ("penetration", Dimension::LENGTH)]
        {
            let Some(entry) = table.get(key) else { continue };
            let instants = self.one_or_each(&entry, dimension)?;
            self.same_length(&entry, instants.len(), numbers.len())?;
            let texts = self.texts(&entry);
            for ((number, instant), text) in numbers.iter_mut().zip(instants).zip(texts) {
                number.at = Some(match key {
                    "angle" => At::Angle(instant),
                    "time" => At::Time(instant),
                    _ => At::Penetration(instant),
                });
                number.words = Some(format!("at {text}"));
            }
        }
        if let (Some(settings), Some(entry)) = (settings?, table.get("set")) {
            self.same_length(&entry, settings.len(), numbers.len())?;
            for (number, setting) in numbers.iter_mut().zip(settings) {
                let (path, value) = setting.split_once('=').unwrap_or((&setting, ""));
                let quantity = path.rsplit('.').next().unwrap_or(path);
                number.words = Some(format!("with {} {value}", quantity.replace('_', " ")));
                number.settings.push(setting);
            }
        }
        Some(Check {
            name: entry.name.replace('_', " "),
            origin: origin?,
            source: source?,
            place: self.reader.place(entry.key_span),
            what: What::Numbers(Numbers { quantity, numbers, tolerance_si, unit }),
        })
    }

    fn origin(&mut self, table: &Table<'_>) -> Option<&'static str> {
        self.reader.choice(&table.get("origin")?, &ORIGINS.map(|origin| (origin, origin)))
    }

    fn text(&mut self, table: &Table<'_>, key: &str) -> Option<String> {
        self.reader.text(&table.get(key)?).map(str::to_owned)
    }

    /// The settings, checked against the model; none where the key is not written.
    fn settings(&mut self, table: &Table<'_>) -> Option<Option<Vec<String>>> {
        let Some(entry) = table.get("set") else { return Some(None) };
        let mut settings = Vec::new();
        for entry in self.reader.list(&entry)? {
            let text = self.reader.text(&entry)?.to_owned();
            if let Err(complaints) = self.case.model.set_values(std::slice::from_ref(&text)) {
                let place = self.reader.place(entry.span);
                for complaint in complaints.sorted() {
                    self.reader.complaints.push(Complaint { place: Some(place.clone()), ..complaint.clone() });
                }
                return None;
            }
            settings.push(text);
        }
        Some(Some(settings))
    }

    /// That a list names nothing to compare.
    fn nothing(&mut self, entry: &Entry<'_>) {
        self.reader.complain(&CaseProblem::NothingExpected { entry: entry.path.describe() }, entry.span);
    }

    fn same_length(&mut self, entry: &Entry<'_>, found: usize, due: usize) -> Option<()> {
        if found == due {
            return Some(());
        }
        let problem = CaseProblem::ListLength { entry: entry.path.describe(), found, due };
        self.reader.complain(&problem, entry.span);
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

    /// A value, or the values of a list, as they are written.
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
    fn quantity(&mut self, table: &Table<'_>) -> Option<(Quantity, Dimension)> {
        let entry = table.get("quantity")?;
        let (word, kind, keys) =
            self.reader.choice(&entry, &QUANTITIES.map(|(word, kind, keys)| (word, (word, kind, keys))))?;
        for key in ["joint", "output", "state", "reduce", "angle", "time", "penetration", "span"] {
            if let Some(entry) = table.get(key).filter(|_| !keys.contains(&key)) {
                let problem = CaseProblem::KeyWithoutEffect { entry: entry.path.describe(), quantity: word };
                self.reader.complain(&problem, entry.key_span);
            }
        }
        let play = if keys.contains(&"joint") { Some(self.play(table)?) } else { None };
        let column = if keys.contains(&"output") { Some(self.column(table, kind)?) } else { None };
        let reduce = match table.get("reduce") {
            Some(entry) => Some(self.reader.choice(&entry, &REDUCTIONS)?),
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
        let span_s = match table.get("span") {
            Some(entry) => self.reader.measured(&entry, Dimension::TIME, Rule::Positive)?,
            None => self.span_s,
        };
        let due = self.dimension(kind, play, column.as_ref(), reduce);
        Some((Quantity { kind, play, column, reduce, span_s }, due))
    }

    fn play(&mut self, table: &Table<'_>) -> Option<usize> {
        if !self.reader.demand(table, "joint") {
            return None;
        }
        let entry = table.get("joint")?;
        let name = self.reader.text(&entry)?;
        let mechanism = &self.case.mechanism;
        let known: Vec<String> =
            mechanism.plays.iter().map(|&play| mechanism.model.play_name(play).to_owned()).collect();
        let found = known.iter().position(|known| known == name);
        if found.is_none() {
            self.unknown(&entry, "joint with play", name, known);
        }
        found
    }

    fn unknown(&mut self, entry: &Entry<'_>, what: &'static str, name: &str, known: Vec<String>) {
        let problem = CaseProblem::UnknownName { entry: entry.path.describe(), what, name: name.to_owned(), known };
        self.reader.complain(&problem, entry.span);
    }

    /// The output, or the state of a body read as one.
    fn column(&mut self, table: &Table<'_>, kind: QuantityKind) -> Option<Column> {
        if let Some(entry) = table.get("state") {
            let (body, part) = self.state(&entry)?;
            let angle = Position::Angle(Relative::to_ground(BodyId(body + 1)));
            let (reading, unit) = match part {
                2 => (Motion::position(angle), SiUnit::ANGLE),
                5 => (Motion::velocity(angle), SiUnit::ANGULAR_VELOCITY),
                8 => (Motion::acceleration(angle), SiUnit::ANGULAR_ACCELERATION),
                _ => {
                    let known = ["angle", "omega", "alpha"].map(str::to_owned).to_vec();
                    self.unknown(&entry, "state for single values called", STATE_PARTS[part], known);
                    return None;
                }
            };
            let name = self.reader.text(&entry)?.to_owned();
            return Some(Column { output: 0, words: name.clone(), name, unit, reading: reading.into() });
        }
        if !self.reader.demand(table, "output") {
            return None;
        }
        let entry = table.get("output")?;
        let index = self.output(&entry)?;
        let column = columns(&self.case.mechanism.model).swap_remove(index);
        let is_quasi_static = matches!(
            kind,
            QuantityKind::WorstCase | QuantityKind::FirstOrderPlay | QuantityKind::DimensionalStandardDeviation
        );
        let known: Vec<String> = position_outputs(&self.case.mechanism).into_iter().map(|output| output.name).collect();
        if is_quasi_static && !known.contains(&column.name) {
            self.unknown(&entry, "output of positions", &column.name, known);
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
        let Some(table) = self.reader.table(entry, &HISTORY_KEYS) else { return Vec::new() };
        let origin = self.origin(&table);
        let source = self.text(&table, "source");
        self.text(&table, "reason");
        let reference = table.get("file").and_then(|entry| {
            let file = self.reader.text(&entry)?.to_owned();
            open_reference(&mut self.reader, folder, &file, entry.span)
        });
        let listed = table.get("columns").and_then(|entry| self.reader.list(&entry)).unwrap_or_default();
        if let Some(columns) = table.get("columns").filter(|_| listed.is_empty()) {
            self.nothing(&columns);
        }
        let (Some(origin), Some(source), Some(reference)) = (origin, source, reference) else { return Vec::new() };
        let mut checks = Vec::new();
        for listed in listed {
            if let Some((name, history)) = self.history_column(&listed, &reference) {
                let place = self.reader.place(listed.span);
                let name = format!("{}: {name}", entry.name.replace('_', " "));
                checks.push(Check { name, origin, source: source.clone(), place, what: What::History(history) });
            }
        }
        checks
    }

    fn history_column(&mut self, entry: &Entry<'_>, reference: &Arc<Reference>) -> Option<(String, History)> {
        let table = self.reader.table(entry, &COLUMN_KEYS)?;
        let wanted = table.get("column")?;
        let name = self.reader.text(&wanted)?;
        let Some(column) = reference.columns.iter().position(|known| known == name) else {
            self.unknown(&wanted, "column", name, reference.columns.clone());
            return None;
        };
        let (ours, due, words) = if let Some(entry) = table.get("output") {
            let index = self.output(&entry)?;
            let column = columns(&self.case.mechanism.model).swap_remove(index);
            (Ours::Output(index), dimension_of(&column.unit), column.name)
        } else {
            let entry = table.get("state")?;
            let (body, part) = self.state(&entry)?;
            let bodies = self.case.model.bodies.len() - 1;
            let index = (part / 3 * bodies + body) * 3 + part % 3;
            (Ours::State(index), state_dimension(part), self.reader.text(&entry)?.to_owned())
        };
        let entry = table.get("tolerance")?;
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
        let complaint = |expected: &str| {
            fs::write(folder.path().join("expected.toml"), expected).expect("a file");
            Case::from_folder(folder.path()).map(|_| ()).expect_err(expected).to_string()
        };
        assert!(complaint("").contains("the file expects nothing"), "{}", complaint(""));
        let empty = "[expected.top]\nquantity = \"ideal_output\"\noutput = \"slider\"\nangle = []\nvalue = []\n\
                     tolerance = \"1 um\"\norigin = \"analytic\"\nsource = \"none\"\nreason = \"none\"\n";
        assert!(complaint(empty).contains("value expects nothing"), "{}", complaint(empty));
    }
}
