//! A model being read: its parts so far, and the reader of points and bodies.

use crate::model::contact::Contact;
use crate::model::coupling::Coupling;
use crate::model::drive::Drive;
use crate::model::ids::{BodyId, ContactId, ControlId, DriveId, JointId, PointId};
use crate::model::load::Load;
use crate::model::parts::control::Control;
use crate::model::parts::spring::Spring;
use crate::model::parts::topology::{Body, Joint};
use crate::model::problem::hint_of_needs;
use loosepin_text::numbers::{EntryProblem, NameTable, NumberReader, QuantityId, UNREAD};
use std::collections::{HashMap, HashSet};
use std::sync::Arc;

use loosepin_text::diagnostics::{Diagnostic, Source, nearest_name};
use loosepin_text::document::Entry;
use loosepin_text::units::{Dimension, Rule};

/// A model in the making.
pub(super) struct ModelReader {
    pub numbers: NumberReader,
    /// Whether pins lean out of the plane.
    pub leans: bool,
    /// Whether the file says whether they do.
    pub says_lean: bool,
    /// Bodies whose points could not be read.
    pub without_points: HashSet<BodyId>,
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
            offset_m: None,
            points: Vec::new(),
            beam: None,
        };
        ModelReader {
            numbers: NumberReader::new(source, hint_of_needs),
            leans: false,
            says_lean: false,
            without_points: HashSet::new(),
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

    /// Two lengths, x and y.
    pub fn vector(&mut self, entry: &Entry<'_>) -> [QuantityId; 2] {
        let Some(pair) = self.numbers.reader.pair(entry) else { return [UNREAD; 2] };
        let mut ids = [UNREAD; 2];
        for ((mut element, axis), id) in pair.into_iter().zip(["x", "y"]).zip(&mut ids) {
            element.path = entry.path.join(axis);
            *id = self.numbers.quantity_of(&element, Dimension::LENGTH, Rule::Finite).unwrap_or(UNREAD);
        }
        ids
    }

    /// The point that an entry names as `body.point`.
    pub fn point(&mut self, entry: &Entry<'_>) -> Option<PointId> {
        let text = self.numbers.reader.text(entry)?;
        let Some((body_name, point_name)) = text.split_once('.') else {
            let problem = EntryProblem::NotAPoint { entry: entry.path.describe(), text: text.to_owned() };
            return self.numbers.reader.refuse(&problem, entry.span);
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
        self.numbers.unknown(entry, "point", text, nearest, known);
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
        self.numbers.unknown(entry, "body", name, nearest, known);
        None
    }
}
