//! A slider in its guide: it moves along z and does not turn.

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

/// A slider in its guide: it moves along z and does not turn.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Prismatic;

impl KindOfJoint for Prismatic {
    const WORD: &'static str = PrismaticTable::WORD;
    const KEYS: &'static Keys = &PrismaticTable::KEYS;
    const TURNS: bool = false;
    const SLIDES: bool = true;
    const SIGN: JointSign = JointSign::Guide;
    type Play = NoPlay;

    fn read(table: Table<'_>, reader: &mut dyn JointReader) -> Option<ReadJoint<Self, Self::Play>> {
        let own = PrismaticTable::of(reader, table)?;
        let (table, points, across) = (&own.table, &own.points, &own.across);
        let markers = own.axes.markers_with_directions(reader, table, points, across, Self::WORD);
        let markers = own.shifts.applied_to(markers, reader, Some(&own.tilts))?;
        Some(ReadJoint::ideal(Prismatic, markers))
    }

    fn rows(&self) -> Vec<Row> {
        vec![
            Row::Perpendicular(Axis::X, Axis::Z),
            Row::Perpendicular(Axis::Y, Axis::Z),
            Row::Across(Axis::X),
            Row::Across(Axis::Y),
            Row::Perpendicular(Axis::X, Axis::Y),
        ]
    }
}

record! {
    /// a body slides along an axis and does not turn
    struct PrismaticTable for ReadsNumbers, kind "prismatic" of joint, planned PLANNED;
    include points: Points<'t>;
    include axes: Axes<'t>;
    include across: Across<'t>;
    include shifts: Shifts<'t>;
    include tilts: Tilts<'t>;
}
