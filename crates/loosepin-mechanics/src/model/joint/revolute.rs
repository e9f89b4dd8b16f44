//! A pin (journal) turns in a hole (bearing); with a radial clearance it has play.

use super::clearance::Clearance;
use super::kind::{AtBeam, KindOfJoint, NotDriven, PlayParts, TreeAttachment};
use super::reading::{JointReader, PlayKeys, span_of};
use super::row::PlaneRow;
use crate::model::ids::{BodyId, ContactId, PointId};
use crate::model::parts::friction::JointFrictionTable;
use crate::model::parts::wear::JOINT_WEAR;
use crate::model::problem::{ModelProblem, needs_keys};
use crate::model::words::part_names::Names;
use loosepin_text::diagnostics::Span;
use loosepin_text::document::{Entry, EntryPath, Keys, Kind, Table, quantity};
use loosepin_text::numbers::{DIAMETRAL, QuantityId, RADIAL};
use loosepin_text::record;
use loosepin_text::units::{Dimension, Dimension as D, Op, Rule};

/// The journal point turns about the bearing point; with a clearance, it may leave it.
#[derive(Debug, Clone)]
pub struct Revolute {
    /// Point of the body with the hole (body i).
    pub bearing: PointId,
    /// Point of the body with the pin (body j).
    pub journal: PointId,
    /// Absent for an ideal joint.
    pub clearance: Option<Clearance>,
}

impl KindOfJoint for Revolute {
    const WORD: &'static str = RevoluteTable::WORD;
    const KEYS: &'static Keys = &RevoluteTable::KEYS;
    const COORDINATE: Option<Dimension> = Some(Dimension::ANGLE);
    const TREE_ATTACHMENT: TreeAttachment = TreeAttachment::Turning;
    const ROWS: &'static [PlaneRow] = &[PlaneRow::Coincident];
    const AT_BEAM: AtBeam = AtBeam::Point;
    const CLEARANCE_KEY: &'static str = RADIAL;

    const FRICTION_SIZE: Option<&'static str> = Some("pin_radius");
    const WEARS: bool = true;

    fn read(table: &Table<'_>, reader: &mut dyn JointReader) -> Option<Self> {
        let own = RevoluteTable::of(reader, table.clone())?;
        let clearance = clearance(&own, reader);
        let (bearing, journal) = (own.bearing?, own.journal?);
        let clearance = match clearance? {
            Some(cold) => Some(warm(cold, [bearing.body, journal.body], own.clearance_span(), reader)?),
            None => None,
        };
        Some(Self { bearing, journal, clearance })
    }

    fn points(&self) -> [PointId; 2] {
        [self.bearing, self.journal]
    }

    fn play_parts(&self) -> Option<PlayParts<'_>> {
        self.clearance.as_ref().map(PlayParts::Pin)
    }

    fn why_not_driven(&self, is_zero: &dyn Fn(QuantityId) -> bool) -> Option<NotDriven> {
        let has_play = self.clearance.as_ref().is_some_and(|own| !is_zero(own.radial_clearance_m));
        has_play.then_some(NotDriven {
            why: "has play",
            hint: "drive an ideal joint, or set the radial clearance of this one to \"0 mm\"",
        })
    }

    fn words(&self, names: &dyn Names) -> String {
        format!("revolute: {} turns in {}", names.point(self.journal), names.point(self.bearing))
    }

    fn play_words(&self, names: &dyn Names) -> Option<String> {
        let own = self.clearance.as_ref()?;
        let [clearance, radius] = [own.radial_clearance_m, own.bearing_radius_m].map(|id| names.length(id));
        let bearing = if own.has_radius { format!(" in a bearing of radius {radius}") } else { String::new() };
        Some(format!("play: radial clearance {clearance}{bearing}"))
    }
}

/// The clearance; the outer option is absent after a diagnostic, the inner for an ideal joint.
fn clearance(own: &RevoluteTable<'_>, reader: &mut dyn JointReader) -> Option<Option<Clearance>> {
    let (table, on_diameter) = (&own.table, own.diametral_clearance.is_some());
    let keys = PlayKeys {
        clearance: if on_diameter { DIAMETRAL } else { RADIAL },
        needed: &["contact"],
        with_contact: &["bearing_radius"],
        beside: &["bearing_radius", "bearing_length", "axial_clearance", "contact"],
    };
    if let Some(radial) = own.radial_clearance.as_ref().filter(|_| on_diameter) {
        let problem = ModelProblem::ClearanceTwice { entry: table.path.describe() };
        return reader.document().refuse(&problem, radial.key_span);
    }
    let Some(stated_m) = reader.play_clearance(table, &keys)? else { return Some(None) };
    let radial_clearance_m = if on_diameter { half_of(stated_m, &table.path.join(RADIAL), reader) } else { stated_m };
    let has_radius = own.bearing_radius.is_some();
    let bearing_radius_m = match own.bearing_radius {
        Some(radius_m) => radius_m?,
        None => no_radius(radial_clearance_m, &table.path, reader),
    };
    if has_radius && !reader.demand_order(radial_clearance_m, bearing_radius_m, own.clearance_span()) {
        return None;
    }
    let contact = own.contact.unwrap_or_else(|| Some(reader.no_contact()))?;
    let facts = reader.contact_facts(contact);
    if (facts.is_line || facts.has_film) && own.bearing_length.is_none() {
        let entry = table.path.describe();
        let problem = if facts.is_line {
            needs_keys(entry, "contact", vec!["bearing_length"]).into()
        } else {
            ModelProblem::FilmNeedsLength { entry }
        };
        return reader.document().refuse(&problem, table.get("contact").map_or(table.span, |entry| entry.key_span));
    }
    if reader.leans() && own.bearing_length.is_none() {
        return reader
            .document()
            .refuse(&ModelProblem::LeanNeedsLength { entry: table.path.describe() }, own.clearance_span());
    }
    let (bearing_length_m, axial_clearance_m) = (own.bearing_length.flatten(), own.axial_clearance);
    Some(Some(Clearance {
        bearing_radius_m,
        has_radius,
        radial_clearance_m,
        bearing_length_m,
        axial_clearance_m,
        contact,
    }))
}

