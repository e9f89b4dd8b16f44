//! Kinds of joints, with a file for each, and another for its play: their tables, the rows that they are made of, where play takes them. Nothing
//! else names a kind.

pub(crate) mod frames;
pub(crate) mod joint_reader;
pub(crate) mod kind_of_joint;
pub(crate) mod places;
pub(crate) mod row;
pub(crate) mod sign;

mod cylindrical;
mod cylindrical_play;
mod planar;
mod prismatic;
mod revolute;
mod revolute_play;
mod rigid;
mod screw;
mod spherical;
mod spherical_play;
mod universal;
mod upright_play;

pub use cylindrical::Cylindrical;
pub use cylindrical_play::CylindricalPlay;
pub use planar::Planar;
pub use prismatic::Prismatic;
pub use revolute::Revolute;
pub use revolute_play::RevolutePlay;
pub use rigid::Rigid;
pub use screw::Screw;
pub use spherical::Spherical;
pub use spherical_play::SphericalPlay;
pub use universal::Universal;
pub use upright_play::UprightPlay;

use crate::play::block::Block;
use crate::play::kind_of_play::{KindOfPlay, NoPlay, PlayNumbers, PlayOfFile};
use frames::MarkerShift;
use joint_reader::JointReader;
use kind_of_joint::{KindOfJoint, ReadJoint};
use loosepin_text::document::{Keys, Table};
use loosepin_text::numbers::{QuantityId, Values};
use row::Row;
use sign::JointSign;

/// Makes the enum of all kinds, and hands every question on to the kind.
macro_rules! spatial_kinds {
    ($($kind:ident),* $(,)?) => {
        /// A kind of joint in space; each stands in a file of its own.
        #[derive(Debug, Clone, Copy, PartialEq)]
        pub enum SpatialKind {
            $(#[doc = concat!("See [`", stringify!($kind), "`].")] $kind($kind),)*
        }

        /// Words of all kinds in files, with their keys.
        pub(crate) const JOINT_KINDS: &[(&str, &Keys)] = &[$(($kind::WORD, $kind::KEYS)),*];

        $(impl From<$kind> for SpatialKind {
            fn from(kind: $kind) -> Self {
                Self::$kind(kind)
            }
        })*

        impl SpatialKind {
            /// Reads a joint of the kind `word` from its table; `None` after a diagnostic, or if there is no such kind.
            pub(crate) fn read(
                word: &str,
                table: Table<'_>,
                reader: &mut dyn JointReader,
            ) -> Option<ReadJoint<Self, SpatialPlay<QuantityId>>> {
                match word {
                    $(<$kind as KindOfJoint>::WORD => $kind::read(table, reader).map(ReadJoint::into_any),)*
                    _ => None,
                }
            }

            /// Keys of a file that give a joint of this kind play; none where it has none.
            pub fn play_keys(&self) -> &'static [&'static str] {
                match self { $(Self::$kind(_) => <$kind as KindOfJoint>::Play::KEYS,)* }
            }

            /// The kind with these values of its numbers.
            pub(crate) fn with_numbers(self, numbers: &[f64]) -> Self {
                match self { $(Self::$kind(kind) => Self::$kind(kind.with_numbers(numbers)),)* }
            }
        }

        /// `ask!(self, kind => expression)` for the current kind; `constant!(self, NAME)` for a constant of its kind.
        macro_rules! ask {
            ($own:expr, $name:ident => $answer:expr) => {
                match $own { $(SpatialKind::$kind($name) => $answer,)* }
            };
        }
        macro_rules! constant {
            ($own:expr, $name:ident) => {
                match $own { $(SpatialKind::$kind(_) => <$kind as KindOfJoint>::$name,)* }
            };
        }
    };
}

