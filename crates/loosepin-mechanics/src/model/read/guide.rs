//! The play of a slider in its guide.

use super::reader::ModelReader;
use crate::contact::NormalDescription;
use crate::model::ids::ContactId;
use crate::model::problem::ModelProblem;
use crate::model::quantity::{Origin, QuantityId};
use crate::model::topology::{GuideClearance, SlidingVelocity, Stiffness};
use loosepin_text::document::Table;
use loosepin_text::units::{Dimension, Expression, Rule, run};

/// The key of the contact: a clearance needs it where the model is run, and not for the motion without dynamics.
const CONTACT: &str = "contact";

/// Keys of a joint kind that go with its clearance.
pub(super) struct PlayKeys {
    /// The key of the clearance.
    pub clearance: &'static str,
    /// Keys that a clearance above zero needs; the contact only where the model is run.
    pub needed: &'static [&'static str],
    /// All keys that have a meaning beside a clearance only.
    pub beside: &'static [&'static str],
}

impl ModelReader {
    /// The clearance of a prismatic joint; the outer option is absent after a complaint, the inner for an ideal joint.
    pub(super) fn guide_clearance(
        &mut self,
        table: &Table<'_>,
        ends_m: Option<[QuantityId; 2]>,
    ) -> Option<Option<GuideClearance>> {
        const KEYS: PlayKeys = PlayKeys {
            clearance: "clearance",
            needed: &["half_length", "half_height", "contact"],
            beside: &["half_length", "half_height", "contact", "corner_radius"],
        };
        let [half_length_m, half_height_m, corner_radius_m] =
            ["half_length", "half_height", "corner_radius"].map(|key| self.quantity(table, key));
        let contact = self.contact_of(table);
        let Some(clearance_m) = self.play_clearance(table, &KEYS)? else { return Some(None) };
        let contact = self.contact_of_play(table, contact)?;
        self.demand_flat_contact(table, contact, "a corner of a slider")?;
        if table.has(CONTACT) {
            self.demand_corner_radius(table, contact)?;
        }
        Some(Some(GuideClearance {
            half_length_m: half_length_m?,
            half_height_m: half_height_m?,
            clearance_m,
            corner_radius_m,
            ends_m,
            contact,
        }))
    }

    /// The ends of a guide; the outer option is absent after a complaint, the inner for a guide without ends.
    pub(super) fn guide_ends(&mut self, guide: &Table<'_>, has_clearance: bool) -> Option<Option<[QuantityId; 2]>> {
        const KEYS: [&str; 2] = ["start", "end"];
        let ends = KEYS.map(|key| self.quantity(guide, key));
        let (given, missing): (Vec<&'static str>, Vec<&'static str>) = KEYS.into_iter().partition(|key| guide.has(key));
        let Some(key) = given.first() else { return Some(None) };
        if !missing.is_empty() {
            self.complain_of_missing(guide, key, missing);
            return None;
        }
        if !has_clearance {
            self.complain_of_missing(guide, key, vec!["clearance"]);
            return None;
        }
        let [start, end] = [ends[0]?, ends[1]?];
        let span = guide.get("start").map_or(guide.span, |entry| entry.span);
        self.demand_order(start, end, span).then_some(Some([start, end]))
    }

    /// The clearance of a joint that may have play; the outer option is absent after a complaint, the inner for an ideal joint.
    pub(super) fn play_clearance(&mut self, table: &Table<'_>, keys: &PlayKeys) -> Option<Option<QuantityId>> {
        let is_missing = |key: &&'static str| *key != CONTACT && !table.has(key);
        let missing: Vec<&'static str> = keys.needed.iter().copied().filter(is_missing).collect();
        let has_no_contact = keys.needed.contains(&CONTACT) && !table.has(CONTACT);
        let Some(entry) = table.get(keys.clearance) else {
            if let Some(key) = keys.beside.iter().find(|key| table.has(key)) {
                self.complain_of_missing(table, key, vec![keys.clearance]);
                return None;
            }
            return Some(None);
        };
        let expression = self.expression_due(&entry, Dimension::LENGTH)?;
        if (!missing.is_empty() || has_no_contact) && is_literal_zero(&expression) {
            // An ideal joint: a clearance above zero would need what is missing, so this one cannot be set.
            self.add_with_origin(&entry, &expression, Rule::NonNegative, Origin::Fixed)?;
            return Some(None);
        }
        let clearance_m = self.add(&entry, &expression, Rule::NonNegative)?;
        if !missing.is_empty() {
            self.complain_of_missing(table, keys.clearance, missing);
            return None;
        }
        if has_no_contact {
            self.miss_for_runs(table, CONTACT);
        }
        Some(Some(clearance_m))
    }

    /// Complains where the contact is one that `what_touches`, on a plane, cannot have.
    pub(super) fn demand_flat_contact(
        &mut self,
        table: &Table<'_>,
        id: ContactId,
        what_touches: &'static str,
    ) -> Option<()> {
        let contact = &self.contacts[id.0];
        let is_literal =
            contact.friction.as_ref().is_some_and(|friction| friction.sliding_velocity == SlidingVelocity::Literal);
        let what = match contact.law {
            NormalDescription::Line(law) => Some(format!("the line-contact law '{}'", law.name)),
            _ if contact.film.is_some() => Some("a film of oil".to_owned()),
            _ => is_literal.then(|| "the literal reading of the sliding velocity".to_owned()),
        };
        if let Some(what) = what {
            let (entry, contact) = (table.path.describe(), contact.name.clone());
            let problem = ModelProblem::NotForPlanes { entry, contact, what, what_touches };
            return self.reader.refuse(&problem, table.get("contact").map_or(table.span, |entry| entry.span));
        }
        Some(())
    }

    /// The radius of the corners belongs to a stiffness from the materials, and to no other.
    fn demand_corner_radius(&mut self, table: &Table<'_>, id: ContactId) -> Option<()> {
        let is_of_materials = matches!(self.contacts[id.0].stiffness, Stiffness::Material { .. });
        match (is_of_materials, table.get("corner_radius")) {
            (true, None) => {
                self.complain_of_missing(table, "contact", vec!["corner_radius"]);
                None
            }
            (false, Some(_)) => {
                self.refuse_beside(table, "corner_radius", "stiffness");
                None
            }
            _ => Some(()),
        }
    }
}

fn is_literal_zero(expression: &Expression) -> bool {
    expression.reads.is_empty() && run(&expression.ops, &mut []) == 0.0
}
