//! A belt or a chain around two wheels.

use super::kind::{Coupled, KindOfCoupling};
use super::proportion::{OFFSET, Proportion};
use super::reading::CouplingReader;
use super::wheels::{Wheels, WheelsTable};
use crate::model::words::part_names::Names;
use loosepin_math::Real;
use loosepin_text::document::{Entry, Keys, Kind, Table, choice};
use loosepin_text::numbers::QuantityId;
use loosepin_text::units::Dimension;
use loosepin_text::{choices, record};

/// A belt or a chain without slip around two wheels.
#[derive(Debug, Clone)]
pub struct Belt {
    /// Both wheels.
    pub wheels: Wheels,
}

impl KindOfCoupling for Belt {
    type Curve<T: Real> = Proportion<T>;

    const WORD: &'static str = BeltTable::WORD;
    const KEYS: &'static Keys = &BeltTable::KEYS;

    fn read(entry: &Entry<'_>, table: &Table<'_>, reader: &mut dyn CouplingReader) -> Option<Coupled<Self>> {
        let own = BeltTable::of(reader, table.clone())?;
        let joints = reader.two_joints(table, [&own.first, &own.second], [Some(Dimension::ANGLE); 2])?;
        let are_opposed = own.run.map(|IsCrossed(is_crossed)| is_crossed);
        let wheels = Wheels::read((entry, &own.wheels, &own.offset), joints, are_opposed, reader)?;
        Some(Coupled::without_play(joints, Self { wheels }))
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

choices!(
    /// Whether the belt makes the wheels turn against each other.
    struct IsCrossed(bool): "open" => false, "crossed" => true
);

record! {
    /// a belt or chain without slip around two wheels; each wheel is on a revolute joint, and one body carries both joints
    struct BeltTable for CouplingReader, kind "belt" of coupling, exactly one of [radii, teeth];
    /// revolute joint of the first wheel
    required first: Option<Entry<'t>> = Kind::Reference("joint"), "\"input\"";
    /// revolute joint of the second wheel
    required second: Option<Entry<'t>> = Kind::Reference("joint"), "\"output\"";
    /// open: the wheels turn in the same direction; crossed: in opposite directions
    optional run: Option<IsCrossed> = choice::<IsCrossed>(), "\"open\"", or "open";
    include wheels: WheelsTable<'t>;
    optional offset: Entry<'t> as OFFSET;
}
