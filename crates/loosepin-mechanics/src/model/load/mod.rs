//! Loads: forces and torques from outside. One file for each kind, and the list of them here. Nothing outside this folder names a kind.
//!
//! A kind says of itself what the rest of the program asks ([`KindOfLoad`]), reads its own table, and says what it does at a state.

mod course;
mod force;
mod kind;
mod size;
mod torque;

pub use course::TimeCourse;
pub use force::ForceLoad;
pub use kind::{ActsOn, Direction, KindOfLoad, LoadPlace, Push};
pub(super) use size::{ARGUMENTS, PointsOfLoad};
pub use size::{SizeKeys, SizeTable};
pub use torque::TorqueLoad;

use super::ids::JointId;
use super::part_reader::PartReader;
use crate::model::words::part_names::Names;
use loosepin_math::Real;
use loosepin_text::document::{Keys, Table};
use loosepin_text::numbers::QuantityId;

/// Makes the enum of all kinds, and hands every question on to the kind.
macro_rules! load_kinds {
    ($($(#[$doc:meta])* $kind:ident),* $(,)?) => {
        /// A load of any kind.
        #[derive(Debug, Clone, Copy, PartialEq, Eq)]
        pub enum LoadKind {
            $($(#[$doc])* $kind($kind),)*
        }

        /// Words of all kinds in files, with their keys.
        pub(super) static LOAD_KINDS: &[(&str, &Keys)] =
            &[$((<$kind as KindOfLoad>::WORD, <$kind as KindOfLoad>::KEYS)),*];

        impl LoadKind {
            /// Reads a load of the kind `word` from its table: see [`KindOfLoad::read`].
            pub(super) fn read<'t>(
                word: &str,
                table: Table<'t>,
                reader: &mut dyn PartReader,
            ) -> (Option<Self>, Option<SizeTable<'t>>) {
                match word {
                    $(<$kind as KindOfLoad>::WORD => {
                        let (kind, size) = $kind::read(table, reader);
                        (kind.map(Self::$kind), size)
                    })*
                    _ => (None, None),
                }
            }

            /// How the size of the kind `word` is written: [`KindOfLoad::SIZE`].
            pub(super) fn size_of_kind(word: &str) -> Option<SizeKeys> {
                match word {
                    $(<$kind as KindOfLoad>::WORD => <$kind as KindOfLoad>::SIZE,)*
                    _ => None,
                }
            }

            /// See [`KindOfLoad::WORD`].
            pub fn word(&self) -> &'static str {
                match self { $(Self::$kind(_) => <$kind as KindOfLoad>::WORD,)* }
            }

            /// See [`KindOfLoad::SIZE`].
            pub fn size(&self) -> Option<SizeKeys> {
                match self { $(Self::$kind(_) => <$kind as KindOfLoad>::SIZE,)* }
            }

            /// See [`KindOfLoad::acts_on`].
            pub fn acts_on(&self) -> ActsOn {
                match self { $(Self::$kind(kind) => kind.acts_on(),)* }
            }

            /// See [`KindOfLoad::direction`].
            pub fn direction(&self) -> Option<Direction> {
                match self { $(Self::$kind(kind) => kind.direction(),)* }
            }

            /// See [`KindOfLoad::numbers`].
            pub(crate) fn numbers(&self, number: &dyn Fn(QuantityId) -> f64) -> Vec<f64> {
                match self { $(Self::$kind(kind) => kind.numbers(number),)* }
            }

            /// See [`KindOfLoad::push`].
            #[inline(always)]
            pub(crate) fn push<T: Real>(&self, numbers: &[T], size: T, place: &impl LoadPlace<T>) -> Push<T> {
                match self { $(Self::$kind(kind) => kind.push(numbers, size, place),)* }
            }

            /// See [`KindOfLoad::words`].
            pub fn words(&self, names: &dyn Names, size: &str) -> String {
                match self { $(Self::$kind(kind) => kind.words(names, size),)* }
            }
        }
    };
}

load_kinds! {
    /// A force on a point.
    ForceLoad,
    /// A torque on a body.
    TorqueLoad,
}

/// A force or a torque from outside; the ground gets nothing in return.
#[derive(Debug, Clone)]
pub struct Load {
    /// Name in the file.
    pub name: String,
    /// Its kind, with the point or body that it acts on.
    pub kind: LoadKind,
    /// Its size, where it has one that is constant or changes with time or with the motion of a joint.
    pub course: Option<TimeCourse>,
    /// The joint whose coordinate and rate its size is over.
    pub joint: Option<JointId>,
}
