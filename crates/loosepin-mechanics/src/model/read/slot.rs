//! A pin in a slot.

use super::guide::PlayKeys;
use super::joint::clearance_span;
use super::reader::ModelReader;
use crate::model::keys::SLOT_LINE_KEYS;
use crate::model::topology::{JointKind, SlotClearance};
use loosepin_text::document::Table;

impl ModelReader {
    /// Reads a pin in a slot.
    pub(super) fn slot(&mut self, table: &Table<'_>) -> Option<JointKind> {
        let slot = table.get("slot").and_then(|entry| {
            let slot = self.reader.table(&entry, &SLOT_LINE_KEYS)?;
            let point = slot.get("point").and_then(|entry| self.point(&entry));
            let angle_rad = self.quantity(&slot, "angle");
            Some((point?, angle_rad?))
        });
        let pin = table.get("pin").and_then(|entry| self.point(&entry));
        let clearance = self.slot_clearance(table);
        let ((slot, slot_angle_rad), pin) = (slot?, pin?);
        let clearance = match clearance? {
            Some(cold) => {
                let span = clearance_span(table, &["clearance"]);
                Some(self.warm_slot(cold, [slot.body, pin.body], span)?)
            }
            None => None,
        };
        Some(JointKind::Slot { slot, slot_angle_rad, pin, clearance })
    }

    /// The outer option is absent after a complaint, the inner for an ideal joint.
    fn slot_clearance(&mut self, table: &Table<'_>) -> Option<Option<SlotClearance>> {
        const NEEDED: &[&str] = &["half_length", "end_radius", "contact"];
        const KEYS: PlayKeys = PlayKeys { clearance: "clearance", needed: NEEDED, beside: NEEDED };
        let [half_length_m, end_radius_m] = ["half_length", "end_radius"].map(|key| self.quantity(table, key));
        let contact = self.contact_of(table);
        let Some(clearance_m) = self.play_clearance(table, &KEYS)? else { return Some(None) };
        let contact = self.contact_of_play(table, contact);
        let (half_length_m, end_radius_m, contact) = (half_length_m?, end_radius_m?, contact?);
        let span = table.get("clearance").map_or(table.span, |entry| entry.span);
        if !self.demand_order(clearance_m, end_radius_m, span) {
            return None;
        }
        self.demand_flat_contact(table, contact, "a pin on the flat face of a slot")?;
        Some(Some(SlotClearance { half_length_m, end_radius_m, clearance_m, contact }))
    }
}
