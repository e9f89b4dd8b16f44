//! Assumptions behind the force of a contact: shown with every contact force.

use loosepin_text::units::extended;
use serde::{Deserialize, Serialize};

/// Assumptions behind the force of a contact law, besides the law's name and its restitution.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct ContactBasis {
    /// Which bodies the law has in mind.
    pub shape: ContactShape,
    /// Whether the model file names the law; else it is the default.
    pub is_law_named: bool,
    /// Impact speed as which slower ones are computed; absent in records of older versions.
    #[serde(with = "extended", default)]
    pub minimum_impact_speed_m_s: Option<f64>,
    /// Impact speed up to which the law is meant to hold; absent where none is known.
    #[serde(with = "extended")]
    pub largest_valid_speed_m_s: Option<f64>,
    /// Penetration at which the law ends; absent where it does not end.
    #[serde(with = "extended")]
    pub largest_valid_penetration_m: Option<f64>,
}

/// The bodies between which a contact law has its force.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(tag = "kind", rename_all = "snake_case")]
pub enum ContactShape {
    /// A point contact whose stiffness comes from the materials: no length enters.
    Point {
        /// Length of the bearing where the model gives one: the law does not use it.
        #[serde(with = "extended")]
        unused_length_m: Option<f64>,
    },
    /// The stiffness is given.
    Given,
    /// A cylinder in a cylinder.
    Line {
        /// Length of the bearing.
        #[serde(with = "extended")]
        length_m: f64,
    },
    /// Worn surfaces on an elastic foundation, in place of the law.
    Foundation,
}

/// The largest force of a pin as a line-contact law would have it: at the elastic energy that was stored at the largest penetration.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct LongPinForce {
    /// Name of that law.
    pub law: String,
    /// Length of the bearing.
    #[serde(with = "extended")]
    pub length_m: f64,
    /// Whether the model gives that length; else it is the diameter of the bearing.
    pub is_length_given: bool,
    /// The force; absent where the law ends before it has stored that energy.
    #[serde(with = "extended")]
    pub force_n: Option<f64>,
}
