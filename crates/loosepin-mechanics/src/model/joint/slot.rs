//! A pin slides and turns in a straight slot with round ends; with a clearance it has play.

use super::clearance::SlotClearance;
use super::kind::{AtBeam, Hanging, IdealRows, Keeps, KindOfJoint, NotDriven, PlayParts};
use super::reading::{JointReader, PlayKeys, clearance_span};
use crate::model::ids::{BodyId, PointId};
use crate::model::part_names::Names;
use crate::model::quantity::QuantityId;
use loosepin_text::document::{Keys, Kind, Table, optional, quantity, required};
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
    const WORD: &'static str = "slot";
    const KEYS: &'static Keys = &KEYS;
    const COORDINATE: Option<Dimension> = Some(Dimension::LENGTH);
    // In the tree it would have two coordinates; cut, it is one constraint.
    const HANGING: Hanging = Hanging::Never;
    const ROWS: IdealRows = IdealRows { keeps: Keeps::Line, holds_angle: false };
    const AT_BEAM: AtBeam = AtBeam::Refused("slot joint");

    fn read(table: &Table<'_>, reader: &mut dyn JointReader) -> Option<Self> {
        let slot = table.get("slot").and_then(|entry| {
            let slot = reader.document().table(&entry, &SLOT_LINE_KEYS)?;
            let point = slot.get("point").and_then(|entry| reader.point(&entry));
            let angle_rad = reader.quantity(&slot, "angle");
            Some((point?, angle_rad?))
        });
        let pin = table.get("pin").and_then(|entry| reader.point(&entry));
        let clearance = clearance(table, reader);
        let ((slot, slot_angle_rad), pin) = (slot?, pin?);
        let clearance = match clearance? {
            Some(cold) => Some(warm(cold, [slot.body, pin.body], table, reader)?),
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
        Some(NotDriven::never("is a slot"))
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

/// The clearance; the outer option is absent after a complaint, the inner for an ideal joint.
fn clearance(table: &Table<'_>, reader: &mut dyn JointReader) -> Option<Option<SlotClearance>> {
    const NEEDED: &[&str] = &["half_length", "end_radius", "contact"];
    const PLAY_KEYS: PlayKeys = PlayKeys { clearance: "clearance", needed: NEEDED, beside: NEEDED };
    let [half_length_m, end_radius_m] = ["half_length", "end_radius"].map(|key| reader.quantity(table, key));
    let contact = reader.contact_of(table);
    let Some(clearance_m) = reader.play_clearance(table, &PLAY_KEYS)? else { return Some(None) };
    let contact = reader.contact_of_play(table, contact);
    let (half_length_m, end_radius_m, contact) = (half_length_m?, end_radius_m?, contact?);
    if !reader.demand_order(clearance_m, end_radius_m, clearance_span(table, &["clearance"])) {
        return None;
    }
    reader.demand_flat_contact(table, contact, "a pin on the flat face of a slot")?;
    Some(Some(SlotClearance { half_length_m, end_radius_m, clearance_m, contact }))
}

/// The clearance with slot and pin as warm as their bodies.
fn warm(
    cold: SlotClearance,
    bodies: [BodyId; 2],
    table: &Table<'_>,
    reader: &mut dyn JointReader,
) -> Option<SlotClearance> {
    let span = clearance_span(table, &["clearance"]);
    let clearance_m = reader.warm_clearance(cold.clearance_m, &[cold.end_radius_m], bodies, span)?;
    let [half_length_m, end_radius_m] =
        [cold.half_length_m, cold.end_radius_m].map(|length| reader.grown_with(length, bodies[0]));
    Some(SlotClearance { half_length_m, end_radius_m, clearance_m, ..cold })
}

static SLOT_LINE_KEYS: Keys = Keys::new(
    "the line of a slot",
    &[
        required("point", Kind::Point, "\"yoke.middle\"", "the middle of the slot"),
        required("angle", quantity(D::ANGLE, Rule::Finite), "\"90 deg\"", "its direction from the x axis of the body"),
    ],
);

static KEYS: Keys = Keys::new(
    "a pin slides and turns in a straight slot with round ends; with a clearance it has play",
    &[
        required("kind", Kind::Choice(&["slot"]), "\"slot\"", "the kind of joint"),
        required(
            "slot",
            Kind::Table(&SLOT_LINE_KEYS),
            "{ point = \"yoke.middle\", angle = \"90 deg\" }",
            "the middle of the slot and its direction",
        ),
        required("pin", Kind::Point, "\"crank.pin\"", "point at the centre of the pin"),
        optional(
            "half_length",
            quantity(D::LENGTH, Rule::Positive),
            "\"60 mm\"",
            "from the middle of the slot to the centre of each round end",
        ),
        optional(
            "end_radius",
            quantity(D::LENGTH, Rule::Positive),
            "\"10 mm\"",
            "radius of the round ends, half the width of the slot",
        ),
        optional(
            "clearance",
            quantity(D::LENGTH, Rule::NonNegative),
            "\"0.1 mm\"",
            "radius of the ends minus radius of the pin; ideal joint, without ends, if left out or zero",
        ),
        optional("contact", Kind::Reference("contact"), "\"steel_pin\"", "the contact between pin and slot"),
    ],
);
