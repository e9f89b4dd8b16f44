//! A slider moves along a line of its guide and does not turn against it; with a clearance it has play.

use super::clearance::GuideClearance;
use super::kind::{AtBeam, KindOfJoint, NotDriven, PlayParts, TreeAttachment};
use super::reading::{JointReader, PlayKeys, span_of};
use super::row::PlaneRow;
use crate::model::ids::{BodyId, ContactId, PointId};
use crate::model::parts::friction::JointFrictionTable;
use crate::model::words::part_names::Names;
use loosepin_text::diagnostics::Span;
use loosepin_text::document::{Entry, Keys, Kind, Table, Value, quantity};
use loosepin_text::numbers::QuantityId;
use loosepin_text::record;
use loosepin_text::units::{Dimension, Dimension as D, Rule};

/// The slider point stays on a line fixed to the guide body, and the slider body does not turn against it.
/// Coordinate s: (r_slider - r_guide)·d, d the direction of the line; zero where the two points coincide.
#[derive(Debug, Clone)]
pub struct Prismatic {
    /// Point of the guide body that the line goes through.
    pub guide: PointId,
    /// Angle of the line's direction from the guide body's x axis, rad.
    pub guide_angle_rad: QuantityId,
    /// Point of the slider body that stays on the line.
    pub slider: PointId,
    /// Angle from the slider body's x axis to the same line, rad (zero: the slider's x axis lies along it).
    pub slider_angle_rad: QuantityId,
    /// Absent for an ideal joint.
    pub clearance: Option<GuideClearance>,
}

impl KindOfJoint for Prismatic {
    const WORD: &'static str = PrismaticTable::WORD;
    const KEYS: &'static Keys = &PrismaticTable::KEYS;
    const COORDINATE: Option<Dimension> = Some(Dimension::LENGTH);
    const TREE_ATTACHMENT: TreeAttachment = TreeAttachment::Sliding;
    const ROWS: &'static [PlaneRow] = &[PlaneRow::OnLine, PlaneRow::Angle];
    const AT_BEAM: AtBeam = AtBeam::Refused("prismatic joint");
    const CONTACT_PLACES: &'static [&'static str] = &CORNERS;

    const FRICTION_SIZE: Option<&'static str> = Some("guide_length");

    fn read(table: &Table<'_>, reader: &mut dyn JointReader) -> Option<Self> {
        let own = PrismaticTable::of(reader, table.clone())?;
        let ends_m = own.guide.as_ref().and_then(|guide| guide_ends(guide, own.clearance.is_some(), reader));
        let clearance = clearance(&own, reader);
        let (guide, LineOfSlider { point: slider, angle_rad: slider_angle_rad }) = (own.guide?, own.slider?);
        let (guide, guide_angle_rad, ends_m) = (guide.point?, guide.angle?, ends_m?);
        let clearance = match clearance? {
            Some(cold) => {
                let cold = GuideClearance { ends_m, ..cold };
                Some(warm(cold, [guide.body, slider.body], span_of(&own.clearance, table), reader)?)
            }
            None => None,
        };
        Some(Self { guide, guide_angle_rad, slider, slider_angle_rad, clearance })
    }

    fn points(&self) -> [PointId; 2] {
        [self.guide, self.slider]
    }

    fn angles_rad(&self) -> [Option<QuantityId>; 2] {
        [Some(self.guide_angle_rad), Some(self.slider_angle_rad)]
    }

    fn play_parts(&self) -> Option<PlayParts<'_>> {
        let clearance = self.clearance.as_ref()?;
        let (guide_angle_rad, slider_angle_rad) = (self.guide_angle_rad, self.slider_angle_rad);
        Some(PlayParts::Block { clearance, guide_angle_rad, slider_angle_rad })
    }

    fn why_not_driven(&self, is_zero: &dyn Fn(QuantityId) -> bool) -> Option<NotDriven> {
        let has_play = self.clearance.as_ref().is_some_and(|own| !is_zero(own.clearance_m));
        has_play.then_some(NotDriven {
            why: "has play in its guide",
            hint: "drive an ideal joint, or set the clearance of this one to \"0 mm\"",
        })
    }

    fn words(&self, names: &dyn Names) -> String {
        let turned_rad = names.value_si(self.guide_angle_rad) - names.value_si(self.slider_angle_rad);
        let turned = if turned_rad == 0.0 {
            String::new()
        } else {
            let [slider, guide] = [self.slider, self.guide].map(|point| names.body(point.body));
            format!(", which turns '{slider}' by {} from '{guide}'", names.angle(turned_rad))
        };
        format!(
            "prismatic: {} slides on a line through {} at {}{turned}",
            names.point(self.slider),
            names.point(self.guide),
            names.angle(names.value_si(self.guide_angle_rad))
        )
    }

    fn play_words(&self, names: &dyn Names) -> Option<String> {
        let own = self.clearance.as_ref()?;
        let radius =
            own.corner_radius_m.map_or(String::new(), |id| format!(", corners of radius {}", names.length(id)));
        let [clearance, half_length, half_height] =
            [own.clearance_m, own.half_length_m, own.half_height_m].map(|id| names.length(id));
        let ends = own.ends_m.map_or("a guide without ends".to_owned(), |[start, end]| {
            format!("faces from {} to {}", names.length(start), names.length(end))
        });
        Some(format!(
            "play: clearance {clearance} on each side of a slider of half-length {half_length} and half-height {half_height}{radius}; {ends}"
        ))
    }
}

