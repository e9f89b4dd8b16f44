//! From the text of a file to a model in space, with all its diagnostics at once.

use super::assembly::SpatialAssemblyTable;
use super::body::{SpatialBodyTable, SpatialGroundTable};
use super::drive::{SpatialCycleTable, SpatialDriveTable};
use super::output::SpatialOutputTable;
use super::parts::SpatialModel;
use super::problem::SpatialModelProblem;
use super::reader::SpaceReader;
use crate::kind::JOINT_KINDS;
use loosepin_text::diagnostics::{Diagnostic, Diagnostics, Source};
use loosepin_text::document::{Entry, Kind, Table, describe_path, json_schema, parse_toml, quantity, read_source};
use loosepin_text::numbers::EntryProblem;
use loosepin_text::numbers::ReadsNumbers;
use loosepin_text::plausible::JudgedModel;
use loosepin_text::record;
use loosepin_text::units::{Dimension, Rule};
use std::path::Path;
use std::sync::Arc;

/// Tables of planar models that models in space do not have yet.
const PLANNED: &[(&str, &str)] = &[
    ("contact", "there are no runs in space yet, so nothing touches"),
    ("coupling", "gears, belts and racks are known in planar models"),
    ("cam", "cams are known in planar models"),
    ("spring", "springs are known in planar models"),
    ("load", "loads are known in planar models"),
    ("control", "controls are known in planar models"),
    ("initial", "there are no runs in space yet; the drives determine the motion"),
    ("wear", "wear is known in planar models"),
    ("temperature_rise", "warm parts are known in planar models"),
];

record! {
    /// a mechanism in space with its nominal values
    struct SpatialModelTable for ReadsNumbers, planned PLANNED;
    /// name of the mechanism
    required name: Option<String> = Kind::Text, "\"spatial slider-crank\"";
    /// "space" for a mechanism in space
    required geometry: Entry<'t> = Kind::Choice(&["space"]), "\"space\"";
    /// acceleration of gravity along x, y and z; not used yet
    optional gravity: Entry<'t> =
        Kind::Three(&quantity(Dimension::ACCELERATION, Rule::Finite)), "[\"0 m/s^2\", \"0 m/s^2\", \"-9.81 m/s^2\"]";
    /// named values for use in expressions
    optional parameter: Entry<'t> = Kind::Values(&Kind::AnyQuantity), "";
    /// the bodies, each under [body.NAME]
    required body: Option<Entry<'t>> =
        Kind::Tables { keys: &SpatialBodyTable::KEYS, except: &[("ground", &SpatialGroundTable::KEYS)] }, "";
    /// the joints, each under [joint.NAME]
    optional joint: Entry<'t> = Kind::TaggedTables { tag: "kind", variants: JOINT_KINDS }, "";
    /// the drives, each under [drive.NAME]
    optional drive: Entry<'t> = Kind::Tables { keys: &SpatialDriveTable::KEYS, except: &[] }, "";
    /// where bodies are at the start
    optional assembly: Entry<'t> = Kind::Table(&SpatialAssemblyTable::KEYS), "";
    /// the turn over which the mechanism is moved
    optional cycle: Entry<'t> = Kind::Table(&SpatialCycleTable::KEYS), "";
    /// the outputs, in their order
    optional output: Entry<'t> = Kind::Tables { keys: &SpatialOutputTable::KEYS, except: &[] }, "";
}

/// Moving bodies, at most: loop equations are solved densely.
const MAX_BODIES: usize = 60;
/// Joints, at most.
const MAX_JOINTS: usize = 120;
/// Entries of each other table, at most.
const MAX_ENTRIES: usize = 100;

/// Tables, what their entries are called, and how many there may be.
const SIZES: [(&str, &str, usize); 4] = [
    ("body", "moving bodies", MAX_BODIES),
    ("joint", "joints", MAX_JOINTS),
    ("drive", "drives", MAX_ENTRIES),
    ("output", "outputs", MAX_ENTRIES),
];

/// The JSON Schema of a model in space, for editors.
pub fn spatial_model_schema() -> serde_json::Value {
    json_schema("loosepin model in space", &SpatialModelTable::KEYS)
}

