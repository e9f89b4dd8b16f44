//! Reading springs.

use super::reader::ModelReader;
use crate::model::keys::spring::SPRING_KINDS;
use crate::model::problem::ModelProblem;
use crate::model::spring::{Elasticity, Spring, SpringKind};
use crate::model::table_curve::TableCurve;
use loosepin_text::document::{Entry, Table};
use loosepin_text::units::Dimension;

impl ModelReader {
    /// Reads the table of springs.
    pub fn read_springs(&mut self, entry: &Entry<'_>) {
        for entry in self.reader.named(entry, "a spring") {
            self.remember(&entry);
            let spring = self.spring(&entry);
            self.springs.extend(spring);
        }
    }

    fn spring(&mut self, entry: &Entry<'_>) -> Option<Spring> {
        let (kind, table) = self.table_of_kind(entry, SPRING_KINDS)?;
        let is_linear = kind == "linear";
        let kind = if is_linear { self.linear_spring(&table) } else { self.torsional_spring(&table) };
        let elasticity = self.elasticity(&table, is_linear);
        let damping = self.quantity(&table, "damping");
        let kind = kind?;
        let [first, second] = kind.bodies();
        if first == second {
            let body = self.bodies[first.0].name.clone();
            return self.reader.refuse(&ModelProblem::SameBody { entry: entry.path.describe(), body }, entry.key_span);
        }
        Some(Spring { name: entry.name.to_owned(), kind, elasticity: elasticity?, damping })
    }

    fn elasticity(&mut self, table: &Table<'_>, is_linear: bool) -> Option<Elasticity> {
        let free_key = if is_linear { "free_length" } else { "free_angle" };
        let Some(key) = ["points", "csv"].into_iter().find(|key| table.has(key)) else {
            self.refuse_beside(table, "curve", "stiffness");
            let stiffness = self.quantity(table, "stiffness");
            let free = self.quantity(table, free_key);
            let preload = self.quantity_or(table, "preload", 0.0);
            return Some(Elasticity::Linear { stiffness: stiffness?, free: free?, preload: preload? });
        };
        self.refuse_beside(table, "preload", key);
        let curve = self.reader.choice_or(table, "curve", &TableCurve::WORDS, TableCurve::Monotone);
        let columns = if is_linear {
            [("length", Dimension::LENGTH), ("force", Dimension::FORCE)]
        } else {
            [("angle", Dimension::ANGLE), ("torque", Dimension::TORQUE)]
        };
        let points = self.table_points(table, columns)?;
        Some(Elasticity::Table { points, curve: curve? })
    }

    fn linear_spring(&mut self, table: &Table<'_>) -> Option<SpringKind> {
        let [first, second] = ["first", "second"].map(|key| table.get(key).and_then(|entry| self.point(&entry)));
        Some(SpringKind::Linear { first: first?, second: second? })
    }

    fn torsional_spring(&mut self, table: &Table<'_>) -> Option<SpringKind> {
        let entry = table.path.describe();
        let Some(joint_entry) = table.get("joint") else {
            let missing: Vec<&'static str> = ["first", "second"].into_iter().filter(|key| !table.has(key)).collect();
            if !missing.is_empty() {
                return self.reader.refuse(&ModelProblem::NoBodies { entry }, table.span);
            }
            let [first, second] = ["first", "second"].map(|key| {
                let entry = table.get(key)?;
                let name = self.reader.text(&entry)?.to_owned();
                self.body(&entry, &name)
            });
            return Some(SpringKind::Torsional { first: first?, second: second? });
        };
        for key in ["first", "second"] {
            self.refuse_beside(table, key, "joint");
        }
        let joint = self.joint(&joint_entry)?;
        let kind = &self.joints[joint.0].kind;
        if kind.turns() {
            let [first, second] = kind.bodies();
            return Some(SpringKind::Torsional { first, second });
        }
        let name = self.joints[joint.0].name.clone();
        self.reader.refuse(&ModelProblem::DoesNotTurn { entry, joint: name }, joint_entry.span)
    }
}
