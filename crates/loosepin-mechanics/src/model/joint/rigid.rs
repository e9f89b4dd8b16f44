//! Two points coincide and the bodies do not turn against each other.

use super::kind::{AtBeam, KindOfJoint, NotDriven, TreeAttachment};
use super::reading::JointReader;
use super::row::PlaneRow;
use crate::model::ids::PointId;
use crate::model::words::part_names::Names;
use loosepin_text::document::{Keys, Kind, Table, quantity};
use loosepin_text::numbers::QuantityId;
use loosepin_text::record;
use loosepin_text::units::{Dimension, Rule};

/// Both points coincide and the bodies do not turn against each other.
#[derive(Debug, Clone)]
pub struct Rigid {
    /// Point of the first body.
    pub first: PointId,
    /// Point of the second body.
    pub second: PointId,
    /// Angle of the second body's x axis from the first body's x axis, rad.
    pub angle_rad: QuantityId,
}

impl KindOfJoint for Rigid {
    const WORD: &'static str = RigidTable::WORD;
    const KEYS: &'static Keys = &RigidTable::KEYS;
    const COORDINATE: Option<Dimension> = None;
    const TREE_ATTACHMENT: TreeAttachment = TreeAttachment::Fixed;
    const ROWS: &'static [PlaneRow] = &[PlaneRow::Coincident, PlaneRow::Angle];
    const AT_BEAM: AtBeam = AtBeam::Section;

    fn read(table: &Table<'_>, reader: &mut dyn JointReader) -> Option<Self> {
        let RigidTable { first, second, angle, .. } = RigidTable::of(reader, table.clone())?;
        Some(Self { first, second, angle_rad: angle })
    }

    fn points(&self) -> [PointId; 2] {
        [self.first, self.second]
    }

    fn angles_rad(&self) -> [Option<QuantityId>; 2] {
        [Some(self.angle_rad), None]
    }

    fn why_not_driven(&self, _is_zero: &dyn Fn(QuantityId) -> bool) -> Option<NotDriven> {
        Some(NotDriven::because("is rigid"))
    }

    fn words(&self, names: &dyn Names) -> String {
        format!("rigid: {} is fixed to {}", names.point(self.second), names.point(self.first))
    }
}

record! {
    /// two points coincide, and the bodies do not rotate relative to each other
    struct RigidTable for JointReader, kind "rigid" of joint;
    /// point of the first body
    required first: PointId = Kind::Point, "\"arm.end\"";
    /// point of the second body
    required second: PointId = Kind::Point, "\"tool.base\"";
    /// angle from the first body's x axis to the second's
    required angle: QuantityId = quantity(Dimension::ANGLE, Rule::Finite), "\"0 deg\"";
}
