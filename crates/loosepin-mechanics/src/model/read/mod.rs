//! From the text of a model file to a model, with all its diagnostics at once.
//! A file for each part, with its table. Kinds of joints, couplings, loads, drives and outputs read their own tables in their folders.

mod beams;
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
mod part_reader;
mod play;
mod reader;
mod spring;
mod table_points;
mod warm;
mod wear;

use crate::model::contact::ContactTable;
use crate::model::coupling::{CAM, COUPLING_KINDS};
use crate::model::ids::BodyId;
use crate::model::joint::JOINT_KINDS;
use crate::model::load::LOAD_KINDS;
use crate::model::output::OUTPUT_KEYS;
use crate::model::part_reader::PartReader;
use crate::model::parts::topology::{Guess, Joint, Model};
use crate::model::parts::wear::LifeTable;
use crate::model::problem::ModelProblem;
use crate::model::values::sizes::SIZES;
use body::{BodyTable, GroundTable};
use control::ControlTable;
use cycle::CycleTable;
use drive::DriveTable;
use initial::InitialTable;
use loosepin_text::diagnostics::{Diagnostic, Diagnostics, Source};
use loosepin_text::document::{Entry, Kind, Table, choice, quantity};
use loosepin_text::document::{describe_path, json_schema, parse_toml, read_source, source_from_bytes};
use loosepin_text::numbers::EntryProblem;
use loosepin_text::numbers::UNREAD;
use loosepin_text::plausible::JudgedModel;
use loosepin_text::units::{Dimension, Rule};
use loosepin_text::{choices, record};
use reader::ModelReader;
use spring::SPRING_KINDS;
use std::path::Path;
use std::sync::Arc;

record! {
    /// the choice for loops that can close in two ways
    struct AssemblyTable for PartReader;
    /// approximate angles of bodies at time zero
    required guess: Entry<'t> = Kind::Values(&quantity(Dimension::ANGLE, Rule::Finite)), "{ rocker = \"94 deg\" }";
}

/// What a mechanism moves in.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Geometry {
    Plane,
    Space,
}

choices!(Geometry: "plane" => Self::Plane, "space" => Self::Space);

/// What pins with play do out of the plane.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Lean {
    Held,
    Free,
}

choices!(Lean: "held" => Self::Held, "free" => Self::Free);

record! {
    /// a planar mechanism with its nominal values
    struct ModelTable for PartReader;
    /// name of the mechanism
    required name: Option<String> = Kind::Text, "\"worn pin\"";
    /// "plane" for a planar mechanism, which is meant if omitted; "space" for one in space, which has a format of its own
    optional geometry: Geometry = choice::<Geometry>(), "\"plane\"";
    /// "free" where pins with play lean out of the plane, which motion without dynamics then says apart; "held" if omitted. Runs stay in the plane
    optional lean: Lean = choice::<Lean>(), "\"held\"";
    /// acceleration along -y; "0 m/s^2" for none; needed for runs
    optional gravity: Entry<'t> = quantity(Dimension::ACCELERATION, Rule::Finite), "\"9.81 m/s^2\"";
    /// temperature of parts with thermal_expansion above the temperature of their drawings
    optional temperature_rise: Entry<'t> = quantity(Dimension::TEMPERATURE, Rule::Finite), "\"40 K\"";
    /// named values for use in expressions
    optional parameter: Entry<'t> = Kind::Values(&Kind::AnyQuantity), "";
    /// the bodies, each under [body.NAME]
    required body: Option<Entry<'t>> =
        Kind::Tables { keys: &BodyTable::KEYS, except: &[("ground", &GroundTable::KEYS)] }, "";
    /// contacts, shared by joints
    optional contact: Entry<'t> = Kind::Tables { keys: &ContactTable::KEYS, except: &[] }, "";
    /// the joints
    optional joint: Entry<'t> = Kind::TaggedTables { tag: "kind", variants: JOINT_KINDS }, "";
    /// gears, belts, racks and other ratios of two joints, each under [coupling.NAME]
    optional coupling: Entry<'t> = Kind::TaggedTables { tag: "kind", variants: COUPLING_KINDS }, "";
    /// cams with a profile given by points, each under [cam.NAME]
    optional cam: Entry<'t> = Kind::Tables { keys: CAM.1, except: &[] }, "";
    /// springs with their dampers, each under [spring.NAME]
    optional spring: Entry<'t> = Kind::TaggedTables { tag: "kind", variants: SPRING_KINDS }, "";
    /// external forces and torques, each under [load.NAME]
    optional load: Entry<'t> = Kind::TaggedTables { tag: "kind", variants: LOAD_KINDS }, "";
    /// the drives, each under [drive.NAME]
    optional drive: Entry<'t> = Kind::Tables { keys: &DriveTable::KEYS, except: &[] }, "";
    /// joints whose actuators follow a reference, each under [control.NAME]
    optional control: Entry<'t> = Kind::Tables { keys: &ControlTable::KEYS, except: &[] }, "";
    /// the initial state of motions that the drives alone do not determine
    optional initial: Entry<'t> = Kind::Table(&InitialTable::KEYS), "";
    /// the choice for loops that can close in two ways
    optional assembly: Entry<'t> = Kind::Table(&AssemblyTable::KEYS), "";
    /// the cycles over which the wear of joints is calculated, under [wear]
    optional wear: Entry<'t> = Kind::Table(&LifeTable::KEYS), "";
    /// the turns to simulate and to record, under [cycle]
    required cycle: Option<Entry<'t>> = Kind::Table(&CycleTable::KEYS), "";
    /// the outputs, in their order
    optional output: Entry<'t> = Kind::Tables { keys: &OUTPUT_KEYS, except: &[] }, "";
}

