//! Why an accuracy cannot be computed.

use core::fmt;

/// Why an accuracy cannot be computed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum AccuracyError {
    /// The output names a body or a joint that is not there, or a direction that is not a unit vector.
    OutputDoesNotFit,
    /// The position is not one of this mechanism: the number of bodies or drives differs, or its poses do not close the loops.
    NotAPosition,
    /// The loop equations are singular in this position.
    Singular,
    /// The output moves though all drives are held: it has no ideal value.
    OutputIsFree,
    /// The plays leave no place in which the loops close.
    NoPlace,
    /// Redundant rows do not close without play: there is no ideal position that a first order could be about.
    PartsDoNotFit,
    /// An error of a marker is of a joint that is not there, or has a number that is not finite.
    BadMarkerError,
    /// Somebody stopped it.
    Stopped,
}

impl fmt::Display for AccuracyError {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        out.write_str(match self {
            Self::OutputDoesNotFit => {
                "the output needs a body or joint of this mechanism, and directions that are unit vectors"
            }
            Self::NotAPosition => "the position is not a closed one of this mechanism",
            Self::Singular => "the loop equations are singular in this position",
            Self::OutputIsFree => "the output moves with all drives held, so that it has no ideal value",
            Self::NoPlace => "no place of the joints within their play closes the loops",
            Self::PartsDoNotFit => "the parts do not fit without play, so that there is no worst case of first order",
            Self::Stopped => "the search was stopped before its end",
            Self::BadMarkerError => "errors of markers need a joint of this mechanism and finite numbers",
        })
    }
}

impl std::error::Error for AccuracyError {}
