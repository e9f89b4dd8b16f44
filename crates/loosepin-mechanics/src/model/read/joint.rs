//! Joints.

use super::guide::PlayKeys;
use super::reader::ModelReader;
use crate::contact::NormalDescription;
use crate::model::ids::{ContactId, JointId, PointId};
use crate::model::keys::{GUIDE_KEYS, JOINT_FRICTION_KEYS, JOINT_KINDS, SLIDER_KEYS};
use crate::model::problem::ModelProblem;
use crate::model::quantity::{DIAMETRAL, QuantityId, RADIAL};
use crate::model::topology::{Clearance, Joint, JointFriction, JointKind};
use crate::model::wear::JointWear;
use loosepin_text::diagnostics::Span;
use loosepin_text::document::{Entry, EntryPath, Table};
use loosepin_text::units::{Dimension, Op, Rule};

impl ModelReader {
    /// Reads the table of joints.
    pub fn read_joints(&mut self, entry: &Entry<'_>) {
        for entry in self.reader.named(entry, "a joint") {
            self.remember(&entry);
            let kind = self.joint_kind(&entry);
            let id = kind.map(|(kind, friction, wear)| {
                self.joints.push(Joint { name: entry.name.to_owned(), kind, friction, wear });
                JointId(self.joints.len() - 1)
            });
            self.joint_names.push((entry.name.to_owned(), id));
        }
    }

    fn joint_kind(&mut self, entry: &Entry<'_>) -> Option<(JointKind, Option<JointFriction>, Option<JointWear>)> {
        let (kind, table) = self.table_of_kind(entry, JOINT_KINDS)?;
        let mut wear = Some(None);
        let (kind, friction) = match kind {
            "revolute" => {
                let friction = self.joint_friction(&table, "pin_radius");
                let kind = self.revolute(&table);
                let clearance = match &kind {
                    Some(JointKind::Revolute { clearance, .. }) => clearance.as_ref(),
                    _ => None,
                };
                wear = self.joint_wear(&table, clearance);
                (kind, friction)
            }
            "prismatic" => {
                let friction = self.joint_friction(&table, "guide_length");
                (self.prismatic(&table), friction)
            }
            "slot" => (self.slot(&table), Some(None)),
            _ => (self.rigid(&table), Some(None)),
        };
        let ((kind, friction), wear) = kind.zip(friction).zip(wear)?;
        if kind.play().is_some() && friction.is_some() {
            let beside = [RADIAL, DIAMETRAL].into_iter().find(|key| table.has(key)).unwrap_or("clearance");
            let problem = ModelProblem::KeyWithoutEffect { entry: entry.path.describe(), key: "friction", beside };
            return self.reader.refuse(&problem, entry.key_span);
        }
        let [first, second] = kind.bodies();
        if first != second {
            return Some((kind, friction, wear));
        }
        let body = self.bodies[first.0].name.clone();
        self.reader.refuse(&ModelProblem::SameBody { entry: entry.path.describe(), body }, entry.key_span)
    }

    /// Friction of an ideal joint with its size under `key`; the outer option is absent after a complaint.
    fn joint_friction(&mut self, table: &Table<'_>, key: &'static str) -> Option<Option<JointFriction>> {
        let size_m = self.quantity(table, key);
        let friction = table.get("friction").map(|entry| self.friction(&entry, &JOINT_FRICTION_KEYS));
        for (key, needs) in [("friction", key), (key, "friction")] {
            if table.has(key) && !table.has(needs) {
                self.complain_of_missing(table, key, vec![needs]);
                return None;
            }
        }
        match friction {
            None => Some(None),
            Some(friction) => Some(Some(JointFriction { friction: friction?, size_m: size_m? })),
        }
    }

    fn revolute(&mut self, table: &Table<'_>) -> Option<JointKind> {
        let [bearing, journal] = ["bearing", "journal"].map(|key| table.get(key).and_then(|entry| self.point(&entry)));
        let clearance = self.clearance(table);
        let (bearing, journal) = (bearing?, journal?);
        let span = clearance_span(table, &[RADIAL, DIAMETRAL]);
        let clearance = match clearance? {
            Some(cold) => Some(self.warm_pin(cold, [bearing.body, journal.body], span)?),
            None => None,
        };
        Some(JointKind::Revolute { bearing, journal, clearance })
    }