/// The slider's point, with the angle of the line in its body.
struct LineOfSlider {
    point: PointId,
    angle_rad: QuantityId,
}

impl<'t, R: JointReader + ?Sized> Value<'t, R> for LineOfSlider {
    fn read(reader: &mut R, entry: &Entry<'t>) -> Option<Self> {
        if entry.is_text() {
            let point = reader.point(entry)?;
            let path = entry.path.join("angle");
            let angle_rad = reader.default_quantity(&path, Dimension::ANGLE, Rule::Finite, 0.0);
            return Some(Self { point, angle_rad });
        }
        if !entry.is_table() {
            return reader.document().wrong_type(entry, "a point or a table with point and angle");
        }
        let SliderTable { point, angle, .. } = SliderTable::read(reader, entry)?;
        Some(Self { point, angle_rad: angle })
    }
}

/// The clearance, in a guide without ends; the outer option is absent after a diagnostic, the inner for an ideal joint.
fn clearance(own: &PrismaticTable<'_>, reader: &mut dyn JointReader) -> Option<Option<GuideClearance>> {
    const PLAY_KEYS: PlayKeys = PlayKeys {
        clearance: "clearance",
        needed: &["half_length", "half_height", "contact"],
        with_contact: &[],
        beside: &["half_length", "half_height", "contact", "corner_radius"],
    };
    let Some(clearance_m) = reader.play_clearance(&own.table, &PLAY_KEYS)? else { return Some(None) };
    let contact = own.contact.unwrap_or_else(|| Some(reader.no_contact()))?;
    reader.demand_flat_contact(&own.table, contact, "a corner of a slider")?;
    if own.contact.is_some() {
        demand_corner_radius(own, contact, reader)?;
    }
    Some(Some(GuideClearance {
        half_length_m: own.half_length.flatten()?,
        half_height_m: own.half_height.flatten()?,
        clearance_m,
        corner_radius_m: own.corner_radius.flatten(),
        ends_m: None,
        contact,
    }))
}

/// The ends of a guide; the outer option is absent after a diagnostic, the inner for a guide without ends.
fn guide_ends(
    guide: &GuideTable<'_>,
    has_clearance: bool,
    reader: &mut dyn JointReader,
) -> Option<Option<[QuantityId; 2]>> {
    let [key, missing] = match (guide.start, guide.end) {
        (None, None) => return Some(None),
        (Some(_), None) => ["start", "end"],
        (None, Some(_)) => ["end", "start"],
        (Some(_), Some(_)) if !has_clearance => ["start", "clearance"],
        (Some(start), Some(end)) => {
            let span = guide.table.get("start").map_or(guide.table.span, |entry| entry.span);
            let (start, end) = (start?, end?);
            return reader.demand_order(start, end, span).then_some(Some([start, end]));
        }
    };
    reader.report_missing(&guide.table, key, vec![missing]);
    None
}

