//! A nut on its screw.

use crate::kind::frames::Axis;
use crate::kind::joint_reader::JointReader;
use crate::kind::kind_of_joint::{KindOfJoint, ReadJoint};
use crate::kind::places::{Across, Axes, PLANNED, Points, Shifts, Tilts};
use crate::kind::row::Row;
use crate::kind::sign::JointSign;
use crate::play::kind_of_play::NoPlay;
use loosepin_text::document::{Keys, Table, quantity};
use loosepin_text::numbers::{QuantityId, ReadsNumbers};
use loosepin_text::record;
use loosepin_text::units::{Dimension as D, Rule};

/// A nut on its screw: a shaft that turns about z and moves along it by the pitch for each turn, z_i·d = (p/2π) φ.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Screw {
    /// Advance p in one turn, m; negative for a left-hand thread.
    pub pitch_m: f64,
}

impl KindOfJoint for Screw {
    const WORD: &'static str = ScrewTable::WORD;
    const KEYS: &'static Keys = &ScrewTable::KEYS;
    const TURNS: bool = true;
    const SLIDES: bool = true;
    const SIGN: JointSign = JointSign::Sleeve;
    type Play = NoPlay;

    fn read(table: Table<'_>, reader: &mut dyn JointReader) -> Option<ReadJoint<Self, Self::Play>> {
        let own = ScrewTable::of(reader, table)?;
        let markers = own.axes.markers(reader, &own.table, &own.points, Some(&own.across));
        let markers = own.shifts.applied_to(markers, reader, Some(&own.tilts))?;
        let kind = Self { pitch_m: f64::NAN };
        Some(ReadJoint { numbers: vec![own.pitch], ..ReadJoint::ideal(kind, markers) })
    }

    fn rows(&self) -> Vec<Row> {
        vec![
            Row::Perpendicular(Axis::X, Axis::Z),
            Row::Perpendicular(Axis::Y, Axis::Z),
            Row::Across(Axis::X),
            Row::Across(Axis::Y),
            Row::Helix { pitch_m: self.pitch_m },
        ]
    }

    fn with_numbers(self, numbers: &[f64]) -> Self {
        numbers.first().map_or(self, |&pitch_m| Self { pitch_m })
    }

    fn mistake(&self) -> Option<&'static str> {
        let is_pitch = self.pitch_m.is_finite() && self.pitch_m != 0.0;
        (!is_pitch).then_some("the pitch of a screw must be a number other than 0")
    }

    fn pitch_m(&self) -> Option<f64> {
        Some(self.pitch_m)
    }
}

record! {
    /// a nut on its screw
    struct ScrewTable for ReadsNumbers, kind "screw" of joint, planned PLANNED;
    include points: Points<'t>;
    include axes: Axes<'t>;
    include across: Across<'t>;
    /// advance in one turn; negative for a left-hand thread
    required pitch: QuantityId = quantity(D::LENGTH, Rule::Finite), "\"5 mm\"";
    include shifts: Shifts<'t>;
    include tilts: Tilts<'t>;
}
