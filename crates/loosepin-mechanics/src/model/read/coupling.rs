//! Reading couplings and cams.

use super::reader::ModelReader;
use crate::contact::NormalDescription;
use crate::model::coupling::{Coupling, CouplingLaw, CouplingPlay, Mesh, Ratio, Teeth};
use crate::model::ids::{BodyId, ContactId, JointId};
use crate::model::joint::PlayKeys;
use crate::model::keys::coupling::{CAM_KEYS, COUPLING_KINDS};
use crate::model::problem::ModelProblem;
use crate::model::quantity::QuantityId;
use crate::model::topology::Stiffness;
use loosepin_text::document::{Entry, Table};
use loosepin_text::units::{Dimension, Rule, format_value};

/// Of the angles of a whole period that are written with as many digits as tables have.
const PERIOD_ROUND_OFF: f64 = 1e-9;

impl ModelReader {
    /// Reads the table of couplings.
    pub fn read_couplings(&mut self, entry: &Entry<'_>) {
        for entry in self.reader.named(entry, "a coupling") {
            self.remember(&entry);
            let coupling = self.coupling(&entry);
            self.couplings.extend(coupling);
        }
    }

    fn coupling(&mut self, entry: &Entry<'_>) -> Option<Coupling> {
        let (kind, table) = self.table_of_kind(entry, COUPLING_KINDS)?;
        let has_backlash = matches!(kind, "gears" | "rack");
        let contact = if has_backlash { self.contact_of(&table) } else { None };
        let backlash = if has_backlash { self.backlash(&table, kind) } else { Some(None) };
        let [first, second] = self.two_joints(&table, ["first", "second"], kind)?;
        let (from, to) = (self.coordinate_of(first), self.coordinate_of(second));
        let mut mesh = Mesh::External;
        let ratio = match kind {
            "gears" | "belt" => {
                let way = if kind == "gears" {
                    let mesh = table.get("mesh");
                    mesh.and_then(|entry| self.reader.choice(&entry, &[("external", true), ("internal", false)]))
                } else {
                    self.choice_or(&table, "run", &[("open", false), ("crossed", true)], false)
                };
                let sizes = self.sizes(&table);
                let is_turned = self.is_turned(entry, first, second);
                mesh = if way == Some(false) { Mesh::Internal } else { Mesh::External };
                Ratio::Wheels { sizes: sizes?, is_reversed: way? != is_turned? }
            }
            "rack" => {
                let way = table.get("direction");
                let way = way.and_then(|entry| self.reader.choice(&entry, &[("forward", false), ("backward", true)]));
                let radius_m = self.quantity(&table, "radius");
                let is_turned = self.is_turned(entry, first, second);
                mesh = Mesh::Rack { is_backward: way == Some(true) };
                Ratio::Rack { radius_m: radius_m?, is_reversed: way? != is_turned? }
            }
            _ => {
                let ratio = table.get("ratio");
                Ratio::Given(ratio.and_then(|entry| self.quantity_of(&entry, to.over(from), Rule::Finite))?)
            }
        };
        let offset = match table.get("offset") {
            Some(entry) => self.quantity_of(&entry, to, Rule::Finite)?,
            None => self.default_quantity(&table.path.join("offset"), to, Rule::Finite, 0.0),
        };
        let second_radius_m = match ratio {
            Ratio::Wheels { sizes: [_, radius_m], .. } => Some(radius_m),
            Ratio::Given(_) | Ratio::Rack { .. } => None,
        };
        let play = match backlash? {
            None => None,
            backlash_m => {
                let contact = self.contact_of_play(&table, contact)?;
                self.demand_contact_of_flanks(&table, contact, "the flanks of teeth")?;
                Some(CouplingPlay { backlash_m, second_radius_m, contact })
            }
        };
        let teeth = if has_backlash { self.teeth(&table, [first, second], mesh)? } else { None };
        let law = CouplingLaw::Ratio { ratio, offset };
        Some(Coupling { path: entry.path.dotted(), first, second, law, play, teeth })
    }

