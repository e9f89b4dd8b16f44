//! How a drawing is read.

/// The unit and the tolerance of a drawing.
#[derive(Debug, Clone)]
pub struct ImportOptions {
    /// The unit of the drawing, for example `mm`; that of its header (`$INSUNITS`) where none is given.
    pub unit: Option<String>,
    /// Within this distance, m, > 0, ends and centres coincide.
    pub tolerance_m: f64,
}
