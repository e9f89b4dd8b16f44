//! A pin runs and turns in a slot along a circle; with a clearance it has play.

use super::clearance::CircularSlotClearance;
use super::kind::{AtBeam, KindOfJoint, NotDriven, PlayParts, TreeAttachment};
use super::reading::{JointReader, PlayKeys, span_of};
use super::row::PlaneRow;
use crate::model::ids::{ContactId, PointId};
use crate::model::words::part_names::Names;
use loosepin_text::document::{Entry, Keys, Kind, Table, quantity};
use loosepin_text::numbers::QuantityId;
use loosepin_text::record;
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
    const WORD: &'static str = CircularSlotTable::WORD;
    const KEYS: &'static Keys = &CircularSlotTable::KEYS;
    // Neither the turn of the bodies nor a position along a line.
    const COORDINATE: Option<Dimension> = None;
    // In the tree it would have two coordinates; cut, it is one constraint.
    const TREE_ATTACHMENT: TreeAttachment = TreeAttachment::Never;
    const ROWS: &'static [PlaneRow] = &[PlaneRow::OnCircle];
    const AT_BEAM: AtBeam = AtBeam::Refused("circular slot joint");
    const CONTACT_PLACES: &'static [&'static str] = &["outer flank", "inner flank"];

    fn read(table: &Table<'_>, reader: &mut dyn JointReader) -> Option<Self> {
        let own = CircularSlotTable::of(reader, table.clone())?;
        let cold = clearance(&own, reader);
        let (CircleTable { point: centre, radius: radius_m, .. }, pin) = (own.slot?, own.pin?);
        let clearance = match cold? {
            Some(cold) => {
                if !reader.demand_order(
                    cold.half_width_m,
                    radius_m,
                    table.get("half_width").map_or(table.span, |entry| entry.span),
                ) {
                    return None;
                }
                let (bodies, span) = ([centre.body, pin.body], span_of(&own.clearance, table));
                let clearance_m = reader.warm_clearance(cold.clearance_m, &[cold.half_width_m], bodies, span)?;
                let half_width_m = reader.expanded_with(cold.half_width_m, centre.body);
                Some(CircularSlotClearance { half_width_m, clearance_m, ..cold })
            }
            None => None,
        };
        Some(Self { centre, radius_m: reader.expanded_with(radius_m, centre.body), pin, clearance })
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
        Some(NotDriven::because("is a circular slot"))
    }

    fn words(&self, names: &dyn Names) -> String {
        format!(
            "circular slot: {} slides and turns in a slot of radius {} about {}",
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

/// The clearance; the outer option is absent after a diagnostic, the inner for an ideal joint.
fn clearance(own: &CircularSlotTable<'_>, reader: &mut dyn JointReader) -> Option<Option<CircularSlotClearance>> {
    const NEEDED: &[&str] = &["half_width", "contact"];
    const PLAY_KEYS: PlayKeys = PlayKeys { clearance: "clearance", needed: NEEDED, with_contact: &[], beside: NEEDED };
    let Some(clearance_m) = reader.play_clearance(&own.table, &PLAY_KEYS)? else { return Some(None) };
    let contact = own.contact.unwrap_or_else(|| Some(reader.no_contact()));
    let (half_width_m, contact) = (own.half_width.flatten()?, contact?);
    if !reader.demand_order(clearance_m, half_width_m, span_of(&own.clearance, &own.table)) {
        return None;
    }
    reader.demand_flat_contact(&own.table, contact, "a pin on the flank of a slot")?;
    Some(Some(CircularSlotClearance { half_width_m, clearance_m, contact }))
}

record! {
    /// the centre line of a circular slot
    struct CircleTable for JointReader;
    /// the centre of the circle
    required point: PointId = Kind::Point, "\"plate.centre\"";
    /// radius of the middle of the slot
    required radius: QuantityId = quantity(D::LENGTH, Rule::Positive), "\"60 mm\"";
}

record! {
    /// a pin slides and turns in a slot along a circle; with a clearance it has play
    struct CircularSlotTable for JointReader, kind "circular-slot" of joint;
    /// the centre and the radius of the slot
    required slot: Option<CircleTable<'t>> =
        Kind::Table(&CircleTable::KEYS), "{ point = \"plate.centre\", radius = \"60 mm\" }";
    /// point at the centre of the pin
    required pin: Option<PointId> = Kind::Point, "\"arm.pin\"";
    /// half the width of the slot, from its middle to each flank
    optional half_width: Option<QuantityId> = quantity(D::LENGTH, Rule::Positive), "\"10 mm\"";
    /// half the width of the slot minus radius of the pin; ideal joint if omitted or zero
    optional clearance: Entry<'t> = quantity(D::LENGTH, Rule::NonNegative), "\"0.1 mm\"";
    /// the contact between pin and slot
    optional contact: Option<ContactId> = Kind::Reference("contact"), "\"steel_pin\"";
}