/// What stands for the radius of a bearing that states none, for drawings: a model with it is not run, and its motion does not depend on it.
fn no_radius(clearance_m: QuantityId, joint: &EntryPath, reader: &mut dyn JointReader) -> QuantityId {
    /// Clearances in a radius, about as parts have it.
    const CLEARANCES: f64 = 100.0;
    let ops = vec![Op::Load(clearance_m.0), Op::Number(CLEARANCES), Op::Multiply];
    let path = joint.join("(no bearing_radius)").dotted();
    reader.derived(path, Dimension::LENGTH, Rule::NonNegative, ops, &[clearance_m])
}

/// The radial clearance at `path` of a joint that states its diametral clearance: half of it, whatever that is set to.
fn half_of(diametral_m: QuantityId, path: &EntryPath, reader: &mut dyn JointReader) -> QuantityId {
    let ops = vec![Op::Load(diametral_m.0), Op::Number(0.5), Op::Multiply];
    reader.derived(path.dotted(), Dimension::LENGTH, Rule::NonNegative, ops, &[diametral_m])
}

/// The clearance with hole and pin as warm as their bodies.
fn warm(cold: Clearance, bodies: [BodyId; 2], span: Span, reader: &mut dyn JointReader) -> Option<Clearance> {
    let radial_clearance_m = reader.warm_clearance(cold.radial_clearance_m, &[cold.bearing_radius_m], bodies, span)?;
    let bearing_radius_m = reader.expanded_with(cold.bearing_radius_m, bodies[0]);
    Some(Clearance { bearing_radius_m, radial_clearance_m, ..cold })
}

record! {
    /// the journal (pin) turns in the bearing (hole); with a radial clearance it has play
    struct RevoluteTable for JointReader, kind "revolute" of joint;
    /// point at the centre of the hole
    required bearing: Option<PointId> = Kind::Point, "\"rod.small_end\"";
    /// point at the centre of the pin
    required journal: Option<PointId> = Kind::Point, "\"slider.pin\"";
    /// radius of the hole; a clearance needs it where a contact is named or parts are warm
    optional bearing_radius: Option<QuantityId> = quantity(D::LENGTH, Rule::Positive), "\"10 mm\"";
    /// radius of the hole minus radius of the pin; ideal joint if omitted or zero
    optional radial_clearance: Entry<'t> = quantity(D::LENGTH, Rule::NonNegative), "\"0.5 mm\"";
    /// diameter of the hole minus diameter of the pin, instead of radial_clearance: twice its value
    optional diametral_clearance: Entry<'t> = quantity(D::LENGTH, Rule::NonNegative), "\"1 mm\"";
    /// length of the bearing along its axis, for line-contact laws, films of oil and pins that lean; a point-contact law does not use it, but
    /// the result then also shows what a line-contact law would give
    optional bearing_length: Option<QuantityId> = quantity(D::LENGTH, Rule::Positive), "\"20 mm\"";
    /// how far the pin moves along its axis from the middle to either stop; 0 if omitted. Matters where pins lean
    optional axial_clearance: QuantityId = quantity(D::LENGTH, Rule::NonNegative), "\"0.1 mm\"";
    /// the contact between pin and hole
    optional contact: Option<ContactId> = Kind::Reference("contact"), "\"steel_pin\"";
    /// friction of a joint without play; none if omitted. For a joint with play, the contact gives the friction
    #[allow(dead_code)]
    optional friction: Entry<'t> = Kind::Table(&JointFrictionTable::KEYS), "{ coefficient = 0.1 }";
    /// radius of the pin, at whose surface friction acts
    #[allow(dead_code)]
    optional pin_radius: Entry<'t> = quantity(D::LENGTH, Rule::Positive), "\"8 mm\"";
    #[allow(dead_code)]
    optional wear: Entry<'t> as JOINT_WEAR;
}

impl RevoluteTable<'_> {
    /// Span of its clearance.
    fn clearance_span(&self) -> Span {
        span_of(
            if self.radial_clearance.is_some() { &self.radial_clearance } else { &self.diametral_clearance },
            &self.table,
        )
    }
}