    /// The teeth whose force the joints feel; the outer option is absent after a complaint, the inner where torques alone act.
    fn teeth(&mut self, table: &Table<'_>, joints: [JointId; 2], mesh: Mesh) -> Option<Option<Teeth>> {
        let Some(entry) = table.get("pressure_angle") else { return Some(None) };
        let pressure_angle_rad = self.quantity(table, "pressure_angle");
        let described = || table.path.describe();
        if !matches!(mesh, Mesh::Rack { .. }) && table.has("teeth") {
            return self.reader.refuse(&ModelProblem::ForceNeedsRadii { entry: described() }, entry.key_span);
        }
        for joint in joints.map(|joint| &self.joints[joint.0]) {
            let name = || joint.name.clone();
            let problem = if joint.kind.play().is_some() {
                ModelProblem::ForceOnPlay { entry: described(), joint: name() }
            } else if joint.friction.is_some() {
                ModelProblem::ForceOnFriction { entry: described(), joint: name() }
            } else {
                continue;
            };
            return self.reader.refuse(&problem, entry.key_span);
        }
        // A force along the line of a joint that turns as well, such as a slot, is not that of a rack; gears need joints with an angle.
        let second = &self.joints[joints[1].0];
        if second.kind.slides() && !second.kind.rows().holds_angle {
            let problem = ModelProblem::ForceOnSlot { entry: described(), joint: second.name.clone() };
            return self.reader.refuse(&problem, table.get("second").map_or(table.span, |entry| entry.span));
        }
        let [a, b] = joints.map(|joint| self.joints[joint.0].kind.bodies());
        // The common body carries both; a wheel is the other one.
        let is_second = [b.contains(&a[0]), a.contains(&b[0])];
        Some(Some(Teeth { pressure_angle_rad: pressure_angle_rad?, mesh, is_second }))
    }

    /// The backlash of gears or a rack; the outer option is absent after a complaint, the inner for an ideal coupling.
    fn backlash(&mut self, table: &Table<'_>, kind: &str) -> Option<Option<QuantityId>> {
        const KEYS: PlayKeys = PlayKeys { clearance: "backlash", needed: &["contact"], beside: &["contact"] };
        let backlash = self.play_clearance(table, &KEYS)?;
        if backlash.is_some() && kind == "gears" && table.has("teeth") {
            let problem = ModelProblem::BacklashNeedsRadii { entry: table.path.describe() };
            return self.reader.refuse(&problem, table.get("backlash").map_or(table.span, |entry| entry.key_span));
        }
        Some(backlash)
    }

    /// Complains where the contact is one that flanks of teeth, or a cam and its follower, cannot have: nothing tells the radii
    /// where they touch, nor how they slide on each other.
    fn demand_contact_of_flanks(&mut self, table: &Table<'_>, id: ContactId, what_touches: &'static str) -> Option<()> {
        let contact = &self.contacts[id.0];
        let what = match (&contact.stiffness, contact.law) {
            (_, NormalDescription::Line(law)) => format!("the line-contact law '{}'", law.name),
            (Stiffness::Material { .. }, _) => "a stiffness from the materials".to_owned(),
            _ if contact.film.is_some() => "a film of oil".to_owned(),
            _ if contact.friction.is_some() => "friction".to_owned(),
            _ => return Some(()),
        };
        let problem = ModelProblem::NotForFlanks {
            entry: table.path.describe(),
            contact: contact.name.clone(),
            what,
            what_touches,
        };
        self.reader.refuse(&problem, table.get("contact").map_or(table.span, |entry| entry.span))
    }

    /// Reads the table of cams.
    pub fn read_cams(&mut self, entry: &Entry<'_>) {
        for entry in self.reader.named(entry, "a cam") {
            self.remember(&entry);
            let cam = self.reader.table(&entry, &CAM_KEYS).and_then(|table| self.cam(&entry, &table));
            self.couplings.extend(cam);
        }
    }

    fn cam(&mut self, entry: &Entry<'_>, table: &Table<'_>) -> Option<Coupling> {
        let joints = self.two_joints(table, ["joint", "follower"], "cam");
        let [first, second] = joints?;
        let [from, to] = [first, second].map(|joint| self.coordinate_of(joint));
        let points = self.table_points(table, [("cam", from), ("follower", to)])?;
        if from == Dimension::ANGLE {
            self.demand_whole_turns(table, &points)?;
        }
        let dwells = points.windows(2).map(|pair| {
            let [before, after] = [pair[0][1], pair[1][1]].map(|id| self.quantities.nominal_value(id));
            before == after
        });
        let dwells = dwells.collect();
        let play = if table.has("contact") {
            let contact = self.contact_of(table)?;
            self.demand_contact_of_flanks(table, contact, "a cam and its follower")?;
            let follower = table.get("follower").filter(|_| to != Dimension::LENGTH);
            if let Some(follower) = follower {
                let joint = self.joints[second.0].name.clone();
                let problem = ModelProblem::FollowerTurns { entry: table.path.describe(), joint };
                return self.reader.refuse(&problem, follower.span);
            }
            Some(CouplingPlay { backlash_m: None, second_radius_m: None, contact })
        } else {
            None
        };
        Some(Coupling {
            path: entry.path.dotted(),
            first,
            second,
            law: CouplingLaw::Cam { points, dwells },
            play,
            teeth: None,
        })
    }

