//! What moves a mechanism.

/// A coordinate of a joint.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum JointCoordinate {
    /// φ = atan2(y_i·x_j, x_i·x_j), rad: the turn of the journal's x axis about z.
    Angle,
    /// z_i·(P_j - P_i), m.
    Slide,
}

/// A drive: it prescribes a coordinate of a joint.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Drive {
    /// Number of the joint.
    pub joint: usize,
    /// Which of its coordinates.
    pub coordinate: JointCoordinate,
}

/// What a drive prescribes at an instant.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct DriveValue {
    /// f, rad or m.
    pub value: f64,
    /// ḟ, rad/s or m/s.
    pub rate: f64,
    /// f̈, rad/s² or m/s².
    pub acceleration: f64,
}

impl DriveValue {
    /// A position that is held.
    pub fn held(value: f64) -> Self {
        Self { value, rate: 0.0, acceleration: 0.0 }
    }

    /// A position that is passed at constant speed.
    pub fn at_rate(value: f64, rate: f64) -> Self {
        Self { value, rate, acceleration: 0.0 }
    }
}
