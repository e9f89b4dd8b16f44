//! A model being read: its parts so far, and the reader of quantities, points and names.

use super::parameters::Parameters;
use crate::model::contact::Contact;
use crate::model::coupling::Coupling;
use crate::model::drive::Drive;
use crate::model::ids::{BodyId, ContactId, ControlId, DriveId, JointId, PointId};
use crate::model::load::Load;
use crate::model::parts::control::Control;
use crate::model::parts::spring::Spring;
use crate::model::parts::topology::{Body, Joint};
use crate::model::problem::ModelProblem;
use crate::model::values::quantity::{Origin, Quantity, QuantityId, QuantityTable, UNREAD};
use std::collections::{HashMap, HashSet};
use std::sync::Arc;

use loosepin_text::diagnostics::{Diagnostic, Source, Span, nearest_name};
use loosepin_text::document::{Entry, EntryPath, Keys, Reader, Table, Written};
use loosepin_text::units::{Dimension, Expression, ExpressionProblem, Op, Rule, parse_expression, run};

/// Names of the file with the things that they stand for; absent where they were reported already.
pub(super) type NameTable<T> = Vec<(String, Option<T>)>;

/// A model in the making.
pub(super) struct ModelReader {
    pub reader: Reader,
    /// Whether the file has tables that it cannot have: names that stand there are not missing.
    pub has_unknown_tables: bool,
    /// Bodies whose points could not be read.
    pub without_points: HashSet<BodyId>,
    pub quantities: QuantityTable,
    pub parameters: Parameters,
    pub places: HashMap<String, Span>,
    pub bodies: Vec<Body>,
    /// The bodies of [`Self::bodies`] by their names.
    pub body_of_name: HashMap<String, BodyId>,
    /// How much warmer than their drawings bodies are that do not say so themselves, K.
    pub temperature_rise_k: Option<QuantityId>,
    /// Whether that is written, even if it could not be read.
    pub has_temperature_rise: bool,
    /// Whether a body takes it.
    pub uses_temperature_rise: bool,
    /// Whether a joint wears for as long as `[wear]` says.
    pub uses_life: bool,
    /// Shares by which bodies are longer than their drawings.
    pub elongations: HashMap<BodyId, QuantityId>,
    pub contact_names: NameTable<ContactId>,
    pub contacts: Vec<Contact>,
    pub joint_names: NameTable<JointId>,
    pub joints: Vec<Joint>,
    pub couplings: Vec<Coupling>,
    pub springs: Vec<Spring>,
    pub loads: Vec<Load>,
    pub drive_names: NameTable<DriveId>,
    pub drives: Vec<Drive>,
    pub control_names: NameTable<ControlId>,
    pub controls: Vec<Control>,
    pub used_contacts: Vec<String>,
    pub tables: Vec<Arc<Source>>,
    pub missing_for_runs: Vec<Diagnostic>,
    pub warnings: Vec<Diagnostic>,
}

impl ModelReader {
    pub fn new(source: &Arc<Source>) -> ModelReader {
        let ground = Body {
            name: "ground".to_owned(),
            mass_kg: None,
            inertia_kg_m2: None,
            centre_of_mass_m: None,
            points: Vec::new(),
            beam: None,
        };
        ModelReader {
            reader: Reader::new(source),
            has_unknown_tables: false,
            without_points: HashSet::new(),
            quantities: QuantityTable::default(),
            parameters: Parameters::default(),
            places: HashMap::new(),
            body_of_name: HashMap::from([(ground.name.clone(), BodyId(0))]),
            temperature_rise_k: None,
            has_temperature_rise: false,
            uses_temperature_rise: false,
            uses_life: false,
            elongations: HashMap::new(),
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
            control_names: Vec::new(),
            controls: Vec::new(),
            used_contacts: Vec::new(),
            tables: Vec::new(),
            missing_for_runs: Vec::new(),
            warnings: Vec::new(),
        }
    }

    /// Remembers where a table stands.
    pub fn remember(&mut self, entry: &Entry<'_>) {
        self.places.insert(entry.path.dotted(), entry.key_span);
    }

