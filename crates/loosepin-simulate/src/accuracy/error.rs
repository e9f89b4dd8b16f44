//! Why there is no quasi-static answer.

use loosepin_mechanics::mechanism::SampleError;
use loosepin_mechanics::mechanism::constraints::LargestResidual;
use loosepin_mechanics::model::QuantityError;
use loosepin_text::units::format_number;
use thiserror::Error;

/// Why the ideal motion or the quasi-static answer cannot be given.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum AccuracyError {
    /// The sample is impossible or its loops cannot close at the start.
    #[error(transparent)]
    Sample(#[from] SampleError),
    /// A quantity cannot be varied.
    #[error(transparent)]
    Quantity(#[from] QuantityError),
    /// Forces move the mechanism, not drives alone.
    #[error(
        "the drives alone do not determine the motion: it follows from the forces, which this command does not compute"
    )]
    NotDriven,
    /// The drive whose angle is the input does not turn.
    #[error("drive '{drive}' has speed zero, so it has no cycle")]
    StandsStill {
        /// The drive.
        drive: String,
    },
    /// A drive moves too far in one cycle.
    #[error(
        "in one cycle drive '{drive}' makes about {} steps of 0.2 rad, or of a fifth of the mechanism's size; must be at most {most}",
        format_number(steps.round())
    )]
    TooLong {
        /// The drive.
        drive: String,
        /// The steps.
        steps: f64,
        /// The largest number.
        most: usize,
    },
    /// Too few positions to describe a cycle.
    #[error("{positions} positions a cycle were asked for; must be at least {least}")]
    TooFewPositions {
        /// The number asked for.
        positions: usize,
        /// The smallest number.
        least: usize,
    },
    /// A standard deviation that is negative or not finite.
    #[error("the standard deviation of {path} is {standard_deviation_si}; must be a finite number >= 0")]
    BadStandardDeviation {
        /// Path of the quantity.
        path: String,
        /// The given value, SI.
        standard_deviation_si: f64,
    },
    /// A slider that its guide does not hold upright.
    #[error("joint '{joint}': the slider can turn over in its guide, so there is no quasi-static result")]
    TurnsOver {
        /// The joint.
        joint: String,
    },
    /// Journals displaced within their clearances leave a loop open: a dead point lies within the play.
    #[error("the links cannot close when the journals are displaced within their clearances: {open}")]
    CannotCloseWithPlay {
        /// The constraint that stays open furthest.
        open: LargestResidual,
    },
    /// Journals displaced within their clearances bring the mechanism into a singular position.
    #[error("there is a singular position within the clearances, where the drives no longer determine the motion")]
    SingularWithPlay,
    /// Somebody stopped it.
    #[error("the ideal motion was stopped before its end")]
    Stopped,
}