/// The JSON Schema of a model file, for editors.
pub fn model_schema() -> serde_json::Value {
    json_schema("loosepin model", &ModelTable::KEYS)
}

impl Model {
    /// Reads a model file.
    ///
    /// # Errors
    /// Everything that is wrong with the file, each with its place.
    pub fn from_path(path: &Path) -> Result<Model, Diagnostics> {
        Model::from_source(read_source(path)?)
    }

    /// Reads a model from text that is reported as `name`.
    ///
    /// # Errors
    /// Everything that is wrong with the text, each with its place.
    pub fn from_text(name: &str, text: &str) -> Result<Model, Diagnostics> {
        Model::from_source(Source::new(name, text))
    }

    /// Reads a model from bytes that are reported as `name`.
    ///
    /// # Errors
    /// As [`Model::from_text`]; bytes that are not UTF-8.
    pub fn from_bytes(name: &str, bytes: Vec<u8>) -> Result<Model, Diagnostics> {
        Model::from_source(source_from_bytes(name, bytes)?)
    }

    /// Reads a model from a text with its name and, where [`Source::with_files`] gave them, the tables that it may name: no other
    /// file is opened then.
    ///
    /// # Errors
    /// As [`Model::from_text`].
    pub fn from_source(source: Arc<Source>) -> Result<Model, Diagnostics> {
        let toml = parse_toml(&source)?;
        let mut file = ModelReader::new(&source);
        let space = toml.get_ref().get("geometry").filter(|value| value.get_ref().as_str() == Some("space"));
        if let Some(space) = space {
            // At once: all its tables would be wrong here.
            return Err(Diagnostics::one(&ModelProblem::InSpace, Some(file.numbers.reader.place(space.span().into()))));
        }
        let root = file.numbers.reader.root(toml.get_ref(), &ModelTable::KEYS);
        file.numbers.has_unknown_tables = root.has_unknown();
        file.read(root)
    }
}

/// The model with warnings of numbers that are hardly possible.
fn with_warnings(mut model: Model) -> Model {
    let found = model.implausible_numbers();
    model.warnings.extend(found);
    model
}

