//! What a sample cannot do.

use crate::accuracy::AccuracyError;
use crate::closure::error::{ClosureError, OpenJoint};
use crate::model::SpatialModelError;
use core::fmt;
use loosepin_text::units::{Dimension, format_apart};

/// Why a sample, or what is fixed for all samples, has no answer. `turn` is a place in the motion, in turns.
#[derive(Debug, Clone, PartialEq)]
pub enum SamplingError {
    /// The values make no mechanism, or the model has no turn.
    Model(SpatialModelError),
    /// Places that are not finite numbers in ascending order, or none.
    BadTurns,
    /// An output that is not there.
    NoOutput {
        /// Number of the output.
        output: usize,
        /// How many there are.
        outputs: usize,
    },
    /// A part that this kind of output does not have.
    PartDoesNotFit {
        /// The output.
        output: String,
        /// The part.
        part: &'static str,
    },
    /// A body turns by more than a quarter of a turn between two places, however close they are looked at.
    CoarseTurn {
        /// The output.
        output: String,
    },
    /// A point that rests has no direction along its path.
    AtRest {
        /// The output.
        output: String,
        /// Where.
        turn: f64,
    },
    /// A drive is not where it is in the nominal motion.
    DriveElsewhere {
        /// The drive.
        drive: String,
        /// Where.
        turn: f64,
        /// Its nominal place, rad or m.
        nominal_si: f64,
        /// Its place, rad or m.
        found_si: f64,
        /// Whether that is a length, m.
        is_length: bool,
    },
    /// The loops do not close, or not as those of the nominal mechanism do.
    DoesNotClose {
        /// Where, as far as the motion came.
        turn: f64,
        /// Why.
        why: ClosureError,
    },
    /// Redundant rows contradict each other by more than play can take up.
    CannotBeAssembled {
        /// Where.
        turn: f64,
        /// The row that is farthest from closing with ideal joints.
        open: OpenJoint,
        /// Constraints that repeat others, as many as `loosepin check` counts there.
        repeated: usize,
        /// By what all plays would have to be multiplied, to first order; `None` where no play helps, or there is none.
        needed: Option<f64>,
    },
    /// Play takes the mechanism to a dead centre, where it can go over to its other assembly.
    DeadCentre {
        /// Where.
        turn: f64,
    },
    /// An output has no answer at a place.
    NoAnswer {
        /// Where.
        turn: f64,
        /// The output; empty for all.
        output: String,
        /// Why.
        why: AccuracyError,
    },
    /// Places of the journals cannot be drawn one by one where they must meet conditions together.
    ConditionsOnPlay {
        /// Number of the conditions.
        conditions: usize,
    },
    /// Not as many numbers in [0, 1] as places of the journals are drawn from.
    BadUniforms {
        /// As many are expected.
        expected: usize,
        /// As many were given that are.
        found: usize,
    },
}

impl SamplingError {
    /// The joint at fault, where there is one.
    pub fn joint(&self) -> Option<&str> {
        match self {
            Self::DoesNotClose { why, .. } => why.joint(),
            Self::CannotBeAssembled { open, .. } => Some(&open.joint),
            _ => None,
        }
    }

    /// The place at fault, in turns, where there is one.
    pub fn turn(&self) -> Option<f64> {
        match self {
            Self::AtRest { turn, .. }
            | Self::DriveElsewhere { turn, .. }
            | Self::DoesNotClose { turn, .. }
            | Self::CannotBeAssembled { turn, .. }
            | Self::DeadCentre { turn }
            | Self::NoAnswer { turn, .. } => Some(*turn),
            _ => None,
        }
    }
}

impl From<SpatialModelError> for SamplingError {
    fn from(error: SpatialModelError) -> Self {
        Self::Model(error)
    }
}

impl fmt::Display for SamplingError {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Model(error) => error.fmt(out),
            Self::BadTurns => write!(out, "places in the turn must be finite numbers in ascending order, at least one"),
            Self::NoOutput { output, outputs } => {
                write!(out, "there is no output number {output}; the model has {outputs}, counted from 0")
            }
            Self::PartDoesNotFit { output, part } => write!(
                out,
                "output '{output}' has no part '{part}': position_of and turn_of have a number, path_of has x, y, z, along, across and \
                 magnitude, orientation_of has x, y, z and magnitude"
            ),
            Self::CoarseTurn { output } => write!(
                out,
                "output '{output}': from one place to the next, the body turns by more than a quarter of a turn, so that its turns cannot be \
                 counted"
            ),
            Self::AtRest { output, turn } => write!(
                out,
                "output '{output}' at {turn} turns: the point rests, so that nothing is along or across its path; take its magnitude"
            ),
            Self::DriveElsewhere { drive, turn, nominal_si, found_si, is_length } => {
                let dimension = if *is_length { Dimension::LENGTH } else { Dimension::ANGLE };
                let [found, nominal] = format_apart([*found_si, *nominal_si], dimension);
                write!(
                    out,
                    "drive '{drive}' at {turn} turns: it is at {found} and nominally at {nominal}; its start, and its speed relative to the \
                     turn, cannot vary"
                )
            }
            Self::DoesNotClose { turn, why } => write!(out, "at {turn} turns: {why}"),
            Self::CannotBeAssembled { turn, open, repeated, needed } => {
                let constraints = match repeated {
                    1 => "1 constraint of the joints repeats others and contradicts them".to_owned(),
                    many => format!("{many} constraints of the joints repeat others and contradict them"),
                };
                write!(
                    out,
                    "at {turn} turns the mechanism cannot be put together: {constraints}, {open} with ideal joints; "
                )?;
                match needed {
                    Some(factor) => write!(out, "all plays would have to be {factor:.3} times as large"),
                    None => write!(out, "no play takes that up"),
                }
            }
            Self::DeadCentre { turn } => write!(
                out,
                "at {turn} turns play takes the mechanism to a dead centre, where it can go over to its other assembly: there is no bound"
            ),
            Self::NoAnswer { turn, output, why } if output.is_empty() => write!(out, "at {turn} turns: {why}"),
            Self::NoAnswer { turn, output, why } => write!(out, "output '{output}' at {turn} turns: {why}"),
            Self::ConditionsOnPlay { conditions } => write!(
                out,
                "the plays must meet {conditions} conditions together so that the loops close; places of the journals cannot be drawn one by \
                 one"
            ),
            Self::BadUniforms { expected, found } => {
                write!(out, "places of the journals are drawn from {expected} numbers in [0, 1]; {found} were given")
            }
        }
    }
}

impl std::error::Error for SamplingError {}
