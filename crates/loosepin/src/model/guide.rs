//! The play of a slider in its guide.

use super::file::ModelReader;
use super::joint::is_literal_zero;
use super::problem::ModelProblem;
use super::quantity::Origin;
use super::topology::{ContactId, GuideClearance, SlidingVelocity, Stiffness};
use crate::contact::NormalDescription;
use crate::document::Table;
use crate::units::{Dimension, Rule};

/// What a joint with play needs beside the clearance.
const NEEDED: [&str; 3] = ["half_length", "half_height", "contact"];

impl ModelReader {
    /// The clearance of a prismatic joint; the outer option is absent after a complaint, the inner for an ideal joint.
    pub(super) fn guide_clearance(&mut self, table: &Table<'_>) -> Option<Option<GuideClearance>> {
        let [half_length_m, half_height_m, corner_radius_m] =
            ["half_length", "half_height", "corner_radius"].map(|key| self.quantity(table, key));
        let contact = self.contact_of(table);
        let missing: Vec<&'static str> = NEEDED.into_iter().filter(|key| !table.has(key)).collect();
        let Some(entry) = table.get("clearance") else {
            if let Some(key) = NEEDED.into_iter().chain(["corner_radius"]).find(|key| table.has(key)) {
                self.complain_of_missing(table, key, vec!["clearance"]);
                return None;
            }
            return Some(None);
        };
        let expression = self.expression(&entry)?;
        if !self.reader.measures(&entry, expression.dimension, Dimension::LENGTH) {
            return None;
        }
        if !missing.is_empty() && is_literal_zero(&expression) {
            // An ideal joint: a clearance above zero would need what is missing, so this one cannot be set.
            self.add_with_origin(&entry, &expression, Rule::NonNegative, Origin::Fixed)?;
            return Some(None);
        }
        let clearance_m = self.add(&entry, &expression, Rule::NonNegative)?;
        if !missing.is_empty() {
            self.complain_of_missing(table, "clearance", missing);
            return None;
        }
        let contact = contact?;
        self.demand_corner_contact(table, contact)?;
        Some(Some(GuideClearance {
            half_length_m: half_length_m?,
            half_height_m: half_height_m?,
            clearance_m,
            corner_radius_m,
            contact,
        }))
    }

    /// Complains where the contact is one that a corner on a plane cannot have.
    fn demand_corner_contact(&mut self, table: &Table<'_>, id: ContactId) -> Option<()> {
        let contact = &self.contacts[id.0];
        let is_literal =
            contact.friction.as_ref().is_some_and(|friction| friction.sliding_velocity == SlidingVelocity::Literal);
        let what = match contact.law {
            NormalDescription::Line(law) => Some(format!("the line-contact law '{}'", law.name())),
            _ => is_literal.then(|| "the literal reading of the sliding velocity".to_owned()),
        };
        if let Some(what) = what {
            let problem =
                ModelProblem::NotForCorners { entry: table.path.describe(), contact: contact.name.clone(), what };
            self.reader.complain(&problem, table.get("contact").map_or(table.span, |entry| entry.span));
            return None;
        }
        let is_of_materials = matches!(contact.stiffness, Stiffness::Material { .. });
        match (is_of_materials, table.get("corner_radius")) {
            (true, None) => {
                self.complain_of_missing(table, "contact", vec!["corner_radius"]);
                None
            }
            (false, Some(entry)) => {
                let words = table.path.describe();
                let problem =
                    ModelProblem::KeyWithoutEffect { entry: words, key: "corner_radius", beside: "stiffness" };
                self.reader.complain(&problem, entry.key_span);
                None
            }
            _ => Some(()),
        }
    }

    fn complain_of_missing(&mut self, table: &Table<'_>, key: &'static str, needs: Vec<&'static str>) {
        let problem = ModelProblem::NeedsKeys { entry: table.path.describe(), key, needs };
        self.reader.complain(&problem, table.get(key).map_or(table.span, |entry| entry.key_span));
    }
}
