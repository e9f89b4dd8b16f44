//! From the text of a model file to a model, with all its complaints at once.

use std::collections::HashMap;
use std::path::Path;
use std::sync::Arc;

use super::control::Control;
use super::coupling::Coupling;
use super::drive::Drive;
use super::keys::MODEL_KEYS;
use super::load::Load;
use super::parameter::Parameters;
use super::problem::ModelProblem;
use super::quantity::{Origin, Quantity, QuantityId, QuantityTable};
use super::spring::Spring;
use super::topology::{Body, BodyId, Contact, ContactId, DriveId, Guess, Joint, JointId, Model, PointId};
use loosepin_text::diagnostics::{Complaint, Complaints, Source, Span, nearest_name};
use loosepin_text::document::{
    Entry, EntryPath, Reader, Table, Written, json_schema, parse_toml, read_source, source_from_bytes,
};
use loosepin_text::units::{Dimension, Expression, ExpressionProblem, Rule, parse_expression, run};

/// Stands where a quantity could not be read. No model with complaints is handed out, so it is never looked up.
pub(super) const UNREAD: QuantityId = QuantityId(0);

/// The JSON Schema of a model file, for editors.
pub fn model_schema() -> serde_json::Value {
    json_schema("loosepin model", &MODEL_KEYS)
}

impl Model {
    /// Reads a model file.
    ///
    /// # Errors
    /// Everything that is wrong with the file, each with its place.
    pub fn from_path(path: &Path) -> Result<Model, Complaints> {
        Model::from_source(read_source(path)?)
    }

    /// Reads a model from text that is reported as `name`.
    ///
    /// # Errors
    /// Everything that is wrong with the text, each with its place.
    pub fn from_text(name: &str, text: &str) -> Result<Model, Complaints> {
        Model::from_source(Source::new(name, text))
    }

    /// Reads a model from bytes that are reported as `name`.
    ///
    /// # Errors
    /// As [`Model::from_text`]; bytes that are not UTF-8.
    pub fn from_bytes(name: &str, bytes: Vec<u8>) -> Result<Model, Complaints> {
        Model::from_source(source_from_bytes(name, bytes)?)
    }

    /// Reads a model from a text with its name and, where [`Source::with_files`] gave them, the tables that it may name: no other
    /// file is opened then.
    ///
    /// # Errors
    /// As [`Model::from_text`].
    pub fn from_source(source: Arc<Source>) -> Result<Model, Complaints> {
        let toml = parse_toml(&source)?;
        let mut file = ModelReader::new(&source);
        let root = file.reader.root(toml.get_ref(), &MODEL_KEYS);
        file.read(&root)
    }
}

/// What a name of the file stands for; absent where it was complained about already.
pub(super) type NamesOf<T> = Vec<(String, Option<T>)>;

/// A model in the making.
pub(super) struct ModelReader {
    pub reader: Reader,
    pub quantities: QuantityTable,
    pub parameters: Parameters,
    pub places: HashMap<String, Span>,
    pub bodies: Vec<Body>,
    pub contact_names: NamesOf<ContactId>,
    pub contacts: Vec<Contact>,
    pub joint_names: NamesOf<JointId>,
    pub joints: Vec<Joint>,
    pub couplings: Vec<Coupling>,
    pub springs: Vec<Spring>,
    pub loads: Vec<Load>,
    pub drive_names: NamesOf<DriveId>,
    pub drives: Vec<Drive>,
    pub controls: Vec<Control>,
    pub used_contacts: Vec<String>,
    pub tables: Vec<Arc<Source>>,
    pub warnings: Vec<Complaint>,
}

