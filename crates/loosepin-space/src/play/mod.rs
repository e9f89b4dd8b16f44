//! Kinds of play: which places of the journal each allows, with a file for each kind. Nothing else names a kind.

pub(crate) mod block;
mod cylindrical;
mod journal;
pub(crate) mod kind_of_play;
mod revolute;
mod spherical;
mod upright;

use crate::kind::frames::MarkerShift;
use block::Block;
use kind_of_play::KindOfPlay;

pub use cylindrical::CylindricalPlay;
pub use revolute::RevolutePlay;
pub use spherical::SphericalPlay;
pub use upright::UprightPlay;

/// Lists the kinds once: variant and its type.
macro_rules! spatial_plays {
    ($($variant:ident($kind:ident)),* $(,)?) => {
        /// Play of a joint in space; each kind stands in a file of its own.
        #[derive(Debug, Clone, Copy, PartialEq)]
        pub enum SpatialPlay {
            $(#[doc = concat!("See [`", stringify!($kind), "`].")] $variant($kind),)*
        }
        impl KindOfPlay for SpatialPlay {
            fn word(&self) -> &'static str {
                match self { $(Self::$variant(play) => play.word(),)* }
            }
            fn joint_word(&self) -> &'static str {
                match self { $(Self::$variant(play) => play.joint_word(),)* }
            }
            fn blocks(&self) -> Vec<Block> {
                match self { $(Self::$variant(play) => play.blocks(),)* }
            }
            fn marker_shift(&self, variables: &[f64]) -> MarkerShift {
                match self { $(Self::$variant(play) => play.marker_shift(variables),)* }
            }
            fn derivatives(&self, variables: &[f64]) -> Vec<MarkerShift> {
                match self { $(Self::$variant(play) => play.derivatives(variables),)* }
            }
            fn second_derivatives(&self) -> Vec<(usize, usize, MarkerShift)> {
                match self { $(Self::$variant(play) => play.second_derivatives(),)* }
            }
            fn bearing_length_m(&self) -> Option<f64> {
                match self { $(Self::$variant(play) => play.bearing_length_m(),)* }
            }
            fn mistake(&self) -> Option<(&'static str, f64, &'static str)> {
                match self { $(Self::$variant(play) => play.mistake(),)* }
            }
        }
        $(impl From<$kind> for SpatialPlay {
            fn from(play: $kind) -> Self {
                Self::$variant(play)
            }
        })*
    };
}

spatial_plays!(Spherical(SphericalPlay), Revolute(RevolutePlay), Upright(UprightPlay), Cylindrical(CylindricalPlay),);
