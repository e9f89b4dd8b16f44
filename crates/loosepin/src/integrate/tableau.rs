//! An embedded pair of explicit Runge-Kutta methods as data.

/// Entries of a row that are not zero: (stage, coefficient).
pub type Row = &'static [(usize, f64)];

/// How the error of a step is estimated from its stages.
#[derive(Debug, Clone, Copy)]
pub enum ErrorEstimate {
    /// h Σ eᵢ kᵢ; may use the stage at the end of the step.
    Single(Row),
    /// Hairer's combination of two estimates, err = |h| e5²/√(e5² + 0.01 e3²); uses no stage at the end of the step.
    Combined {
        /// Weights of the estimate of order 5.
        fifth: Row,
        /// Weights of the estimate of order 3.
        third: Row,
    },
}

/// An explicit pair with dense output. Stage 0 is the derivative at the start of the step; the stage after the last is the
/// derivative at its end, which is stage 0 of the next step.
#[derive(Debug)]
pub struct Tableau {
    /// Name of the method.
    pub name: &'static str,
    /// Order of the step.
    pub order: u32,
    /// c of each stage.
    pub nodes: &'static [f64],
    /// a of each stage.
    pub stages: &'static [Row],
    /// b: the step.
    pub weights: Row,
    /// The error estimate.
    pub error: ErrorEstimate,
    /// c of the further stages that only dense output needs; numbered after the derivative at the end.
    pub dense_nodes: &'static [f64],
    /// a of those stages.
    pub dense_stages: &'static [Row],
    /// Rows of the dense output beyond those from both values and both derivatives.
    pub dense: &'static [Row],
}
