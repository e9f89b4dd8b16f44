//! Wear of joints, and for how long it is stated.

use super::reader::ModelReader;
use crate::model::keys::wear::{JOINT_WEAR_KEYS, LIFE_KEYS, SURFACE_KEYS};
use crate::model::problem::ModelProblem;
use crate::model::quantity::QuantityId;
use crate::model::topology::{Clearance, SlidingVelocity, Stiffness};
use crate::model::wear::{JointWear, WearLife, WearPressure};
use loosepin_text::document::{Entry, Table};
use loosepin_text::units::{Dimension, Op, Rule};

/// Sectors of a surface, where the file does not say.
const SECTORS: usize = 360;

impl ModelReader {
    /// Wear of a revolute joint with this table; the outer option is absent after a complaint. `clearance` is what was read of its play.
    pub(super) fn joint_wear(&mut self, table: &Table<'_>, clearance: Option<&Clearance>) -> Option<Option<JointWear>> {
        let Some(entry) = table.get("wear") else { return Some(None) };
        let wear = self.reader.table(&entry, &JOINT_WEAR_KEYS)?;
        let surfaces = ["bearing", "journal"].map(|surface| wear.get(surface).map(|entry| self.coefficient(&entry)));
        let sectors = self.reader.count(&wear, "sectors").map_or(SECTORS, |count| count as usize);
        let words = [("hertz-line", WearPressure::HertzLine), ("concentrated", WearPressure::Concentrated)];
        let pressure = self.choice_or(&wear, "pressure", &words, WearPressure::HertzLine);
        if surfaces.iter().all(Option::is_none) {
            let problem = ModelProblem::NothingWears { entry: wear.path.describe() };
            return self.reader.refuse(&problem, entry.key_span);
        }
        let coefficients = surfaces.into_iter().map(|surface| match surface {
            None => Some(None),
            Some(coefficient) => coefficient.map(Some),
        });
        let coefficients: Option<Vec<Option<QuantityId>>> = coefficients.collect();
        for key in ["radial_clearance", "bearing_length"] {
            let is_there = table.has(key) || (key == "radial_clearance" && table.has("diametral_clearance"));
            if !is_there {
                self.complain_of_missing(table, "wear", vec![key]);
                return None;
            }
        }
        let clearance = clearance?;
        let contact = &self.contacts[clearance.contact.0];
        let name = contact.name.clone();
        let is_literal =
            contact.friction.as_ref().is_some_and(|friction| friction.sliding_velocity == SlidingVelocity::Literal);
        let has_materials = matches!(contact.stiffness, Stiffness::Material { .. });
        if is_literal {
            let problem = ModelProblem::WearByLiteral { entry: wear.path.describe(), contact: name };
            return self.reader.refuse(&problem, entry.key_span);
        }
        let pressure = pressure?;
        if pressure == WearPressure::HertzLine && !has_materials {
            let problem = ModelProblem::WearNeedsMaterials { entry: wear.path.describe(), contact: name };
            return self.reader.refuse(&problem, entry.key_span);
        }
        let coefficients: [Option<QuantityId>; 2] = coefficients?.try_into().ok()?;
        let bearing_length_m = clearance.bearing_length_m?;
        Some(Some(JointWear { coefficients_m2_n: coefficients, bearing_length_m, sectors, pressure }))
    }

    /// The wear coefficient of a surface: as written, or Archard's number over the hardness.
    fn coefficient(&mut self, entry: &Entry<'_>) -> Option<QuantityId> {
        let table = self.reader.table(entry, &SURFACE_KEYS)?;
        let [coefficient, archard, hardness] =
            ["coefficient", "archard", "hardness"].map(|key| self.quantity(&table, key));
        if table.has("coefficient") {
            self.refuse_beside(&table, "hardness", "coefficient");
            return coefficient.filter(|_| !table.has("hardness"));
        }
        if table.has("archard") && !table.has("hardness") {
            self.complain_of_missing(&table, "archard", vec!["hardness"]);
            return None;
        }
        let (archard, hardness) = (archard?, hardness?);
        let ops = vec![Op::Load(archard.0), Op::Load(hardness.0), Op::Divide];
        let path = table.path.join("coefficient").dotted();
        Some(self.derived(path, Dimension::WEAR_COEFFICIENT, Rule::NonNegative, ops, &[archard, hardness]))
    }

    /// For how long wear is stated. Nothing where no joint wears.
    pub(super) fn read_life(&mut self, root: &Table<'_>) -> Option<WearLife> {
        let wears = self.joints.iter().any(|joint| joint.wear.is_some());
        let cycles = match root.get("wear") {
            Some(entry) => {
                let table = self.reader.table(&entry, &LIFE_KEYS)?;
                self.remember(&entry);
                self.choice_or(&table, "geometry", &[("fixed", ())], ());
                self.uses_life = wears;
                self.quantity_or(&table, "cycles", 1.0)?
            }
            None if wears => {
                let path = root.path.join("wear").join("cycles");
                self.default_quantity(&path, Dimension::NUMBER, Rule::Positive, 1.0)
            }
            None => return None,
        };
        wears.then_some(WearLife { cycles })
    }
}
