//! A pin slides and turns in a straight slot with round ends; with a clearance it has play.

use super::clearance::SlotClearance;
use super::kind::{AtBeam, KindOfJoint, NotDriven, PlayParts, TreeAttachment};
use super::reading::{JointReader, PlayKeys, span_of};
use super::row::PlaneRow;
use crate::model::ids::{BodyId, ContactId, PointId};
use crate::model::words::part_names::Names;
use loosepin_text::diagnostics::Span;
use loosepin_text::document::{Entry, Keys, Kind, Table, quantity};
use loosepin_text::numbers::QuantityId;
use loosepin_text::record;
use loosepin_text::units::{Dimension, Dimension as D, Rule};

/// The pin's centre stays on a line fixed to the slot's body, and turns there; with a clearance, it may leave the line and
/// touch the round ends. Coordinate s as for a prismatic joint.
#[derive(Debug, Clone)]
pub struct Slot {
    /// Middle of the slot.
    pub slot: PointId,
    /// Angle of its line from the x axis of its body, rad.
    pub slot_angle_rad: QuantityId,
    /// Centre of the pin.
    pub pin: PointId,
    /// Absent for an ideal joint, which has no ends.
    pub clearance: Option<SlotClearance>,
}

impl KindOfJoint for Slot {
    const WORD: &'static str = SlotTable::WORD;
    const KEYS: &'static Keys = &SlotTable::KEYS;
    const COORDINATE: Option<Dimension> = Some(Dimension::LENGTH);
    // In the tree it would have two coordinates; cut, it is one constraint.
    const TREE_ATTACHMENT: TreeAttachment = TreeAttachment::Never;
    const ROWS: &'static [PlaneRow] = &[PlaneRow::OnLine];
    const AT_BEAM: AtBeam = AtBeam::Refused("slot joint");

    fn read(table: &Table<'_>, reader: &mut dyn JointReader) -> Option<Self> {
        let own = SlotTable::of(reader, table.clone())?;
        let clearance = clearance(&own, reader);
        let (SlotLine { point: slot, angle: slot_angle_rad, .. }, pin) = (own.slot?, own.pin?);
        let clearance = match clearance? {
            Some(cold) => Some(warm(cold, [slot.body, pin.body], span_of(&own.clearance, table), reader)?),
            None => None,
        };
        Some(Self { slot, slot_angle_rad, pin, clearance })
    }

    fn points(&self) -> [PointId; 2] {
        [self.slot, self.pin]
    }

    fn angles_rad(&self) -> [Option<QuantityId>; 2] {
        [Some(self.slot_angle_rad), None]
    }

    fn play_parts(&self) -> Option<PlayParts<'_>> {
        let clearance = self.clearance.as_ref()?;
        Some(PlayParts::Slot { clearance, slot_angle_rad: self.slot_angle_rad })
    }

    fn why_not_driven(&self, _is_zero: &dyn Fn(QuantityId) -> bool) -> Option<NotDriven> {
        Some(NotDriven::because("is a slot"))
    }

    fn words(&self, names: &dyn Names) -> String {
        format!(
            "slot: {} slides and turns in a slot through {} at {}",
            names.point(self.pin),
            names.point(self.slot),
            names.angle(names.value_si(self.slot_angle_rad))
        )
    }

    fn play_words(&self, names: &dyn Names) -> Option<String> {
        let own = self.clearance.as_ref()?;
        let [clearance, half_length, radius] =
            [own.clearance_m, own.half_length_m, own.end_radius_m].map(|id| names.length(id));
        Some(format!(
            "play: clearance {clearance} on each side in a slot with round ends of radius {radius}, their centres {half_length} from its middle"
        ))
    }
}

/// The clearance; the outer option is absent after a diagnostic, the inner for an ideal joint.
fn clearance(own: &SlotTable<'_>, reader: &mut dyn JointReader) -> Option<Option<SlotClearance>> {
    const NEEDED: &[&str] = &["half_length", "end_radius", "contact"];
    const PLAY_KEYS: PlayKeys = PlayKeys { clearance: "clearance", needed: NEEDED, with_contact: &[], beside: NEEDED };
    let Some(clearance_m) = reader.play_clearance(&own.table, &PLAY_KEYS)? else { return Some(None) };
    let contact = own.contact.unwrap_or_else(|| Some(reader.no_contact()))?;
    let (half_length_m, end_radius_m) = (own.half_length.flatten()?, own.end_radius.flatten()?);
    if !reader.demand_order(clearance_m, end_radius_m, span_of(&own.clearance, &own.table)) {
        return None;
    }
    reader.demand_flat_contact(&own.table, contact, "a pin on the flat face of a slot")?;
    Some(Some(SlotClearance { half_length_m, end_radius_m, clearance_m, contact }))
}

/// The clearance with slot and pin as warm as their bodies.
fn warm(cold: SlotClearance, bodies: [BodyId; 2], span: Span, reader: &mut dyn JointReader) -> Option<SlotClearance> {
    let clearance_m = reader.warm_clearance(cold.clearance_m, &[cold.end_radius_m], bodies, span)?;
    let [half_length_m, end_radius_m] =
        [cold.half_length_m, cold.end_radius_m].map(|length| reader.expanded_with(length, bodies[0]));
    Some(SlotClearance { half_length_m, end_radius_m, clearance_m, ..cold })
}

record! {
    /// the line of a slot
    struct SlotLine for JointReader;
    /// the middle of the slot
    required point: PointId = Kind::Point, "\"yoke.middle\"";
    /// angle of the slot from the x axis of the body
    required angle: QuantityId = quantity(D::ANGLE, Rule::Finite), "\"90 deg\"";
}

record! {
    /// a pin slides and turns in a straight slot with round ends; with a clearance it has play
    struct SlotTable for JointReader, kind "slot" of joint;
    /// the middle of the slot and its direction
    required slot: Option<SlotLine<'t>> =
        Kind::Table(&SlotLine::KEYS), "{ point = \"yoke.middle\", angle = \"90 deg\" }";
    /// point at the centre of the pin
    required pin: Option<PointId> = Kind::Point, "\"crank.pin\"";
    /// distance from the middle of the slot to the centre of each round end
    optional half_length: Option<QuantityId> = quantity(D::LENGTH, Rule::Positive), "\"60 mm\"";
    /// radius of the round ends, half the width of the slot
    optional end_radius: Option<QuantityId> = quantity(D::LENGTH, Rule::Positive), "\"10 mm\"";
    /// radius of the ends minus radius of the pin; ideal joint, without ends, if omitted or zero
    optional clearance: Entry<'t> = quantity(D::LENGTH, Rule::NonNegative), "\"0.1 mm\"";
    /// the contact between pin and slot
    optional contact: Option<ContactId> = Kind::Reference("contact"), "\"steel_pin\"";
}