    /// The points of a cam that turns span a turn, whole turns, or a whole part of one: after a turn it is where it was.
    fn demand_whole_turns(&mut self, table: &Table<'_>, points: &[[QuantityId; 2]]) -> Option<()> {
        let [first, last] = [points[0][0], points[points.len() - 1][0]].map(|id| self.quantities.nominal_value(id));
        let turns = (last - first) / std::f64::consts::TAU;
        let is_whole = |count: f64| (count - count.round()).abs() < PERIOD_ROUND_OFF * count;
        if is_whole(turns) || is_whole(1.0 / turns) {
            return Some(());
        }
        let degrees = |angle_rad: f64| format_value(angle_rad, Dimension::ANGLE);
        let problem = ModelProblem::CamPeriod {
            entry: table.path.describe(),
            from: degrees(first),
            to: degrees(last),
            whole: degrees(first + turns.ceil() * std::f64::consts::TAU),
        };
        let key = if table.has("csv") { "csv" } else { "points" };
        self.reader.refuse(&problem, table.get(key).map_or(table.span, |entry| entry.span))
    }

    /// Dimension of the coordinate of a joint.
    pub(super) fn coordinate_of(&self, joint: JointId) -> Dimension {
        self.joints[joint.0].kind.coordinate().unwrap_or(Dimension::ANGLE)
    }

    /// Two joints that a coupling of a kind may have.
    fn two_joints(&mut self, table: &Table<'_>, keys: [&str; 2], kind: &str) -> Option<[JointId; 2]> {
        let dues = match kind {
            "gears" | "belt" => [Some(false), Some(false)],
            "rack" => [Some(false), Some(true)],
            _ => [None, None],
        };
        let mut found = [None; 2];
        for ((key, due), found) in keys.into_iter().zip(dues).zip(&mut found) {
            *found = table.get(key).and_then(|entry| self.coupled_joint(&entry, due));
        }
        let [Some(first), Some(second)] = found else { return None };
        if first == second {
            let name = self.joints[first.0].name.clone();
            let span = table.get(keys[1]).map_or(table.span, |entry| entry.span);
            return self.reader.refuse(&ModelProblem::SameJoint { entry: table.path.describe(), joint: name }, span);
        }
        Some([first, second])
    }

    /// A joint with a coordinate: a position (true), an angle (false) or any.
    pub(super) fn coupled_joint(&mut self, entry: &Entry<'_>, is_prismatic: Option<bool>) -> Option<JointId> {
        let joint = self.moving_joint(entry)?;
        let found = self.coordinate_of(joint) == Dimension::LENGTH;
        if let Some(due) = is_prismatic.filter(|due| *due != found) {
            let name = self.joints[joint.0].name.clone();
            let due = if due { "prismatic" } else { "revolute" };
            self.reader
                .complain(&ModelProblem::WrongJoint { entry: entry.path.describe(), joint: name, due }, entry.span);
            return None;
        }
        Some(joint)
    }

    /// Radii or teeth of two wheels.
    fn sizes(&mut self, table: &Table<'_>) -> Option<[QuantityId; 2]> {
        let (key, dimension) =
            if table.has("radii") { ("radii", Dimension::LENGTH) } else { ("teeth", Dimension::NUMBER) };
        let entry = table.get(key)?;
        let pair = self.reader.pair(&entry)?;
        let mut ids = [None; 2];
        for ((mut element, name), id) in pair.into_iter().zip(["first", "second"]).zip(&mut ids) {
            element.path = entry.path.join(name);
            *id = self.quantity_of(&element, dimension, Rule::Positive);
        }
        let [first, second] = ids;
        Some([first?, second?])
    }

    /// Whether seen from the body that carries both wheels the coordinate of exactly one of the joints counts backwards: where
    /// that body is the bearing's in one joint and the journal's in the other.
    fn is_turned(&mut self, entry: &Entry<'_>, first: JointId, second: JointId) -> Option<bool> {
        let [a, b] = [first, second].map(|joint| self.joints[joint.0].kind.bodies());
        let sides = |body: BodyId, [bearing, _]: [BodyId; 2]| body == bearing;
        let common: Vec<BodyId> = a.into_iter().filter(|body| b.contains(body)).collect();
        let [carrier] = common[..] else {
            let [first, second] = [first, second].map(|joint| self.joints[joint.0].name.clone());
            let problem = ModelProblem::NoCarrier { entry: entry.path.describe(), first, second };
            return self.reader.refuse(&problem, entry.key_span);
        };
        Some(sides(carrier, a) != sides(carrier, b))
    }
}
