//! Reading couplings and cams.

use super::reader::ModelReader;
use crate::model::coupling::{Coupling, CouplingLaw, Ratio};
use crate::model::ids::{BodyId, JointId};
use crate::model::keys::coupling::{CAM_KEYS, COUPLING_KINDS};
use crate::model::problem::ModelProblem;
use crate::model::quantity::QuantityId;
use loosepin_text::document::{Entry, Table};
use loosepin_text::units::{Dimension, Rule};

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
        let [first, second] = self.two_joints(&table, ["first", "second"], kind)?;
        let (from, to) = (self.coordinate_of(first), self.coordinate_of(second));
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
                Ratio::Wheels { sizes: sizes?, is_reversed: way? != is_turned? }
            }
            "rack" => {
                let way = table.get("direction");
                let way = way.and_then(|entry| self.reader.choice(&entry, &[("forward", false), ("backward", true)]));
                let radius_m = self.quantity(&table, "radius");
                let is_turned = self.is_turned(entry, first, second);
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
        Some(Coupling { path: entry.path.dotted(), first, second, law: CouplingLaw::Ratio { ratio, offset } })
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
        Some(Coupling { path: entry.path.dotted(), first, second, law: CouplingLaw::Cam { points } })
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
