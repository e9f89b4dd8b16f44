//! Why a model is no mechanism, or a sample of it cannot be built.

use super::constraints::Opening;
use crate::model::{QuantityError, describe_path};
use loosepin_text::units::{Dimension, format_value, quoted};
use thiserror::Error;

/// Why a model cannot be compiled.
#[derive(Debug, Clone, PartialEq, Error)]
#[allow(missing_docs, reason = "the text of an error says what it is, and names its fields")]
pub enum MechanismError {
    /// The nominal values break a rule.
    #[error(transparent)]
    Quantity(#[from] QuantityError),
    #[error(
        "the mechanism has {mobility} degrees of freedom and {drives} {}: {} not determined",
        if *drives == 1 { "drive" } else { "drives" },
        undetermined_words(undetermined)
    )]
    TooFewDrives {
        /// Degrees of freedom with all clearances at zero.
        mobility: usize,
        drives: usize,
        /// Bodies that can still move when the drives stand still.
        undetermined: Vec<String>,
    },
    #[error(
        "the mechanism has {mobility} {} of freedom and {drives} drives: they work against each other",
        if *mobility == 1 { "degree" } else { "degrees" }
    )]
    TooManyDrives {
        /// Degrees of freedom with all clearances at zero.
        mobility: usize,
        drives: usize,
    },
    #[error("joint '{joint}' closes a loop in which every joint is driven")]
    DrivenLoop { joint: String },
    /// A joint with friction in a mechanism whose constraint forces are not determined.
    #[error(
        "joint '{joint}' has friction, and what it carries is not determined: constraints of ideal joints repeat each other"
    )]
    CarriedNotDetermined { joint: String },
    #[error("the links cannot close at the start: {open} at best")]
    CannotClose { open: Opening },
    #[error("the links cannot close at the start that [initial] gives: {open} at best")]
    CannotCloseAsGiven { open: Opening },
    #[error(
        "the initial state does not determine {}",
        if *is_rate { rates_of(bodies) } else { places_of(bodies) }
    )]
    StartNotDetermined {
        /// Whether rates are missing, not positions.
        is_rate: bool,
        /// Bodies that can still be placed, or moved, in more than one way.
        bodies: Vec<String>,
    },
    #[error("the drives determine the motion; the initial state under [initial] has nothing to say")]
    StartNotNeeded,
    #[error("control '{control}' has nothing to move: the drives determine the motion")]
    NothingToControl { control: String },
    #[error("control '{control}' cannot feed inverse dynamics forward: {reason}")]
    NoInverseDynamics { control: String, reason: &'static str },
    #[error(
        "{} cannot be {} at the start; the links and what else is given come no closer than {}",
        describe_path(path),
        format_value(*given_si, *dimension),
        format_value(*found_si, *dimension)
    )]
    StartContradicts {
        path: String,
        given_si: f64,
        /// The nearest one, SI.
        found_si: f64,
        dimension: Dimension,
    },
    #[error(
        "the mechanism starts in a singular position: {} can move although every drive stands still",
        if bodies.is_empty() { "a body".to_owned() } else { quoted(bodies) }
    )]
    SingularStart { bodies: Vec<String> },
}

/// Where bodies are, in words.
fn places_of(bodies: &[String]) -> String {
    if bodies.len() == 1 { format!("where {} is", quoted(bodies)) } else { format!("where {} are", quoted(bodies)) }
}

/// How fast bodies move, in words.
fn rates_of(bodies: &[String]) -> String {
    if bodies.len() == 1 {
        format!("how fast {} moves", quoted(bodies))
    } else {
        format!("how fast {} move", quoted(bodies))
    }
}

fn undetermined_words(bodies: &[String]) -> String {
    match bodies {
        [] => "a motion is".to_owned(),
        [one] => format!("the motion of '{one}' is"),
        many => format!("the motions of {} are", quoted(many)),
    }
}

/// Why one set of values gives no motion of the ideal mechanism.
#[derive(Debug, Clone, PartialEq, Error)]
#[allow(missing_docs, reason = "the text of an error says what it is, and names its fields")]
pub enum SampleError {
    /// A value breaks its rule.
    #[error(transparent)]
    Quantity(#[from] QuantityError),
    /// A clearance is zero in one and above zero in the other of sample and compiled mechanism.
    #[error("joint '{joint}' has a radial clearance of {}; the compiled mechanism treats it as {}", format_value(*clearance_m, Dimension::LENGTH), if *compiled_with_play { "a joint with play" } else { "ideal" })]
    ClearanceChangesTopology {
        joint: String,
        clearance_m: f64,
        /// Whether it had play when the mechanism was compiled.
        compiled_with_play: bool,
    },
    #[error(
        "joint '{joint}' has a radial clearance of {}; '{law}' was fitted to clearances from {} to {}",
        format_value(*clearance_m, Dimension::LENGTH),
        format_value(fitted_m[0], Dimension::LENGTH),
        format_value(fitted_m[1], Dimension::LENGTH)
    )]
    ClearanceOutsideFit {
        joint: String,
        law: &'static str,
        clearance_m: f64,
        /// Smallest and largest clearance of the fit, m.
        fitted_m: [f64; 2],
    },
    #[error(
        "joint '{joint}' has a film by {law} with a roughness of {} at a radial clearance of {}; must lie between {} and {}",
        format_value(*roughness_m, Dimension::LENGTH),
        format_value(*clearance_m, Dimension::LENGTH),
        format_value(allowed_m[0], Dimension::LENGTH),
        format_value(allowed_m[1], Dimension::LENGTH)
    )]
    RoughnessOutsideFilm {
        joint: String,
        law: &'static str,
        roughness_m: f64,
        clearance_m: f64,
        /// Smallest and largest roughness at this clearance, m.
        allowed_m: [f64; 2],
    },
    #[error("the links cannot close at {}: {open}", format_value(*time_s, Dimension::TIME))]
    CannotClose { open: Opening, time_s: f64 },
    #[error(
        "{} is {}; the links and what else is given make it {}",
        describe_path(path),
        format_value(*given_si, *dimension),
        format_value(*found_si, *dimension)
    )]
    StartContradicts { path: String, given_si: f64, found_si: f64, dimension: Dimension },
    #[error("singular position at {}: the drives no longer determine the motion", format_value(*time_s, Dimension::TIME))]
    Singular { time_s: f64 },
}
