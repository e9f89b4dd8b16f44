//! A pin runs and turns in a slot along a circle; with a clearance it has play.

use super::clearance::CircularSlotClearance;
use super::kind::{AtBeam, Hanging, IdealRows, Keeps, KindOfJoint, NotDriven, PlayParts};
use super::reading::{JointReader, PlayKeys, clearance_span};
use crate::model::ids::PointId;
use crate::model::part_names::Names;
use crate::model::quantity::QuantityId;
use loosepin_text::document::{Keys, Kind, Table, optional, quantity, required};
use loosepin_text::units::{Dimension, Dimension as D, Rule};

/// The pin's centre stays on a circle fixed to the slot's body, and turns there; with a clearance, it may leave the circle and touch
/// either flank. The slot has no ends.
#[derive(Debug, Clone)]
pub struct CircularSlot {
    /// Centre of the circle.
    pub centre: PointId,
    /// Radius R of the middle of the slot, m, > 0.
    pub radius_m: QuantityId,
    /// Centre of the pin.
    pub pin: PointId,
    /// Absent for an ideal joint.
    pub clearance: Option<CircularSlotClearance>,
}

impl KindOfJoint for CircularSlot {
    const WORD: &'static str = "circular-slot";
    const KEYS: &'static Keys = &KEYS;
    // Neither the turn of the bodies nor a position along a line.
    const COORDINATE: Option<Dimension> = None;
    // In the tree it would have two coordinates; cut, it is one constraint.
    const HANGING: Hanging = Hanging::Never;
    const ROWS: IdealRows = IdealRows { keeps: Keeps::Circle, holds_angle: false };
    const AT_BEAM: AtBeam = AtBeam::Refused("circular slot joint");
    const CONTACT_PLACES: &'static [&'static str] = &["outer flank", "inner flank"];

    fn read(table: &Table<'_>, reader: &mut dyn JointReader) -> Option<Self> {
        let slot = table.get("slot").and_then(|entry| {
            let slot = reader.document().table(&entry, &CIRCLE_KEYS)?;
            let centre = slot.get("point").and_then(|entry| reader.point(&entry));
            let radius_m = reader.quantity(&slot, "radius");
            Some((centre?, radius_m?))
        });
        let pin = table.get("pin").and_then(|entry| reader.point(&entry));
        let cold = clearance(table, reader);
        let ((centre, radius_m), pin) = (slot?, pin?);
        let clearance = match cold? {
            Some(cold) => {
                if !reader.demand_order(cold.half_width_m, radius_m, clearance_span(table, &["half_width"])) {
                    return None;
                }
                let (bodies, span) = ([centre.body, pin.body], clearance_span(table, &["clearance"]));
                let clearance_m = reader.warm_clearance(cold.clearance_m, &[cold.half_width_m], bodies, span)?;
                let half_width_m = reader.grown_with(cold.half_width_m, centre.body);
                Some(CircularSlotClearance { half_width_m, clearance_m, ..cold })
            }
            None => None,
        };
        Some(Self { centre, radius_m: reader.grown_with(radius_m, centre.body), pin, clearance })
    }

    fn points(&self) -> [PointId; 2] {
        [self.centre, self.pin]
    }

    fn radius_m(&self) -> Option<QuantityId> {
        Some(self.radius_m)
    }

    fn play_parts(&self) -> Option<PlayParts<'_>> {
        let clearance = self.clearance.as_ref()?;
        Some(PlayParts::CircularSlot { clearance, radius_m: self.radius_m })
    }

    fn why_not_driven(&self, _is_zero: &dyn Fn(QuantityId) -> bool) -> Option<NotDriven> {
        Some(NotDriven::never("is a circular slot"))
    }

    fn words(&self, names: &dyn Names) -> String {
        format!(
            "circular slot: {} runs and turns in a slot of radius {} about {}",
            names.point(self.pin),
            names.length(self.radius_m),
            names.point(self.centre)
        )
    }

    fn play_words(&self, names: &dyn Names) -> Option<String> {
        let own = self.clearance.as_ref()?;
        let [clearance, half_width] = [own.clearance_m, own.half_width_m].map(|id| names.length(id));
        Some(format!("play: clearance {clearance} on each side in a slot of half width {half_width}"))
    }
}

/// The clearance; the outer option is absent after a complaint, the inner for an ideal joint.
fn clearance(table: &Table<'_>, reader: &mut dyn JointReader) -> Option<Option<CircularSlotClearance>> {
    const NEEDED: &[&str] = &["half_width", "contact"];
    const PLAY_KEYS: PlayKeys = PlayKeys { clearance: "clearance", needed: NEEDED, beside: NEEDED };
    let half_width_m = reader.quantity(table, "half_width");
    let contact = reader.contact_of(table);
    let Some(clearance_m) = reader.play_clearance(table, &PLAY_KEYS)? else { return Some(None) };
    let contact = reader.contact_of_play(table, contact);
    let (half_width_m, contact) = (half_width_m?, contact?);
    if !reader.demand_order(clearance_m, half_width_m, clearance_span(table, &["clearance"])) {
        return None;
    }
    reader.demand_flat_contact(table, contact, "a pin on the flank of a slot")?;
    Some(Some(CircularSlotClearance { half_width_m, clearance_m, contact }))
}

static CIRCLE_KEYS: Keys = Keys::new(
    "the circle of a slot",
    &[
        required("point", Kind::Point, "\"plate.centre\"", "the centre of the circle"),
        required("radius", quantity(D::LENGTH, Rule::Positive), "\"60 mm\"", "radius of the middle of the slot"),
    ],
);

static KEYS: Keys = Keys::new(
    "a pin runs and turns in a slot along a circle; with a clearance it has play",
    &[
        required("kind", Kind::Choice(&["circular-slot"]), "\"circular-slot\"", "the kind of joint"),
        required(
            "slot",
            Kind::Table(&CIRCLE_KEYS),
            "{ point = \"plate.centre\", radius = \"60 mm\" }",
            "the centre and the radius of the slot",
        ),
        required("pin", Kind::Point, "\"arm.pin\"", "point at the centre of the pin"),
        optional(
            "half_width",
            quantity(D::LENGTH, Rule::Positive),
            "\"10 mm\"",
            "half the width of the slot, from its middle to each flank",
        ),
        optional(
            "clearance",
            quantity(D::LENGTH, Rule::NonNegative),
            "\"0.1 mm\"",
            "half the width of the slot minus radius of the pin; ideal joint if left out or zero",
        ),
        optional("contact", Kind::Reference("contact"), "\"steel_pin\"", "the contact between pin and slot"),
    ],
);