    /// The clearance of a revolute joint; the outer option is absent after a complaint, the inner for an ideal joint.
    fn clearance(&mut self, table: &Table<'_>) -> Option<Option<Clearance>> {
        let on_diameter = table.has(DIAMETRAL);
        let keys = PlayKeys {
            clearance: if on_diameter { DIAMETRAL } else { RADIAL },
            needed: &["bearing_radius", "contact"],
            beside: &["bearing_radius", "bearing_length", "contact"],
        };
        let bearing_radius_m = self.quantity(table, "bearing_radius");
        let bearing_length_m = self.quantity(table, "bearing_length");
        let contact = self.contact_of(table);
        if let Some(radial) = table.get(RADIAL).filter(|_| on_diameter) {
            let problem = ModelProblem::ClearanceTwice { entry: table.path.describe() };
            return self.reader.refuse(&problem, radial.key_span);
        }
        let Some(stated_m) = self.play_clearance(table, &keys)? else { return Some(None) };
        let span = table.get(keys.clearance).map_or(table.span, |entry| entry.span);
        let radial_clearance_m = if on_diameter { self.half_of(stated_m, &table.path.join(RADIAL)) } else { stated_m };
        let bearing_radius_m = bearing_radius_m?;
        if !self.demand_order(radial_clearance_m, bearing_radius_m, span) {
            return None;
        }
        let contact = self.contact_of_play(table, contact)?;
        // A length that is there and could not be read was complained about.
        let has_line_law = matches!(self.contacts[contact.0].law, NormalDescription::Line(_));
        let has_film = self.contacts[contact.0].film.is_some();
        if (has_line_law || has_film) && !table.has("bearing_length") {
            let entry = table.path.describe();
            let problem = if has_line_law {
                ModelProblem::NeedsKeys { entry, key: "contact", needs: vec!["bearing_length"] }
            } else {
                ModelProblem::FilmNeedsLength { entry }
            };
            return self.reader.refuse(&problem, table.get("contact").map_or(table.span, |entry| entry.key_span));
        }
        Some(Some(Clearance { bearing_radius_m, radial_clearance_m, bearing_length_m, contact }))
    }

    /// The radial clearance at `path` of a joint that states its diametral clearance: half of it, whatever that is set to.
    fn half_of(&mut self, diametral_m: QuantityId, path: &EntryPath) -> QuantityId {
        let ops = vec![Op::Load(diametral_m.0), Op::Number(0.5), Op::Multiply];
        self.derived(path.dotted(), Dimension::LENGTH, Rule::NonNegative, ops, &[diametral_m])
    }

    /// The contact of a joint with play: the one that it names, or one that stands for none; `None` after a complaint.
    pub(super) fn contact_of_play(&mut self, table: &Table<'_>, named: Option<ContactId>) -> Option<ContactId> {
        if table.has("contact") { named } else { self.no_contact() }
    }

    /// The contact that a joint names.
    pub(super) fn contact_of(&mut self, table: &Table<'_>) -> Option<ContactId> {
        let entry = table.get("contact")?;
        let name = self.reader.text(&entry)?.to_owned();
        self.used_contacts.push(name.clone());
        self.named(&entry, "contact", &name, |file| &file.contact_names)
    }

    fn prismatic(&mut self, table: &Table<'_>) -> Option<JointKind> {
        let guide = table.get("guide").and_then(|entry| {
            let guide = self.reader.table(&entry, &GUIDE_KEYS)?;
            let point = guide.get("point").and_then(|entry| self.point(&entry));
            let angle_rad = self.quantity(&guide, "angle");
            let ends_m = self.guide_ends(&guide, table.has("clearance"));
            Some((point?, angle_rad?, ends_m?))
        });
        let slider = table.get("slider").and_then(|entry| self.slider(&entry));
        let ((guide, guide_angle_rad, ends_m), (slider, slider_angle_rad)) = match guide.zip(slider) {
            Some(sound) => sound,
            None => {
                // Its complaints belong to the others.
                self.guide_clearance(table, None);
                return None;
            }
        };
        let span = clearance_span(table, &["clearance"]);
        let clearance = match self.guide_clearance(table, ends_m)? {
            Some(cold) => Some(self.warm_guide(cold, [guide.body, slider.body], span)?),
            None => None,
        };
        Some(JointKind::Prismatic { guide, guide_angle_rad, slider, slider_angle_rad, clearance })
    }

    fn slider(&mut self, entry: &Entry<'_>) -> Option<(PointId, QuantityId)> {
        if entry.is_text() {
            let point = self.point(entry)?;
            let path = entry.path.join("angle");
            return Some((point, self.default_quantity(&path, Dimension::ANGLE, Rule::Finite, 0.0)));
        }
        if !entry.is_table() {
            return self.reader.wrong_type(entry, "a point or a table with point and angle");
        }
        let table = self.reader.table(entry, &SLIDER_KEYS)?;
        let point = table.get("point").and_then(|entry| self.point(&entry));
        let angle_rad = self.quantity_or(&table, "angle", 0.0);
        Some((point?, angle_rad?))
    }

    fn rigid(&mut self, table: &Table<'_>) -> Option<JointKind> {
        let [first, second] = ["first", "second"].map(|key| table.get(key).and_then(|entry| self.point(&entry)));
        let angle_rad = self.quantity(table, "angle");
        Some(JointKind::Rigid { first: first?, second: second?, angle_rad: angle_rad? })
    }
}

/// Where the clearance of a joint stands, under one of `keys`.
pub(super) fn clearance_span(table: &Table<'_>, keys: &[&str]) -> Span {
    keys.iter().find_map(|key| table.get(key)).map_or(table.span, |entry| entry.span)
}
