//! A rack and its pinion.

use super::kind::{Coupled, KindOfCoupling};
use super::play::{BACKLASH, Backlash, CONTACT};
use super::proportion::{OFFSET, Proportion, first, joints, offset, second, sign, signed, words};
use super::reading::CouplingReader;
use super::teeth::{Mesh, PRESSURE_ANGLE, Teeth};
use super::wheels::is_turned;
use crate::model::part_names::Names;
use crate::model::quantity::QuantityId;
use loosepin_math::Real;
use loosepin_text::document::{Entry, Keys, Kind, Table, quantity, required};
use loosepin_text::units::{Dimension, Dimension as D, Rule};

/// A rack and its pinion.
#[derive(Debug, Clone)]
pub struct Rack {
    /// Pitch radius of the pinion, m.
    pub radius_m: QuantityId,
    /// Whether the coordinates of the joints go against each other.
    pub is_reversed: bool,
    /// Position of the rack where the pinion is at zero, m.
    pub offset_m: QuantityId,
}

impl KindOfCoupling for Rack {
    type Curve<T: Real> = Proportion<T>;

    const WORD: &'static str = "rack";
    const KEYS: &'static Keys = &KEYS;

    fn read(entry: &Entry<'_>, table: &Table<'_>, reader: &mut dyn CouplingReader) -> Option<Coupled<Self>> {
        let backlash = Backlash::read(table, reader);
        let joints = joints(table, [Some(Dimension::ANGLE), Some(Dimension::LENGTH)], reader)?;
        let is_backward = table.get("direction");
        let is_backward =
            is_backward.and_then(|entry| reader.document().choice(&entry, &[("forward", false), ("backward", true)]));
        let radius_m = reader.quantity(table, "radius");
        let is_turned = is_turned(entry, joints, reader);
        let (radius_m, is_backward) = (radius_m?, is_backward?);
        let is_reversed = is_backward != is_turned?;
        let offset_m = offset(table, joints[1], reader)?;
        let play = backlash.between_flanks(table, None, reader)?;
        let teeth = Teeth::read(table, joints, [Some(radius_m), None], Mesh::Rack { is_backward }, reader)?;
        Some(Coupled { joints, kind: Self { radius_m, is_reversed, offset_m }, play, teeth })
    }

    fn quantities(&self) -> Vec<QuantityId> {
        vec![self.radius_m, self.offset_m]
    }

    fn curve<T: Real>(&self, number: &dyn Fn(QuantityId) -> T) -> Proportion<T> {
        Proportion { ratio: signed(number(self.radius_m), self.is_reversed), offset: number(self.offset_m) }
    }

    fn words(&self, names: &dyn Names) -> String {
        let factor = format!("{}{} / rad", sign(self.is_reversed), names.quantity(self.radius_m));
        words(&factor, self.offset_m, names)
    }
}

static KEYS: Keys = Keys::new(
    "a rack and its pinion, on a prismatic and a revolute joint with one body in common, which carries both",
    &[
        required("kind", Kind::Choice(&["rack"]), "\"rack\"", "the kind of coupling"),
        first("revolute joint of the pinion"),
        second("prismatic joint of the rack"),
        required("radius", quantity(D::LENGTH, Rule::Positive), "\"12 mm\"", "pitch radius of the pinion"),
        required(
            "direction",
            Kind::Choice(&["forward", "backward"]),
            "\"forward\"",
            "how the rack goes along the line of its guide when the pinion turns from x towards y",
        ),
        PRESSURE_ANGLE,
        OFFSET,
        BACKLASH,
        CONTACT,
    ],
);
