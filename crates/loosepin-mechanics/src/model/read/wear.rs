//! Wear of joints, and for how long it is stated.

use super::reader::ModelReader;
use crate::contact::FrictionLaw;
use crate::model::joint::Clearance;
use crate::model::parts::wear::{
    ActsBack, CycleJumps, FoundationChoice, JointWear, JointWearTable, LifeLimit, LifeTable, SurfaceWear, WearGeometry,
    WearLife, WearMeasure, WearPressure,
};
use crate::model::problem::ModelProblem;
use crate::model::{Contact, Joint, Output};
use loosepin_text::document::{Entry, EntryPath, Table, describe_path};
use loosepin_text::numbers::QuantityId;
use loosepin_text::units::{Dimension, Op, Rule};

/// Keys of a joint that go with the worn shape alone, and that of the unworn one.
const FOUNDATION_KEYS: [&str; 2] = ["foundation", "foundation_stiffness"];
const PRESSURE_KEY: &str = "pressure";

impl ModelReader {
    /// Wear of a revolute joint with this table; the outer option is absent after a diagnostic. `clearance` is what was read of its play.
    pub(super) fn joint_wear(&mut self, table: &Table<'_>, clearance: Option<&Clearance>) -> Option<Option<JointWear>> {
        let Some(entry) = table.get("wear") else { return Some(None) };
        let wear = JointWearTable::read(self, &entry)?;
        self.numbers.remember(&entry);
        for key in FOUNDATION_KEYS.into_iter().chain([PRESSURE_KEY]) {
            if let Some(entry) = wear.table.get(key) {
                self.numbers.remember(&entry);
            }
        }
        let [bearing, journal] = [&wear.bearing, &wear.journal].map(|surface| match surface {
            Some(entry) => self.coefficient(entry).map(Some),
            None => Some(None),
        });
        let foundation = match &wear.foundation_stiffness {
            Some(entry) => {
                self.numbers.refuse_beside(&wear.table, "foundation", "foundation_stiffness");
                self.numbers.quantity_at(entry).map(FoundationChoice::Given).or(wear.foundation)
            }
            None => wear.foundation,
        };
        let wear_path = wear.table.path.describe();
        if wear.bearing.is_none() && wear.journal.is_none() {
            let problem = ModelProblem::NothingWears { entry: wear_path };
            return self.numbers.reader.refuse(&problem, entry.key_span);
        }
        for key in ["radial_clearance", "bearing_length"] {
            let is_there = table.has(key) || (key == "radial_clearance" && table.has("diametral_clearance"));
            if !is_there {
                self.numbers.report_missing(table, "wear", vec![key]);
                return None;
            }
        }
        let clearance = clearance?;
        let contact = &self.contacts[clearance.contact.0];
        let name = contact.name.clone();
        if contact.is_literal() {
            let problem = ModelProblem::WearByLiteral { entry: wear_path, contact: name };
            return self.numbers.reader.refuse(&problem, entry.key_span);
        }
        let bearing_length_m = clearance.bearing_length_m?;
        Some(Some(JointWear {
            coefficients_m2_n: [bearing?, journal?],
            bearing_length_m,
            sectors: wear.sectors,
            pressure: wear.pressure?,
            foundation: foundation?,
        }))
    }

    /// The wear coefficient of a surface: as written, or Archard's number over the hardness.
    fn coefficient(&mut self, entry: &Entry<'_>) -> Option<QuantityId> {
        let SurfaceWear { table, coefficient, archard, hardness } = SurfaceWear::read(self, entry)?;
        if let Some(coefficient) = coefficient {
            self.numbers.refuse_beside(&table, "hardness", "coefficient");
            return coefficient.filter(|_| hardness.is_none());
        }
        if archard.is_some() && hardness.is_none() {
            self.numbers.report_missing(&table, "archard", vec!["hardness"]);
            return None;
        }
        let (archard, hardness) = (archard??, hardness??);
        let ops = vec![Op::Load(archard.0), Op::Load(hardness.0), Op::Divide];
        let path = table.path.join("coefficient").dotted();
        Some(self.numbers.derived(path, Dimension::WEAR_COEFFICIENT, Rule::NonNegative, ops, &[archard, hardness]))
    }

