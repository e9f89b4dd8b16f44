//! Bodies and their points.

use super::reader::{ModelReader, UNREAD};
use crate::model::ids::BodyId;
use crate::model::keys::{BODY_KEYS, GROUND_KEYS};
use crate::model::topology::{Body, Point};
use loosepin_text::document::{Entry, Table};

impl ModelReader {
    /// Reads the table of bodies.
    pub fn read_bodies(&mut self, entry: &Entry<'_>) {
        for entry in self.reader.named(entry, "a body") {
            self.remember(&entry);
            if entry.name == "ground" {
                if let Some(table) = self.reader.table(&entry, &GROUND_KEYS) {
                    self.bodies[0].points = self.points(&table);
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
            };
            if let Some(table) = self.reader.table(&entry, &BODY_KEYS) {
                body.mass_kg = self.quantity(&table, "mass");
                body.inertia_kg_m2 = self.quantity(&table, "inertia");
                body.centre_of_mass_m = table.get("centre_of_mass").map(|entry| self.vector(&entry));
                body.points = self.points(&table);
            }
            self.body_of_name.insert(body.name.clone(), BodyId(self.bodies.len()));
            self.bodies.push(body);
        }
    }

    fn points(&mut self, table: &Table<'_>) -> Vec<Point> {
        let Some(entry) = table.get("points") else { return Vec::new() };
        let mut points = Vec::new();
        for entry in self.reader.named(&entry, "a point") {
            self.remember(&entry);
            points.push(Point { name: entry.name.to_owned(), position_m: self.vector(&entry) });
        }
        points
    }
}
