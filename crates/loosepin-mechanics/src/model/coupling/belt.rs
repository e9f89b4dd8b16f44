//! A belt or a chain around two wheels.

use super::kind::{Coupled, KindOfCoupling};
use super::proportion::{OFFSET, Proportion, first, joints, second};
use super::reading::CouplingReader;
use super::wheels::{RADII, TEETH, Wheels};
use crate::model::part_names::Names;
use crate::model::quantity::QuantityId;
use loosepin_math::Real;
use loosepin_text::document::{Entry, Keys, Kind, Table, optional, required};
use loosepin_text::units::Dimension;

/// A belt or a chain without slip around two wheels.
#[derive(Debug, Clone)]
pub struct Belt {
    /// Both wheels.
    pub wheels: Wheels,
}

impl KindOfCoupling for Belt {
    type Curve<T: Real> = Proportion<T>;

    const WORD: &'static str = "belt";
    const KEYS: &'static Keys = &KEYS;

    fn read(entry: &Entry<'_>, table: &Table<'_>, reader: &mut dyn CouplingReader) -> Option<Coupled<Self>> {
        let joints = joints(table, [Some(Dimension::ANGLE); 2], reader)?;
        let are_opposed = match table.get("run") {
            Some(entry) => reader.document().choice(&entry, &[("open", false), ("crossed", true)]),
            None => Some(false),
        };
        let wheels = Wheels::read((entry, table), joints, are_opposed, reader)?;
        Some(Coupled::ideally(joints, Self { wheels }))
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
    "a belt or a chain without slip around two wheels, on revolute joints with one body in common, which carries both",
    &[
        required("kind", Kind::Choice(&["belt"]), "\"belt\"", "the kind of coupling"),
        first("revolute joint of the first wheel"),
        second("revolute joint of the second wheel"),
        optional(
            "run",
            Kind::Choice(&["open", "crossed"]),
            "\"open\"",
            "open, if left out: the wheels turn the same way; crossed: against each other",
        ),
        RADII,
        TEETH,
        OFFSET,
    ],
)
.with_exactly_one(&[&["radii", "teeth"]]);