/// Makes the enum of all kinds of play, and hands every question on to the kind.
macro_rules! spatial_plays {
    ($($variant:ident($kind:ident)),* $(,)?) => {
        /// Play of a joint in space, its numbers values or quantities of a model; each kind stands in a file of its own.
        #[derive(Debug, Clone, Copy, PartialEq)]
        pub enum SpatialPlay<N = f64> {
            $(#[doc = concat!("See [`", stringify!($kind), "`].")] $variant($kind<N>),)*
        }

        $(impl<N> From<$kind<N>> for SpatialPlay<N> {
            fn from(play: $kind<N>) -> Self {
                Self::$variant(play)
            }
        })*

        impl SpatialPlay<QuantityId> {
            /// The play with these values.
            pub fn with(&self, values: &Values) -> SpatialPlay {
                match self { $(Self::$variant(play) => SpatialPlay::$variant(play.with(|number| values[number])),)* }
            }
        }

        macro_rules! ask_play {
            ($own:expr, $name:ident => $answer:expr) => {
                match $own { $(SpatialPlay::$variant($name) => $answer,)* }
            };
        }
        macro_rules! constant_of_play {
            ($own:expr, $name:ident) => {
                match $own { $(SpatialPlay::$variant(_) => <$kind as KindOfPlay>::$name,)* }
            };
        }
    };
}

spatial_kinds! {
    Revolute,
    Prismatic,
    Cylindrical,
    Spherical,
    Universal,
    Planar,
    Screw,
    Rigid,
}

spatial_plays! {
    Spherical(SphericalPlay),
    Revolute(RevolutePlay),
    Upright(UprightPlay),
    Cylindrical(CylindricalPlay),
}

impl SpatialKind {
    /// The word for it in files.
    pub fn word(&self) -> &'static str {
        constant!(self, WORD)
    }

    /// Whether the angle φ = atan2(y_i·x_j, x_i·x_j) about z is a coordinate of it.
    pub fn turns(&self) -> bool {
        constant!(self, TURNS)
    }

    /// Whether the place z_i·d along z is a coordinate of it.
    pub fn slides(&self) -> bool {
        constant!(self, SLIDES)
    }

    /// What is drawn of it.
    pub(crate) fn sign(&self) -> JointSign {
        constant!(self, SIGN)
    }

    /// The rows that hold the journal's marker to the bearing's.
    pub fn rows(&self) -> Vec<Row> {
        ask!(self, kind => kind.rows())
    }

    /// Degrees of freedom that it leaves: 6 minus its rows.
    pub fn freedoms(&self) -> usize {
        6 - self.rows().into_iter().map(|row| row.scalars().len()).sum::<usize>()
    }

    /// Advance along z in one turn, m, where the place along z follows the angle.
    pub(crate) fn pitch_m(&self) -> Option<f64> {
        ask!(self, kind => kind.pitch_m())
    }

    /// The rule that its numbers break, if they do.
    pub(crate) fn mistake(&self) -> Option<&'static str> {
        ask!(self, kind => kind.mistake())
    }
}

impl<N> From<NoPlay> for SpatialPlay<N> {
    fn from(none: NoPlay) -> Self {
        match none {}
    }
}

impl<N: Copy> SpatialPlay<N> {
    /// The radial clearance, and that along the axis.
    pub fn clearances_m(&self) -> [Option<N>; 2] {
        ask_play!(self, play => play.clearances_m())
    }

    /// Length of the bearing, its middle at the marker, m; `None` where the play does not depend on one.
    pub fn bearing_length_m(&self) -> Option<N> {
        ask_play!(self, play => play.bearing_length_m())
    }
}

impl SpatialPlay {
    /// Its name.
    pub fn word(&self) -> &'static str {
        constant_of_play!(self, WORD)
    }

    /// The word of the kind of joint that it belongs to.
    pub(crate) fn joint_word(&self) -> &'static str {
        constant_of_play!(self, JOINT)
    }

    /// The blocks of variables.
    pub fn blocks(&self) -> Vec<Block> {
        ask_play!(self, play => play.blocks())
    }

    /// Where the variables take the bearing's marker.
    pub fn marker_shift(&self, variables: &[f64]) -> MarkerShift {
        ask_play!(self, play => play.marker_shift(variables))
    }

    /// Derivatives of [`Self::marker_shift`] by each variable.
    pub fn derivatives(&self, variables: &[f64]) -> Vec<MarkerShift> {
        ask_play!(self, play => play.derivatives(variables))
    }

    /// Second derivatives of [`Self::marker_shift`], by two variables, that are not zero.
    pub(crate) fn second_derivatives(&self) -> Vec<(usize, usize, MarkerShift)> {
        ask_play!(self, play => play.second_derivatives())
    }

    /// The first number that cannot be, if one is: its name, its value and the rule that it breaks.
    pub(crate) fn mistake(&self) -> Option<(&'static str, f64, &'static str)> {
        ask_play!(self, play => play.mistake())
    }

    /// Its sizes in words.
    pub fn words(&self) -> String {
        ask_play!(self, play => play.words())
    }
}
