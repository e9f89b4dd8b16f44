//! Drives and the motions that they prescribe: one file each, and the list of them here. Nothing outside this folder names a motion.
//!
//! A motion says of itself what the rest of the program asks ([`KindOfDrive`]), reads its own table ([`MotionTable`]), and has the numbers
//! that the equations evaluate ([`MotionLaw`]).

mod constant_speed;
mod cycloidal;
mod expression;
mod harmonic;
mod kind;
mod polynomial;
mod reading;
mod table_motion;
mod time_table;

pub use constant_speed::{ConstantSpeed, ConstantSpeedMotion};
pub use cycloidal::{Cycloidal, CycloidalMotion};
pub use expression::{Expression, ExpressionMotion};
pub use harmonic::{Harmonic, HarmonicMotion};
pub use kind::{KindOfDrive, MotionLaw, MotionTable, Period, Steady, TimeDual, Written};
pub use polynomial::{Polynomial, PolynomialMotion};
pub use reading::DriveReader;
pub use table_motion::{AtTime, TableMotion, TablePiece};
pub use time_table::TimeTable;

use super::ids::JointId;
use crate::model::words::part_names::Names;
use loosepin_math::{Real, numbers};
use loosepin_text::document::{Keys, Table};
use loosepin_text::numbers::QuantityId;
use loosepin_text::units::Dimension;

/// A joint coordinate prescribed over time: the journal body's angle from the bearing body's, rad, or the position of the
/// slider along the guide, m.
#[derive(Debug, Clone)]
pub struct Drive {
    /// Name in the file.
    pub name: String,
    /// The driven joint, ideal revolute or prismatic.
    pub joint: JointId,
    /// The coordinate over time.
    pub law: DriveLaw,
}

/// Makes the enum of all motions and that of their numbers, and hands every question on to the motion. Each motion stands with its numbers;
/// those with a table behind `motion` first.
macro_rules! drive_laws {
    (
        of_motion_tables { $($(#[$doc:meta])* $kind:ident($motion:ident),)* }
        of_own_keys { $($(#[$own_doc:meta])* $own_kind:ident($own_motion:ident),)* }
    ) => {
        /// Words of the motions with a table, with their keys.
        pub(super) static MOTION_KINDS: &[(&str, &Keys)] = &[$(($kind::WORD, $kind::KEYS)),*];

        impl DriveLaw {
            /// Reads the motion of the kind `word` from its table; `None` after a diagnostic, or if there is no such kind.
            pub(super) fn read(
                word: &str,
                table: &Table<'_>,
                dimension: Dimension,
                reader: &mut dyn DriveReader,
            ) -> Option<Self> {
                match word {
                    $(<$kind as KindOfDrive>::WORD => $kind::read(table, dimension, reader).map(Self::from),)*
                    _ => None,
                }
            }
        }

        $(impl From<Written<$kind>> for DriveLaw {
            fn from(written: Written<$kind>) -> Self {
                match written {
                    Written::Motion(kind) => Self::$kind(kind),
                    Written::Standstill(position) => Self::standstill(position),
                }
            }
        })*

        drive_laws! { all $($(#[$doc])* $kind($motion),)* $($(#[$own_doc])* $own_kind($own_motion),)* }
    };
    (all $($(#[$doc:meta])* $kind:ident($motion:ident),)*) => {
        /// The motions that a drive can prescribe; coordinates in rad or m.
        #[derive(Debug, Clone)]
        pub enum DriveLaw {
            $($(#[$doc])* $kind($kind),)*
        }

        /// Numbers of the motion of a driven coordinate, m or rad.
        #[derive(Debug, Clone)]
        pub enum DriveMotion<T> {
            $($(#[$doc])* $kind($motion<T>),)*
        }

        numbers!(enum DriveMotion { $($kind(motion)),* });

        impl DriveLaw {
            /// See [`KindOfDrive::motion`].
            pub fn motion<T: AtTime>(&self, number: &dyn Fn(QuantityId) -> T, time_s: f64) -> DriveMotion<T> {
                match self { $(Self::$kind(kind) => DriveMotion::$kind(kind.motion(number, time_s)),)* }
            }

            /// See [`KindOfDrive::WORD`].
            pub fn word(&self) -> &'static str {
                match self { $(Self::$kind(_) => <$kind as KindOfDrive>::WORD,)* }
            }
        }

        impl<T: Real> DriveMotion<T> {
            /// See [`MotionLaw::at`].
            #[inline(always)]
            pub fn at(&self, time_s: T, workspace: &mut [TimeDual<T>]) -> [T; 3] {
                match self { $(Self::$kind(motion) => motion.at(time_s, workspace),)* }
            }

            /// See [`MotionLaw::constant_speed`].
            pub fn constant_speed(&self) -> Option<T> {
                match self { $(Self::$kind(motion) => motion.constant_speed(),)* }
            }

            /// See [`MotionLaw::pace_1_s`].
            pub fn pace_1_s(&self, scale: T) -> Option<T> {
                match self { $(Self::$kind(motion) => motion.pace_1_s(scale),)* }
            }
        }

        /// `ask!(self, kind => expression)` for the current motion.
        macro_rules! ask {
            ($own:expr, $name:ident => $answer:expr) => {
                match $own { $(DriveLaw::$kind($name) => $answer,)* }
            };
        }
    };
}

drive_laws! {
    of_motion_tables {
        /// A polynomial over time.
        Polynomial(PolynomialMotion),
        /// A harmonic motion.
        Harmonic(HarmonicMotion),
        /// A rise between two rests.
        Cycloidal(CycloidalMotion),
        /// A table of times and coordinates; its numbers are those of the present piece.
        TimeTable(TablePiece),
        /// An expression over time.
        Expression(ExpressionMotion),
    }
    of_own_keys {
        /// A constant speed.
        ConstantSpeed(ConstantSpeedMotion),
    }
}

impl DriveLaw {
    /// One of constant speed.
    pub fn steady_motion(steady: Steady) -> Self {
        Self::ConstantSpeed(ConstantSpeed { steady })
    }

    /// Standing still at `position`.
    fn standstill(position: QuantityId) -> Self {
        Self::Polynomial(Polynomial { coefficients: vec![position] })
    }

    /// See [`KindOfDrive::quantities`].
    pub fn quantities(&self) -> Vec<QuantityId> {
        ask!(self, kind => kind.quantities())
    }

    /// See [`KindOfDrive::words`].
    pub fn words(&self, names: &dyn Names) -> String {
        ask!(self, kind => kind.words(names))
    }

    /// See [`KindOfDrive::steady`].
    pub fn steady(&self) -> Option<Steady> {
        ask!(self, kind => kind.steady())
    }

    /// See [`KindOfDrive::period`].
    pub fn period(&self) -> Option<Period> {
        ask!(self, kind => kind.period())
    }

    /// See [`KindOfDrive::breaks_s`].
    pub fn breaks_s(&self, number: &dyn Fn(QuantityId) -> f64) -> Vec<f64> {
        ask!(self, kind => kind.breaks_s(number))
    }

    /// See [`KindOfDrive::pieces`].
    pub fn pieces(&self, number: &dyn Fn(QuantityId) -> f64) -> Option<TableMotion<f64>> {
        ask!(self, kind => kind.pieces(number))
    }

    /// See [`KindOfDrive::workspace_length`].
    pub fn workspace_length(&self) -> usize {
        ask!(self, kind => kind.workspace_length())
    }
}

impl<T> From<TablePiece<T>> for DriveMotion<T> {
    fn from(piece: TablePiece<T>) -> Self {
        Self::TimeTable(piece)
    }
}
