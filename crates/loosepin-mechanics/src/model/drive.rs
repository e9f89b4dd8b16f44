//! Drives and the motions that they prescribe.

use super::function::Function;
use super::ids::JointId;
use super::quantity::QuantityId;

/// A joint coordinate prescribed over time: the journal body's angle from the bearing body's, rad, or the position of the
/// slider along the guide, m.
#[derive(Debug, Clone)]
pub struct Drive {
    /// Name in the file.
    pub name: String,
    /// The driven joint, ideal revolute or prismatic.
    pub joint: JointId,
    /// The coordinate over time.
    pub law: DriveLaw,
}

/// The motions that a drive can prescribe; coordinates in rad or m.
#[derive(Debug, Clone)]
pub enum DriveLaw {
    /// start + speed t.
    Constant {
        /// Speed, rad/s or m/s.
        speed: QuantityId,
        /// At time zero.
        start: QuantityId,
    },
    /// Σ c_k t^k.
    Polynomial {
        /// c_0, c_1, ...
        coefficients: Vec<QuantityId>,
    },
    /// mean + amplitude sin(2π frequency t + phase).
    Harmonic {
        /// Its middle.
        mean: QuantityId,
        /// Largest departure from the middle.
        amplitude: QuantityId,
        /// Oscillations in a second, 1/s, > 0.
        frequency: QuantityId,
        /// At time zero, rad.
        phase_rad: QuantityId,
    },
    /// from + (to - from) (τ - sin(2π τ)/2π) with τ = (t - dwell)/duration cut to [0, 1].
    Cycloidal {
        /// Where it rests before.
        from: QuantityId,
        /// Where it rests afterwards.
        to: QuantityId,
        /// Duration of the rise, s, > 0.
        duration_s: QuantityId,
        /// Rest before the rise, s, >= 0.
        dwell_s: QuantityId,
    },
    /// A cubic spline.
    Table {
        /// Times, s, increasing, and coordinates.
        points: Vec<[QuantityId; 2]>,
        /// Whether it goes on with the same course, from where it ended; else it rests before and after.
        is_periodic: bool,
    },
    /// A function of the time.
    Function(Function),
}

impl DriveLaw {
    /// The quantities that it follows.
    pub fn quantities(&self) -> Vec<QuantityId> {
        match self {
            Self::Constant { speed, start } => vec![*start, *speed],
            Self::Polynomial { coefficients } => coefficients.clone(),
            Self::Harmonic { mean, amplitude, frequency, phase_rad } => vec![*mean, *amplitude, *frequency, *phase_rad],
            Self::Cycloidal { from, to, duration_s, dwell_s } => vec![*from, *to, *duration_s, *dwell_s],
            Self::Table { points, .. } => points.iter().flatten().copied().collect(),
            Self::Function(function) => function.parameters.clone(),
        }
    }

    /// Whether it repeats itself in time.
    pub fn has_period(&self) -> bool {
        matches!(self, Self::Harmonic { .. } | Self::Table { is_periodic: true, .. })
    }

    /// Its kind as written in files; `constant` for a constant speed.
    pub fn kind(&self) -> &'static str {
        match self {
            Self::Constant { .. } => "constant",
            Self::Polynomial { .. } => "polynomial",
            Self::Harmonic { .. } => "harmonic",
            Self::Cycloidal { .. } => "cycloidal",
            Self::Table { .. } => "table",
            Self::Function(_) => "expression",
        }
    }
}
