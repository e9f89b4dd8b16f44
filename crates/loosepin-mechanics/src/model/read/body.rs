//! Bodies and their points.

use super::reader::ModelReader;
use super::warm::ThermalTable;
use crate::model::ids::BodyId;
use crate::model::part_reader::PartReader;
use crate::model::parts::topology::{Body, Point};
use crate::model::read::beams::beam::BeamTable;
use loosepin_text::document::{DocumentProblem, Entry, Kind, Table, quantity};
use loosepin_text::numbers::{QuantityId, UNREAD};
use loosepin_text::record;
use loosepin_text::units::{Dimension as D, Rule};

/// Named points.
const POINTS: Kind = Kind::Values(&Kind::Vector);

record! {
    /// where a body lies out of the plane
    pub(super) struct LayerTable for PartReader;
    /// how far the plane of the body lies above that of the drawing; matters where pins lean
    optional offset: Entry<'t> = quantity(D::LENGTH, Rule::Finite), "\"12 mm\"";
}

record! {
    /// the ground: points that do not move
    pub(super) struct GroundTable for PartReader;
    /// named points in the frame of the body
    optional points: Entry<'t> = POINTS, "{ o = [\"0 mm\", \"0 mm\"] }";
    include layer: LayerTable<'t>;
    include warmth: ThermalTable<'t>;
}

record! {
    /// a body: rigid with mass, inertia and centre of mass, or a flexible beam
    pub(super) struct BodyTable for PartReader;
    /// mass of a rigid body; needed for runs
    optional mass: Entry<'t> = quantity(D::MASS, Rule::Positive), "\"0.3 kg\"";
    /// moment of inertia about the centre of mass; needed for runs
    optional inertia: Entry<'t> = quantity(D::INERTIA, Rule::Positive), "\"1e-4 kg m^2\"";
    /// centre of mass in the frame of the body; needed for runs
    optional centre_of_mass: Entry<'t> = Kind::Vector, "[\"25 mm\", \"0 mm\"]";
    /// named points in the frame of the body
    optional points: Entry<'t> = POINTS, "{ pin = [\"50 mm\", \"0 mm\"] }";
    /// a beam that bends and stretches, under [body.NAME.beam]
    optional beam: Entry<'t> = Kind::Table(&BeamTable::KEYS), "";
    include layer: LayerTable<'t>;
    include warmth: ThermalTable<'t>;
}

/// What a rigid body needs to be run.
const MASS_KEYS: [&str; 3] = ["mass", "inertia", "centre_of_mass"];

impl ModelReader {
    /// Reads the table of bodies.
    pub fn read_bodies(&mut self, entry: &Entry<'_>) {
        for entry in self.numbers.reader.named(entry, "a body") {
            self.numbers.remember(&entry);
            if entry.name == "ground" {
                if let Some(own) = GroundTable::read(self, &entry) {
                    let elongation = self.elongation(&own.warmth);
                    self.elongations.extend(elongation.map(|id| (BodyId(0), id)));
                    self.bodies[0].offset_m = self.offset_m(&own.layer);
                    self.bodies[0].points = self.points(&own.points, elongation);
                }
                continue;
            }
            // A body that could not be read keeps its name, so that joints are not reported as well.
            let mut body = Body {
                name: entry.name.to_owned(),
                mass_kg: Some(UNREAD),
                inertia_kg_m2: Some(UNREAD),
                centre_of_mass_m: Some([UNREAD; 2]),
                offset_m: None,
                points: Vec::new(),
                beam: None,
            };
            let id = BodyId(self.bodies.len());
            if let Some(own) = BodyTable::read(self, &entry) {
                let table = &own.table;
                let elongation = self.elongation(&own.warmth);
                self.elongations.extend(elongation.map(|elongation| (id, elongation)));
                body.mass_kg = own.mass.as_ref().and_then(|entry| self.numbers.quantity_at(entry));
                let inertia = own.inertia.as_ref().and_then(|entry| self.numbers.quantity_at(entry));
                body.inertia_kg_m2 = inertia.map(|inertia| self.thermally_scaled(inertia, elongation, 2));
                let centre = own.centre_of_mass.as_ref().map(|entry| self.vector(entry));
                body.centre_of_mass_m =
                    centre.map(|centre| centre.map(|length| self.thermally_expanded(length, elongation)));
                body.offset_m = self.offset_m(&own.layer);
                body.points = self.points(&own.points, elongation);
                if let Some(entry) = &own.beam {
                    for key in MASS_KEYS {
                        self.refuse_both(table, [key, "beam"]);
                    }
                    self.numbers.refuse_beside(table, "thermal_expansion", "beam");
                    self.beam(entry, &mut body);
                } else {
                    for key in MASS_KEYS.into_iter().filter(|key| !table.has(key)) {
                        self.miss_for_runs(table, key);
                    }
                }
                if own.points.is_some_and(|points| !points.is_table()) {
                    self.without_points.insert(id);
                }
            } else {
                self.without_points.insert(id);
            }
            self.body_of_name.insert(body.name.clone(), id);
            self.bodies.push(body);
        }
    }

    /// Reports where two keys stand of which each excludes the other.
    fn refuse_both(&mut self, table: &Table<'_>, keys: [&'static str; 2]) {
        if let Some(entry) = table.get(keys[1]).filter(|_| table.has(keys[0])) {
            let (table, given) = (table.path.describe(), keys.to_vec());
            self.numbers
                .reader
                .report(&DocumentProblem::MoreThanOneOf { table, given: given.clone(), keys: given }, entry.key_span);
        }
    }

    fn offset_m(&mut self, own: &LayerTable<'_>) -> Option<QuantityId> {
        own.offset.as_ref().and_then(|entry| self.numbers.quantity_at(entry))
    }

    fn points(&mut self, entry: &Option<Entry<'_>>, elongation: Option<QuantityId>) -> Vec<Point> {
        let Some(entry) = entry else { return Vec::new() };
        let mut points = Vec::new();
        for entry in self.numbers.reader.named(entry, "a point") {
            self.numbers.remember(&entry);
            let position_m = self.vector(&entry).map(|length| self.thermally_expanded(length, elongation));
            points.push(Point { name: entry.name.to_owned(), position_m });
        }
        points
    }
}