/// Whether a file says that it is a model in space: `geometry = "space"` at its top. False for what is no TOML.
pub fn is_spatial(source: &Arc<Source>) -> bool {
    let Ok(toml) = parse_toml(source) else { return false };
    toml.get_ref().get("geometry").is_some_and(|value| value.get_ref().as_str() == Some("space"))
}

impl SpatialModel {
    /// Reads a model file.
    ///
    /// # Errors
    /// Everything that is wrong with the file, each with its place.
    pub fn from_path(path: &Path) -> Result<SpatialModel, Diagnostics> {
        SpatialModel::from_source(&read_source(path)?)
    }

    /// Reads a model from text that is reported as `name`.
    ///
    /// # Errors
    /// As [`SpatialModel::from_path`].
    pub fn from_text(name: &str, text: &str) -> Result<SpatialModel, Diagnostics> {
        SpatialModel::from_source(&Source::new(name, text))
    }

    /// Reads a model from a text with its name.
    ///
    /// # Errors
    /// As [`SpatialModel::from_path`].
    pub fn from_source(source: &Arc<Source>) -> Result<SpatialModel, Diagnostics> {
        let toml = parse_toml(source)?;
        let mut file = SpaceReader::new(source);
        let root = file.numbers.reader.root(toml.get_ref(), &SpatialModelTable::KEYS);
        file.numbers.has_unknown_tables = root.has_unknown();
        file.read(root)
    }
}

impl SpaceReader {
    fn read(mut self, root: Table<'_>) -> Result<SpatialModel, Diagnostics> {
        if self.numbers.refuses_sizes(&root, &SIZES) {
            return Err(self.numbers.reader.diagnostics);
        }
        let Some(own) = SpatialModelTable::of(&mut self, root) else { return Err(self.numbers.reader.diagnostics) };
        self.check_geometry(&own.geometry);
        if let Some(entry) = &own.parameter {
            self.numbers.read_parameters(entry);
        }
        let gravity_m_s2 = own.gravity.and_then(|entry| self.numbers.three(&entry, Dimension::ACCELERATION));
        for (entry, read) in [
            (&own.body, SpaceReader::read_bodies as fn(&mut SpaceReader, &Entry<'_>)),
            (&own.joint, SpaceReader::read_joints),
            (&own.drive, SpaceReader::read_drives),
        ] {
            if let Some(entry) = entry {
                read(&mut self, entry);
            }
        }
        let guesses = own.assembly.map(|entry| self.read_guesses(&entry)).unwrap_or_default();
        let cycle = own.cycle.and_then(|entry| self.read_cycle(&entry));
        let outputs = own.output.map(|entry| self.read_outputs(&entry)).unwrap_or_default();
        self.warn_of_unused();
        if self.numbers.reader.diagnostics.has_errors() {
            return Err(self.numbers.reader.diagnostics);
        }
        let mut model = SpatialModel {
            name: own.name.unwrap_or_default(),
            quantities: self.numbers.quantities,
            gravity_m_s2,
            bodies: self.bodies,
            joints: self.joints,
            drives: self.drives,
            guesses,
            cycle,
            outputs,
            warnings: self.warnings,
            source: self.numbers.reader.source,
            places: self.numbers.places,
        };
        // Directions of length zero and the like, at their places.
        let values = model.quantities.nominal();
        model.mechanism(&values).map_err(|error| model.diagnostic(&error))?;
        for output in 0..model.outputs.len() {
            model.outputs_of(output, &values).map_err(|error| model.diagnostic(&error))?;
        }
        let hardly_possible = model.implausible_numbers();
        model.warnings.extend(hardly_possible);
        Ok(model)
    }

    fn check_geometry(&mut self, entry: &Entry<'_>) {
        let Some(found) = self.numbers.reader.text(entry) else { return };
        if found != "space" {
            let problem = SpatialModelProblem::NotSpace { found: found.to_owned() };
            self.numbers.reader.report(&problem, entry.span);
        }
    }

    fn warn_of_unused(&mut self) {
        let paths: Vec<String> = self.numbers.parameters.unused().map(|name| format!("parameter.{name}")).collect();
        for path in paths {
            let place = self.numbers.places.get(&path).map(|span| self.numbers.reader.place(*span));
            let problem = EntryProblem::Unused { entry: describe_path(&path) };
            self.warnings.push(Diagnostic::warning(&problem, place));
        }
    }
}
