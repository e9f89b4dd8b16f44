//! A pin in its bearing: points coincide and z axes are parallel; one turn about z.

use crate::kind::frames::Axis;
use crate::kind::joint_reader::JointReader;
use crate::kind::kind_of_joint::{KindOfJoint, ReadJoint};
use crate::kind::places::{Across, Axes, PLANNED, Points, Shifts, Tilts};
use crate::kind::revolute_play::{RevolutePlay, RevolutePlayKeys};
use crate::kind::row::Row;
use crate::kind::sign::JointSign;
use loosepin_text::document::{Keys, Table};
use loosepin_text::numbers::{QuantityId, ReadsNumbers};
use loosepin_text::record;

/// A pin in its bearing: points coincide and z axes are parallel; one turn about z.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Revolute;

impl KindOfJoint for Revolute {
    const WORD: &'static str = RevoluteTable::WORD;
    const KEYS: &'static Keys = &RevoluteTable::KEYS;
    const TURNS: bool = true;
    const SLIDES: bool = false;
    const SIGN: JointSign = JointSign::Pin;
    type Play = RevolutePlay<QuantityId>;

    fn read(table: Table<'_>, reader: &mut dyn JointReader) -> Option<ReadJoint<Self, Self::Play>> {
        let own = RevoluteTable::of(reader, table)?;
        let markers = own.axes.markers(reader, &own.table, &own.points, Some(&own.across));
        let play = own.play.play(reader, &own.table)?;
        let markers = own.shifts.applied_to(markers, reader, Some(&own.tilts))?;
        Some(ReadJoint { play, ..ReadJoint::ideal(Revolute, markers) })
    }

    fn rows(&self) -> Vec<Row> {
        vec![Row::Coincident, Row::Perpendicular(Axis::X, Axis::Z), Row::Perpendicular(Axis::Y, Axis::Z)]
    }
}

record! {
    /// both bodies turn about an axis
    struct RevoluteTable for ReadsNumbers, kind "revolute" of joint, planned PLANNED;
    include points: Points<'t>;
    include axes: Axes<'t>;
    include across: Across<'t>;
    include play: RevolutePlayKeys<'t>;
    include shifts: Shifts<'t>;
    include tilts: Tilts<'t>;
}
