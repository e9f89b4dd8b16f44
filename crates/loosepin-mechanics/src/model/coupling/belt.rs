//! A belt or a chain around two wheels.

use super::kind::{Coupled, KindOfCoupling};
use super::proportion::{OFFSET, Proportion, first, joints, offset, second, words};
use super::reading::CouplingReader;
use super::wheels::{RADII, TEETH, Wheels};
use crate::model::joint::Names;
use crate::model::quantity::QuantityId;
use loosepin_math::Real;
use loosepin_text::document::{Entry, Keys, Kind, Table, optional, required};
use loosepin_text::units::Dimension;

/// A belt or a chain without slip around two wheels.
#[derive(Debug, Clone)]
pub struct Belt {
    /// Both wheels.
    pub wheels: Wheels,
    /// Angle of the second where the first is at zero, rad.
    pub offset_rad: QuantityId,
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
        let offset_rad = offset(table, joints[1], reader)?;
        Some(Coupled::ideally(joints, Self { wheels, offset_rad }))
    }

    fn quantities(&self) -> Vec<QuantityId> {
        self.wheels.sizes.into_iter().chain([self.offset_rad]).collect()
    }

    fn curve<T: Real>(&self, number: &dyn Fn(QuantityId) -> T) -> Proportion<T> {
        Proportion { ratio: self.wheels.ratio(number), offset: number(self.offset_rad) }
    }

    fn words(&self, names: &dyn Names) -> String {
        words(&self.wheels.words(names), self.offset_rad, names)
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
