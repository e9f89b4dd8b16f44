//! A ball in its socket: points coincide.

use crate::kind::joint_reader::JointReader;
use crate::kind::kind_of_joint::{KindOfJoint, ReadJoint};
use crate::kind::places::{PLANNED, Points, Shifts};
use crate::kind::row::Row;
use crate::kind::sign::JointSign;
use crate::kind::spherical_play::{SphericalPlay, SphericalPlayKeys};
use loosepin_text::document::{Keys, Table};
use loosepin_text::numbers::{QuantityId, ReadsNumbers};
use loosepin_text::record;

/// A ball in its socket: points coincide.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Spherical;

impl KindOfJoint for Spherical {
    const WORD: &'static str = SphericalTable::WORD;
    const KEYS: &'static Keys = &SphericalTable::KEYS;
    const TURNS: bool = false;
    const SLIDES: bool = false;
    const SIGN: JointSign = JointSign::Ball;
    type Play = SphericalPlay<QuantityId>;

    fn read(table: Table<'_>, reader: &mut dyn JointReader) -> Option<ReadJoint<Self, Self::Play>> {
        let own = SphericalTable::of(reader, table)?;
        let play = own.play.play(reader, &own.table)?;
        let markers = own.points.markers(reader);
        let markers = own.shifts.applied_to(markers, reader, None)?;
        Some(ReadJoint { play, ..ReadJoint::ideal(Spherical, markers) })
    }

    fn rows(&self) -> Vec<Row> {
        vec![Row::Coincident]
    }
}

record! {
    /// a ball in a socket
    struct SphericalTable for ReadsNumbers, kind "spherical" of joint, planned PLANNED;
    include points: Points<'t>;
    include play: SphericalPlayKeys<'t>;
    include shifts: Shifts<'t>;
}
