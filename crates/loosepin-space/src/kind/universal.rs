//! Two shafts and a cross: points coincide, and the z axes, which are the two pins of the cross, stay at a right angle.

use crate::kind::frames::Axis;
use crate::kind::joint_reader::JointReader;
use crate::kind::kind_of_joint::{KindOfJoint, ReadJoint};
use crate::kind::places::{PLANNED, Points, Shifts, Tilts, marker};
use crate::kind::row::Row;
use crate::kind::sign::JointSign;
use crate::model::direction::DIRECTION;
use crate::play::kind_of_play::NoPlay;
use loosepin_text::document::{Entry, Keys, Table};
use loosepin_text::numbers::ReadsNumbers;
use loosepin_text::record;

/// Two shafts and a cross: points coincide, and the z axes, which are the two pins of the cross, stay at a right angle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Universal;

impl KindOfJoint for Universal {
    const WORD: &'static str = UniversalTable::WORD;
    const KEYS: &'static Keys = &UniversalTable::KEYS;
    const TURNS: bool = false;
    const SLIDES: bool = false;
    const SIGN: JointSign = JointSign::Cross;
    type Play = NoPlay;

    fn read(table: Table<'_>, reader: &mut dyn JointReader) -> Option<ReadJoint<Self, Self::Play>> {
        let own = UniversalTable::of(reader, table)?;
        let bearing = marker(reader, &own.points.bearing, Some(&own.bearing_pin), None);
        let journal = marker(reader, &own.points.journal, Some(&own.journal_pin), None);
        let markers = bearing.zip(journal).map(|(bearing, journal)| [bearing, journal]);
        let markers = own.shifts.applied_to(markers, reader, Some(&own.tilts))?;
        Some(ReadJoint::ideal(Universal, markers))
    }

    fn rows(&self) -> Vec<Row> {
        vec![Row::Coincident, Row::Perpendicular(Axis::Z, Axis::Z)]
    }
}

record! {
    /// two shafts and a cross, whose pins stay at a right angle
    struct UniversalTable for ReadsNumbers, kind "universal" of joint, planned PLANNED;
    include points: Points<'t>;
    /// the pin of the cross in the body of the bearing
    required bearing_pin: Entry<'t> = DIRECTION, "\"y\"";
    /// the pin of the cross in the body of the journal
    required journal_pin: Entry<'t> = DIRECTION, "\"z\"";
    include shifts: Shifts<'t>;
    include tilts: Tilts<'t>;
}
