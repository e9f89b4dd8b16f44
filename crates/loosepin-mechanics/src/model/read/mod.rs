//! From the text of a model file to a model, with all its complaints at once.

mod beam;
mod beam_mass;
mod body;
mod contact;
mod control;
mod coupling;
mod cycle;
mod default_law;
mod drive;
mod function;
mod initial;
mod joint;
mod load;
mod missing;
mod output;
mod parameter;
mod parameters;
mod part_reader;
mod play;
mod reader;
mod spring;
mod table_points;
mod unitless;
mod warm;
mod wear;

use crate::model::ids::BodyId;
use crate::model::keys::{ASSEMBLY_KEYS, MODEL_KEYS};
use crate::model::problem::ModelProblem;
use crate::model::quantity::UNREAD;
use crate::model::sizes::SIZES;
use crate::model::topology::{Guess, Model};
use loosepin_text::diagnostics::{Complaint, Complaints, Source};
use loosepin_text::document::{Entry, Table, describe_path, json_schema, parse_toml, read_source, source_from_bytes};
use loosepin_text::units::{Dimension, Rule};
use reader::ModelReader;
use std::path::Path;
use std::sync::Arc;

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
        file.has_unknown_tables = root.has_unknown();
        file.read(&root)
    }
}

/// The model with warnings of numbers that are hardly possible.
fn with_warnings(mut model: Model) -> Model {
    let found = model.hardly_possible();
    model.warnings.extend(found);
    model
}

impl ModelReader {
    fn read(mut self, root: &Table<'_>) -> Result<Model, Complaints> {
        if self.refuses_sizes(root) {
            return Err(self.reader.complaints);
        }
        let name = root.get("name").and_then(|entry| self.reader.text(&entry)).unwrap_or_default().to_owned();
        if let Some(entry) = root.get("parameter") {
            self.read_parameters(&entry);
        }
        if !root.has("gravity") {
            self.miss_for_runs(root, "gravity");
        }
        let gravity_m_s2 = self.quantity_or(root, "gravity", 0.0).unwrap_or(UNREAD);
        self.has_temperature_rise = root.has("temperature_rise");
        self.temperature_rise_k = self.quantity(root, "temperature_rise");
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
        let (mut initial, initial_offsets) =
            root.get("initial").map(|entry| self.read_initial(&entry)).unwrap_or_default();
        if root.get("initial").is_none() || (initial.is_empty() && !initial_offsets.is_empty()) {
            initial = self.initial_of_controls();
        }
        self.refuse_beside_beams();
        let cycle = root.get("cycle").and_then(|entry| self.read_cycle(&entry));
        let outputs = root.get("output").map(|entry| self.read_outputs(&entry)).unwrap_or_default();
        let wear = self.read_life(root, &outputs);
        self.take_laws_of_long_pins(wear.as_ref());
        self.refuse_measures_of_fixed_wear(&outputs, wear.as_ref());
        self.warn_of_unused();
        match cycle {
            Some(cycle) if !self.reader.complaints.has_errors() => Ok(with_warnings(Model {
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
                initial_offsets,
                cycle,
                wear,
                outputs,
                missing_for_runs: self.missing_for_runs,
                warnings: self.warnings,
                source: self.reader.source,
                tables: self.tables,
                places: self.places,
            })),
            // What looks unused may be so only because of an error, so warnings wait until there is none.
            _ => Err(self.reader.complaints),
        }
    }

    /// Complains about the first entry of a table that is one too many; true where there is one, and nothing is to be read.
    fn refuses_sizes(&mut self, root: &Table<'_>) -> bool {
        let mut is_too_large = false;
        for (key, what, most) in SIZES {
            let Some(entry) = root.get(key).filter(Entry::is_table) else { continue };
            let entries = self.reader.any_keys(&entry);
            let counted: Vec<&Entry<'_>> = entries.iter().filter(|e| (key, e.name) != ("body", "ground")).collect();
            if let Some(surplus) = counted.get(most) {
                self.reader.complain(&ModelProblem::TooMany { what, found: counted.len(), most }, surplus.key_span);
                is_too_large = true;
            }
        }
        is_too_large
    }

    fn warn_of_unused(&mut self) {
        let contacts = self.contact_names.iter().map(|(name, _)| name);
        let unused_contacts = contacts.filter(|name| !self.used_contacts.contains(name));
        let mut paths: Vec<String> = unused_contacts.map(|name| format!("contact.{name}")).collect();
        paths.extend(self.parameters.unused().map(|name| format!("parameter.{name}")));
        if self.has_temperature_rise && !self.uses_temperature_rise {
            paths.push("temperature_rise".to_owned());
        }
        if self.places.contains_key("wear") && !self.uses_life {
            paths.push("wear".to_owned());
        }
        for path in paths {
            let written = self.quantities.id(&path).and_then(|id| self.quantities[id].span);
            let span = self.places.get(&path).copied().or(written);
            let place = span.map(|span| self.reader.place(span));
            let problem = ModelProblem::Unused { entry: describe_path(&path) };
            self.warnings.push(Complaint::warning(&problem, place));
        }
    }

    fn read_guesses(&mut self, entry: &Entry<'_>) -> Vec<Guess> {
        let Some(guess) = self.reader.table(entry, &ASSEMBLY_KEYS).and_then(|assembly| assembly.get("guess")) else {
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