impl ModelReader {
    fn new(source: &Arc<Source>) -> ModelReader {
        let ground = Body {
            name: "ground".to_owned(),
            mass_kg: None,
            inertia_kg_m2: None,
            centre_of_mass_m: None,
            points: Vec::new(),
        };
        ModelReader {
            reader: Reader::new(source),
            quantities: QuantityTable::default(),
            parameters: Parameters::default(),
            places: HashMap::new(),
            bodies: vec![ground],
            contact_names: Vec::new(),
            contacts: Vec::new(),
            joint_names: Vec::new(),
            joints: Vec::new(),
            couplings: Vec::new(),
            springs: Vec::new(),
            loads: Vec::new(),
            drive_names: Vec::new(),
            drives: Vec::new(),
            controls: Vec::new(),
            used_contacts: Vec::new(),
            tables: Vec::new(),
            warnings: Vec::new(),
        }
    }

    fn read(mut self, root: &Table<'_>) -> Result<Model, Complaints> {
        let name = root.get("name").and_then(|entry| self.reader.text(&entry)).unwrap_or_default().to_owned();
        if let Some(entry) = root.get("parameter") {
            self.read_parameters(&entry);
        }
        let gravity_m_s2 = self.quantity(root, "gravity").unwrap_or(UNREAD);
        for (key, read) in [
            ("body", ModelReader::read_bodies as fn(&mut ModelReader, &Entry<'_>)),
            ("contact", ModelReader::read_contacts),
            ("joint", ModelReader::read_joints),
            ("coupling", ModelReader::read_couplings),
            ("cam", ModelReader::read_cams),
            ("spring", ModelReader::read_springs),
            ("load", ModelReader::read_loads),
            ("drive", ModelReader::read_drives),
            ("control", ModelReader::read_controls),
        ] {
            if let Some(entry) = root.get(key) {
                read(&mut self, &entry);
            }
        }
        let guesses = root.get("assembly").map(|entry| self.read_guesses(&entry)).unwrap_or_default();
        let initial = match root.get("initial") {
            Some(entry) => self.read_initial(&entry),
            None => self.initial_of_controls(),
        };
        let cycle = root.get("cycle").and_then(|entry| self.read_cycle(&entry));
        let outputs = root.get("output").map(|entry| self.read_outputs(&entry)).unwrap_or_default();
        self.warn_of_unused();
        match cycle {
            Some(cycle) if !self.reader.complaints.has_errors() => Ok(Model {
                name,
                quantities: self.quantities,
                gravity_m_s2,
                bodies: self.bodies,
                contacts: self.contacts,
                joints: self.joints,
                couplings: self.couplings,
                springs: self.springs,
                loads: self.loads,
                drives: self.drives,
                controls: self.controls,
                guesses,
                initial,
                cycle,
                outputs,
                warnings: self.warnings,
                source: self.reader.source,
                tables: self.tables,
                places: self.places,
            }),
            // What looks unused may be so only because of an error, so warnings wait until there is none.
            _ => Err(self.reader.complaints),
        }
    }

    fn warn_of_unused(&mut self) {
        let contacts = self.contact_names.iter().map(|(name, _)| name);
        let unused_contacts = contacts.filter(|name| !self.used_contacts.contains(name));
        let mut paths: Vec<String> = unused_contacts.map(|name| format!("contact.{name}")).collect();
        paths.extend(self.parameters.unused().map(|name| format!("parameter.{name}")));
        for path in paths {
            let place = self.places.get(&path).map(|span| self.reader.place(*span));
            let problem = ModelProblem::Unused { entry: loosepin_text::document::describe_path(&path) };
            self.warnings.push(Complaint::warning(&problem, place));
        }
    }

    /// Remembers where a table stands.
    pub fn remember(&mut self, entry: &Entry<'_>) {
        self.places.insert(entry.path.dotted(), entry.key_span);
    }

    /// The quantity behind a key, of the dimension and rule that the table of keys demands; absent where it is not
    /// written or was complained about.
    pub fn quantity(&mut self, table: &Table<'_>, key: &str) -> Option<QuantityId> {
        let entry = table.get(key)?;
        let (dimension, rule) = entry.due_quantity()?;
        self.quantity_of(&entry, dimension, rule)
    }

    /// As [`ModelReader::quantity`], with a value for where it is not written.
    pub fn quantity_or(&mut self, table: &Table<'_>, key: &'static str, default_si: f64) -> Option<QuantityId> {
        match table.due_quantity(key) {
            Some((dimension, rule)) if !table.has(key) => {
                Some(self.default_quantity(&table.path.join(key), dimension, rule, default_si))
            }
            _ => self.quantity(table, key),
        }
    }

    /// A quantity that the file does not mention.
    pub fn default_quantity(
        &mut self,
        path: &EntryPath,
        dimension: Dimension,
        rule: Rule,
        default_si: f64,
    ) -> QuantityId {
        let quantity = Quantity { path: path.dotted(), dimension, rule, origin: Origin::Default, span: None };
        self.quantities.add_number(quantity, default_si)
    }

    /// The quantity at an entry, of a given dimension.
    pub fn quantity_of(&mut self, entry: &Entry<'_>, dimension: Dimension, rule: Rule) -> Option<QuantityId> {
        let expression = self.expression(entry)?;
        if !self.reader.measures(entry, expression.dimension, dimension) {
            return None;
        }
        self.add(entry, &expression, rule)
    }

    /// What is written at an entry, as an expression over parameters.
    pub fn expression(&mut self, entry: &Entry<'_>) -> Option<Expression> {
        match self.reader.written(entry)? {
            Written::Number(value) => Some(Expression::number(value)),
            Written::Text(text) => match parse_expression(text, &self.parameters) {
                Ok(expression) => {
                    self.parameters.mark_used(&expression.reads);
                    Some(expression)
                }
                Err(error) => {
                    let is_echo = matches!(&error.problem, ExpressionProblem::UnknownName { name, .. } if self.parameters.is_broken(name));
                    if !is_echo {
                        let span = self.reader.inside(entry, text, &error.span);
                        self.reader.complain(&error.problem, span);
                    }
                    None
                }
            },
        }
    }

    /// Adds a quantity; complains where its value breaks the rule.
    pub fn add(&mut self, entry: &Entry<'_>, expression: &Expression, rule: Rule) -> Option<QuantityId> {
        let origin = if expression.reads.is_empty() {
            Origin::Literal
        } else {
            Origin::Expression { depends_on: expression.reads.iter().copied().map(QuantityId).collect() }
        };
        self.add_with_origin(entry, expression, rule, origin)
    }

    /// As [`ModelReader::add`], where the origin is known.
    pub fn add_with_origin(
        &mut self,
        entry: &Entry<'_>,
        expression: &Expression,
        rule: Rule,
        origin: Origin,
    ) -> Option<QuantityId> {
        let dimension = expression.dimension;
        let quantity = Quantity { path: entry.path.dotted(), dimension, rule, origin, span: Some(entry.span) };
        let id = if expression.reads.is_empty() {
            self.quantities.add_number(quantity, run(&expression.ops, &mut []))
        } else {
            self.quantities.add_expression(quantity, expression)
        };
        if let Err(problem) = self.quantities[id].check(self.quantities.nominal_value(id)) {
            self.reader.complain(&problem, entry.span);
            return None;
        }
        Some(id)
    }

    /// Demands that one quantity be below another; complains at `span` if the values of the file do not obey.
    pub fn demand_order(&mut self, smaller: QuantityId, larger: QuantityId, span: Span) -> bool {
        let Err(problem) = self.quantities.demand_order(smaller, larger) else { return true };
        let mut complaint = Complaint::error(&problem, Some(self.reader.place(span)));
        if let Some(limit) = self.quantities[larger].span.filter(|limit| *limit != span) {
            complaint = complaint.with_label(self.reader.place(limit), "it must be below this");
        }
        self.reader.complaints.push(complaint);
        false
    }

    /// Two lengths, x and y.
    pub fn vector(&mut self, entry: &Entry<'_>) -> [QuantityId; 2] {
        let Some(pair) = self.reader.pair(entry) else { return [UNREAD; 2] };
        let mut ids = [UNREAD; 2];
        for ((mut element, axis), id) in pair.into_iter().zip(["x", "y"]).zip(&mut ids) {
            element.path = entry.path.join(axis);
            *id = self.quantity_of(&element, Dimension::LENGTH, Rule::Finite).unwrap_or(UNREAD);
        }
        ids
    }

    /// The point that an entry names as `body.point`.
    pub fn point(&mut self, entry: &Entry<'_>) -> Option<PointId> {
        let text = self.reader.text(entry)?;
        let Some((body_name, point_name)) = text.split_once('.') else {
            let problem = ModelProblem::NotAPoint { entry: entry.path.describe(), text: text.to_owned() };
            self.reader.complain(&problem, entry.span);
            return None;
        };
        let body = self.body(entry, body_name)?;
        let points = &self.bodies[body.0].points;
        if let Some(point) = points.iter().position(|point| point.name == point_name) {
            return Some(PointId { body, point });
        }
        let known = points.iter().map(|point| format!("'{body_name}.{}'", point.name)).collect();
        let nearest = nearest_name(point_name, points.iter().map(|point| point.name.as_str()))
            .map(|nearest| format!("{body_name}.{nearest}"));
        self.unknown(entry, "point", text, nearest, known);
        None
    }

    /// The body called `name`.
    pub fn body(&mut self, entry: &Entry<'_>, name: &str) -> Option<BodyId> {
        if let Some(body) = self.bodies.iter().position(|body| body.name == name) {
            return Some(BodyId(body));
        }
        let known = self.bodies.iter().map(|body| format!("'{}'", body.name)).collect();
        let nearest = nearest_name(name, self.bodies.iter().map(|body| body.name.as_str())).map(str::to_owned);
        self.unknown(entry, "body", name, nearest, known);
        None
    }

    /// What `name` stands for in a list of names.
    pub fn named<T: Copy>(
        &mut self,
        entry: &Entry<'_>,
        what: &'static str,
        name: &str,
        names: fn(&ModelReader) -> &NamesOf<T>,
    ) -> Option<T> {
        let list = names(self);
        if let Some((_, meaning)) = list.iter().find(|(known, _)| known == name) {
            return *meaning;
        }
        let known = list.iter().map(|(known, _)| format!("'{known}'")).collect();
        let nearest = nearest_name(name, list.iter().map(|(known, _)| known.as_str())).map(str::to_owned);
        self.unknown(entry, what, name, nearest, known);
        None
    }

    fn unknown(
        &mut self,
        entry: &Entry<'_>,
        what: &'static str,
        name: &str,
        nearest: Option<String>,
        known: Vec<String>,
    ) {
        let problem = ModelProblem::UnknownReference {
            entry: entry.path.describe(),
            what,
            name: name.to_owned(),
            nearest,
            known,
        };
        self.reader.complain(&problem, entry.span);
    }

    fn read_guesses(&mut self, entry: &Entry<'_>) -> Vec<Guess> {
        let Some(guess) =
            self.reader.table(entry, &super::keys::ASSEMBLY_KEYS).and_then(|assembly| assembly.get("guess"))
        else {
            return Vec::new();
        };
        let mut guesses = Vec::new();
        for entry in self.reader.any_keys(&guess) {
            let angle_rad = self.quantity_of(&entry, Dimension::ANGLE, Rule::Finite);
            match self.body(&entry.at_key(), entry.name) {
                Some(BodyId(0)) => self.reader.complain(&ModelProblem::GuessOfGround, entry.key_span),
                Some(body) => guesses.extend(angle_rad.map(|angle_rad| Guess { body, angle_rad })),
                None => {}
            }
        }
        guesses
    }
}
