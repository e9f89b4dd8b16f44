//! Two gears in mesh.

use super::kind::{Coupled, KindOfCoupling};
use super::play::{BACKLASH, Backlash, CONTACT};
use super::proportion::{OFFSET, Proportion, first, joints, second};
use super::reading::CouplingReader;
use super::teeth::{Mesh, PRESSURE_ANGLE, Teeth};
use super::wheels::{RADII, TEETH, Wheels};
use crate::model::part_names::Names;
use crate::model::problem::ModelProblem;
use crate::model::quantity::QuantityId;
use loosepin_math::Real;
use loosepin_text::document::{Entry, Keys, Kind, Table, required};
use loosepin_text::units::Dimension;

/// Two gears in mesh.
#[derive(Debug, Clone)]
pub struct Gears {
    /// Both wheels.
    pub wheels: Wheels,
}

impl KindOfCoupling for Gears {
    type Curve<T: Real> = Proportion<T>;

    const WORD: &'static str = "gears";
    const KEYS: &'static Keys = &KEYS;

    fn read(entry: &Entry<'_>, table: &Table<'_>, reader: &mut dyn CouplingReader) -> Option<Coupled<Self>> {
        let mut backlash = Backlash::read(table, reader);
        if backlash.is_stated() && table.has("teeth") {
            let problem = ModelProblem::BacklashNeedsRadii { entry: table.path.describe() };
            let span = table.get("backlash").map_or(table.span, |entry| entry.key_span);
            reader.document().complain(&problem, span);
            backlash = backlash.refused();
        }
        let joints = joints(table, [Some(Dimension::ANGLE); 2], reader)?;
        let mesh = table.get("mesh");
        let mesh = mesh.and_then(|entry| {
            reader.document().choice(&entry, &[("external", Mesh::External), ("internal", Mesh::Internal)])
        });
        let are_opposed = mesh.map(|mesh| mesh == Mesh::External);
        let wheels = Wheels::read((entry, table), joints, are_opposed, reader)?;
        let play = backlash.between_flanks(table, Some(wheels.sizes[1]), reader)?;
        let teeth = Teeth::read(table, joints, wheels.sizes.map(Some), mesh?, reader)?;
        Some(Coupled { joints, kind: Self { wheels }, play, teeth })
    }

    fn quantities(&self) -> Vec<QuantityId> {
        self.wheels.quantities()
    }

    fn curve<T: Real>(&self, number: &dyn Fn(QuantityId) -> T) -> Proportion<T> {
        self.wheels.proportion(number)
    }

    fn words(&self, names: &dyn Names) -> String {
        self.wheels.words(names)
    }
}

static KEYS: Keys = Keys::new(
    "two gears in mesh, on revolute joints with one body in common, which carries both",
    &[
        required("kind", Kind::Choice(&["gears"]), "\"gears\"", "the kind of coupling"),
        first("revolute joint of the first gear"),
        second("revolute joint of the second gear"),
        required(
            "mesh",
            Kind::Choice(&["external", "internal"]),
            "\"external\"",
            "external: they turn against each other on their carrier; internal: the same way",
        ),
        RADII,
        TEETH,
        PRESSURE_ANGLE,
        OFFSET,
        BACKLASH,
        CONTACT,
    ],
)
.with_exactly_one(&[&["radii", "teeth"]]);
