//! Why a model is no mechanism, or a sample of it cannot be built.

use crate::model::QuantityError;
use crate::units::{Dimension, format_value};
use thiserror::Error;

/// Why a model cannot be compiled.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum MechanismError {
    /// The nominal values break a rule.
    #[error(transparent)]
    Quantity(#[from] QuantityError),
    /// Fewer drives than degrees of freedom.
    #[error(
        "the mechanism has {mobility} degrees of freedom and {drives} {}: {} not determined",
        if *drives == 1 { "drive" } else { "drives" },
        undetermined_words(undetermined)
    )]
    TooFewDrives {
        /// Degrees of freedom with all clearances at zero.
        mobility: usize,
        /// Number of drives.
        drives: usize,
        /// Bodies that can still move when the drives stand still.
        undetermined: Vec<String>,
    },
    /// More drives than degrees of freedom.
    #[error(
        "the mechanism has {mobility} {} of freedom and {drives} drives: they work against each other",
        if *mobility == 1 { "degree" } else { "degrees" }
    )]
    TooManyDrives {
        /// Degrees of freedom with all clearances at zero.
        mobility: usize,
        /// Number of drives.
        drives: usize,
    },
    /// A loop in which every joint is driven.
    #[error("joint '{joint}' closes a loop in which every joint is driven")]
    DrivenLoop {
        /// The driven joint that closes the loop.
        joint: String,
    },
    /// No configuration closes all loops.
    #[error(
        "the links cannot close at the start: joint '{joint}' stays {} open at best",
        format_value(*gap_m, Dimension::LENGTH)
    )]
    CannotClose {
        /// The joint with the largest gap.
        joint: String,
        /// Its gap, m.
        gap_m: f64,
    },
    /// The start is a singular position.
    #[error(
        "the mechanism starts in a singular position: {} can move although every drive stands still",
        quoted(bodies)
    )]
    SingularStart {
        /// Bodies that can move there.
        bodies: Vec<String>,
    },
}

fn undetermined_words(bodies: &[String]) -> String {
    match bodies {
        [] => "a motion is".to_owned(),
        [one] => format!("the motion of '{one}' is"),
        many => format!("the motions of {} are", quoted(many)),
    }
}

/// `'crank', 'rod' and 'slider'`.
fn quoted(bodies: &[String]) -> String {
    let quoted: Vec<String> = bodies.iter().map(|body| format!("'{body}'")).collect();
    match quoted.as_slice() {
        [] => "a body".to_owned(),
        [one] => one.clone(),
        [first @ .., last] => format!("{} and {last}", first.join(", ")),
    }
}

/// Why one set of values gives no motion of the ideal mechanism.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum SampleError {
    /// A value breaks its rule.
    #[error(transparent)]
    Quantity(#[from] QuantityError),
    /// A clearance is zero in one and above zero in the other of sample and compiled mechanism.
    #[error("joint '{joint}' has a radial clearance of {}; the compiled mechanism treats it as {}", format_value(*clearance_m, Dimension::LENGTH), if *compiled_with_play { "a joint with play" } else { "ideal" })]
    ClearanceChangesTopology {
        /// The joint.
        joint: String,
        /// Its clearance in this sample, m.
        clearance_m: f64,
        /// What it was when the mechanism was compiled.
        compiled_with_play: bool,
    },
    /// A clearance to which the contact law was not fitted.
    #[error(
        "joint '{joint}' has a radial clearance of {}; '{law}' was fitted to clearances from {} to {}",
        format_value(*clearance_m, Dimension::LENGTH),
        format_value(fitted_m[0], Dimension::LENGTH),
        format_value(fitted_m[1], Dimension::LENGTH)
    )]
    ClearanceOutsideFit {
        /// The joint.
        joint: String,
        /// The law.
        law: &'static str,
        /// Its clearance in this sample, m.
        clearance_m: f64,
        /// Smallest and largest clearance of the fit, m.
        fitted_m: [f64; 2],
    },
    /// A clearance that has no room for a film of oil.
    #[error(
        "joint '{joint}' has a film with a roughness of {} in a radial clearance of {}; must be below it",
        format_value(*roughness_m, Dimension::LENGTH),
        format_value(*clearance_m, Dimension::LENGTH)
    )]
    RoughnessFillsClearance {
        /// The joint.
        joint: String,
        /// The roughness in this sample, m.
        roughness_m: f64,
        /// The clearance in this sample, m.
        clearance_m: f64,
    },
    /// The loops cannot be closed at this instant.
    #[error(
        "the links cannot close at {}: joint '{joint}' stays {} open",
        format_value(*time_s, Dimension::TIME),
        format_value(*gap_m, Dimension::LENGTH)
    )]
    CannotClose {
        /// The joint with the largest gap.
        joint: String,
        /// Its gap, m.
        gap_m: f64,
        /// The time, s.
        time_s: f64,
    },
    /// A singular position is met.
    #[error("singular position at {}: the drives no longer determine the motion", format_value(*time_s, Dimension::TIME))]
    Singular {
        /// The time, s.
        time_s: f64,
    },
}
