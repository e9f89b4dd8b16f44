//! Kinds of outputs: what is read off a position, with a file for each kind. Nothing else names a kind.

mod joint;
pub(crate) mod kind_of_output;
mod point;
mod relative_turn;
mod rotation;
mod rotation_sine;

use crate::enclosure::enclosed_output::EnclosedOutput;
use crate::enclosure::jet::Number;
use crate::enclosure::position_box::{PlacedJet, PositionBox};
use crate::mechanism::spatial_mechanism::SpatialMechanism;
use kind_of_output::{BodyGradient, KindOfOutput, OutputState};
use loosepin_math::Vec3;

pub use joint::JointOutput;
pub use point::PointOutput;
pub use rotation::RotationOutput;
pub use rotation_sine::RotationSineOutput;

/// Lists the kinds once: variant and its type.
macro_rules! spatial_outputs {
    ($($variant:ident($kind:ident)),* $(,)?) => {
        /// A number that is read off a position; each kind stands in a file of its own.
        #[derive(Debug, Clone, Copy, PartialEq)]
        pub enum SpatialOutput {
            $(#[doc = concat!("See [`", stringify!($kind), "`].")] $variant($kind),)*
        }
        impl KindOfOutput for SpatialOutput {
            fn word(&self) -> &'static str {
                match self { $(Self::$variant(output) => output.word(),)* }
            }
            fn deviation(&self, ideal: &OutputState, actual: &OutputState) -> f64 {
                match self { $(Self::$variant(output) => output.deviation(ideal, actual),)* }
            }
            fn gradient(&self, ideal: &OutputState, actual: &OutputState) -> Vec<BodyGradient> {
                match self { $(Self::$variant(output) => output.gradient(ideal, actual),)* }
            }
            fn fits(&self, mechanism: &SpatialMechanism) -> bool {
                match self { $(Self::$variant(output) => output.fits(mechanism),)* }
            }
        }
        impl EnclosedOutput for SpatialOutput {
            fn enclosed<T: Number>(&self, at: &PositionBox) -> PlacedJet<T> {
                match self { $(Self::$variant(output) => output.enclosed(at),)* }
            }
        }
        $(impl From<$kind> for SpatialOutput {
            fn from(output: $kind) -> Self {
                Self::$variant(output)
            }
        })*
    };
}

spatial_outputs!(Point(PointOutput), Rotation(RotationOutput), RotationSine(RotationSineOutput), Joint(JointOutput),);

impl SpatialOutput {
    /// The displacement of a point along x, y and z of the ground.
    pub fn displacement(body: usize, point_m: Vec3) -> [Self; 3] {
        Vec3::AXES.map(|direction| PointOutput { body, point_m, direction }.into())
    }

    /// The displacement of a point along a direction, if it is that.
    pub fn point(&self) -> Option<PointOutput> {
        match self {
            Self::Point(own) => Some(*own),
            _ => None,
        }
    }

    /// The body whose rotation vector this is a component of, if it is that.
    pub(crate) fn rotated_body(&self) -> Option<usize> {
        match self {
            Self::Rotation(own) => Some(own.body),
            _ => None,
        }
    }

    /// The component along another direction of the vector that this is a component of; `None` of what is no vector.
    pub(crate) fn component(&self, direction: Vec3) -> Option<Self> {
        match self {
            Self::Point(own) => Some(PointOutput { direction, ..*own }.into()),
            Self::Rotation(own) => Some(RotationOutput { axis: direction, ..*own }.into()),
            Self::RotationSine(own) => Some(RotationSineOutput { axis: direction, ..*own }.into()),
            Self::Joint(_) => None,
        }
    }

    /// The components of a body's rotation vector.
    pub fn rotation(body: usize) -> [Self; 3] {
        Vec3::AXES.map(|axis| RotationOutput { body, axis }.into())
    }
}
