//! Bodies and their points.

use super::reader::ModelReader;
use crate::model::ids::BodyId;
use crate::model::keys::{BODY_KEYS, GROUND_KEYS};
use crate::model::quantity::{QuantityId, UNREAD};
use crate::model::topology::{Body, Point};
use loosepin_text::document::{DocumentProblem, Entry, Table};

/// What a rigid body needs to be run.
const MASS_KEYS: [&str; 3] = ["mass", "inertia", "centre_of_mass"];

impl ModelReader {
    /// Reads the table of bodies.
    pub fn read_bodies(&mut self, entry: &Entry<'_>) {
        for entry in self.reader.named(entry, "a body") {
            self.remember(&entry);
            if entry.name == "ground" {
                if let Some(table) = self.reader.table(&entry, &GROUND_KEYS) {
                    let elongation = self.elongation(&table);
                    self.elongations.extend(elongation.map(|id| (BodyId(0), id)));
                    self.bodies[0].points = self.points(&table, elongation);
                }
                continue;
            }
            // A body that could not be read keeps its name, so that joints are not complained about as well.
            let mut body = Body {
                name: entry.name.to_owned(),
                mass_kg: Some(UNREAD),
                inertia_kg_m2: Some(UNREAD),
                centre_of_mass_m: Some([UNREAD; 2]),
                points: Vec::new(),
                beam: None,
            };
            let id = BodyId(self.bodies.len());
            if let Some(table) = self.reader.table(&entry, &BODY_KEYS) {
                let elongation = self.elongation(&table);
                self.elongations.extend(elongation.map(|elongation| (id, elongation)));
                body.mass_kg = self.quantity(&table, "mass");
                let inertia = self.quantity(&table, "inertia");
                body.inertia_kg_m2 = inertia.map(|inertia| self.times_grown(inertia, elongation, 2));
                let centre = table.get("centre_of_mass").map(|entry| self.vector(&entry));
                body.centre_of_mass_m = centre.map(|centre| centre.map(|length| self.grown(length, elongation)));
                body.points = self.points(&table, elongation);
                if table.get("beam").is_none() {
                    for key in MASS_KEYS.into_iter().filter(|key| !table.has(key)) {
                        self.miss_for_runs(&table, key);
                    }
                }
                if let Some(entry) = table.get("beam") {
                    for key in MASS_KEYS {
                        self.refuse_both(&table, [key, "beam"]);
                    }
                    self.refuse_beside(&table, "thermal_expansion", "beam");
                    self.beam(&entry, &mut body);
                }
                if table.get("points").is_some_and(|points| !points.is_table()) {
                    self.without_points.insert(id);
                }
            } else {
                self.without_points.insert(id);
            }
            self.body_of_name.insert(body.name.clone(), id);
            self.bodies.push(body);
        }
    }

    /// Complains where two keys stand of which each excludes the other.
    fn refuse_both(&mut self, table: &Table<'_>, keys: [&'static str; 2]) {
        if let Some(entry) = table.get(keys[1]).filter(|_| table.has(keys[0])) {
            let (table, given) = (table.path.describe(), keys.to_vec());
            self.reader
                .complain(&DocumentProblem::MoreThanOneOf { table, given: given.clone(), keys: given }, entry.key_span);
        }
    }

    fn points(&mut self, table: &Table<'_>, elongation: Option<QuantityId>) -> Vec<Point> {
        let Some(entry) = table.get("points") else { return Vec::new() };
        let mut points = Vec::new();
        for entry in self.reader.named(&entry, "a point") {
            self.remember(&entry);
            let position_m = self.vector(&entry).map(|length| self.grown(length, elongation));
            points.push(Point { name: entry.name.to_owned(), position_m });
        }
        points
    }
}