impl ModelReader {
    fn read(mut self, root: Table<'_>) -> Result<Model, Diagnostics> {
        if self.numbers.refuses_sizes(&root, &SIZES) {
            return Err(self.numbers.reader.diagnostics);
        }
        let Some(own) = ModelTable::of(&mut self, root) else { return Err(self.numbers.reader.diagnostics) };
        let name = own.name.unwrap_or_default();
        (self.leans, self.says_lean) = (own.lean == Some(Lean::Free), own.lean.is_some());
        if let Some(entry) = &own.parameter {
            self.numbers.read_parameters(entry);
        }
        if own.gravity.is_none() {
            self.miss_for_runs(&own.table, "gravity");
        }
        let gravity_m_s2 = self.numbers.quantity_or(&own.table, "gravity", 0.0).unwrap_or(UNREAD);
        self.has_temperature_rise = own.temperature_rise.is_some();
        self.temperature_rise_k = own.temperature_rise.and_then(|entry| self.numbers.quantity_at(&entry));
        for (entry, read) in [
            (&own.body, ModelReader::read_bodies as fn(&mut ModelReader, &Entry<'_>)),
            (&own.contact, ModelReader::read_contacts),
            (&own.joint, ModelReader::read_joints),
            (&own.coupling, ModelReader::read_couplings),
            (&own.cam, ModelReader::read_cams),
            (&own.spring, ModelReader::read_springs),
            (&own.load, ModelReader::read_loads),
            (&own.drive, ModelReader::read_drives),
            (&own.control, ModelReader::read_controls),
        ] {
            if let Some(entry) = entry {
                read(&mut self, entry);
            }
        }
        let guesses = own.assembly.map(|entry| self.read_guesses(&entry)).unwrap_or_default();
        let (mut initial, initial_offsets) =
            own.initial.as_ref().map(|entry| self.read_initial(entry)).unwrap_or_default();
        if own.initial.is_none() || (initial.is_empty() && !initial_offsets.is_empty()) {
            initial = self.initial_of_controls();
        }
        self.refuse_beside_beams();
        let cycle = own.cycle.and_then(|entry| self.read_cycle(&entry));
        let outputs = own.output.map(|entry| self.read_outputs(&entry)).unwrap_or_default();
        let wear = self.read_life(&own.wear, &outputs);
        self.take_laws_of_long_pins(wear.as_ref());
        self.refuse_measures_of_fixed_wear(&outputs, wear.as_ref());
        self.warn_of_unused();
        match cycle {
            Some(cycle) if !self.numbers.reader.diagnostics.has_errors() => Ok(with_warnings(Model {
                name,
                quantities: self.numbers.quantities,
                gravity_m_s2,
                leans: self.leans,
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
                asked_paths: Vec::new(),
                missing_for_runs: self.missing_for_runs,
                warnings: self.warnings,
                source: self.numbers.reader.source,
                tables: self.tables,
                places: self.numbers.places,
            })),
            // What looks unused may be so only because of an error, so warnings wait until there is none.
            _ => Err(self.numbers.reader.diagnostics),
        }
    }

    fn warn_of_unused(&mut self) {
        let contacts = self.contact_names.iter().map(|(name, _)| name);
        let unused_contacts = contacts.filter(|name| !self.used_contacts.contains(name));
        let mut paths: Vec<String> = unused_contacts.map(|name| format!("contact.{name}")).collect();
        paths.extend(self.numbers.parameters.unused().map(|name| format!("parameter.{name}")));
        if self.has_temperature_rise && !self.uses_temperature_rise {
            paths.push("temperature_rise".to_owned());
        }
        if self.numbers.places.contains_key("wear") && !self.uses_life {
            paths.push("wear".to_owned());
        }
        if !self.says_lean {
            let bodies = self.bodies.iter().filter(|body| body.offset_m.is_some());
            paths.extend(bodies.map(|body| format!("body.{}.offset", body.name)));
            let slides = |joint: &&Joint| joint.kind.pin_clearance().is_some_and(|pin| pin.axial_clearance_m.is_some());
            let joints = self.joints.iter().filter(slides);
            paths.extend(joints.map(|joint| format!("joint.{}.axial_clearance", joint.name)));
        }
        for path in paths {
            let written = self.numbers.quantities.id(&path).and_then(|id| self.numbers.quantities[id].span);
            let span = self.numbers.places.get(&path).copied().or(written);
            let place = span.map(|span| self.numbers.reader.place(span));
            let problem = EntryProblem::Unused { entry: describe_path(&path) };
            self.warnings.push(Diagnostic::warning(&problem, place));
        }
    }

    fn read_guesses(&mut self, entry: &Entry<'_>) -> Vec<Guess> {
        let Some(AssemblyTable { guess, .. }) = AssemblyTable::read(self, entry) else { return Vec::new() };
        let mut guesses = Vec::new();
        for entry in self.numbers.reader.any_keys(&guess) {
            let angle_rad = self.numbers.quantity_of(&entry, Dimension::ANGLE, Rule::Finite);
            match self.body(&entry.at_key(), entry.name) {
                Some(BodyId(0)) => self.numbers.reader.report(&ModelProblem::GuessOfGround, entry.key_span),
                Some(body) => guesses.extend(angle_rad.map(|angle_rad| Guess { body, angle_rad })),
                None => {}
            }
        }
        guesses
    }
}