    /// The quantity behind a key, of the dimension and rule that the table of keys demands; absent where it is not
    /// written or was reported.
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
        let expression = self.expression_due(entry, dimension)?;
        self.add(entry, &expression, rule)
    }

    /// The expression at an entry, of the dimension that is due.
    pub fn expression_due(&mut self, entry: &Entry<'_>, due: Dimension) -> Option<Expression> {
        let expression = self.expression_of(entry, Some(due))?;
        if expression.dimension != due && self.blames_parameter(entry, due) {
            return None;
        }
        self.reader.measures(entry, expression.dimension, due).then_some(expression)
    }

    /// The text or number at an entry as an expression over parameters.
    pub fn expression(&mut self, entry: &Entry<'_>) -> Option<Expression> {
        self.expression_of(entry, None)
    }

    /// As [`ModelReader::expression`]; where a dimension is due, hints name its units.
    pub fn expression_of(&mut self, entry: &Entry<'_>, due: Option<Dimension>) -> Option<Expression> {
        match self.reader.written(entry)? {
            Written::Number(value) => Some(Expression::number(value)),
            Written::Text(text) => match parse_expression(text, &self.parameters) {
                Ok(expression) => {
                    self.parameters.mark_used(&expression.reads);
                    Some(expression)
                }
                Err(error) => {
                    let is_echo = matches!(&error.problem, ExpressionProblem::UnknownName { name, .. } if self.parameters.is_broken(name));
                    let is_blamed = due.is_some_and(|due| !is_echo && self.blames_parameter(entry, due));
                    if !is_echo && !is_blamed {
                        let error = due.map_or(error.clone(), |due| error.for_due(text, due));
                        let error = error.for_key(text, entry.example());
                        let span = self.reader.inside(entry, text, &error.span);
                        self.reader.report(&error.problem, span);
                    }
                    None
                }
            },
        }
    }

    /// Adds a quantity; reports where its value breaks the rule.
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
            return self.reader.refuse(&problem, entry.span);
        }
        Some(id)
    }

    /// A number that follows from others, at the place of the first of them.
    pub fn derived(
        &mut self,
        path: String,
        dimension: Dimension,
        rule: Rule,
        ops: Vec<Op>,
        reads: &[QuantityId],
    ) -> QuantityId {
        let expression = Expression { ops, dimension, reads: reads.iter().map(|id| id.0).collect() };
        let span = reads.first().and_then(|id| self.quantities[*id].span);
        let origin = Origin::Expression { depends_on: reads.to_vec() };
        self.quantities.add_expression(Quantity { path, dimension, rule, origin, span }, &expression)
    }

    /// Demands that one quantity be below another; reports at `span` if the values of the file do not obey.
    pub fn demand_order(&mut self, smaller: QuantityId, larger: QuantityId, span: Span) -> bool {
        let Err(problem) = self.quantities.demand_order(smaller, larger) else { return true };
        let mut diagnostic = Diagnostic::error(&problem, Some(self.reader.place(span)));
        if let Some(limit) = self.quantities[larger].span.filter(|limit| *limit != span) {
            diagnostic = diagnostic.with_label(self.reader.place(limit), "it must be below this");
        }
        self.reader.diagnostics.push(diagnostic);
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

    /// The table at an entry whose keys depend on its `kind`, and that kind.
    pub fn table_of_kind<'t>(
        &mut self,
        entry: &Entry<'t>,
        kinds: &[(&'static str, &'static Keys)],
    ) -> Option<(&'static str, Table<'t>)> {
        let choices: Vec<_> = kinds.iter().map(|&(kind, keys)| (kind, (kind, keys))).collect();
        let (kind, keys) = self.reader.tag(entry, "kind", &choices)?;
        Some((kind, self.reader.table(entry, keys)?))
    }

    /// Reports a key, where it is written, that means nothing beside another.
    pub fn refuse_beside(&mut self, table: &Table<'_>, key: &'static str, beside: &'static str) {
        if let Some(entry) = table.get(key) {
            let problem = ModelProblem::KeyWithoutEffect { entry: table.path.describe(), key, beside };
            self.reader.report(&problem, entry.key_span);
        }
    }

    /// Reports a key that needs others.
    pub fn report_missing(&mut self, table: &Table<'_>, key: &'static str, needs: Vec<&'static str>) {
        // A key that is not known may have been meant for it.
        if table.has_unknown() {
            return;
        }
        let problem = ModelProblem::NeedsKeys { entry: table.path.describe(), key, needs };
        self.reader.report(&problem, table.get(key).map_or(table.span, |entry| entry.key_span));
    }

    /// The point that an entry names as `body.point`.
    pub fn point(&mut self, entry: &Entry<'_>) -> Option<PointId> {
        let text = self.reader.text(entry)?;
        let Some((body_name, point_name)) = text.split_once('.') else {
            let problem = ModelProblem::NotAPoint { entry: entry.path.describe(), text: text.to_owned() };
            return self.reader.refuse(&problem, entry.span);
        };
        let body = self.body(entry, body_name)?;
        let points = &self.bodies[body.0].points;
        if let Some(point) = points.iter().position(|point| point.name == point_name) {
            return Some(PointId { body, point });
        }
        // Its points have a diagnostic already.
        if self.without_points.contains(&body) {
            return None;
        }
        let known = points.iter().map(|point| format!("'{body_name}.{}'", point.name)).collect();
        let nearest = nearest_name(point_name, points.iter().map(|point| point.name.as_str()))
            .map(|nearest| format!("{body_name}.{nearest}"));
        self.unknown(entry, "point", text, nearest, known);
        None
    }

    /// The body called `name`.
    pub fn body(&mut self, entry: &Entry<'_>, name: &str) -> Option<BodyId> {
        if let Some(body) = self.body_of_name.get(name) {
            return Some(*body);
        }
        let known = self.bodies.iter().map(|body| format!("'{}'", body.name)).collect();
        // Of a point, its body was meant.
        let of_point = name.split_once('.').map(|(body, _)| body).filter(|body| self.body_of_name.contains_key(*body));
        let nearest = of_point.or_else(|| nearest_name(name, self.bodies.iter().map(|body| body.name.as_str())));
        let nearest = nearest.map(str::to_owned);
        self.unknown(entry, "body", name, nearest, known);
        None
    }

    /// The thing that `name` stands for in a list of names.
    pub fn named<T: Copy>(
        &mut self,
        entry: &Entry<'_>,
        what: &'static str,
        name: &str,
        names: fn(&ModelReader) -> &NameTable<T>,
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
        // What is meant may stand in a misspelt table, which has its diagnostic.
        if self.has_unknown_tables {
            return;
        }
        let problem = ModelProblem::UnknownReference {
            entry: entry.path.describe(),
            what,
            name: name.to_owned(),
            nearest,
            known,
        };
        self.reader.report(&problem, entry.span);
    }
}
