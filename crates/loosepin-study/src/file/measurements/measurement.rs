//! Readings of a backlash test and features of a measured motion, checked and in SI.

use loosepin_mechanics::model::{BodyId, PointId, Position};
use loosepin_result::study::{Deviation, Reduction};
use loosepin_text::diagnostics::Place;
use loosepin_text::units::SiUnit;

/// A reading of a backlash test: the drives locked, an output pushed to and fro, the travel between the settled positions.
#[derive(Debug, Clone, PartialEq)]
pub struct Measured {
    /// Name in messages: as written, or `reading 3`.
    pub name: String,
    /// The mechanism that was measured; `None` if the file does not say.
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
    /// The push.
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
    /// Place of the pose in the file.
    pub pose_place: Place,
}

/// The push that moves an output to and fro.
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

/// A feature of a measured motion.
#[derive(Debug, Clone, PartialEq)]
pub struct MeasuredMotion {
    /// Name in messages: as written, or output and feature.
    pub name: String,
    /// The mechanism that was measured; `None` if the file does not say.
    pub specimen: Option<String>,
    /// The instrument, which has the common error.
    pub instrument: String,
    /// The measured quantity.
    pub subject: MotionSubject,
    /// Unit of the feature.
    pub unit: SiUnit,
    /// The feature in each repeat, SI, or its mean over all; empty where it was not measured yet.
    pub values_si: Vec<f64>,
    /// Number of repeats behind it; each repeat is the next stretch of recorded turns.
    pub repeats: usize,
    /// Largest error common to all values of the instrument, of either sign.
    pub error: MotionError,
    /// Standard deviation of the independent error of one repeat.
    pub scatter: MotionError,
    /// Place in the file.
    pub place: Place,
}

impl MeasuredMotion {
    /// Mean over the repeats, SI; `None` if it was not measured.
    pub fn mean_si(&self) -> Option<f64> {
        let count = self.values_si.len();
        (count > 0).then(|| self.values_si.iter().sum::<f64>() / count as f64)
    }
}

/// The measured quantity of a feature.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum MotionSubject {
    /// An output, located between samples by the integrator.
    Located {
        /// Index in [`crate::Study::outputs`].
        output: usize,
        /// Which deviation of it.
        deviation: Deviation,
        /// How it becomes a number.
        reduction: Reduction,
    },
    /// An output at `samples_per_turn` equal angles of the drive, low-pass filtered.
    Sampled {
        /// Index in [`crate::Study::outputs`].
        output: usize,
        /// How the samples become a number.
        feature: SampledFeature,
        /// Highest order that is kept; all where no filter is stated.
        highest_order: Option<usize>,
    },
    /// Impacts a turn of the joint with this place among those with play.
    Impacts {
        /// Place among the joints with play.
        play: usize,
    },
}

/// Number that samples are reduced to.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum SampledFeature {
    /// A reduction over all samples.
    Reduced(Reduction),
    /// Amplitude of an order.
    Order(usize),
    /// Angle of the drive in a turn, rad, in which the output is within this distance of its largest value.
    Dwell(f64),
}

/// An error, in the unit of the feature or as a share of its true value.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MotionError {
    /// Its size, SI or a share.
    pub size: f64,
    /// Whether it is a share of the true value.
    pub is_share: bool,
}

/// A feature as it is written.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum FeatureWord {
    Reduced(Reduction),
    Order,
    Dwell,
    Impacts,
}

/// Features in the words of study files.
pub(crate) const FEATURES: [(&str, FeatureWord); Reduction::ALL.len() + 3] = {
    let mut table = [("", FeatureWord::Order); Reduction::ALL.len() + 3];
    let mut place = 0;
    while place < Reduction::ALL.len() {
        table[place] = (Reduction::ALL[place].word(), FeatureWord::Reduced(Reduction::ALL[place]));
        place += 1;
    }
    table[place] = ("order", FeatureWord::Order);
    table[place + 1] = ("dwell", FeatureWord::Dwell);
    table[place + 2] = ("impacts", FeatureWord::Impacts);
    table
};
