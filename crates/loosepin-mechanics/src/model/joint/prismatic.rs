//! A slider moves along a line of its guide and does not turn against it; with a clearance it has play.

use super::clearance::GuideClearance;
use super::kind::{AtBeam, Hanging, IdealRows, Keeps, KindOfJoint, NotDriven, PlayParts};
use super::reading::{JointReader, PlayKeys, clearance_span};
use crate::model::ids::{BodyId, ContactId, PointId};
use crate::model::keys::friction::JOINT_FRICTION_KEYS;
use crate::model::part_names::Names;
use crate::model::quantity::QuantityId;
use loosepin_text::document::{Entry, Keys, Kind, Table, optional, quantity, required};
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
    const WORD: &'static str = "prismatic";
    const KEYS: &'static Keys = &KEYS;
    const COORDINATE: Option<Dimension> = Some(Dimension::LENGTH);
    const HANGING: Hanging = Hanging::Sliding;
    const ROWS: IdealRows = IdealRows { keeps: Keeps::Line, holds_angle: true };
    const AT_BEAM: AtBeam = AtBeam::Refused("prismatic joint");
    const CONTACT_PLACES: &'static [&'static str] = &CORNERS;

    const FRICTION_SIZE: Option<&'static str> = Some("guide_length");

    fn read(table: &Table<'_>, reader: &mut dyn JointReader) -> Option<Self> {
        let guide = table.get("guide").and_then(|entry| {
            let guide = reader.document().table(&entry, &GUIDE_KEYS)?;
            let point = guide.get("point").and_then(|entry| reader.point(&entry));
            let angle_rad = reader.quantity(&guide, "angle");
            let ends_m = guide_ends(&guide, table.has("clearance"), reader);
            Some((point?, angle_rad?, ends_m?))
        });
        let slider = table.get("slider").and_then(|entry| slider(&entry, reader));
        let ((guide, guide_angle_rad, ends_m), (slider, slider_angle_rad)) = match guide.zip(slider) {
            Some(sound) => sound,
            None => {
                // Its complaints belong to the others.
                clearance(table, None, reader);
                return None;
            }
        };
        let clearance = match clearance(table, ends_m, reader)? {
            Some(cold) => Some(warm(cold, [guide.body, slider.body], table, reader)?),
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
fn slider(entry: &Entry<'_>, reader: &mut dyn JointReader) -> Option<(PointId, QuantityId)> {
    if entry.is_text() {
        let point = reader.point(entry)?;
        let path = entry.path.join("angle");
        return Some((point, reader.default_quantity(&path, Dimension::ANGLE, Rule::Finite, 0.0)));
    }
    if !entry.is_table() {
        return reader.document().wrong_type(entry, "a point or a table with point and angle");
    }
    let table = reader.document().table(entry, &SLIDER_KEYS)?;
    let point = table.get("point").and_then(|entry| reader.point(&entry));
    let angle_rad = reader.quantity_or(&table, "angle", 0.0);
    Some((point?, angle_rad?))
}

/// The clearance; the outer option is absent after a complaint, the inner for an ideal joint.
fn clearance(
    table: &Table<'_>,
    ends_m: Option<[QuantityId; 2]>,
    reader: &mut dyn JointReader,
) -> Option<Option<GuideClearance>> {
    const PLAY_KEYS: PlayKeys = PlayKeys {
        clearance: "clearance",
        needed: &["half_length", "half_height", "contact"],
        beside: &["half_length", "half_height", "contact", "corner_radius"],
    };
    let [half_length_m, half_height_m, corner_radius_m] =
        ["half_length", "half_height", "corner_radius"].map(|key| reader.quantity(table, key));
    let contact = reader.contact_of(table);
    let Some(clearance_m) = reader.play_clearance(table, &PLAY_KEYS)? else { return Some(None) };
    let contact = reader.contact_of_play(table, contact)?;
    reader.demand_flat_contact(table, contact, "a corner of a slider")?;
    if table.has("contact") {
        demand_corner_radius(table, contact, reader)?;
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
fn guide_ends(guide: &Table<'_>, has_clearance: bool, reader: &mut dyn JointReader) -> Option<Option<[QuantityId; 2]>> {
    const END_KEYS: [&str; 2] = ["start", "end"];
    let ends = END_KEYS.map(|key| reader.quantity(guide, key));
    let (given, missing): (Vec<&'static str>, Vec<&'static str>) = END_KEYS.into_iter().partition(|key| guide.has(key));
    let Some(key) = given.first() else { return Some(None) };
    if !missing.is_empty() {
        reader.complain_of_missing(guide, key, missing);
        return None;
    }
    if !has_clearance {
        reader.complain_of_missing(guide, key, vec!["clearance"]);
        return None;
    }
    let [start, end] = [ends[0]?, ends[1]?];
    let span = guide.get("start").map_or(guide.span, |entry| entry.span);
    reader.demand_order(start, end, span).then_some(Some([start, end]))
}

/// The radius of the corners belongs to a stiffness from the materials, and to no other.
fn demand_corner_radius(table: &Table<'_>, contact: ContactId, reader: &mut dyn JointReader) -> Option<()> {
    match (reader.contact_facts(contact).is_of_materials, table.get("corner_radius")) {
        (true, None) => {
            reader.complain_of_missing(table, "contact", vec!["corner_radius"]);
            None
        }
        (false, Some(_)) => {
            reader.refuse_beside(table, "corner_radius", "stiffness");
            None
        }
        _ => Some(()),
    }
}

/// The clearance with guide and block as warm as their bodies.
fn warm(
    cold: GuideClearance,
    bodies: [BodyId; 2],
    table: &Table<'_>,
    reader: &mut dyn JointReader,
) -> Option<GuideClearance> {
    // The guide is as high as the block and the gap.
    let outer = [cold.half_height_m, cold.clearance_m];
    let clearance_m = reader.warm_clearance(cold.clearance_m, &outer, bodies, clearance_span(table, &["clearance"]))?;
    let [half_length_m, half_height_m] =
        [cold.half_length_m, cold.half_height_m].map(|length| reader.grown_with(length, bodies[1]));
    let ends_m = cold.ends_m.map(|ends| ends.map(|end| reader.grown_with(end, bodies[0])));
    Some(GuideClearance { half_length_m, half_height_m, clearance_m, ends_m, ..cold })
}

/// Names of the places where a block may touch: where along the guide's direction, at which face.
const CORNERS: [&str; 4] = ["upper rear", "upper front", "lower rear", "lower front"];

static GUIDE_KEYS: Keys = Keys::new(
    "the line of a guide",
    &[
        required("point", Kind::Point, "\"ground.o\"", "a point that the line goes through"),
        required("angle", quantity(D::ANGLE, Rule::Finite), "\"0 deg\"", "its direction from the x axis of the body"),
        optional(
            "start",
            quantity(D::LENGTH, Rule::Finite),
            "\"-80 mm\"",
            "where the faces of a guide with play begin, from the point along the line; without ends if left out",
        ),
        optional("end", quantity(D::LENGTH, Rule::Finite), "\"200 mm\"", "where those faces end"),
    ],
);

static SLIDER_KEYS: Keys = Keys::new(
    "the point that stays on the line of a guide",
    &[
        required("point", Kind::Point, "\"slider.pin\"", "the point"),
        optional(
            "angle",
            quantity(D::ANGLE, Rule::Finite),
            "\"0 deg\"",
            "direction of the line from the x axis of the slider; 0 deg if left out",
        ),
    ],
);

static KEYS: Keys = Keys::new(
    "a slider moves along a line of its guide and does not turn against it; with a clearance it has play",
    &[
        required("kind", Kind::Choice(&["prismatic"]), "\"prismatic\"", "the kind of joint"),
        required("guide", Kind::Table(&GUIDE_KEYS), "{ point = \"ground.o\", angle = \"0 deg\" }", "the line"),
        required(
            "slider",
            Kind::AnyOf(&[Kind::Point, Kind::Table(&SLIDER_KEYS)]),
            "\"slider.pin\"",
            "the point on the line, with an angle where the line is not along the slider's x axis",
        ),
        optional("friction", Kind::Table(&JOINT_FRICTION_KEYS), "{ coefficient = 0.1 }", "friction; none if left out"),
        optional(
            "guide_length",
            quantity(D::LENGTH, Rule::Positive),
            "\"60 mm\"",
            "length over which the guide holds the slider, half of it on each side of the slider point; friction acts at both ends",
        ),
        optional(
            "half_length",
            quantity(D::LENGTH, Rule::Positive),
            "\"50 mm\"",
            "half the length along the guide of the block around the slider's point",
        ),
        optional(
            "half_height",
            quantity(D::LENGTH, Rule::Positive),
            "\"25 mm\"",
            "half the height of that block across the guide",
        ),
        optional(
            "clearance",
            quantity(D::LENGTH, Rule::NonNegative),
            "\"0.1 mm\"",
            "gap between the block and each face of the guide; ideal joint if left out or zero",
        ),
        optional(
            "corner_radius",
            quantity(D::LENGTH, Rule::Positive),
            "\"5 mm\"",
            "radius of the block's corners, for a contact whose stiffness comes from the materials",
        ),
        optional("contact", Kind::Reference("contact"), "\"corner\"", "the contact between corners and guide"),
    ],
);