    /// For how long wear is stated. `None` if no joint wears.
    pub(super) fn read_life(&mut self, entry: &Option<Entry<'_>>, outputs: &[Output]) -> Option<WearLife> {
        let wears = self.joints.iter().any(|joint| joint.wear.is_some());
        let life = match entry {
            Some(entry) => {
                let life = LifeTable::read(self, entry)?;
                self.numbers.remember(entry);
                self.uses_life = wears;
                life
            }
            None if wears => {
                let table = Table::omitted(EntryPath::default().join("wear"), &LifeTable::KEYS);
                LifeTable::of(self, table)?
            }
            None => return None,
        };
        let geometry = match life.geometry? {
            ActsBack(true) => self.worn_geometry(&life),
            ActsBack(false) => self.fixed_geometry(&life.table),
        };
        let limit = self.limit(&life, outputs);
        let (cycles, geometry, limit) = (life.cycles?, geometry?, limit?);
        wears.then_some(WearLife { cycles, geometry, limit })
    }

    /// The unworn shape: nothing of jumps goes with it.
    fn fixed_geometry(&mut self, table: &Table<'_>) -> Option<WearGeometry> {
        for key in ["jumps", "tolerance", "limit_of", "limit"] {
            if let Some(entry) = table.get(key) {
                let problem = ModelProblem::OnlyWorn { entry: table.path.describe(), key };
                return self.numbers.reader.refuse(&problem, entry.key_span);
            }
        }
        self.fixed_joints()?;
        Some(WearGeometry::Fixed)
    }

    /// Reports joints that wear with the unworn shape and do not go with it; `None` if one does not.
    fn fixed_joints(&mut self) -> Option<()> {
        let mut is_sound = true;
        for (name, contact, pressure, _) in self.wearing_joints() {
            let path = format!("joint.{name}.wear");
            for key in FOUNDATION_KEYS {
                if let Some(span) = self.numbers.places.get(&format!("{path}.{key}")).copied() {
                    self.numbers.reader.report(&ModelProblem::OnlyWorn { entry: describe_path(&path), key }, span);
                    is_sound = false;
                }
            }
            let has_materials = self.contacts[contact].law.materials().is_some();
            let span = self.numbers.places.get(&path).copied()?;
            if pressure == WearPressure::HertzLine && !has_materials {
                let contact = self.contacts[contact].name.clone();
                let problem = ModelProblem::WearNeedsMaterials { entry: describe_path(&path), contact };
                self.numbers.reader.report(&problem, span);
                is_sound = false;
            }
        }
        is_sound.then_some(())
    }

    /// Name, contact, pressure and foundation of the joints with play that wear.
    fn wearing_joints(&self) -> Vec<(String, usize, WearPressure, FoundationChoice)> {
        let wearing = |joint: &Joint| {
            let (wear, clearance) = joint.wear.as_ref().zip(joint.kind.pin_clearance())?;
            Some((joint.name.clone(), clearance.contact.0, wear.pressure, wear.foundation))
        };
        self.joints.iter().filter_map(wearing).collect()
    }

