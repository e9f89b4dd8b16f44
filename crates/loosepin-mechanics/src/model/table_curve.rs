//! Curves through the points of a table.

/// How a curve goes between its points.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum TableCurve {
    /// Nowhere beyond the points on both sides; its slope does not jump.
    Monotone,
    /// A cubic spline: its curvature does not jump either.
    Spline,
}

impl TableCurve {
    /// The words of the file for it.
    pub(super) const WORDS: [(&str, TableCurve); 2] =
        [("monotone", TableCurve::Monotone), ("spline", TableCurve::Spline)];
}