/// The radius of the corners belongs to a stiffness from the materials, and to no other.
fn demand_corner_radius(own: &PrismaticTable<'_>, contact: ContactId, reader: &mut dyn JointReader) -> Option<()> {
    match (reader.contact_facts(contact).is_of_materials, own.corner_radius) {
        (true, None) => reader.report_missing(&own.table, "contact", vec!["corner_radius"]),
        (false, Some(_)) => reader.refuse_beside(&own.table, "corner_radius", "stiffness"),
        _ => return Some(()),
    }
    None
}

/// The clearance with guide and block as warm as their bodies.
fn warm(cold: GuideClearance, bodies: [BodyId; 2], span: Span, reader: &mut dyn JointReader) -> Option<GuideClearance> {
    // The guide is as high as the block and the gap.
    let outer = [cold.half_height_m, cold.clearance_m];
    let clearance_m = reader.warm_clearance(cold.clearance_m, &outer, bodies, span)?;
    let [half_length_m, half_height_m] =
        [cold.half_length_m, cold.half_height_m].map(|length| reader.expanded_with(length, bodies[1]));
    let ends_m = cold.ends_m.map(|ends| ends.map(|end| reader.expanded_with(end, bodies[0])));
    Some(GuideClearance { half_length_m, half_height_m, clearance_m, ends_m, ..cold })
}

/// Names of the places where a block may touch: where along the guide's direction, at which face.
const CORNERS: [&str; 4] = ["upper rear", "upper front", "lower rear", "lower front"];

record! {
    /// the line of a guide
    struct GuideTable for JointReader;
    /// a point that the line goes through
    required point: Option<PointId> = Kind::Point, "\"ground.o\"";
    /// angle of the line from the x axis of the body
    required angle: Option<QuantityId> = quantity(D::ANGLE, Rule::Finite), "\"0 deg\"";
    /// position on the line, from the point, where the faces of a guide with play begin; no ends if omitted
    optional start: Option<QuantityId> = quantity(D::LENGTH, Rule::Finite), "\"-80 mm\"";
    /// position on the line, from the point, where these faces end
    optional end: Option<QuantityId> = quantity(D::LENGTH, Rule::Finite), "\"200 mm\"";
}

record! {
    /// the point that stays on the line of a guide
    struct SliderTable for JointReader;
    /// the point
    required point: PointId = Kind::Point, "\"slider.pin\"";
    /// angle of the line from the x axis of the slider
    optional angle: QuantityId = quantity(D::ANGLE, Rule::Finite), "\"0 deg\"", or "0 deg";
}

record! {
    /// a slider moves along a line of its guide and does not turn against it; with a clearance it has play
    struct PrismaticTable for JointReader, kind "prismatic" of joint;
    /// the line
    required guide: Option<GuideTable<'t>> =
        Kind::Table(&GuideTable::KEYS), "{ point = \"ground.o\", angle = \"0 deg\" }";
    /// the point on the line, with an angle if the line is not along the slider's x axis
    required slider: Option<LineOfSlider> =
        Kind::AnyOf(&[Kind::Point, Kind::Table(&SliderTable::KEYS)]), "\"slider.pin\"";
    /// friction; none if omitted
    #[allow(dead_code)]
    optional friction: Entry<'t> = Kind::Table(&JointFrictionTable::KEYS), "{ coefficient = 0.1 }";
    /// length over which the guide supports the slider, half of it on each side of the slider point; friction acts at both ends
    #[allow(dead_code)]
    optional guide_length: Entry<'t> = quantity(D::LENGTH, Rule::Positive), "\"60 mm\"";
    /// half the length of the block along the guide; the slider's point is at its centre
    optional half_length: Option<QuantityId> = quantity(D::LENGTH, Rule::Positive), "\"50 mm\"";
    /// half the height of the block across the guide
    optional half_height: Option<QuantityId> = quantity(D::LENGTH, Rule::Positive), "\"25 mm\"";
    /// gap between the block and each face of the guide; ideal joint if omitted or zero
    optional clearance: Entry<'t> = quantity(D::LENGTH, Rule::NonNegative), "\"0.1 mm\"";
    /// radius of the block's corners, for a contact whose stiffness comes from the materials
    optional corner_radius: Option<QuantityId> = quantity(D::LENGTH, Rule::Positive), "\"5 mm\"";
    /// the contact between corners and guide
    optional contact: Option<ContactId> = Kind::Reference("contact"), "\"corner\"";
}