    /// The worn shape, by jumps.
    fn worn_geometry(&mut self, life: &LifeTable<'_>) -> Option<WearGeometry> {
        let table = &life.table;
        let span = table.get("geometry").map_or(table.span, |entry| entry.key_span);
        for (joint, contact, _, foundation) in self.wearing_joints() {
            let contact = &self.contacts[contact];
            if let Some(what) = not_for_foundations(contact, foundation) {
                let contact = contact.name.clone();
                let problem = ModelProblem::WornContact { entry: table.path.describe(), joint, contact, what };
                return self.numbers.reader.refuse(&problem, span);
            }
            let path = format!("joint.{joint}.wear");
            if let Some(span) = self.numbers.places.get(&format!("{path}.{PRESSURE_KEY}")).copied() {
                let problem = ModelProblem::OnlyFixed { entry: describe_path(&path), key: PRESSURE_KEY };
                return self.numbers.reader.refuse(&problem, span);
            }
        }
        let tolerance = life.tolerance.quantity(self);
        let jumps = match life.jumps {
            Some(count) => {
                self.numbers.refuse_beside(table, "tolerance", "jumps");
                CycleJumps::Equal(count?)
            }
            None => CycleJumps::Controlled(tolerance?),
        };
        Some(WearGeometry::Worn(jumps))
    }

    /// Reports outputs of wear that need the worn shape, or a limit.
    pub(super) fn refuse_measures_of_fixed_wear(&mut self, outputs: &[Output], life: Option<&WearLife>) {
        let Some(life) = life else { return };
        for output in outputs {
            let Some((_, measure)) = output.kind.wear() else { continue };
            let needs = match measure {
                WearMeasure::Clearance if life.geometry == WearGeometry::Fixed => "geometry = \"worn\"",
                WearMeasure::Life if life.limit.is_none() => "geometry = \"worn\" and a limit",
                _ => continue,
            };
            let problem =
                ModelProblem::MeasureOfWornGeometry { output: output.name.clone(), measure: measure.word(), needs };
            if let Some(span) = self.numbers.places.get(&format!("output.{}", output.name)).copied() {
                self.numbers.reader.report(&problem, span);
            }
        }
    }

    /// The deviation that ends the life of the mechanism; the outer option is absent after a diagnostic.
    fn limit(&mut self, life: &LifeTable<'_>, outputs: &[Output]) -> Option<Option<LifeLimit>> {
        let (of, limit) = match (&life.limit_of, &life.limit) {
            (None, None) => return Some(None),
            (Some(of), Some(limit)) => (of, limit),
            (of, _) => {
                let [key, needed] = if of.is_some() { ["limit_of", "limit"] } else { ["limit", "limit_of"] };
                self.numbers.report_missing(&life.table, key, vec![needed]);
                return None;
            }
        };
        let name = self.numbers.reader.text(of)?;
        let name = name.strip_prefix("output.").unwrap_or(name).to_owned();
        let has_history = |output: &Output| output.kind.reading().is_some();
        let Some(output) = outputs.iter().position(|output| output.name == name && has_history(output)) else {
            let problem = ModelProblem::NoLimitedOutput { entry: of.path.describe(), output: name };
            return self.numbers.reader.refuse(&problem, of.span);
        };
        let limit = self.numbers.quantity_of(limit, outputs[output].kind.dimension(), Rule::Positive)?;
        Some(Some(LifeLimit { output, limit }))
    }
}

/// Why a contact has no elastic foundation.
fn not_for_foundations(contact: &Contact, foundation: FoundationChoice) -> Option<&'static str> {
    let has_materials = contact.law.materials().is_some();
    let has_memory = |numbers: usize, law: FrictionLaw<f64>| numbers > 0 && law.has_bristle();
    let friction = contact.friction.as_ref();
    // Any numbers: whether a law has a bristle does not depend on them.
    let ones = |count: usize| vec![1.0; count];
    if contact.film.is_some() {
        return Some("has a film of oil");
    }
    if friction.is_some_and(|own| has_memory(own.numbers.len(), own.law.law(&ones(own.numbers.len())))) {
        return Some("has friction with a memory");
    }
    match foundation {
        _ if contact.law.loss().is_none() => Some("has no loss of the form 1 + χ δ̇/v0"),
        FoundationChoice::Liu if !has_materials => Some("has a given stiffness: write foundation_stiffness"),
        FoundationChoice::Law if !has_materials || contact.law.line().is_some() => {
            Some("is no point law with materials: write foundation_stiffness")
        }
        _ => None,
    }
}
