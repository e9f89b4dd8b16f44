//! A rack and its pinion.

use super::kind::{Coupled, KindOfCoupling};
use super::play::{Backlash, BacklashTable};
use super::proportion::{OFFSET, Proportion, offset, sign, signed, words};
use super::reading::CouplingReader;
use super::teeth::{Mesh, PRESSURE_ANGLE, Teeth};
use super::wheels::is_turned;
use crate::model::words::part_names::Names;
use loosepin_math::Real;
use loosepin_text::document::{Entry, Keys, Kind, Table, choice, quantity};
use loosepin_text::numbers::QuantityId;
use loosepin_text::units::{Dimension, Rule};
use loosepin_text::{choices, record};

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

    const WORD: &'static str = RackTable::WORD;
    const KEYS: &'static Keys = &RackTable::KEYS;

    fn read(entry: &Entry<'_>, table: &Table<'_>, reader: &mut dyn CouplingReader) -> Option<Coupled<Self>> {
        let own = RackTable::of(reader, table.clone())?;
        let backlash = Backlash::read(&own.play, reader);
        let dues = [Some(Dimension::ANGLE), Some(Dimension::LENGTH)];
        let joints = reader.two_joints(table, [&own.first, &own.second], dues)?;
        let radius_m = own.radius.as_ref().and_then(|entry| reader.quantity_at(entry));
        let is_turned = is_turned(entry, joints, reader);
        let (radius_m, IsBackward(is_backward)) = (radius_m?, own.direction?);
        let is_reversed = is_backward != is_turned?;
        let offset_m = offset(&own.offset, table, joints[1], reader)?;
        let play = backlash.between_flanks(table, None, reader)?;
        let (radii_m, mesh) = ([Some(radius_m), None], Mesh::Rack { is_backward });
        let teeth = Teeth::read((table, &own.pressure_angle, &own.second), joints, radii_m, mesh, reader)?;
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

choices!(
    /// Whether the rack goes against its guide.
    struct IsBackward(bool): "forward" => false, "backward" => true
);

record! {
    /// a rack on a prismatic joint and its pinion on a revolute joint; one body carries both joints
    struct RackTable for CouplingReader, kind "rack" of coupling;
    /// revolute joint of the pinion
    required first: Option<Entry<'t>> = Kind::Reference("joint"), "\"input\"";
    /// prismatic joint of the rack
    required second: Option<Entry<'t>> = Kind::Reference("joint"), "\"output\"";
    /// pitch radius of the pinion
    required radius: Option<Entry<'t>> = quantity(Dimension::LENGTH, Rule::Positive), "\"12 mm\"";
    /// direction in which the rack moves along its guide when the pinion turns from x towards y
    required direction: Option<IsBackward> = choice::<IsBackward>(), "\"forward\"";
    optional pressure_angle: Entry<'t> as PRESSURE_ANGLE;
    optional offset: Entry<'t> as OFFSET;
    include play: BacklashTable<'t>;
}
