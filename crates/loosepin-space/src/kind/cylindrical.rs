//! A shaft that turns about z and slides along it.

use crate::kind::cylindrical_play::CylindricalPlay;
use crate::kind::frames::Axis;
use crate::kind::joint_reader::JointReader;
use crate::kind::kind_of_joint::{KindOfJoint, ReadJoint};
use crate::kind::places::{Across, Axes, PLANNED, Points, Shifts, Tilts};
use crate::kind::row::Row;
use crate::kind::sign::JointSign;
use crate::play::bearing::BearingKeys;
use loosepin_text::document::{Keys, Table};
use loosepin_text::numbers::{QuantityId, ReadsNumbers};
use loosepin_text::record;

/// A shaft that turns about z and slides along it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Cylindrical;

impl KindOfJoint for Cylindrical {
    const WORD: &'static str = CylindricalTable::WORD;
    const KEYS: &'static Keys = &CylindricalTable::KEYS;
    const TURNS: bool = true;
    const SLIDES: bool = true;
    const SIGN: JointSign = JointSign::Sleeve;
    type Play = CylindricalPlay<QuantityId>;

    fn read(table: Table<'_>, reader: &mut dyn JointReader) -> Option<ReadJoint<Self, Self::Play>> {
        let own = CylindricalTable::of(reader, table)?;
        let markers = own.axes.markers(reader, &own.table, &own.points, Some(&own.across));
        let play = CylindricalPlay::read(&own.play, reader, &own.table)?;
        let markers = own.shifts.applied_to(markers, reader, Some(&own.tilts))?;
        Some(ReadJoint { play, ..ReadJoint::ideal(Cylindrical, markers) })
    }

    fn rows(&self) -> Vec<Row> {
        vec![
            Row::Perpendicular(Axis::X, Axis::Z),
            Row::Perpendicular(Axis::Y, Axis::Z),
            Row::Across(Axis::X),
            Row::Across(Axis::Y),
        ]
    }
}

record! {
    /// a body turns about an axis and slides along it
    struct CylindricalTable for ReadsNumbers, kind "cylindrical" of joint, planned PLANNED;
    include points: Points<'t>;
    include axes: Axes<'t>;
    include across: Across<'t>;
    include play: BearingKeys<'t>;
    include shifts: Shifts<'t>;
    include tilts: Tilts<'t>;
}
