//! What a reading of a backlash test says, checked and in SI.

use loosepin_mechanics::model::{BodyId, PointId, Position};
use loosepin_text::diagnostics::Place;
use loosepin_text::units::SiUnit;

/// A reading of a backlash test: the drives locked, an output pushed to and fro, the travel between the settled positions.
#[derive(Debug, Clone, PartialEq)]
pub struct Measured {
    /// Name in messages: as written, or `reading 3`.
    pub name: String,
    /// The mechanism that was measured; nothing where the file does not say.
    pub specimen: Option<String>,
    /// The instrument, which has the common error.
    pub instrument: String,
    /// Name of the output, with the component of a path.
    pub output: String,
    /// The position that is read.
    pub travel: Position,
    /// Its unit.
    pub unit: SiUnit,
    /// Angle of the drive that the cycle counts, rad.
    pub pose_rad: f64,
    /// Largest error of that angle, of either sign, rad.
    pub pose_error_rad: f64,
    /// What pushes.
    pub push: Push,
    /// Largest coefficient of friction in the joints, where the file states it.
    pub friction: Option<f64>,
    /// Dead travel, mean over the repeats, SI.
    pub dead_travel_si: f64,
    /// Number of readings behind it.
    pub repeats: usize,
    /// Largest error common to all readings of the instrument, of either sign, SI.
    pub error_si: f64,
    /// The error of each reading by itself.
    pub scatter: ReadingScatter,
    /// Place of the dead travel in the file.
    pub place: Place,
}

/// What pushes an output to and fro.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Push {
    /// A force at a point.
    Force {
        /// The point.
        point: PointId,
        /// Its direction on the way to, from the ground's x axis, rad.
        direction_rad: f64,
        /// Its size, N.
        force_n: f64,
    },
    /// A moment on a body.
    Moment {
        /// The body.
        body: BodyId,
        /// Its size, N m.
        moment_n_m: f64,
    },
}

/// The independent error of one reading: normal about zero.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum ReadingScatter {
    /// Its standard deviation is known, SI; zero for readings without one.
    Known(f64),
    /// Its standard deviation is estimated from the repeats, SI.
    Estimated(f64),
}
