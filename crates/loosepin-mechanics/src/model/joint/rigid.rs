//! Two points coincide and the bodies do not turn against each other.

use super::kind::{AtBeam, Hanging, IdealRows, Keeps, KindOfJoint, NotDriven};
use super::reading::JointReader;
use crate::model::ids::PointId;
use crate::model::part_names::Names;
use crate::model::quantity::QuantityId;
use loosepin_text::document::{Keys, Kind, Table, quantity, required};
use loosepin_text::units::{Dimension, Dimension as D, Rule};

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
    const WORD: &'static str = "rigid";
    const KEYS: &'static Keys = &KEYS;
    const COORDINATE: Option<Dimension> = None;
    const HANGING: Hanging = Hanging::Fixed;
    const ROWS: IdealRows = IdealRows { keeps: Keeps::Points, holds_angle: true };
    const AT_BEAM: AtBeam = AtBeam::Section;

    fn read(table: &Table<'_>, reader: &mut dyn JointReader) -> Option<Self> {
        let [first, second] = ["first", "second"].map(|key| table.get(key).and_then(|entry| reader.point(&entry)));
        let angle_rad = reader.quantity(table, "angle");
        Some(Self { first: first?, second: second?, angle_rad: angle_rad? })
    }

    fn points(&self) -> [PointId; 2] {
        [self.first, self.second]
    }

    fn angles_rad(&self) -> [Option<QuantityId>; 2] {
        [Some(self.angle_rad), None]
    }

    fn why_not_driven(&self, _is_zero: &dyn Fn(QuantityId) -> bool) -> Option<NotDriven> {
        Some(NotDriven::never("is rigid"))
    }

    fn words(&self, names: &dyn Names) -> String {
        format!("rigid: {} is fixed to {}", names.point(self.second), names.point(self.first))
    }
}

static KEYS: Keys = Keys::new(
    "two points coincide and the bodies do not turn against each other",
    &[
        required("kind", Kind::Choice(&["rigid"]), "\"rigid\"", "the kind of joint"),
        required("first", Kind::Point, "\"arm.end\"", "point of the first body"),
        required("second", Kind::Point, "\"tool.base\"", "point of the second body"),
        required(
            "angle",
            quantity(D::ANGLE, Rule::Finite),
            "\"0 deg\"",
            "angle of the second body's x axis from the first's",
        ),
    ],
);
