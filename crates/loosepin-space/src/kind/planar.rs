//! A face on a face: z axes are parallel, and the points have the same place along z.

use crate::kind::frames::Axis;
use crate::kind::joint_reader::JointReader;
use crate::kind::kind_of_joint::{KindOfJoint, ReadJoint};
use crate::kind::places::{Axes, PLANNED, Points, Shifts, Tilts};
use crate::kind::row::Row;
use crate::kind::sign::JointSign;
use crate::play::kind_of_play::NoPlay;
use loosepin_text::document::{Keys, Table};
use loosepin_text::numbers::ReadsNumbers;
use loosepin_text::record;

/// A face on a face: z axes are parallel, and the points have the same place along z.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Planar;

impl KindOfJoint for Planar {
    const WORD: &'static str = PlanarTable::WORD;
    const KEYS: &'static Keys = &PlanarTable::KEYS;
    const TURNS: bool = true;
    const SLIDES: bool = false;
    const SIGN: JointSign = JointSign::Plate;
    type Play = NoPlay;

    fn read(table: Table<'_>, reader: &mut dyn JointReader) -> Option<ReadJoint<Self, Self::Play>> {
        let own = PlanarTable::of(reader, table)?;
        let markers = own.axes.markers(reader, &own.table, &own.points, None);
        let markers = own.shifts.applied_to(markers, reader, Some(&own.tilts))?;
        Some(ReadJoint::ideal(Planar, markers))
    }

    fn rows(&self) -> Vec<Row> {
        vec![Row::Perpendicular(Axis::X, Axis::Z), Row::Perpendicular(Axis::Y, Axis::Z), Row::Across(Axis::Z)]
    }
}

record! {
    /// a body slides on a plane and turns in it; the axis is across the plane
    struct PlanarTable for ReadsNumbers, kind "planar" of joint, planned PLANNED;
    include points: Points<'t>;
    include axes: Axes<'t>;
    include shifts: Shifts<'t>;
    include tilts: Tilts<'t>;
}
