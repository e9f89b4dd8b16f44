//! The clearance of a joint or coupling that may have play.

use super::reader::ModelReader;
use crate::model::ids::ContactId;
use crate::model::joint::PlayKeys;
use crate::model::problem::ModelProblem;
use loosepin_text::document::Table;
use loosepin_text::numbers::{Origin, QuantityId};
use loosepin_text::units::{Dimension, Expression, Rule, run};

/// The key of the contact: a clearance needs it where the model is run, and not for the motion without dynamics.
const CONTACT: &str = "contact";

impl ModelReader {
    /// The clearance of a joint that may have play; the outer option is absent after a diagnostic, the inner for an ideal joint.
    pub(super) fn play_clearance(&mut self, table: &Table<'_>, keys: &PlayKeys) -> Option<Option<QuantityId>> {
        let is_missing = |key: &&'static str| *key != CONTACT && !table.has(key);
        let has_no_contact = keys.needed.contains(&CONTACT) && !table.has(CONTACT);
        let is_for_runs = has_no_contact && self.elongations.is_empty();
        let needed = keys.needed.iter().chain(keys.with_contact.iter().filter(|_| !is_for_runs));
        let missing: Vec<&'static str> = needed.copied().filter(is_missing).collect();
        let Some(entry) = table.get(keys.clearance) else {
            if let Some(key) = keys.beside.iter().find(|key| table.has(key)) {
                self.numbers.report_missing(table, key, vec![keys.clearance]);
                return None;
            }
            return Some(None);
        };
        let expression = self.numbers.expression_due(&entry, Dimension::LENGTH)?;
        if (!missing.is_empty() || has_no_contact) && is_literal_zero(&expression) {
            // An ideal joint: a clearance above zero would need what is missing, so this one cannot be set.
            self.numbers.add_with_origin(&entry, &expression, Rule::NonNegative, Origin::Fixed)?;
            return Some(None);
        }
        let clearance_m = self.numbers.add(&entry, &expression, Rule::NonNegative)?;
        if !missing.is_empty() {
            self.numbers.report_missing(table, keys.clearance, missing);
            return None;
        }
        for key in keys.with_contact.iter().chain([&CONTACT].into_iter().filter(|_| has_no_contact)) {
            if !table.has(key) {
                self.miss_for_runs(table, key);
            }
        }
        Some(Some(clearance_m))
    }

    /// Reports where the contact is one that `what_touches`, on a plane, cannot have.
    pub(super) fn demand_flat_contact(
        &mut self,
        table: &Table<'_>,
        id: ContactId,
        what_touches: &'static str,
    ) -> Option<()> {
        let contact = &self.contacts[id.0];
        let what = match contact.law.line() {
            Some(law) => Some(format!("the line-contact law '{}'", law.name)),
            _ if contact.film.is_some() => Some("a film of oil".to_owned()),
            _ => contact.is_literal().then(|| "the literal reading of the sliding velocity".to_owned()),
        };
        if let Some(what) = what {
            let (entry, contact) = (table.path.describe(), contact.name.clone());
            let problem = ModelProblem::NotForPlanes { entry, contact, what, what_touches };
            return self.numbers.reader.refuse(&problem, table.get("contact").map_or(table.span, |entry| entry.span));
        }
        Some(())
    }
}

fn is_literal_zero(expression: &Expression) -> bool {
    expression.reads.is_empty() && run(&expression.ops, &mut []) == 0.0
}
