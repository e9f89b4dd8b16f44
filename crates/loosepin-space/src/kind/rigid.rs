//! Both bodies move as one.

use crate::kind::frames::Axis;
use crate::kind::joint_reader::JointReader;
use crate::kind::kind_of_joint::{KindOfJoint, ReadJoint};
use crate::kind::places::{Across, Axes, PLANNED, Points, Shifts, Tilts};
use crate::kind::row::Row;
use crate::kind::sign::JointSign;
use crate::play::kind_of_play::NoPlay;
use loosepin_text::document::{Keys, Table};
use loosepin_text::numbers::ReadsNumbers;
use loosepin_text::record;

/// Both bodies move as one.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Rigid;

impl KindOfJoint for Rigid {
    const WORD: &'static str = RigidTable::WORD;
    const KEYS: &'static Keys = &RigidTable::KEYS;
    const TURNS: bool = false;
    const SLIDES: bool = false;
    const SIGN: JointSign = JointSign::Weld;
    type Play = NoPlay;

    fn read(table: Table<'_>, reader: &mut dyn JointReader) -> Option<ReadJoint<Self, Self::Play>> {
        let own = RigidTable::of(reader, table)?;
        let (table, points, across) = (&own.table, &own.points, &own.across);
        let markers = own.axes.markers_with_directions(reader, table, points, across, Self::WORD);
        let markers = own.shifts.applied_to(markers, reader, Some(&own.tilts))?;
        Some(ReadJoint::ideal(Rigid, markers))
    }

    fn rows(&self) -> Vec<Row> {
        vec![
            Row::Coincident,
            Row::Perpendicular(Axis::X, Axis::Z),
            Row::Perpendicular(Axis::Y, Axis::Z),
            Row::Perpendicular(Axis::X, Axis::Y),
        ]
    }
}

record! {
    /// both bodies move as one
    struct RigidTable for ReadsNumbers, kind "rigid" of joint, planned PLANNED;
    include points: Points<'t>;
    include axes: Axes<'t>;
    include across: Across<'t>;
    include shifts: Shifts<'t>;
    include tilts: Tilts<'t>;
}
