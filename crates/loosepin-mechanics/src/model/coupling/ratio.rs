//! Any two joints, the coordinate of one a multiple of that of the other.

use super::kind::{Coupled, KindOfCoupling};
use super::proportion::{OFFSET, Proportion, offset, words};
use super::reading::CouplingReader;
use crate::model::words::part_names::Names;
use loosepin_math::Real;
use loosepin_text::document::{Entry, Keys, Kind, Table};
use loosepin_text::numbers::QuantityId;
use loosepin_text::record;
use loosepin_text::units::Rule;

/// A ratio as given.
#[derive(Debug, Clone)]
pub struct Ratio {
    /// Coordinate of the second joint by that of the first, rad/rad, m/rad, rad/m or m/m.
    pub ratio: QuantityId,
    /// Coordinate of the second joint where the first is at zero, rad or m.
    pub offset: QuantityId,
}

impl KindOfCoupling for Ratio {
    type Curve<T: Real> = Proportion<T>;

    const WORD: &'static str = RatioTable::WORD;
    const KEYS: &'static Keys = &RatioTable::KEYS;

    fn read(_entry: &Entry<'_>, table: &Table<'_>, reader: &mut dyn CouplingReader) -> Option<Coupled<Self>> {
        let own = RatioTable::of(reader, table.clone())?;
        let joints = reader.two_joints(table, [&own.first, &own.second], [None; 2])?;
        let [from, to] = joints.map(|joint| reader.coordinate_of(joint));
        let ratio = reader.quantity_of(&own.ratio?, to.over(from), Rule::Finite)?;
        let offset = offset(&own.offset, table, joints[1], reader)?;
        Some(Coupled::without_play(joints, Self { ratio, offset }))
    }

    fn quantities(&self) -> Vec<QuantityId> {
        vec![self.ratio, self.offset]
    }

    fn curve<T: Real>(&self, number: &dyn Fn(QuantityId) -> T) -> Proportion<T> {
        Proportion { ratio: number(self.ratio), offset: number(self.offset) }
    }

    fn words(&self, names: &dyn Names) -> String {
        words(&names.quantity(self.ratio), self.offset, names)
    }
}

record! {
    /// the angle or position of the second joint is a multiple of that of the first
    struct RatioTable for CouplingReader, kind "ratio" of coupling;
    /// a revolute or prismatic joint
    required first: Option<Entry<'t>> = Kind::Reference("joint"), "\"input\"";
    /// another revolute or prismatic joint
    required second: Option<Entry<'t>> = Kind::Reference("joint"), "\"output\"";
    /// coordinate of the second joint divided by that of the first
    required ratio: Option<Entry<'t>> = Kind::AnyQuantity, "-2.5";
    optional offset: Entry<'t> as OFFSET;
}
