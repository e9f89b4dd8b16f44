//! The interface of a motion of a drive, and its terms.

use super::reading::DriveReader;
use super::table_motion::{AtTime, TableMotion};
use crate::model::words::part_names::Names;
use loosepin_math::{Dual, Real};
use loosepin_text::document::{Keys, Kind, Table, quantity};
use loosepin_text::numbers::QuantityId;
use loosepin_text::units::{Dimension, Rule};

/// Second-order dual number over time: value, rate and acceleration at once.
pub type TimeDual<T> = Dual<Dual<T>>;

/// A motion that a drive, or the reference of a control, prescribes; coordinates in rad or m.
///
/// The rest of the program asks these questions, and knows no motion by its name. What is not stated is answered so: the motion is not of
/// constant speed, has no period, no breaks and no pieces.
pub trait KindOfDrive: Sized {
    /// Its numbers.
    type Motion<T: Real>: MotionLaw<T>;

    /// Word in files; of a constant speed, which has no word there, in errors.
    const WORD: &'static str;

    /// The quantities that it follows.
    fn quantities(&self) -> Vec<QuantityId>;

    /// Its numbers, with those that `number` gives for its quantities; one of pieces is in that which holds `time_s`.
    fn motion<T: AtTime>(&self, number: &dyn Fn(QuantityId) -> T, time_s: f64) -> Self::Motion<T>;

    /// How it goes, in words: `at 5000 rpm from 0 deg`.
    fn words(&self, names: &dyn Names) -> String;

    /// Start and speed of one of constant speed.
    fn steady(&self) -> Option<Steady> {
        None
    }

    /// Its period, where it repeats itself in time.
    fn period(&self) -> Option<Period> {
        None
    }

    /// Times at which its third derivative or a lower one jumps, s, but for those between the pieces of [`KindOfDrive::pieces`].
    fn breaks_s(&self, number: &dyn Fn(QuantityId) -> f64) -> Vec<f64> {
        let _ = number;
        Vec::new()
    }

    /// The pieces that it consists of.
    fn pieces(&self, number: &dyn Fn(QuantityId) -> f64) -> Option<TableMotion<f64>> {
        let _ = number;
        None
    }

    /// Numbers that [`MotionLaw::at`] needs as room.
    fn workspace_length(&self) -> usize {
        0
    }
}

/// A motion that is written as a table of its own, behind `motion`.
pub trait MotionTable: KindOfDrive {
    /// Keys of its table.
    const KEYS: &'static Keys;

    /// Reads it from its table, for a coordinate of `dimension`; `None` after a diagnostic.
    fn read(table: &Table<'_>, dimension: Dimension, reader: &mut dyn DriveReader) -> Option<Written<Self>>;
}

/// Content of a table.
#[derive(Debug, Clone)]
pub enum Written<K> {
    /// This motion.
    Motion(K),
    /// No motion: the coordinate keeps its value.
    Standstill(QuantityId),
}

/// The numbers of a motion: what the equations of motion evaluate.
pub trait MotionLaw<T: Real> {
    /// Position, velocity and acceleration at `time_s`; `workspace` holds [`KindOfDrive::workspace_length`] numbers.
    fn at(&self, time_s: T, workspace: &mut [TimeDual<T>]) -> [T; 3];

    /// The speed, m/s or rad/s, of a motion that has the same for ever.
    fn constant_speed(&self) -> Option<T> {
        None
    }

    /// How fast it changes, 1/s: its velocity over `scale`, and what its acceleration and its frequency say about it. `None` if that takes a
    /// look at the motion.
    fn pace_1_s(&self, scale: T) -> Option<T> {
        let _ = scale;
        None
    }
}

/// start + speed t.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Steady {
    /// Speed, rad/s or m/s.
    pub speed: QuantityId,
    /// At time zero, rad or m.
    pub start: QuantityId,
}

/// The period of a motion.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Period {
    /// Frequency, 1/s.
    Frequency(QuantityId),
    /// From a time to another one, s.
    Between([QuantityId; 2]),
}

impl Period {
    /// How long it is, s, with the numbers that `number` gives.
    pub fn duration_s<T: Real>(self, number: &dyn Fn(QuantityId) -> T) -> T {
        match self {
            Self::Frequency(frequency) => T::one() / number(frequency),
            Self::Between([first_s, last_s]) => number(last_s) - number(first_s),
        }
    }
}

/// An angle or a position.
pub(super) const COORDINATE: Kind =
    Kind::AnyOf(&[quantity(Dimension::ANGLE, Rule::Finite), quantity(Dimension::LENGTH, Rule::Finite)]);
